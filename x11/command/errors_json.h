#pragma once

#include <nlohmann/json.hpp>

#include "shading/figure/figure_errors.h"
#include "shading/laboratory/errors.h"

namespace xnewell {

/// The errors of a picture as JSON. errors.h says what the numbers are.
[[nodiscard]] nlohmann::ordered_json errorsAsJson(const Errors& errors);
/// The same of a figure; figure_errors.h says what the numbers are.
[[nodiscard]] nlohmann::ordered_json errorsAsJson(const FigureErrors& errors);

}  // namespace xnewell
