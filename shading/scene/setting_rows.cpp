#include "shading/scene/setting_rows.h"

#include <algorithm>
#include <iterator>

namespace xnewell {

const std::vector<Setting>& settingRows() {
  static const std::vector<Setting> rows = [] {
    std::vector<Setting> all = methodRows();
    for (const std::vector<Setting>& more : {lightRows(), tableRows()})
      std::ranges::copy(more, std::back_inserter(all));
    return all;
  }();
  return rows;
}

}  // namespace xnewell
