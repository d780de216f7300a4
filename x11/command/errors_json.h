#pragma once

#include <nlohmann/json.hpp>

#include "shading/picture/errors.h"

namespace xnewell {

/// The errors of a picture as JSON. errors.h says what the numbers are.
[[nodiscard]] nlohmann::ordered_json errorsAsJson(const Errors& errors);

}  // namespace xnewell
