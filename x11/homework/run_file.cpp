#include "x11/homework/run_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "geometry/files/text_file.h"
#include "shading/diagnose/paint_steps.h"
#include "shading/scene/json_text.h"

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

}  // namespace xnewell
