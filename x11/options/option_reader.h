#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "shading/scene/settings.h"
#include "x11/options/option_rows.h"
#include "x11/options/options.h"
#include "x11/options/read_value.h"

namespace xnewell {

/// Makes the rows of the options. The code here reads their values, so that the error messages are in our
/// words. Each function returns the new row, until the next one is made.
class Reader {
 public:
  /// Adds a setting of the picture. Everything comes from its row. Its value joins `overrides`.
  OptionRow& setting(const Setting& row, std::vector<Override>& overrides) {
    const bool flag = row.field.kind == ValueKind::Flag;
    std::string help{row.is};
    if (!flag) help += "; " + expected(row);
    if (!row.unit.empty()) help += ", in " + std::string{row.unit};
    if (!row.more.empty()) help += ". " + std::string{row.more};
    const std::string name{row.option};
    std::string initially;
    if (flag)
      help += (help.ends_with('.') ? " " : ". ") + name + "=false ends what the scene asks for";
    else
      initially =
          row.initially.empty() ? textOf(row, row.field.get(PictureSettings{})) : std::string{row.initially};
    OptionRow& made = text(name, help, initially, [&](const std::string& given) {
      overrides.push_back({&row, valueOf(row, given)});
    });
    if (flag) made.takes = Takes::Nothing;
    return made.proposes(row.field.choices);
  }
  /// Adds the alias of a setting.
  OptionRow& alias(const Setting& row, std::vector<Override>& overrides) {
    return flag(std::string{row.alias},
                "the same as " + std::string{row.option} + ' ' + std::string{row.means}, [&] {
                  overrides.push_back({&row, valueOf(row, std::string{row.means})});
                });
  }
  /// Adds a number in [low, high]. `initially` is its default in words, if it is not the number's own; `why`
  /// ends the message that refuses another number.
  template <class Number>
  OptionRow& number(const std::string& name, Number& target, double low, double high, const std::string& help,
                    std::string initially = "", const std::string& why = "") {
    if (initially.empty()) initially = textOf(static_cast<double>(target));
    return text(name, help, initially, [=, &target](const std::string& given) {
      const bool whole = std::is_integral_v<Number>;
      const std::string needed = std::string{whole ? "a whole number" : "a number"} + " from " + textOf(low) +
                                 " to " + textOf(high) + why;
      const double v = numbers(name, given, 1, needed)[0];
      if (v < low || v > high || (whole && v != std::floor(v))) refuse(name, given, needed);
      target = static_cast<Number>(v);
    });
  }
  OptionRow& point(const std::string& name, const std::string& help, const std::string& initially,
                   auto&& set) {
    return text(name, help, initially, [=](const std::string& given) {
      const auto v = numbers(name, given, 3, "three finite numbers x,y,z");
      set(glm::dvec3{v[0], v[1], v[2]});
    });
  }
  /// Adds a choice of one row of a table, by its name.
  template <class Rows, class Id>
  OptionRow& choice(const std::string& name, const Rows& rows, Id& target, const std::string& help) {
    std::string all, initially;
    for (const auto& row : rows) {
      all += (all.empty() ? "" : ", ") + std::string{row.name};
      if (row.id == target) initially = row.name;
    }
    return text(name, help + ": " + all, initially,
                [=, &rows, &target](const std::string& given) {
                  const auto row = std::ranges::find(rows, given, [](const auto& r) { return r.name; });
                  if (row == rows.end()) refuse(name, given, "one of " + all);
                  target = row->id;
                })
        .proposes(rows);
  }
  /// Adds the name of a `what`, such as a file. The name must not be empty.
  OptionRow& named(const std::string& name, std::string& target, const std::string& what,
                   const std::string& help) {
    OptionRow& row = text(name, help, "", [=, &target](const std::string& given) {
      if (given.empty()) throw UsageError{name + ": the " + what + "'s name is empty"};
      target = given;
    });
    if (what == "file") row.takes = Takes::File;
    if (what == "folder") row.takes = Takes::Folder;
    return row;
  }
  OptionRow& text(const std::string& name, const std::string& help, const std::string& initially,
                  std::function<void(const std::string&)> take) {
    return rows_.emplace_back(OptionRow{.name = name,
                                        .letter = {},
                                        .does = help + (initially.empty() ? "" : " [" + initially + "]"),
                                        .takes = Takes::Text,
                                        .take = std::move(take)});
  }
  OptionRow& flag(const std::string& name, const std::string& help, std::function<void()> set) {
    OptionRow& row = text(name, help, "", [name, set = std::move(set)](const std::string& given) {
      if (given != "true") throw UsageError{name + " takes no value"};
      set();
    });
    row.takes = Takes::Nothing;
    return row;
  }
  OptionRow& flag(const std::string& name, bool& target, const std::string& help) {
    return flag(name, help, [&target] { target = true; });
  }
  /// The rows, in the order of --help.
  [[nodiscard]] std::vector<OptionRow> rows() && { return std::move(rows_); }

 private:
  std::vector<OptionRow> rows_;
};

/// Adds the options of the camera.
void addCamera(Reader& r, CameraSettings& camera);
/// Adds what is shown, and where a window begins.
void addView(Reader& r, Options& o);
/// Adds the effects on the stored colours, after the indices are picked.
void addEffects(Reader& r, Options& o);

}  // namespace xnewell
