#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>

#include "shading/scene/settings.h"

namespace xnewell {

/// These functions make the Field of a setting. `member` is a function from the settings to the member that
/// stores the value.

template <class T>
inline constexpr bool kOptional = false;
template <class T>
inline constexpr bool kOptional<std::optional<T>> = true;

/// A field for a number, a flag or three numbers, or for an optional number or an optional three numbers,
/// which may stay open.
template <class Member>
Field holds(Member member) {
  using T = std::remove_cvref_t<decltype(member(std::declval<PictureSettings&>()))>;
  Field field;
  if constexpr (std::is_same_v<T, bool>) field.kind = ValueKind::Flag;
  if constexpr (std::is_same_v<T, int>) field.kind = ValueKind::Whole;
  if constexpr (std::is_same_v<T, glm::dvec3> || std::is_same_v<T, std::optional<glm::dvec3>>)
    field.kind = ValueKind::Triple;
  field.get = [=](const PictureSettings& s) -> Value {
    if constexpr (kOptional<T>)
      return member(s) ? Value{*member(s)} : Value{};
    else if constexpr (std::is_same_v<T, glm::dvec3>)
      return member(s);
    else
      return static_cast<double>(member(s));
  };
  field.set = [=](PictureSettings& s, const Value& value) {
    if constexpr (kOptional<T>) {
      member(s).reset();
      if (const auto* v = std::get_if<typename T::value_type>(&value)) member(s) = *v;
    } else if constexpr (std::is_same_v<T, glm::dvec3>) {
      member(s) = std::get<glm::dvec3>(value);
    } else {
      member(s) = static_cast<T>(std::get<double>(value));
    }
  };
  return field;
}

/// True if each row says itself in words, or if rows of this table have no words.
template <class Rows>
constexpr bool allHaveWords(const Rows& rows) {
  return std::ranges::none_of(rows, [](const auto& row) {
    if constexpr (requires { row.words; }) return row.words.empty();
    return false;
  });
}

/// A field for a choice of one of the rows of a table, or for an optional one, which may stay open. A row may
/// have a label and words. The table must live as long as the program.
template <class Rows, class Member>
Field choosesFrom(const Rows& rows, Member member) {
  using T = std::remove_cvref_t<decltype(member(std::declval<PictureSettings&>()))>;
  Field field{.kind = ValueKind::Choice};
  for (const auto& row : rows) {
    Choice choice{.name = row.name, .label = row.name, .words = ""};
    if constexpr (requires { row.label; }) choice.label = row.label;
    if constexpr (requires { row.words; }) choice.words = row.words;
    field.choices.push_back(choice);
  }
  field.get = [member, &rows](const PictureSettings& s) -> Value {
    if constexpr (kOptional<T>)
      if (!member(s)) return {};
    const auto row = std::ranges::find_if(rows, [&](const auto& r) { return member(s) == r.id; });
    return static_cast<double>(row - rows.begin());
  };
  field.set = [member, &rows](PictureSettings& s, const Value& value) {
    if constexpr (kOptional<T>) {
      member(s).reset();
      if (std::holds_alternative<std::monostate>(value)) return;
    }
    member(s) = rows[static_cast<std::size_t>(std::get<double>(value))].id;
  };
  return field;
}
template <const auto& kRows, class Member>
Field chooses(Member member) {
  static_assert(allHaveWords(kRows), "a row of this table has no words");
  return choosesFrom(kRows, member);
}

}  // namespace xnewell
