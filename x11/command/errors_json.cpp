#include "x11/command/errors_json.h"

namespace xnewell {

namespace {

nlohmann::ordered_json jsonOf(const Spread& spread) {
  return {{"mean", spread.mean},
          {"rms", spread.rootMeanSquare},
          {"p99", spread.p99},
          {"largest", spread.largest}};
}

nlohmann::ordered_json jsonOf(const WorstPlace& place) {
  const auto rgb = [](const glm::dvec3& I) { return nlohmann::ordered_json{I.r, I.g, I.b}; };
  const auto face = [](int number) {
    return number < 0 ? nlohmann::ordered_json{} : nlohmann::ordered_json(number);
  };
  return {{"x", place.x},
          {"y", place.y},
          {"error", place.error},
          {"shows", rgb(place.shown)},
          {"should", rgb(place.due)},
          {"shows_face", face(place.shownFace)},
          {"should_face", face(place.face)}};
}

}  // namespace

nlohmann::ordered_json errorsAsJson(const Errors& errors) {
  nlohmann::ordered_json patches, worst = nlohmann::ordered_json::array();
  if (errors.patches)
    patches = {{"samples", errors.patches->samples},
               {"mean", errors.patches->mean},
               {"largest", errors.patches->largest},
               {"mean_pixels", errors.patches->meanPixels},
               {"largest_pixels", errors.patches->largestPixels}};
  for (const WorstPlace& place : errors.worst) worst.push_back(jsonOf(place));
  return {{"samples", errors.samples},
          {"wrong_faces", errors.wrongFaces},
          {"intensity",
           {{"before_table", jsonOf(errors.beforeTable)}, {"after_table", jsonOf(errors.afterTable)}}},
          {"ciede2000", jsonOf(errors.color)},
          {"distance_to_patches", patches},
          {"blocks_8x8", errors.blocks ? jsonOf(*errors.blocks) : nlohmann::ordered_json{}},
          {"worst", worst}};
}

nlohmann::ordered_json errorsAsJson(const FigureErrors& errors) {
  return {{"samples", errors.samples},
          {"differ", errors.differ},
          {"largest", errors.largest},
          {"ciede2000", jsonOf(errors.figure)},
          {"ciede2000_of_the_picture", jsonOf(errors.picture)}};
}

}  // namespace xnewell
