#pragma once

#include <functional>
#include <string>

#include "x11/kit/prompt.h"

namespace xnewell {

/// Asks for the name of a file to write, and a second time before it replaces a file.
/// @param complaint  says what is wrong with a name; "" if nothing
/// @param write      writes the file. If it throws std::system_error, that is told, and the user may correct
///                   the name
[[nodiscard]] Question fileQuestion(std::string asks, std::string text,
                                    std::function<std::string(const std::string& file)> complaint,
                                    std::function<void(const std::string& file)> write);

}  // namespace xnewell
