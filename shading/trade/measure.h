#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shading/laboratory/ground_truth.h"
#include "shading/picture/picture.h"
#include "shading/picture/picture_cache.h"
#include "shading/trade/timing.h"
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

/// Measures configurations of one scene: their errors on the user's view and on other views, and what they
/// cost. It keeps the scene with each number of divisions, and the references. Of those that no picture's own
/// polygons are, it keeps only the faces that show: a scene may have millions, and there are four views.
class Measure {
 public:
  /// @throws ViewError if the set-up has no picture
  Measure(const Shared<Scene>& scene, const PictureSettings& settings);
  ~Measure() = default;
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
  [[nodiscard]] Measured brief(const Configuration& configuration) { return measured(configuration, false); }
  /// One picture of the user's view: the RMS error, and the least time of up to nine runs if they are short.
  /// Nothing if there is no such picture.
  [[nodiscard]] std::optional<Measured> glance(const Configuration& configuration);
  /// Makes the picture as if it were the first. Returns the processor's time in milliseconds.
  double run(const Configuration& configuration, Stages& stages);

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

/// What an item of requiredBy() costs is measured in one of two ways. Either the picture is made of another
/// scene, or with other settings, which do not require the item: the difference in time is its cost. Or the
/// item is a step of its own, which is done alone.
struct ItemRow {
  std::string_view name;  ///< as in Required
  /// Changes the scene and the settings so that the item is not required, and as little else as possible.
  void (*without)(Scene& scene, PictureSettings& settings) = nullptr;
  /// The step alone, if `without` is null.
  std::function<void()> (*alone)(const Picture& picture) = nullptr;
};
/// One row for each item.
[[nodiscard]] const std::vector<ItemRow>& itemRows();

/// The picture as it is and without one item each run in turn. The costs do not add up to the picture's time:
/// without light, for example, there are no highlights either.
[[nodiscard]] std::vector<ItemCost> itemCostsOf(const Picture& picture, const TimingLimits& limits,
                                                const TimingProgress& goOn = {});

}  // namespace xnewell
