#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shading/picture/picture.h"

namespace xnewell {

/// What a picture needed of the illumination model, and why. The rest was not computed.
struct Required {
  std::string_view name;                  ///< "specular"
  std::variant<bool, std::int64_t> what;  ///< whether, or how many
  std::string why;                        ///< "no surface has ks above 0"
};
[[nodiscard]] std::vector<Required> requiredBy(const Picture& picture);

}  // namespace xnewell
