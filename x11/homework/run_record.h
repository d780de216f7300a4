#pragma once

#include <array>
#include <functional>
#include <glm/vec2.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "depthsort/pair_tests.h"
#include "depthsort/record/explain.h"
#include "depthsort/region.h"
#include "shading/picture/picture.h"

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

/// Samples of a row: columns [from, to).
struct SampleRow {
  int row = 0, from = 0, to = 0;
  bool operator==(const SampleRow&) const = default;
};
/// Samples where one polygon hides another, and the first of them.
struct Hidden {
  int samples = 0, i = 0, j = 0;
  std::vector<SampleRow> rows = {};

  [[nodiscard]] std::string text() const;  ///< "12 samples, such as 3,4"
};

/// A run of the depth sort that somebody else makes, recorded as the program records its own: the student's
/// by hand, or that of another program. Any steps make a record that can be replayed.
class RunRecord {
 public:
  /// The picture has planes. `all`: every event is kept; otherwise only the splits are, and what is painted.
  explicit RunRecord(const Picture& picture, bool all = true);
  RunRecord(const RunRecord&) = delete;  // its tests refer to its picture
  RunRecord& operator=(const RunRecord&) = delete;
  ~RunRecord() = default;

  struct Part {
    Fragment fragment;
    Region region;
    Extents extents;
  };
  [[nodiscard]] const SnappedScene& scene() const { return picture_.snapped(); }
  [[nodiscard]] const Picture& picture() const { return picture_; }
  [[nodiscard]] const SortedScene& sorted() const { return sorted_; }
  [[nodiscard]] PairTests& tests() { return tests_; }
  [[nodiscard]] int parts() const { return static_cast<int>(parts_.size()); }
  /// A fragment by its id.
  [[nodiscard]] const Part& operator[](int id) const { return parts_[id]; }
  [[nodiscard]] const SnappedFace& face(int id) const { return scene().faces[parts_[id].fragment.face]; }
  [[nodiscard]] Shape shape(int id) const {
    const Part& part = parts_[id];
    return {face(id), part.fragment.face, part.extents.box, part.fragment.piece < 0 ? nullptr : &part.region};
  }
  [[nodiscard]] bool crosses(int P, int Q) { return tests_.crosses(shape(P), shape(Q)); }
  [[nodiscard]] Relation compare(int P, int Q) { return tests_.compare(shape(P), shape(Q)); }
  /// The samples of both where Q must be painted before P: P is nearer there, and rounding alone does not
  /// part them.
  [[nodiscard]] Hidden hidden(int P, int Q) const;

  /// The list before the first step.
  void begin(std::vector<int> list) { sorted_.list = std::move(list); }
  /// P becomes the polygon that the next event is about. If it is not the P of the moves before, they end.
  void take(int P);
  /// An event that changes no list.
  void add(const Event& event);
  void move(int P, int Q);
  void paint(int P);
  /// The plane of `by` properly crosses the polygon. Returns the id of the piece behind; the one in front has
  /// the next id.
  int cut(int of, int by);
  /// The marked polygons, P last.
  [[nodiscard]] const std::vector<int>& marked() const { return marked_; }
  [[nodiscard]] int events() const { return static_cast<int>(sorted_.events.size()); }

  struct State {
    std::size_t events, fragments, pieces, cuts;
    std::vector<int> marked;
  };
  [[nodiscard]] State state() const {
    return {sorted_.events.size(), sorted_.fragments.size(), sorted_.pieces.size(), sorted_.cuts.size(),
            marked_};
  }
  /// Goes back to a state before.
  void restore(State state);

 private:
  const Picture picture_;
  bool all_;
  PairTests tests_;
  SortedScene sorted_;
  std::vector<Part> parts_;
  std::vector<int> marked_;
};

/// The polygons that a run file speaks of, and what it does to them.
class NamedRun {
 public:
  /// Names are those of `named`, which may be the same scene in a picture of another size.
  NamedRun(const Picture& picture, const SnappedScene& named, bool all);

  struct Polygon {
    enum class State { Waiting, Painted, Split, Unknown };
    std::string name;
    int face;                     ///< number in the scene; another one below 0 for each unknown polygon
    std::vector<int> parts = {};  ///< ids of fragments; several for a concave face, none if it is not visible
    State state = State::Waiting;
    int line = 0;                          ///< that painted or split it
    std::optional<std::int64_t> own = {};  ///< of a piece: the number that the program gave it
    std::optional<std::array<double, 5>> shade = {};
  };
  /// Indices of polygons; -1 for none.
  struct Step {
    int P = -1, Q = -1;
    std::array<int, 2> pieces{-1, -1};  ///< behind, in front
    std::array<int, 2> before{-1, -1};  ///< that had the number of the piece
  };
  /// Does a step, as far as it can be done. `before` is called when its P and Q are known and nothing is done
  /// yet.
  Step step(
      const RunStep& s, const std::function<void(const Step&)>& before = [](const Step&) {});

  [[nodiscard]] Polygon& operator[](int polygon) { return polygons_[polygon]; }
  [[nodiscard]] const Polygon& operator[](int polygon) const { return polygons_[polygon]; }
  [[nodiscard]] int polygons() const { return static_cast<int>(polygons_.size()); }
  /// `face 4 lid`: the number and the part, as the lists of the window have them.
  [[nodiscard]] std::string nameOfFace(int face) const;
  [[nodiscard]] int faces() const { return faces_; }
  [[nodiscard]] int polygonOfFace(int number) { return polygon({.id = number}); }
  /// The polygon that a fragment is, or is a part of; -1 if the run does not speak of it.
  [[nodiscard]] int polygonOf(int fragment) const {
    return fragment < static_cast<int>(polygonOf_.size()) ? polygonOf_[fragment] : -1;
  }
  /// The line of each event.
  [[nodiscard]] const std::vector<int>& lines() const { return lines_; }

  RunRecord record;

 private:
  int add(Polygon polygon);
  /// The polygon that has this number now; -1 if there is none.
  [[nodiscard]] int find(const RunPolygon& named);
  [[nodiscard]] int polygon(const RunPolygon& named);
  int addPiece(int P, const RunPolygon& named, std::vector<int> parts);
  [[nodiscard]] std::unordered_map<std::int64_t, int>& known(const RunPolygon& named) {
    return named.name.empty() ? byNumber_ : byPlace_;
  }
  void split(const RunStep& s, Step& step);

  const Fragments fragments_;  ///< of no run: names of faces
  const SnappedScene& named_;
  int faces_;
  std::unordered_map<int, std::vector<int>> partsOf_;  ///< of faces by their numbers
  std::vector<Polygon> polygons_;
  std::vector<int> polygonOf_, lines_;
  std::unordered_map<std::int64_t, int> byNumber_, byPlace_;
};

}  // namespace xnewell
