#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "x11/sides/sides_page.h"
#include "x11/window/window_view.h"

namespace xnewell {

/// Two setups of the scene beside each other: A is the window's, B is kept here. Both use the size and the
/// camera of A. If a setting of A is changed elsewhere and both had the same value, it changes in B too.

/// Two setups that are worth comparing.
struct PairRow {
  std::string_view name;
  Unlike shows;
  void (*set)(PictureSettings& A, PictureSettings& B);  ///< both are equal to A before
};
extern const std::array<PairRow, 4> kPairs;

class SideBySideView : public WindowView {
 public:
  /// All that is passed must outlive it. The screen has cells for `most` colours.
  SideBySideView(Host& host, std::function<Subject()> subject, std::function<int()> most)
      : WindowView{host}, subject_{std::move(subject)}, most_{std::move(most)} {}

  /// The controls change the setup that has the focus, A or B; a click on a caption sets it.
  [[nodiscard]] Controls controls() override;
  [[nodiscard]] KeyTable ownKeys() override;
  void enter() override {
    joins_ = true;
    if (host_.setup().picture.light.mistake != Mistake::None) kind_ = Unlike::Intensity;
  }
  void leave() override;
  [[nodiscard]] Rect picture(const Layout& at) const override { return layoutOfSides(at.body).A; }
  [[nodiscard]] bool late(const Setup& setup) const override;
  void draw(Painter paint, const DrawContext& context) override;
  [[nodiscard]] std::string status() const override { return status_; }
  [[nodiscard]] std::string aside() const override { return aside_; }
  [[nodiscard]] std::vector<std::string> report() const override { return words_; }
  [[nodiscard]] const CellUse* use() const override { return &use_; }
  [[nodiscard]] const OwnColors* colors() const override { return &colors_; }

  /// Puts B beside the window's setup, and compares this.
  void put(const Setup& B, Unlike kind);
  /// Begins anew: B is the window's setup with these settings over it. None: with an order worth comparing,
  /// beside that of the window when the view is opened.
  void begin(const std::optional<std::vector<Override>>& own, Unlike kind);
  /// The settings of B that differ from those of A.
  [[nodiscard]] std::vector<Override> ownOfB() const;
  [[nodiscard]] Unlike kind() const { return kind_; }
  /// B as it would be drawn beside this A.
  [[nodiscard]] Setup beside(const Setup& A) const;
  [[nodiscard]] char focus() const { return focus_; }

 private:
  enum class Changed { A, B, Both };
  /// A change made here: A after it, and B before it.
  struct Before {
    Changed changed;
    char control;
    Setup A, B;
  };
  /// Several changes of one control in a row count as one, as in the window.
  void remember(Changed changed, char control, const Setup& A);
  /// B takes over what has changed in A since the last drawing: camera and size, and settings that both
  /// shared.
  void follow(const Setup& A);
  /// Changes the setup that has the focus.
  void changeFocused(char control, const std::function<void(Setup&)>& edit);
  void nextPlace();
  void nextKind();
  /// The letters that a click on a part of the page presses.
  [[nodiscard]] std::vector<std::pair<char, Rect>> buttons() const;
  void swap(const Setup& A);
  void nextPair(const Setup& A);
  /// Undoes the last change made here. Returns false if the window must undo a change of A.
  bool undo(const Setup& A);
  /// The picture of B, painted; a setup that cannot be drawn is undone and told.
  [[nodiscard]] Picture makeB(const DrawContext& context);
  /// The measurements of a picture with these settings.
  struct Measured {
    std::optional<PictureSettings> of = {};
    Difference errors = {};  ///< beside the truth
    BestTime time = {};
  };
  void measure(const Picture& A, const Picture& B);
  /// Where the truth about one of the two pictures is kept: both have one if their lights and surfaces agree.
  [[nodiscard]] CachedGroundTruth& truthOf(const Picture& picture);

  std::function<Subject()> subject_;
  std::function<int()> most_;
  std::optional<Setup> a_, b_;  ///< both setups at the last drawing
  char focus_ = 'B';
  Unlike kind_ = Unlike::Face;
  int place_ = 0;
  bool blinking_ = false;
  std::size_t pair_ = 0;        ///< index of the next of kPairs
  bool joins_ = true;           ///< the view was entered: A may have been changed elsewhere
  std::vector<Before> before_;  ///< changes made here, the oldest first

  std::optional<PictureCache> picturesB_;
  // The state of the last drawing.
  struct Shown {
    std::optional<Setup> b;
    Unlike kind;
    int place;
    bool blinking;
    char focus;
    bool operator==(const Shown&) const = default;
  };
  [[nodiscard]] Shown told() const { return {b_, kind_, place_, blinking_, focus_}; }
  std::optional<Shown> drawn_;
  Measured measuredA_, measuredB_;
  std::array<CachedGroundTruth, 2> truths_;
  /// The pictures that were shown before they were measured, and whether the next drawing measures them.
  std::optional<std::pair<PictureSettings, PictureSettings>> announced_;
  bool owes_ = false;
  std::optional<std::pair<Unlike, std::pair<PictureSettings, PictureSettings>>> placed_;
  std::vector<DifferingPlace> places_;
  SidesLayout at_;
  CellUse use_;
  OwnColors colors_{};
  std::string status_, aside_;
  std::vector<std::string> words_;
  bool noIntensities_ = false, coarse_ = false;
  bool slow_ = false;  ///< B takes long to draw while something is dragged
};

}  // namespace xnewell
