#include "shading/figure/mark_strokes.h"

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <optional>
#include <utility>

#include "geometry/view/clip.h"
#include "shading/figure/edge_strokes.h"

namespace xnewell {

namespace {

/// Puts places of the world into the snapped scene.
class OnScreen {
 public:
  explicit OnScreen(const Picture& picture)
      : view_{picture.surfaces().view},
        rotation_{vrcRotation(view_)},
        screenFromVrc_{screenFromCanonical(view_, picture.settings().width, picture.settings().height) *
                       canonicalFromVrc(view_)},
        planes_{clipPlanes(frontDepth(view_, picture.settings().width), kMaxPicture)},
        scale_{kGrid, kGrid, std::ldexp(double{kGrid}, -picture.snapped().zShift)} {}

  static constexpr std::size_t kBackPlane = 1;
  /// The part of a line in front of the eye and near the page.
  [[nodiscard]] std::optional<std::pair<glm::dvec3, glm::dvec3>> line(const glm::dvec3& A,
                                                                      const glm::dvec3& B) const {
    const glm::dvec4 a = homogeneous(A), b = homogeneous(B);
    double from = 0, to = 1;
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      if (k == kBackPlane) continue;  // it lies right behind the faces unless the user gives it
      const ClipPlane& plane = planes_[k];
      const double atA = glm::dot(plane, a), atB = glm::dot(plane, b);
      if (atA < 0 && atB < 0) return {};
      if (atA < 0) from = std::max(from, atA / (atA - atB));
      if (atB < 0) to = std::min(to, atA / (atA - atB));
    }
    if (from > to) return {};
    return std::pair{snapped(a + from * (b - a)), snapped(a + to * (b - a))};
  }

 private:
  [[nodiscard]] glm::dvec4 homogeneous(const glm::dvec3& p) const {
    return screenFromVrc_ * glm::dvec4{rotation_ * (p - view_.vrp), 1.0};
  }
  [[nodiscard]] glm::dvec3 snapped(const glm::dvec4& p) const { return glm::dvec3{p} / p.w * scale_; }

  ViewSpec view_;
  glm::dmat3 rotation_;
  glm::dmat4 screenFromVrc_;
  std::array<ClipPlane, 6> planes_;
  glm::dvec3 scale_;
};

}  // namespace

void addMarks(const Picture& picture, VectorFigure& figure) {
  const SceneMarks& marks = picture.scene().marks;
  if (marks.empty()) return;
  const OnScreen screen{picture};
  const HidingFaces faces{picture.snapped(), figure.width, figure.height};
  figure.strokes = edgeStrokes(picture.snapped(), faces, marks.edges);
  for (FigureStroke& stroke : figure.strokes) stroke.color = figureColorOf(marks.edgeColor);
  for (const SceneLine& line : marks.lines) {
    FigureStroke seen{
        figureColorOf(line.color), static_cast<int>(std::lround(line.width * kFigureSteps)), false, {}};
    FigureStroke unseen = seen;
    unseen.dashed = true;
    for (std::size_t k = 1; k < line.points.size(); ++k)
      if (const auto part = screen.line(line.points[k - 1], line.points[k]))
        addLine(faces, part->first, part->second, seen, unseen);
    if (marks.edges == ModelEdges::All && !unseen.lines.empty()) figure.strokes.push_back(std::move(unseen));
    if (!seen.lines.empty()) figure.strokes.push_back(std::move(seen));
  }
  for (const SceneLabel& label : marks.labels) {
    const auto at = screen.line(label.at, label.at);
    if (!at || faces.hides(at->first)) continue;
    const glm::dvec3 steps = at->first * (static_cast<double>(kFigureSteps) / kGrid);
    figure.texts.push_back({{static_cast<int>(std::lround(steps.x)), static_cast<int>(std::lround(steps.y))},
                            figureColorOf(label.color),
                            static_cast<int>(std::lround(label.size * kFigureSteps)),
                            label.text});
  }
}

}  // namespace xnewell
