#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shading/color/images.h"
#include "shading/diagnose/approach.h"
#include "shading/diagnose/handed_in.h"
#include "shading/diagnose/hypothesis.h"
#include "shading/diagnose/other_model.h"
#include "shading/diagnose/other_program.h"

namespace xnewell {

/// How the outlines of a picture that somebody hands in lie beside the right ones.
struct Outlines {
  /// The pixels that both pictures paint over those that either paints, away from outlines. Where the ground
  /// is nearly black a face may be, too, so there only faces where none should be count.
  double overlap = 0;
  /// Pixels with ground where a face should be, or a face where ground should be, although all pixels within
  /// two steps of them should be the same. Other edge rules and corners that are rounded to pixels reach less
  /// far.
  int apart = 0;
  int farthest = 0, i = 0, j = 0;  ///< of these pixels, how far one lies from the right outline, and where

  /// True if more pixels are apart than stray ones.
  [[nodiscard]] bool areOff() const { return apart > kStray; }
  static constexpr int kStray = 20;
};

/// @param faces   what the right picture shows, row by row; kNothing for ground
/// @param ground  the colour of the handed picture where the right one shows ground
/// @param least   with less overlap, only the overlap is told
[[nodiscard]] Outlines outlinesOf(const RgbImage& handed, const std::vector<int>& faces,
                                  std::array<std::uint8_t, 3> ground, double least);

/// Which mistake is it? Somebody's program drew a scene that is known, with settings that are known. For each
/// row of hypothesis.h the other program says what it would show, and the picture is compared with it.
///
/// 1. Samples: pixels whose 3 x 3 neighbours show the same face, and where the orders that the course allows
///    (exact, by mean z, by farthest z) agree. So rules for edges and legal orders do not count.
/// 2. d is the difference in shades; where neighbouring cells are further apart than one step of 255, it is
///    measured in their distance. Where the shade changes from pixel to pixel, one more shade for each of
///    these counts as one: a corner that is rounded to a pixel moves the shades by as much.
/// 3. The cost of a hypothesis is the mean of -log p(d), where p is 97 % a two-sided geometric distribution
///    and 3 % anything. Its width is the best of six.
/// 4. All rows within kClass of the best are a class. If "right" or a row that the course allows is in it and
///    explains the picture, the picture is right.
/// 5. A mistake must explain kInformative of the samples that tell: those where it, or the picture, is not
///    right. That guards against mistakes that are not in the list. With flat shading and one hue, to explain
///    is to show the same stored value, and a mistake must explain kExact of them; elsewhere, edges of other
///    programs leave some slack. kFewTelling samples and kFewFaces faces must tell it, or a third of all
///    faces.
///    No face may speak against it, and where it tells it must be as near to the picture as elsewhere.
/// 6. If the right program does not show the picture exactly, other numbers are searched for, one at a time
///    (numbers.cpp). A number that fits better than all rows is told if several faces tell it from the best
///    of these; one that fits as well as a mistake is told with it, and one that fits as well as what the
///    course allows is a doubt.
/// 7. Outlines that are farther from the right ones than other edge rules and rounded corners may bring them
///    (Outlines) are told; a picture with such outlines is not right.
/// 8. If nothing fits, two rows at once are tried, and after them numbers in small steps.
/// 9. If still nothing fits, or outlines do not, each row of the view places the faces anew (place.cpp). Of a
///    picture that is right, all pixels are looked at: edges tell a shift of less than a pixel, and shades
///    that no face has there may tell a mistake that few samples show.

inline constexpr int kMostSamples = 3000;
inline constexpr double kClass = 0.01, kInformative = 0.9, kInformativeOrder = 0.87;
inline constexpr double kExplainsRight = 0.97;  ///< of the samples, before a picture is called right
inline constexpr double kExact = 0.97;  ///< of the samples that tell, where each value must be the same
/// In a search every sixth sample stands for all, after every 48th has been explained well enough.
inline constexpr std::size_t kThinned = 6, kFew = 48;
inline constexpr double kExplainsFew = 0.85, kExplainsSome = 0.9;
inline constexpr double kOverlap = 0.97;  ///< of the outlines; below it is another scene, camera or size

struct DiagnosedSample {
  int i = 0, j = 0, face = 0;  ///< of the snapped faces
};

/// Outlines: the shades are right, or right with what the course allows, but faces lie elsewhere.
enum class Marking { Right, Allowed, Outlines, Mistake, OneOf, Numbers, Unknown, OtherScene };

/// How well one hypothesis, or two at once, fit a picture.
struct Fit {
  const Hypothesis* first = nullptr;
  const Hypothesis* second = nullptr;      ///< null for one
  std::optional<OtherNumber> number = {};  ///< of first, if that is rowOfNumber()
  double cost = 0;
  double explained = 0;    ///< share of all samples
  int telling = 0;         ///< samples that tell
  double informative = 0;  ///< share of these that it explains
  int faces = 0;           ///< that have those of these samples which it explains
  int against = 0;         ///< faces of whose samples it explains less than half
  /// Shades that it is off by, on the mean of the samples that tell; and of the others, which say how exact
  /// the picture is.
  double off = 0, noise = 0;
  int places = 0;  ///< pairs of a right value and the picture's that the samples that tell have
};

/// Where a mistake shows most.
struct DiagnosedPixel {
  int i = 0, j = 0, face = 0;                          ///< the face's number in the scene
  std::array<double, 3> yours{}, right{}, mistaken{};  ///< values 0 to 255; of one hue only the first
  double NdotL = 0, RdotV = 0;
};

/// What two mistakes show at the pixel that tells them apart best.
struct Parting {
  int i = 0, j = 0, face = 0;  ///< the face's number in the scene; that of the right picture
  /// Values 0 to 255; nothing where no face shows. Of several hues only the first.
  std::optional<double> first, second, right;
  int firstCell = -1, secondCell = -1, rightCell = -1;  ///< -1: no face, or several hues
  double shades = 0;                                    ///< how far the values are apart
  double cells = 0;                                     ///< how far the cells are apart
};

struct Diagnosis {
  Marking verdict = Marking::Unknown;
  std::vector<Fit> found;  ///< the class, each name once, best first; of "right", what it is right with
  std::vector<Fit> all;    ///< all single hypotheses, best first
  std::optional<DiagnosedPixel> pixel;
  /// What fits a picture that is right with a variant as well as that.
  std::vector<Fit> doubts;
  int samples = 0;
  /// Of a right picture: all samples inside faces, those that show another face, and those of another shade.
  int inside = 0, others = 0, strange = 0;
  double exact = 1;      ///< the share of samples with the very value of the right picture
  double brightest = 0;  ///< the share of samples where the picture has the shade of I = 1
  Outlines outlines{.overlap = 1};
  bool isOtherSize = false, isOneColor = false;
  bool isBlack = false;     ///< where faces show that are not
  bool readsCells = false;  ///< the cells of the picture are those of the table
  bool oneHue = true;
};

/// The most pixels of a picture that is diagnosed: it takes some 30 bytes for each.
inline constexpr std::int64_t kMostDiagnosed = std::int64_t{4096} * 4096;
/// Why a scene cannot be diagnosed with these settings; "" if it can.
[[nodiscard]] std::string whyNotDiagnosed(const Scene& scene, const PictureSettings& settings);

/// Diagnoses pictures of one scene. What all pictures share is made once.
class Diagnoser {
 public:
  /// Precondition: whyNotDiagnosed() is "". @throws ViewError; std::invalid_argument if the scene shows too
  /// few samples
  Diagnoser(Scene scene, const PictureSettings& settings);
  Diagnoser(const Diagnoser&) = delete;
  Diagnoser& operator=(const Diagnoser&) = delete;

  [[nodiscard]] Diagnosis operator()(const HandedIn& picture);

  [[nodiscard]] const Picture& picture() const { return picture_; }
  [[nodiscard]] const std::vector<DiagnosedSample>& samples() const { return samples_; }
  /// What a program shows at a sample; nothing where its order shows no face.
  struct Predicted {
    std::array<float, 3> value{};
    float step = 1;
    /// How many values it changes from this sample to the next ones. Corners that are rounded to pixels move
    /// what is interpolated by up to that much.
    float slope = 0;
    std::int16_t cell = -1;
    bool shows = true;

    Predicted() = default;
    explicit Predicted(const ShownHere& shown);
  };
  /// At every `stride`th sample.
  [[nodiscard]] std::vector<Predicted> predicted(const Approach& way, std::size_t stride = 1);
  [[nodiscard]] Approach approachWith(const Hypothesis& first, const Hypothesis* second = nullptr) const;
  [[nodiscard]] Approach approachOf(const Fit& fit) const;
  /// The pixel where the rows of two keys differ most; of several forms of a key the nearest two count.
  /// Nothing if the settings leave no row of a key. (parting.cpp)
  [[nodiscard]] std::optional<Parting> partingOf(std::string_view a, std::string_view b);
  /// The keys of the mistakes that leave a right picture as it is, by their first form.
  [[nodiscard]] std::vector<std::string_view> whatCannotBeSeen();
  /// The whole picture as a program shows it that works in this way.
  [[nodiscard]] RgbImage pictureBy(const Approach& way);

 private:
  /// What a picture has at some samples.
  struct Read {
    std::vector<std::array<std::uint8_t, 3>> value;
    std::vector<std::int16_t> cell;  ///< empty if its cells are not ours
  };
  [[nodiscard]] const std::vector<int>& facesOf(const Approach& way);
  [[nodiscard]] std::size_t indexOf(int i, int j) const {
    return static_cast<std::size_t>(j) * settings_.width + i;
  }
  /// True if all neighbours show what the pixel shows.
  [[nodiscard]] bool isInside(const std::vector<int>& faces, int i, int j) const;
  /// All samples inside faces, by row.
  [[nodiscard]] std::vector<DiagnosedSample> insideFaces();
  void chooseSamples();
  void countOthers(const HandedIn& handed, Diagnosis& d);
  [[nodiscard]] bool isStrange(OtherProgram& program, const Read& yours, const DiagnosedSample& s);
  /// True if a row shows something else than the right picture at some pixels of faces.
  [[nodiscard]] bool differsSomewhere(const Hypothesis& h);
  [[nodiscard]] bool isAnotherFace(OtherProgram& program, const Read& yours, std::size_t k,
                                   const DiagnosedSample& s);
  [[nodiscard]] static Predicted predictedAt(OtherProgram& program, const DiagnosedSample& s, int face);
  [[nodiscard]] std::optional<std::array<std::uint8_t, 3>> groundOf(const HandedIn& picture,
                                                                    const std::vector<int>& faces) const;
  [[nodiscard]] Read read(const HandedIn& picture, std::span<const DiagnosedSample> samples,
                          bool cells) const;
  [[nodiscard]] bool hasOurCells(const HandedIn& picture);
  /// Every `stride`th sample; `other` has no more than these.
  [[nodiscard]] Fit fit(const std::vector<Predicted>& other, std::size_t stride = 1);
  [[nodiscard]] double apart(const Read& yours, std::size_t sample, const Predicted& other) const;
  [[nodiscard]] double apart(const Predicted& a, const Predicted& b) const;
  [[nodiscard]] std::vector<std::optional<Predicted>> insideFaces(const Hypothesis& h);
  [[nodiscard]] double cellsApart(double cell, const Predicted& other) const;
  [[nodiscard]] bool isSame(const Read& yours, std::size_t sample, const Predicted& other) const;
  [[nodiscard]] double tolerance() const;
  [[nodiscard]] bool isTold(const Fit& fit) const;
  [[nodiscard]] bool isContradicted(const Fit& fit) const;
  [[nodiscard]] bool tellsExactly() const;
  /// How well a way explains some samples, if `few` of them say so.
  [[nodiscard]] std::optional<Fit> promising(const std::vector<Predicted>& few, const Approach& way);
  [[nodiscard]] std::vector<OtherNumber> likelyNumbers(bool fine) const;
  [[nodiscard]] std::vector<Fit> numbersThatFit(bool fine);
  [[nodiscard]] bool severalTell(const Fit& number, const Hypothesis& best);
  [[nodiscard]] bool applies(const Hypothesis& h) const;
  [[nodiscard]] const std::vector<Predicted>& known(const Hypothesis& h);
  void decide(Diagnosis& d);
  bool decideByTwo(Diagnosis& d, double best, bool twoMistakes);
  /// A view (place.cpp): places all over the picture, and what shows there.
  struct Seen {
    std::vector<int> face;  ///< kNothing: the ground; kEdge: that is not known
    std::vector<Predicted> shown;
  };
  struct Score {
    double share = 0, overlap = 0;
    int known = 0, counted = 0, faces = 0;  ///< places; those where either picture shows a face; faces
    bool hasGround = false;                 ///< the picture has one colour beside the faces
  };
  static constexpr int kEdge = -2;
  [[nodiscard]] const Seen& seenBy(const Hypothesis& h);
  /// Of every `stride`th place.
  [[nodiscard]] Score scoreOf(const HandedIn& handed, const Seen& seen, const Read& yours,
                              std::size_t stride = 1) const;
  bool decidePlaced(const HandedIn& handed, Diagnosis& d);
  void addWhatShowsNothing(const HandedIn& handed, Diagnosis& d);
  void decideByEdges(const HandedIn& handed, Diagnosis& d);
  void addPixel(Diagnosis& d);

  Picture picture_;
  PictureSettings settings_;
  OtherModel model_;
  std::map<PaintWay, std::vector<int>> faces_;
  std::pair<const ViewMistake*, std::vector<int>> viewed_;  ///< the last view
  std::vector<DiagnosedSample> places_;                     ///< all over the picture
  std::map<const Hypothesis*, Seen> seen_;
  std::vector<DiagnosedSample> samples_;
  int facesSampled_ = 0;
  std::map<const Hypothesis*, std::vector<Predicted>> known_;
  std::map<std::pair<const Hypothesis*, const Hypothesis*>, std::vector<Predicted>> two_;  ///< few
  /// By number, few; of the second, in small steps.
  std::vector<std::pair<OtherNumber, std::vector<Predicted>>> numbers_, fineNumbers_;
  Read asHanded_;  ///< at samples_
  std::array<std::uint8_t, 3> ground_{};
};

}  // namespace xnewell
