#pragma once

// Stands before each file of the build for browsers, whose C++ library cannot read floating-point numbers
// yet.
#ifdef __cplusplus
#include <fast_float/fast_float.h>
#include <charconv>

namespace std {

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const auto [end, error] = fast_float::from_chars(first, last, value);
  return {end, error};
}

}  // namespace std
#endif
