#pragma once

#include <array>
#include <functional>
#include <glm/vec2.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "depthsort/record/explain.h"

namespace xnewell {

/// A run of the depth sort as a file has it: a JSON object a line. `trace` writes one, and so does any
/// program with shading/library/xnewell_run.h.

/// A polygon of a line. A program names faces by their numbers in the scene, and pieces by numbers of its
/// own. trace names each by its place among the picture's polygons, and in words.
struct RunPolygon {
  static constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::min();
  std::int64_t id = kNone;               ///< a program may write any
  std::string name = {};                 ///< "" for a program's number
  std::vector<glm::dvec2> outline = {};  ///< pixels; empty if it is not told, or has no area
  /// What flat shading has: normal, N.L and cell.
  std::optional<std::array<double, 5>> shade = {};
};

struct RunStep {
  std::optional<Event::Kind> kind = {};  ///< none: P is marked, or a note
  bool marks = false;
  RunPolygon P = {}, Q = {}, behind = {}, inFront = {};
  std::optional<Test> test = {};
  std::string_view outcome = {};  ///< of a test: one of kOutcomes
  std::optional<Verdict> verdict = {};
  int cell = -1;          ///< of a polygon that is painted; -1 if it is not told
  std::string text = {};  ///< of a note
  int step = 0;           ///< as trace counts; 0: it is not told
  int line = 0;           ///< of the file

  /// What a test says of P and Q; Crossing if it does not tell.
  [[nodiscard]] Verdict said() const;
};
inline constexpr std::array<std::string_view, 5> kOutcomes{"P first", "Q first", "crossing", "yes", "no"};
/// The first three of them.
[[nodiscard]] constexpr std::string_view nameOf(Verdict verdict) {
  return kOutcomes[static_cast<std::size_t>(verdict)];
}

[[nodiscard]] nlohmann::ordered_json asJson(const RunStep& step);

/// True if a file of JSON lines has events, as a run does, and not a painting order.
[[nodiscard]] bool isRunFile(const std::string& file);

class RunFile {
 public:
  /// @throws std::system_error; ParseError for a file of more than 256 MB
  explicit RunFile(const std::string& file);
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::size_t lines() const;
  /// What the first line says of the picture.
  [[nodiscard]] std::optional<glm::ivec2> size() const { return size_; }
  /// True unless the first line names another scene; where its file lies does not count.
  [[nodiscard]] bool isOf(const std::string& scene) const;
  [[nodiscard]] const std::string& scene() const { return scene_; }  ///< that it names; or else ""
  /// Lines that only tell of the run are left out. @throws ParseError for what is no such line, and for a
  /// std::runtime_error of `use`
  void forEach(const std::function<void(const RunStep&)>& use) const;

 private:
  std::string name_, text_, scene_;
  std::optional<glm::ivec2> size_;
};

}  // namespace xnewell
