#include "x11/homework/run_record.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "depthsort/fragment_spans.h"
#include "depthsort/region.h"
#include "geometry/files/text_file.h"
#include "shading/diagnose/judge_order.h"
#include "shading/laboratory/errors.h"
#include "shading/scene/json_text.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

using Json = Node::Json;

constexpr std::size_t kMostBytes = 256 << 20;
constexpr std::string_view kExample = R"({"event": "take", "P": 3})";
constexpr int kKinds = static_cast<int>(Event::Kind::Paint) + 1;

std::string_view wordOf(const RunStep& step) {
  return step.kind ? wordFor(*step.kind) : step.marks ? "mark" : "note";
}

void put(Json& json, const std::string& key, const RunPolygon& polygon) {
  if (polygon.id == RunPolygon::kNone) return;
  if (polygon.name.empty()) {
    json[key] = polygon.id;
  } else {
    json[key] = polygon.name;
    json[key + "_id"] = polygon.id;
  }
  for (const glm::dvec2& at : polygon.outline) json[key + "_outline"].push_back({at.x, at.y});
  if (polygon.shade) json[key + "_shade"] = *polygon.shade;
}

std::string textOf(const Json& json, const std::string& key) {
  const auto at = json.find(key);
  if (at == json.end() || !at->is_string()) throw std::runtime_error{'"' + key + "\" is needed, in quotes"};
  return at->get<std::string>();
}

int numberOf(const Json& value, const std::string& key) {
  using Int = std::numeric_limits<int>;
  if (!value.is_number_integer() || value < Int::min() || value > Int::max())
    throw std::runtime_error{'"' + key + "\" is a whole number, and no name"};
  return value.get<int>();
}

RunPolygon polygonOf(const Json& json, const std::string& key) {
  RunPolygon polygon;
  const auto at = json.find(key);
  if (at == json.end())
    throw std::runtime_error{'"' + key + "\" is needed: the number of a face, from 0, or of a piece"};
  if (at->is_string() && json.contains(key + "_id")) {
    polygon.name = at->get<std::string>();
    polygon.id = numberOf(json[key + "_id"], key + "_id");
  } else {
    polygon.id = numberOf(*at, key);
  }
  const auto outline = json.find(key + "_outline");
  if (outline != json.end() && (!outline->is_array() || outline->size() > 2))  // with two corners it is empty
    polygon.outline = outlineOf(*outline, key + "_outline");
  if (const auto shade = json.find(key + "_shade"); shade != json.end()) {
    const auto isFinite = [](const Json& v) { return v.is_number() && std::isfinite(v.get<double>()); };
    if (!shade->is_array() || shade->size() != 5 || !std::ranges::all_of(*shade, isFinite))
      throw std::runtime_error{'"' + key + "_shade\" is [Nx, Ny, Nz, N.L, cell]"};
    polygon.shade = shade->get<std::array<double, 5>>();
  }
  return polygon;
}

RunStep stepOf(const Json& json) {
  RunStep step;
  const std::string word = textOf(json, "event");
  if (word == "note") {
    step.text = textOf(json, "text");
    return step;
  }
  step.marks = word == "mark";
  for (int k = 0; k < kKinds && !step.kind; ++k)
    if (wordFor(static_cast<Event::Kind>(k)) == word) step.kind = static_cast<Event::Kind>(k);
  if (!step.marks && !step.kind)
    throw std::runtime_error{inQuotes(word) +
                             " is no event: take, test, move, mark, cut, paint and note are"};
  step.P = polygonOf(json, "P");
  if (step.marks || step.kind == Event::Kind::Take) return step;
  if (step.kind == Event::Kind::Paint) {
    if (const auto cell = json.find("cell"); cell != json.end()) step.cell = numberOf(*cell, "cell");
    return step;
  }
  step.Q = polygonOf(json, "Q");
  if (step.kind == Event::Kind::Split) {
    step.behind = polygonOf(json, "behind");
    step.inFront = polygonOf(json, "in_front");
  }
  if (step.kind == Event::Kind::Compare) {
    const std::string test = textOf(json, "test"), outcome = textOf(json, "outcome");
    const auto row = std::ranges::find(kTestRows, test, &TestRow::name);
    const auto said = std::ranges::find(kOutcomes, outcome);
    if (row == kTestRows.end())
      throw std::runtime_error{inQuotes(test) + " is no test: plane, 1, 2, 3, 4, 5, 3', 4' and 6 are"};
    if (said == kOutcomes.end())
      throw std::runtime_error{inQuotes(outcome) + " is no outcome of a test: yes and no are"};
    step.test = row->id, step.outcome = *said;
    if (const auto verdict = json.find("verdict"); verdict != json.end())
      for (const Verdict v : {Verdict::PFirst, Verdict::QFirst, Verdict::Crossing})
        if (*verdict == nameOf(v)) step.verdict = v;
  }
  return step;
}

}  // namespace

Verdict RunStep::said() const {
  if (verdict && outcome != "no") return *verdict;
  const bool exchanged = test == Test::QBehindP || test == Test::PInFrontOfQ;
  return outcome == "yes" ? (exchanged ? Verdict::QFirst : Verdict::PFirst)
                          : static_cast<Verdict>(std::min<std::ptrdiff_t>(
                                std::ranges::find(kOutcomes, outcome) - kOutcomes.begin(),
                                static_cast<std::ptrdiff_t>(Verdict::Crossing)));
}

Json asJson(const RunStep& step) {
  Json json;
  if (step.step > 0) json["step"] = step.step;
  json["event"] = wordOf(step);
  put(json, "P", step.P);
  put(json, "Q", step.Q);
  if (step.test) {
    const TestRow& row = kTestRows[static_cast<int>(*step.test)];
    json.update({{"test", row.name}, {"asks", row.asks}, {"outcome", step.outcome}});
  }
  if (step.verdict) json["verdict"] = nameOf(*step.verdict);
  put(json, "behind", step.behind);
  put(json, "in_front", step.inFront);
  if (step.cell >= 0) json["cell"] = step.cell;
  if (!step.text.empty()) json["text"] = step.text;
  return json;
}

bool isRunFile(const std::string& file) {
  const std::string text = readTextFile(file, kMostBytes);
  return text.find("\"event\"") != text.npos;
}

RunFile::RunFile(const std::string& file) : name_{file}, text_{readTextFile(file, kMostBytes)} {
  forEachJsonLine(std::string_view{text_}.substr(0, text_.find('\n')), name_, kExample,
                  [&](const Json& json, int) {
                    if (json.contains("size")) size_ = pictureSizeOf(json["size"]);
                    if (json.contains("scene")) scene_ = textOf(json, "scene");
                  });
}

bool RunFile::isOf(const std::string& scene) const {
  return scene_.empty() || std::filesystem::path{scene_}.stem() == std::filesystem::path{scene}.stem();
}

std::size_t RunFile::lines() const { return static_cast<std::size_t>(std::ranges::count(text_, '\n')) + 1; }

void RunFile::forEach(const std::function<void(const RunStep&)>& use) const {
  forEachJsonLine(text_, name_, kExample, [&](const Json& json, int line) {
    const auto word = json.find("event");
    if (word != json.end() && (*word == "run" || *word == "summary")) return;
    RunStep step = stepOf(json);
    step.line = line;
    use(step);
  });
}

std::string Hidden::text() const {
  return counted(samples, "sample") + ", such as " + std::to_string(i) + ',' + std::to_string(j);
}

RunRecord::RunRecord(const Picture& picture, bool all)
    : picture_{picture},
      all_{all},
      tests_{scene(),
             {.width = picture.settings().width, .height = picture.settings().height, .textbook = true}} {
  const Regions regions{scene()};
  for (int f = 0; f < static_cast<int>(scene().faces.size()); ++f) {
    const SnappedFace& face = scene().faces[f];
    Part& whole = parts_.emplace_back(Fragment{f}, Region{}, extentsOf(scene(), face));
    regions.outline(face, whole.region);
  }
}

Hidden RunRecord::hidden(int P, int Q) const {
  Hidden found;
  if (!parts_[P].extents.box.overlaps(parts_[Q].extents.box)) return found;
  const int width = picture_.settings().width, height = picture_.settings().height;
  std::map<int, std::vector<Columns>> rows;
  forEachSpan(scene(), sorted_, parts_[P].fragment, width, height, [&](int row, int from, int to) {
    rows[row].push_back({from, to});
  });
  const ScreenPlane &p = scene().planes[face(P).plane], &q = scene().planes[face(Q).plane];
  const int ofP = parts_[P].fragment.face, ofQ = parts_[Q].fragment.face;
  const auto add = [&](int i, int row) {
    if (found.samples++ == 0) found.i = i, found.j = row;
    if (!found.rows.empty() && found.rows.back().row == row && found.rows.back().to == i)
      ++found.rows.back().to;
    else
      found.rows.push_back({row, i, i + 1});
  };
  forEachSpan(scene(), sorted_, parts_[Q].fragment, width, height, [&](int row, int from, int to) {
    const auto at = rows.find(row);
    if (at == rows.end()) return;
    for (const Columns& columns : at->second)
      for (int i = std::max(from, columns.from); i < std::min(to, columns.to); ++i)
        if (nearer(p, q, i, row) > 0 && checkOf(scene(), ofQ, ofP, i, row) == SampleCheck::Wrong) add(i, row);
  });
  return found;
}

void RunRecord::take(int P) {
  if (!marked_.empty() && marked_.back() == P) return;
  add({.kind = Event::Kind::Take, .P = P});
  marked_ = {P};
}

void RunRecord::add(const Event& event) {
  if (all_ || event.kind == Event::Kind::Split) sorted_.events.push_back(event);
}

void RunRecord::move(int P, int Q) {
  // A marked Q would be marked twice: then the moves begin anew.
  if (std::ranges::find(marked_, Q) != marked_.end()) marked_.clear();
  take(P);
  add({.kind = Event::Kind::Move, .P = P, .Q = Q});
  marked_.push_back(Q);
}

void RunRecord::paint(int P) {
  take(P);
  add({.kind = Event::Kind::Paint, .P = P});
  sorted_.fragments.push_back(parts_[P].fragment);
  marked_.pop_back();
}

int RunRecord::cut(int of, int by) {
  const PairTests::Parts pieces = tests_.split(shape(of), shape(by));
  add({.kind = Event::Kind::Split, .P = of, .Q = by});
  marked_.erase(std::ranges::find(marked_, of), marked_.end());
  const PixelArea all{0, 0, picture_.settings().width, picture_.settings().height};
  for (const Region* region : {&pieces.behind, &pieces.front}) {
    const Extents extents = extentsOf(scene(), face(of), *region, parts_[of].extents);
    const int index = parts_[of].fragment.face;
    enterPiece(sorted_, {index, of}, *region, rowsOf(extents.box, all, false));
    parts_.push_back({{index, static_cast<int>(sorted_.pieces.size()) - 1}, *region, extents});
  }
  return parts() - 2;
}

void RunRecord::restore(State state) {
  parts_.resize(parts_.size() - (sorted_.pieces.size() - state.pieces));
  sorted_.events.resize(state.events);
  sorted_.fragments.resize(state.fragments);
  sorted_.pieces.resize(state.pieces);
  sorted_.cuts.resize(state.cuts);
  marked_ = std::move(state.marked);
}

NamedRun::NamedRun(const Picture& picture, const SnappedScene& named, bool all)
    : record{picture, all},
      fragments_{picture.scene().mesh, record.scene(), record.sorted()},
      named_{named},
      faces_{picture.scene().mesh.faceCount()} {
  std::vector<int> list;
  for (int f = 0; f < record.parts(); ++f) partsOf_[record.face(f).number].push_back(f), list.push_back(f);
  std::ranges::stable_sort(list, {}, [&](int f) { return record[f].extents.zFar; });
  record.begin(std::move(list));
}

int NamedRun::add(Polygon polygon) {
  constexpr int kMost = 2'000'000;  // half a gigabyte
  if (polygons() == kMost) throw std::runtime_error{"more than " + grouped(kMost) + " polygons and pieces"};
  polygonOf_.resize(record.parts(), -1);
  for (const int part : polygon.parts) polygonOf_[part] = polygons();
  polygons_.push_back(std::move(polygon));
  return polygons() - 1;
}

std::string NamedRun::nameOfFace(int face) const {
  const std::string number = "face " + std::to_string(face);
  const auto parts = partsOf_.find(face);
  if (parts == partsOf_.end() || parts->second.size() > 1) return number;
  const std::string part = fragments_.part(parts->second[0]);
  return number + (part.empty() ? "" : " " + part);
}

int NamedRun::find(const RunPolygon& named) {
  const bool isFace = named.name.empty();
  if (const auto at = known(named).find(named.id); at != known(named).end()) return at->second;
  if (named.id < 0 || named.id >= (isFace ? faces_ : std::ssize(named_.faces))) return -1;
  const int id = static_cast<int>(named.id);
  Polygon made{"", isFace ? id : named_.faces[id].number};
  if (const auto parts = partsOf_.find(made.face); parts != partsOf_.end()) made.parts = parts->second;
  made.name = made.parts.size() > 1 && !isFace ? named.name : nameOfFace(made.face);
  if (!isFace) {  // one of the parts: the one with as many before it
    int before = 0;
    while (before < id && named_.faces[id - before - 1].number == made.face) ++before;
    made.parts = before < std::ssize(made.parts) ? std::vector{made.parts[before]} : std::vector<int>{};
  }
  return known(named)[named.id] = add(std::move(made));
}

int NamedRun::polygon(const RunPolygon& named) {
  if (const int polygon = find(named); polygon >= 0) return polygon;
  return known(named)[named.id] = add({.name = "polygon " + std::to_string(named.id),
                                       .face = -1 - polygons(),
                                       .state = Polygon::State::Unknown});
}

int NamedRun::addPiece(int P, const RunPolygon& named, std::vector<int> parts) {
  const bool isNumber = named.name.empty();
  const int face = polygons_[P].face;
  return known(named)[named.id] = add({.name = isNumber ? "piece " + std::to_string(named.id) +
                                                              (face < 0 ? "" : " of " + nameOfFace(face))
                                                        : named.name,
                                       .face = face,
                                       .parts = std::move(parts),
                                       .own = isNumber ? std::optional{named.id} : std::nullopt});
}

void NamedRun::split(const RunStep& s, Step& step) {
  const std::vector<int> whole = polygons_[step.P].parts, by = polygons_[step.Q].parts;
  std::array<std::vector<int>, 2> parts;
  if (polygons_[step.P].state == Polygon::State::Waiting && !by.empty() && step.P != step.Q) {
    for (const int part : whole) {
      if (record.crosses(part, by[0])) {
        const int first = record.cut(part, by[0]);
        parts[0].push_back(first), parts[1].push_back(first + 1);
        continue;
      }
      record.add({.kind = Event::Kind::Impossible, .P = part, .Q = by[0]});
      parts[record.tests().signsOver(record.shape(part), record.shape(by[0])).positive].push_back(part);
    }
  } else if (!whole.empty()) {
    record.take(whole[0]);
    if (polygons_[step.P].state == Polygon::State::Waiting) parts[0] = whole;
  }
  for (const int k : {0, 1}) {
    const RunPolygon& named = k == 0 ? s.behind : s.inFront;
    if (const int before = find(named); before >= 0 && polygons_[before].state != Polygon::State::Unknown)
      step.before[k] = before;
    step.pieces[k] = addPiece(step.P, named, std::move(parts[k]));
  }
}

NamedRun::Step NamedRun::step(const RunStep& s, const std::function<void(const Step&)>& before) {
  if (!s.kind && !s.marks) return {};
  Step step{polygon(s.P)};
  if (s.Q.id != RunPolygon::kNone) step.Q = polygon(s.Q);
  before(step);
  if (s.marks) return step;
  const std::vector<int> p = polygons_[step.P].parts,
                         q = step.Q < 0 ? std::vector<int>{} : polygons_[step.Q].parts;
  const bool shows = !p.empty() && (step.Q < 0 || (!q.empty() && step.P != step.Q));
  switch (*s.kind) {
    case Event::Kind::Take:
      if (!shows) break;
      if (record.marked() == std::vector{p[0]} && !record.sorted().events.empty())
        record.add({.kind = *s.kind, .P = p[0]});  // again, with no other mark to lose
      record.take(p[0]);
      break;
    case Event::Kind::Compare:
      if (shows) record.add({.kind = *s.kind, .test = *s.test, .verdict = s.said(), .P = p[0], .Q = q[0]});
      break;
    case Event::Kind::Move:
      if (shows) record.move(p[0], q[0]);
      break;
    case Event::Kind::Paint:
      for (const int part : p) record.paint(part);
      break;
    case Event::Kind::Split:
      split(s, step);
      break;
    default:  // the contact of a cycle changes marks, which are the program's own
      if (shows && *s.kind != Event::Kind::Void) record.add({.kind = *s.kind, .P = p[0], .Q = q[0]});
      break;
  }
  Polygon& P = polygons_[step.P];
  if (P.state == Polygon::State::Waiting && (s.kind == Event::Kind::Paint || s.kind == Event::Kind::Split))
    P.state = s.kind == Event::Kind::Paint ? Polygon::State::Painted : Polygon::State::Split, P.line = s.line;
  lines_.resize(record.sorted().events.size(), s.line);
  return step;
}

}  // namespace xnewell
