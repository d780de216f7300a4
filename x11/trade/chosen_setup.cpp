#include "x11/trade/chosen_setup.h"

#include "shading/picture/facts.h"

namespace xnewell {

Setup withChanges(Setup setup, const Configuration& chosen) {
  for (const Change& change : chosen.changes)
    if (change.setting)
      (void)applyOverrides(setup.picture, {{change.setting, change.value}});
    else
      setup.divisions = static_cast<int>(change.value);
  return setup;
}

Setup measuredPart(Setup setup) {
  setup.picture = withoutColors(setup.picture);
  setup.fill = Fill::Scanline;
  setup.show = Show::Shaded;
  return setup;
}

}  // namespace xnewell
