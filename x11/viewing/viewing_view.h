#pragma once

#include <functional>
#include <optional>
#include <string>

#include "x11/viewing/outside_view.h"
#include "x11/viewing/viewing_page.h"
#include "x11/window/window_view.h"

namespace xnewell {

/// Where the parts of view 9 are.
struct ViewingLayout {
  Rect outside;
  std::array<Rect, kViewStages.size()> small;
  Rect table;
  Rect column;        ///< of the controls and what is below them
  int pitch = 16;     ///< from line to line
  int rowPitch = 22;  ///< from control to control
  bool narrow = false;
};
[[nodiscard]] ViewingLayout layoutOfViewing(const Layout& at);

/// View 9: what each stage of the viewing transformation does to the scene, to a vertex and to the light.
class ViewingView : public WindowView {
 public:
  ViewingView(Host& host, std::function<Subject()> subject)
      : WindowView{host}, subject_{std::move(subject)} {}

  /// Begins at a stage, counted from 1 (0: the first), and with a vertex as cornerOf() reads it ("": in the
  /// middle of the picture).
  void begin(int stage, const std::string& vertex);
  [[nodiscard]] int stage() const { return static_cast<int>(stage_) + 1; }
  /// The vertex that was drawn last, "495.1".
  [[nodiscard]] std::string vertex() const { return vertex_ ? textOf(*vertex_) : asked_; }

  [[nodiscard]] Controls controls() override;
  [[nodiscard]] KeyTable ownKeys() override;
  void enter() override { list_.setFocus(std::nullopt); }
  [[nodiscard]] bool grab(int x, int y) override;
  void dragTo(int x, int y) override;
  void drop() override;
  [[nodiscard]] bool zoom(double factor) override;
  void leave() override;

  /// The page has numbers of the picture of view 1.
  [[nodiscard]] Rect picture(const Layout& at) const override { return at.well; }
  [[nodiscard]] bool late(const Setup&) const override { return late_ || list_.late(); }
  void draw(Painter paint, const DrawContext& context) override;
  [[nodiscard]] std::string status() const override { return status_; }
  [[nodiscard]] std::string aside() const override { return aside_; }
  [[nodiscard]] std::vector<std::string> report() const override { return words_; }
  [[nodiscard]] std::optional<int> inspected() const override { return cell_; }

 private:
  /// The camera of the setup, placed once.
  [[nodiscard]] const Camera& camera();
  void choose(int stage);
  void turn(double around, double down);
  /// Chooses the vertex under the pointer.
  void pick(int x, int y);
  void addParts(Controls& all);
  void addHandles(Controls& all);
  /// The pointer is at a place of the drag of this handle, or begins it.
  void dragHandle(ViewHandle handle, const glm::ivec2& pointer);
  /// "PRP n 12.00": the numbers of a handle.
  [[nodiscard]] static std::string nameOf(ViewHandle handle, const Controls& all);
  /// Returns the y below the column's controls.
  int placeControls(const Controls& all, const ViewingLayout& at);

  std::function<Subject()> subject_;
  ViewStage stage_ = ViewStage::World;
  ShownMatrix matrix_ = ShownMatrix::ThisStage;
  OutsideTurn turn_;
  std::optional<FaceCorner> vertex_;
  std::string asked_;  ///< the vertex that the next drawing looks for
  double angle_ = 45;  ///< of the last oblique view
  bool late_ = true;
  struct Placed {
    const Scene* scene;
    CameraSettings settings;
    double aspect;
    Camera camera;
  };
  std::optional<Placed> placed_;
  struct Lit {
    Picture picture;  ///< keeps what `parts` refers to
    Palette palette;
    LitParts parts;
    StagePoints points;
  };
  std::optional<Lit> lit_;
  int made_ = 0;  ///< how often lit_ was made
  StageImages images_;
  // The state of the last drawing.
  Rect outside_{};
  std::array<Rect, kViewStages.size()> small_{}, rows_{};
  const StageImage* image_ = nullptr;  ///< one of images_
  std::shared_ptr<const ViewingStory> story_;
  int faces_ = 0;  ///< of the scene whose vertex it is
  std::vector<HandleAt> handles_;
  std::optional<HandleDrag> drag_;
  std::optional<glm::ivec2> clicked_;
  int unit_ = 1;
  std::optional<int> cell_;
  std::string status_, aside_;
  std::vector<std::string> words_;
};

}  // namespace xnewell
