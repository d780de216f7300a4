#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "shading/scene/json_node.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// What a scene file adds to its objects for figures only: lines and words that have a place in space.

struct SceneLine {
  std::vector<glm::dvec3> points;
  glm::dvec3 color{0};
  double width = 1;  ///< in pixels
};
struct SceneLabel {
  std::string text;  ///< UTF-8, of printable characters of Latin-1
  glm::dvec3 at{0};  ///< where it begins, on its base line
  glm::dvec3 color{0};
  double size = 12;  ///< of the font, in pixels
};
struct SceneMarks {
  std::vector<SceneLine> lines;
  std::vector<SceneLabel> labels;
};

/// Reads "lines" and "labels", in the file's units. @throws ParseError
[[nodiscard]] SceneMarks readMarks(const Node& root);

/// Those of the file that a scene came from, in the units of its mesh; none if that is no scene file.
/// @throws as readSceneFile()
[[nodiscard]] SceneMarks marksOf(const Scene& scene);

}  // namespace xnewell
