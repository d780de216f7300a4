#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// The names of what a file has and the program has no use for: `vn`, `vertex.red`. Each is named once.
class LeftOut {
 public:
  void add(std::string_view name);
  /// `the program does not use vn, s, l`; "" if there is nothing. It names the first kNamed and
  /// says whether others follow: a file that is no model may have any number of them.
  [[nodiscard]] std::string sentence() const;
  static constexpr std::size_t kNamed = 12;

 private:
  std::vector<std::string> names_;  ///< in the order of the file
  bool others_ = false;             ///< whether there are names that found no room
};

}  // namespace xnewell
