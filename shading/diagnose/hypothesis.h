#pragma once

#include <span>
#include <string_view>

#include "shading/diagnose/approach.h"
#include "shading/diagnose/other_model.h"
#include "shading/light/equation.h"
#include "shading/scene/picture_settings.h"

namespace xnewell {

/// What a program may have done instead of what the settings say: a row each.

/// What a row means for whoever wrote the program.
enum class Meaning {
  Right,    ///< what the settings say
  Allowed,  ///< another way that the course allows; never called a mistake
  Wrong,    ///< a mistake
  Numbers,  ///< a right program that got other numbers
};

struct Hypothesis {
  std::string_view key, sentence;
  std::string_view term;  ///< the part of the equation, of the table or of the painting that it touches
  Meaning meaning = Meaning::Wrong;
  Approach way = {};                                  ///< what is done otherwise
  bool (*applies)(const PictureSettings&) = nullptr;  ///< null: always
  bool (*changes)(const Light&) = nullptr;            ///< the lights that it changes; null: any, or none
};

/// All rows. The first is "right". A mistake of the equation that has a row in kMistakes has its name and its
/// sentence from there. Rows of one key are forms of one mistake.
[[nodiscard]] std::span<const Hypothesis> hypotheses();
/// The row of a number that is another one. It stands in no list: its values are searched for.
[[nodiscard]] const Hypothesis& rowOfNumber(NumberOf which);
/// The number of different mistakes in them.
[[nodiscard]] int mistakesKnown();
[[nodiscard]] const Hypothesis* hypothesisNamed(std::string_view key);

}  // namespace xnewell
