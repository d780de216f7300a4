#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shading/scene/settings.h"
#include "x11/options/option_rows.h"
#include "x11/options/options.h"
#include "x11/options/read_value.h"

namespace xnewell {

/// Adds options to CLI11. The code here reads their values, so that the error messages are in our words.
class Reader {
 public:
  explicit Reader(CLI::App& app) : app_{app} {}

  /// Adds a setting of the picture. Everything comes from its row. Its value joins `overrides`.
  void setting(const Setting& row, std::vector<Override>& overrides) {
    std::string help{row.is};
    if (row.field.kind != ValueKind::Flag) help += "; " + expected(row);
    if (!row.unit.empty()) help += ", in " + std::string{row.unit};
    if (!row.more.empty()) help += ". " + std::string{row.more};
    const std::string name{row.option};
    if (row.field.kind == ValueKind::Flag) {
      app_.add_flag_function(
              name,
              [&](std::int64_t times) {
                overrides.push_back({&row, times > 0 ? 1.0 : 0.0});
              },
              help + (help.ends_with('.') ? " " : ". ") + name + "=false ends what the scene asks for")
          ->check([name](const std::string& given) -> std::string {
            if (given != "true" && given != "false") refuse(name, given, "true or false");
            return "";
          });
      return;
    }
    const std::string initially =
        row.initially.empty() ? textOf(row, row.field.get(PictureSettings{})) : std::string{row.initially};
    text(name, help, initially, [&](const std::string& given) {
      overrides.push_back({&row, valueOf(row, given)});
    });
    for (const Choice& choice : row.field.choices) words_[name].emplace_back(choice.name);
  }
  /// Adds a number in [low, high]. `initially` is its default in words, if it is not the number's own; `why`
  /// ends the message that refuses another number.
  template <class Number>
  void number(const std::string& name, Number& target, double low, double high, const std::string& help,
              std::string initially = "", const std::string& why = "") {
    if (initially.empty()) initially = textOf(static_cast<double>(target));
    text(name, help, initially, [=, &target](const std::string& given) {
      const bool whole = std::is_integral_v<Number>;
      const std::string needed = std::string{whole ? "a whole number" : "a number"} + " from " + textOf(low) +
                                 " to " + textOf(high) + why;
      const double v = numbers(name, given, 1, needed)[0];
      if (v < low || v > high || (whole && v != std::floor(v))) refuse(name, given, needed);
      target = static_cast<Number>(v);
    });
  }
  void point(const std::string& name, const std::string& help, const std::string& initially, auto&& set) {
    text(name, help, initially, [=](const std::string& given) {
      const auto v = numbers(name, given, 3, "three finite numbers x,y,z");
      set(glm::dvec3{v[0], v[1], v[2]});
    });
  }
  /// Adds a choice of one row of a table, by its name.
  template <class Rows, class Id>
  void choice(const std::string& name, const Rows& rows, Id& target, const std::string& help) {
    std::string all, initially;
    for (const auto& row : rows) {
      all += (all.empty() ? "" : ", ") + std::string{row.name};
      if (row.id == target) initially = row.name;
    }
    proposes(name, rows);
    text(name, help + ": " + all, initially, [=, &rows, &target](const std::string& given) {
      const auto row = std::ranges::find(rows, given, [](const auto& r) { return r.name; });
      if (row == rows.end()) refuse(name, given, "one of " + all);
      target = row->id;
    });
  }
  /// Adds the name of a `what`, such as a file. The name must not be empty.
  void named(const std::string& name, std::string& target, const std::string& what, const std::string& help) {
    if (what == "file") takes(name, Takes::File);
    if (what == "folder") takes(name, Takes::Folder);
    text(name, help, "", [=, &target](const std::string& given) {
      if (given.empty()) throw UsageError{name + ": the " + what + "'s name is empty"};
      target = given;
    });
  }
  void text(const std::string& name, const std::string& help, const std::string& initially,
            const std::function<void(const std::string&)>& take) {
    app_.add_option_function<std::string>(name, take,
                                          help + (initially.empty() ? "" : " [" + initially + "]"))
        ->type_name("");
  }
  /// The value may be left out: then `take` gets "".
  void mayTakeText(const std::string& name, const std::string& help, const std::string& initially,
                   const std::function<void(const std::string&)>& take) {
    text(name, help, initially, take);
    app_.get_option(name)->expected(0, 1);
  }
  void flag(const std::string& name, bool& target, const std::string& help) {
    app_.add_flag(name, target, help)->disable_flag_override();
  }
  /// Says that the value of an option is the name of a file or of a folder.
  void takes(const std::string& name, Takes what) { takes_[name] = what; }
  /// Says where an option works (OptionRow::places).
  void only(const std::string& name, std::vector<std::string_view> places) {
    places_[name] = std::move(places);
  }
  /// Says that the value of an option may be the name of one of these rows.
  void proposes(const std::string& name, const auto& rows) {
    for (const auto& row : rows) words_[name].emplace_back(row.name);
  }
  /// The options so far, in the order of --help.
  [[nodiscard]] std::vector<OptionRow> rows() const;

 private:
  CLI::App& app_;
  std::map<std::string, Takes> takes_;
  std::map<std::string, std::vector<std::string_view>> places_;
  std::map<std::string, std::vector<std::string>> words_;
};

/// Adds the options of the camera.
void addCamera(Reader& r, CameraSettings& camera);
/// Adds what is shown, and where a window begins.
void addView(Reader& r, Options& o);
/// Adds the effects on the stored colours, after the indices are picked.
void addEffects(Reader& r, Options& o);
/// Says where the options work that do not work with all commands that draw a scene.
void addPlaces(Reader& r);

}  // namespace xnewell
