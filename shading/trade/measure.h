#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "shading/laboratory/ground_truth.h"
#include "shading/picture/picture_cache.h"
#include "shading/trade/trade.h"

namespace xnewell {

/// The stage times of several runs of one way.
class Stages {
 public:
  void add(const StageTimes& times) { all_.push_back(times); }
  [[nodiscard]] StageTimes medians() const;

 private:
  std::vector<StageTimes> all_;
};

/// What one run of a configuration tells.
struct Glance {
  double ms = 0;      ///< of the processor
  StageTimes stages;  ///< their sum is `ms`
  double rms = 0;     ///< the error of the intensity after the table; infinite if there is no picture
};

/// Measures configurations of one scene: their errors on the user's view and on other views, and what they
/// cost. It keeps the scene with each number of divisions, and the references. Of those that no picture's own
/// polygons are, it keeps only the faces that show: a scene may have millions, and there are four views.
/// Tests put other times in the place of those of this machine.
class Measure {
 public:
  /// @throws ViewError if the set-up has no picture
  Measure(const Shared<Scene>& scene, const PictureSettings& settings);
  virtual ~Measure() = default;
  Measure(const Measure&) = delete;
  Measure& operator=(const Measure&) = delete;

  [[nodiscard]] const Picture& asked() const { return asked_; }
  [[nodiscard]] Configuration askedConfiguration() const {
    return {asked_.settings(), asked_.scene().divisions, {}};
  }
  [[nodiscard]] int referenceDivisions() const { return finestDivisions(asked_.scene()); }
  /// How far the reference's polygons are from the patches.
  [[nodiscard]] std::optional<PatchDistance> referenceOff() const {
    return distanceFromPatches(*here_.reference);
  }
  [[nodiscard]] int otherViews() const { return static_cast<int>(others_.size()); }

  /// Why there is no such picture; "" if there is one.
  [[nodiscard]] std::string refusal(const Configuration& configuration);
  /// All errors, and all costs but the times. Precondition: no refusal().
  [[nodiscard]] Measured whole(const Configuration& configuration) { return measured(configuration, true); }
  /// The same without what only a closer look needs: colours, distances.
  [[nodiscard]] virtual Measured brief(const Configuration& configuration) {
    return measured(configuration, false);
  }
  /// One picture of the user's view, with its error. The time is the least of up to nine runs if they are
  /// short.
  [[nodiscard]] virtual Glance glance(const Configuration& configuration);
  /// Makes the picture as if it were the first. Returns the processor's time in milliseconds.
  virtual double run(const Configuration& configuration, Stages& stages);

 private:
  /// A view: its camera, and what it should show.
  struct SeenFrom {
    CameraSettings camera;
    std::shared_ptr<const Reference> reference;
  };
  [[nodiscard]] Measured measured(const Configuration& configuration, bool whole);
  [[nodiscard]] Picture painted(const Configuration& configuration, const CameraSettings& camera);
  [[nodiscard]] const Shared<Scene>& scene(int divisions);
  /// The polygons of a number of divisions, from the camera of a view.
  struct Polygons {
    std::shared_ptr<const PolygonGroundTruth> view;
    std::optional<std::optional<PatchDistance>> off;  ///< nothing as long as nobody asked for it
  };
  [[nodiscard]] Polygons& polygons(int divisions, const SeenFrom& seen, const Picture& picture);
  /// The RMS error of a picture's intensity after the table. For the intensity alone, the reference may stand
  /// for the polygons.
  [[nodiscard]] static double rmsOf(const Picture& picture, const SeenFrom& seen);
  /// `keepsFaces` if the reference may stand for the polygons of the set-up in every respect.
  [[nodiscard]] SeenFrom seenFrom(const CameraSettings& camera, const PictureSettings& settings,
                                  bool keepsFaces);

  std::map<int, Shared<Scene>> scenes_;  ///< by divisions
  FineScene fine_;
  Picture asked_;  ///< as it is seen (Picture::onlyShown())
  SeenFrom here_;
  std::vector<SeenFrom> others_;
  std::map<std::pair<int, const SeenFrom*>, Polygons> polygons_;  ///< by divisions and view
};

}  // namespace xnewell
