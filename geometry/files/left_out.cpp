#include "geometry/files/left_out.h"

#include <algorithm>

#include "geometry/files/text_file.h"

namespace xnewell {

void LeftOut::add(std::string_view name) {
  if (!names_.empty() && names_.back() == name) return;  // most often a run of the same
  if (std::ranges::find(names_, name) != names_.end()) return;
  if (names_.size() < kNamed)
    names_.emplace_back(name);
  else
    others_ = true;
}

std::string LeftOut::sentence() const {
  if (names_.empty()) return "";
  std::string all = "the program does not use ";
  for (const std::string& name : names_) {
    if (&name != names_.data()) all += ", ";
    const std::string quoted = inQuotes(name);  // with unprintable bytes replaced
    all += quoted.ends_with("...'") ? quoted : quoted.substr(1, quoted.size() - 2);
  }
  return others_ ? all + " and others" : all;
}

}  // namespace xnewell
