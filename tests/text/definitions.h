#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// Finds what a C++ file defines for the whole program: types, functions, and inline variables, with the
/// names that the linker sees. It reads the text alone and knows just enough of the language for this
/// project's files.

struct Definition {
  enum class Kind { Type, Function, Variable } kind;
  /// With its namespaces: "xnewell::Rect". A function has the types of its parameters, without their names:
  /// "xnewell::rowOf(Order)".
  std::string name;
  bool operator==(const Definition&) const = default;
};

struct Definitions {
  std::vector<Definition> all;
  std::set<std::string> declared;  ///< types that are named here and defined elsewhere: "xnewell::Rect"
  bool balanced = true;            ///< false if the braces do not match, so that the rest may be wrong
};

/// The definitions at namespace scope. What only its own file can use is left out: anonymous namespaces,
/// static functions, constants that are not inline. So are members and types inside a type or a function.
[[nodiscard]] Definitions definitionsIn(std::string_view source);

}  // namespace xnewell
