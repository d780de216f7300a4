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

/// The settings of a picture, one row each. These all use the rows: scene files, the options and --help, the
/// window's controls, the notes on settings without effect, and the words that compare two set-ups. Size and
/// camera have no row. The default of a setting is its value in a default-constructed PictureSettings.

/// The value of a setting: a number, three numbers, or nothing if the setting may stay open. A flag is 0 or
/// 1. A choice is the index of its row.
using Value = std::variant<std::monostate, double, glm::dvec3>;

enum class ValueKind { Number, Whole, Flag, Choice, Triple };

/// The range of a number, or of each of three numbers.
struct ValueRange {
  double low, high;   ///< infinite if there is no limit
  bool open = false;  ///< true if the ends are excluded
};

/// One of the possible values of a choice.
struct Choice {
  std::string_view name, label;  ///< the name in files and options, and the label on a control
  std::string_view words;        ///< "z-sort by mean z"; if it is empty, the phrase has the name
};

/// What a flag means when it is off and when it is on: "not dithered", "dithered". Both, or neither.
class FlagWords {
 public:
  FlagWords() = default;
  constexpr FlagWords(std::string_view off, std::string_view on) : off_{off}, on_{on} {}
  [[nodiscard]] constexpr std::string_view of(bool flag) const { return flag ? on_ : off_; }

 private:
  std::string_view off_, on_;
};

/// Where a setting is stored, and which values it can have.
struct Field {
  ValueKind kind = ValueKind::Number;
  std::function<Value(const PictureSettings&)> get = {};
  std::function<void(PictureSettings&, const Value&)> set = {};
  std::vector<Choice> choices = {};
};

/// The facts that decide whether a setting has an effect.
struct PictureFacts {
  const PictureSettings& settings;
  ColorPlan plan;                   ///< never Needed: if that was chosen, the plan that the scene needs
  bool highlights;                  ///< true if a surface has ks above 0
  bool patches, normals, textures;  ///< normals: the file has some
};
/// The facts of a picture with these settings and a scene that adds none: no patches, normals or textures,
/// and one hue if the plan is Needed.
[[nodiscard]] PictureFacts factsOf(const PictureSettings& settings);

/// The condition under which a setting has an effect.
struct Need {
  bool (*met)(const PictureFacts&) = nullptr;  ///< null: it always has an effect
  std::string_view appliesTo = {};             ///< completes the sentence `it applies to ...`
  /// What happens if a setting is given but has no effect. Noted: a note. Refused: an error. RefusedOrKept:
  /// an error, except in set-ups and lessons, which may keep the setting for another method. Only the
  /// settings decide whether it is an error, not the scene.
  enum class Unmet { Noted, Refused, RefusedOrKept } unmet = Unmet::Noted;
};

/// Sections of the window's column of controls. Hidden: the column does not show the control.
enum class Section { Hidden, Light, Surface, Method, ColourTable };

/// The track of a control. An arrow moves the value by `step`; on a logarithmic track, it moves by that share
/// of the track's length.
struct Slider {
  double low, high, step;
  bool logarithmic = false;
  int decimals = 0;
};

/// What a setting decides.
///
/// A model setting says what the picture shows: which light falls on which surface, and what the equation is.
/// It is right by definition. A short cut says how the picture is computed and shown: what is left out, done
/// once for many places, interpolated, rounded or guessed. It saves time, memory or colours, and it has an
/// error. One of its values is `exact`: that value leaves out the least.
///
/// reference.h compares pictures with what their model settings describe. A setting that decides both, such
/// as the number of polygons of a solid, is a short cut. There is no default: each row must say what it is.
class Role {
 public:
  [[nodiscard]] static constexpr Role model() { return Role{std::nullopt}; }
  /// `exact` is the name of a choice, or a number. A flag is 0 or 1.
  [[nodiscard]] static constexpr Role shortCut(std::string_view exact) { return Role{Exact{exact}}; }
  [[nodiscard]] static constexpr Role shortCut(double exact) { return Role{Exact{exact}}; }

  [[nodiscard]] constexpr bool isShortCut() const { return exact_.has_value(); }
  /// Precondition: isShortCut().
  [[nodiscard]] constexpr const std::variant<double, std::string_view>& exact() const { return *exact_; }

 private:
  using Exact = std::variant<double, std::string_view>;
  explicit constexpr Role(std::optional<Exact> exact) : exact_{exact} {}
  std::optional<Exact> exact_;
};

struct Setting {
  std::string_view key = {};     ///< the key in "shading" of a scene file: "table.i0"
  std::string_view option = {};  ///< "--i0"
  std::string_view alias = {};   ///< an option that is the same as `option` with the value `means`
  std::string_view means = {};
  std::string_view label = {};        ///< "I0"
  char control = 0;                   ///< the key in the window
  Section section = Section::Hidden;  ///< the section that has its control
  std::string_view is = {};           ///< a description
  std::string_view more = {};         ///< more sentences, for --help only
  Role role;
  Field field = {};
  ValueRange range = {0, 1};
  std::string_view letters = {};  ///< the names of its three numbers: "x,y,z"
  /// For three numbers: a further condition, and its description.
  bool (*allowed)(const glm::dvec3&) = nullptr;
  std::string_view allowedAre = {};
  std::string_view unit = {};
  std::optional<Slider> slider = {};
  std::vector<double> trials = {};  ///< for a number that is a short cut: values worth a comparison
  Need need = {};
  std::string_view initially = {};  ///< the default in words, if the value does not say it
  std::string_view replaces = {};   ///< what the setting replaces in the scene (one of kStrippable)
  /// What two set-ups differ in, for example "light". If it is empty, the label is used.
  std::string_view differsIn = {};
  /// For example "{} shades". If it is empty, the label and the value are used.
  std::string_view phrase = {};
  FlagWords words = {};      ///< of a flag; a choice has its words in its rows (Choice::words)
  bool alwaysNamed = false;  ///< named even if two set-ups agree in it
};

[[nodiscard]] const std::vector<Setting>& settingRows();
/// The row of an option ("--ka"), of an alias or of a control's key; null if there is none.
[[nodiscard]] const Setting* settingOf(std::string_view option);
[[nodiscard]] const Setting* settingOf(char control);

/// True if the value has the right kind and lies in the range.
[[nodiscard]] bool allows(const Setting& setting, const Value& value);
/// "a number from 0 to 1"; "one of log, search"; "three finite numbers x,y,z, not all 0".
[[nodiscard]] std::string expected(const Setting& setting);
/// The index of the choice with this name; nothing if there is none.
[[nodiscard]] std::optional<int> choiceNamed(const Setting& setting, std::string_view name);
/// The text of a value in files and options, with as many digits as it takes to read the same value again:
/// "0.02", "phong", "1,0,0". It is "" for a setting that is open.
[[nodiscard]] std::string textOf(const Setting& setting, const Value& value);
[[nodiscard]] std::string textOf(double number);

/// The value of a setting for people: "ks 0.4", "240 shades", "Gouraud". Numbers have up to six decimals.
[[nodiscard]] std::string phraseOf(const Setting& setting, const PictureSettings& settings);

/// The settings with every short cut at its exact value. Model settings, size and camera stay.
[[nodiscard]] PictureSettings withoutShortCuts(PictureSettings settings);

[[nodiscard]] bool hasEffect(const Setting& setting, const PictureFacts& facts);
/// "n has no effect here; it applies to highlights ...".
[[nodiscard]] std::string noEffect(std::string_view name, const Setting& setting,
                                   std::string_view where = "here");

/// A setting, and the value that takes the place of its own. Options, the keys of a scene file, the steps of
/// a lesson and the controls of the window are lists of these over the settings that were there before.
struct Override {
  const Setting* setting;
  Value value;
};

/// Ensures Ia + Ip <= 1. If the sum is larger, it reduces the one that was not set, or Ia if neither was. It
/// changes nothing and returns false if both were set and the sum exceeds 1.
[[nodiscard]] bool keepWithinOne(Illumination& light, bool IaSet, bool IpSet);

/// Puts the values into the settings, in their order. What goes with another value of its own ends, unless
/// the list has it: a direction of the light ends its position and its attenuation, and an attenuation ends
/// its range and coefficients. keepWithinOne() takes those in the list as set. Returns false if Ia + Ip of
/// the list exceeds 1.
[[nodiscard]] bool applyOverrides(PictureSettings& settings, const std::vector<Override>& overrides);

}  // namespace xnewell
