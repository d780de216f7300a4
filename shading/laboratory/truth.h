#pragma once

#include <optional>

#include "shading/laboratory/reference.h"

namespace xnewell {

/// The scene with finely divided surfaces (finelyDivided()); nothing if the scene's own are as fine.
using FineScene = std::optional<Shared<Scene>>;
[[nodiscard]] FineScene fineSceneOf(const Scene& scene);

/// What a picture should show: the reference of its view on the fine scene of its scene. Eye and window are
/// those of the picture to the last bit. Clipping planes that the user did not give are placed anew, so that
/// they enclose the surfaces. @throws ViewError
[[nodiscard]] Reference referenceOf(const Picture& picture, const FineScene& fine);

/// The truth about a picture. Every error that the program tells, in a number or in a view, is against it.
///
/// What should be seen is the reference of the fine scene, so coarse polygons are a short cut like any other.
/// Which face is the right one is asked of the picture's own polygons, because no other could be painted.
class Truth {
 public:
  /// @throws ViewError if the fine surfaces cannot be pictured
  explicit Truth(const Picture& of) : Truth{of, fineSceneOf(of.scene())} {}
  Truth(const Picture& of, const FineScene& fine);

  [[nodiscard]] const Reference& reference() const { return reference_; }
  /// The true view of the picture's own polygons.
  [[nodiscard]] const TrueView& polygons() const { return polygons_ ? *polygons_ : reference_; }

 private:
  Reference reference_;
  std::optional<TrueView> polygons_;  ///< nothing if the reference has the same polygons
};

/// Keeps the last truth for the next picture. It is made anew when the scene, the view or a setting of the
/// model changes. If only the view changes, the fine surfaces stay.
class LastTruth {
 public:
  [[nodiscard]] const Truth& of(const Picture& picture);

 private:
  std::optional<Picture> of_;  ///< keeps its scene alive, so that its address tells it
  FineScene fine_;
  std::optional<Truth> truth_;
};

}  // namespace xnewell
