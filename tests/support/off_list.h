#pragma once

#include <string>
#include <vector>

#include "tests/support/student.h"

namespace student {

/// What the equation has at a place, for one light.
struct Place {
  Triple N, L, V, P;
  double NL, NV, RV, d, f, Ip, Ia, ka, kd, ks;
  int n;
};

/// Mistakes of the equation that no list of shading/diagnose has. Their keys begin with "off-".
[[nodiscard]] const std::vector<std::string>& offListKeys();
[[nodiscard]] double offList(const std::string& key, const Place& at);

}  // namespace student
