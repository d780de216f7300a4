#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shading/scene/picture_settings.h"

namespace xnewell {

/// The settings of a picture, one row each. Scene files, options and --help, the window's controls, the notes
/// on settings without effect, and the words on how two setups differ all walk these rows. Size and camera
/// have none. A default is what a default-constructed PictureSettings holds.

/// A setting's value: a number, three numbers, or nothing where the setting may stay open. A flag is 0 or 1,
/// a choice the index of its row.
using Value = std::variant<std::monostate, double, glm::dvec3>;

enum class ValueKind { Number, Whole, Flag, Choice, Triple };

/// The numbers that a setting takes, or each of three.
struct ValueRange {
  double low, high;   ///< infinite for none
  bool open = false;  ///< without its ends
};

/// One of a choice.
struct Choice {
  std::string_view name, label;  ///< in files and options; on a control
};

/// Where a setting is stored, and what it can hold.
struct Field {
  ValueKind kind = ValueKind::Number;
  std::function<Value(const PictureSettings&)> get = {};
  std::function<void(PictureSettings&, const Value&)> set = {};
  std::vector<Choice> choices = {};
};

/// What decides whether a setting has an effect.
struct PictureFacts {
  const PictureSettings& settings;
  ColorPlan plan;   ///< never Needed: what the scene needed
  bool highlights;  ///< a surface has ks above 0
  bool patches, textures;
};
/// Of a picture of these settings whose scene says nothing itself: one hue, no patches, no textures.
[[nodiscard]] PictureFacts factsOf(const PictureSettings& settings);

/// What a setting needs to have an effect.
struct Need {
  bool (*met)(const PictureFacts&) = nullptr;  ///< null: always
  std::string_view appliesTo = {};             ///< `it applies to ...`
  /// If it is chosen all the same: a note; an error; or an error but in set-ups and lessons, which may keep
  /// it for another method. An error is decided by the settings alone.
  enum class Unmet { Noted, Refused, RefusedOrKept } unmet = Unmet::Noted;
};

/// Sections of the window's column of controls.
enum class Section { Hidden, Light, Surface, Method, ColourTable };

/// The track of a control. An arrow moves by `step`, or on a logarithmic track by that share of it.
struct Slider {
  double low, high, step;
  bool logarithmic = false;
  int decimals = 0;
};

struct Setting {
  std::string_view key = {};          ///< below "shading" in a scene file: "table.i0"
  std::string_view option = {};       ///< "--i0"
  std::string_view label = {};        ///< "I0"
  char control = 0;                   ///< the window's key
  Section section = Section::Hidden;  ///< where its control stands
  std::string_view is = {};           ///< what it is
  std::string_view more = {};         ///< for --help alone
  Field field = {};
  ValueRange range = {0, 1};
  std::string_view letters = {};  ///< names of three numbers: "x,y,z"
  /// For three numbers: a condition beside the range, and its words.
  bool (*allowed)(const glm::dvec3&) = nullptr;
  std::string_view allowedAre = {};
  std::string_view unit = {};
  std::optional<Slider> slider = {};
  Need need = {};
  std::string_view initially = {};           ///< the default in words, where its value does not tell
  std::string_view replaces = {};            ///< what it replaces of the scene (kStrippable)
  std::string_view differsIn = {};           ///< two setups differ in "the light"; "" for the label
  std::string_view phrase = {};              ///< "{} shades"; "" for the label and the value
  std::vector<std::string_view> words = {};  ///< for each choice, or for false and true; else their names
  bool alwaysSaid = false;                   ///< even where two setups agree
};

[[nodiscard]] const std::vector<Setting>& settingRows();
/// The row of an option ("--ka") or of a control's key; null where there is none.
[[nodiscard]] const Setting* settingOf(std::string_view option);
[[nodiscard]] const Setting* settingOf(char control);

/// Whether the value has the right kind and lies in the range.
[[nodiscard]] bool allows(const Setting& setting, const Value& value);
/// "a number from 0 to 1"; "one of log, search"; "three finite numbers x,y,z, not all 0".
[[nodiscard]] std::string expected(const Setting& setting);
/// The index of the choice; nothing where there is none of that name.
[[nodiscard]] std::optional<int> choiceNamed(const Setting& setting, std::string_view name);
/// As files and options have it, with as many digits as it takes: "0.02", "phong", "1,0,0". "" for an open
/// one.
[[nodiscard]] std::string textOf(const Setting& setting, const Value& value);
[[nodiscard]] std::string textOf(double number);

[[nodiscard]] bool hasEffect(const Setting& setting, const PictureFacts& facts);
/// "n has no effect here; it applies to highlights ...".
[[nodiscard]] std::string noEffect(std::string_view name, const Setting& setting,
                                   std::string_view where = "here");

/// Ia + Ip <= 1: the one that was not set gives way. False where both were set, and exceed 1.
[[nodiscard]] bool keepWithinOne(Illumination& light, bool IaSet, bool IpSet);

}  // namespace xnewell
