#pragma once

#include <cstddef>
#include <vector>

#include "shading/laboratory/true_surface.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// The settings of a picture without its short cuts, and without what only painting needs: nothing is shaded,
/// and no cells are chosen.
[[nodiscard]] PictureSettings trueSettings(const PictureSettings& settings);

/// What each sample of a picture should see: the face that is nearest there, and the place on the true
/// surface. It has the scene, the camera and the size of a picture, and none of its short cuts (Role in
/// settings.h). visibleFaces() finds the faces on the grid of the screen; it keeps back faces.
class TrueView {
 public:
  explicit TrueView(const Picture& of);

  /// Forgets the faces that no sample shows, which saves most of the memory. Such a view cannot tell whether
  /// a face that it does not show may touch the one that it shows (Comparison::wrongFaces()).
  void keepShownOnly();

  /// The picture of the same view without short cuts, which is not painted. faces() are among its faces.
  [[nodiscard]] const Picture& picture() const { return picture_; }
  /// Indices into picture().snapped().faces, row by row; kNothing where no face shows.
  [[nodiscard]] const std::vector<int>& faces() const { return faces_; }
  /// The place that a sample shows. Precondition: a face shows there.
  [[nodiscard]] SurfacePlace place(std::size_t sample) const;
  [[nodiscard]] const TrueSurface& surface() const { return surface_; }

 private:
  Picture picture_;
  std::vector<int> faces_;
  TrueSurface surface_;
};

}  // namespace xnewell
