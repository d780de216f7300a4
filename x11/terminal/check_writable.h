#pragma once

#include <string>

namespace xnewell {

/// Finds out early whether a file can be written, before a command measures for a long time.
/// @throws std::system_error `FILE: Permission denied`, if it surely cannot
void checkWritable(const std::string& file);

}  // namespace xnewell
