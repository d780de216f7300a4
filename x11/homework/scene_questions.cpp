#include <algorithm>
#include <cmath>

#include "depthsort/depth_sort.h"
#include "depthsort/oracle.h"
#include "depthsort/order.h"
#include "depthsort/pair_tests.h"
#include "depthsort/record/explain.h"
#include "shading/diagnose/face_images.h"
#include "shading/picture/picture_cache.h"
#include "x11/drawing/wording.h"
#include "x11/homework/questions.h"

namespace xnewell {

/// Questions about a scene: what shows, what hides what, and what the depth sort does.

namespace {

using MaybeOne = std::optional<ExamQuestion>;

PictureSettings unsorted(PictureSettings settings) {
  settings.order = Order::Unsorted, settings.adapt = 0;
  return settings;
}

std::string sizeOf(const QuestionScene& s) {
  return sizeText(s.picture.settings().width, s.picture.settings().height);
}

int numberOf(const QuestionScene& s, int face) { return s.picture.snapped().faces[face].number; }

struct Spot {
  int i = 0, j = 0, face = kNothing;
};
/// A pixel that shows a face.
std::optional<Spot> rolledSpot(Dice& dice, const QuestionScene& s) {
  const PictureSettings& settings = s.picture.settings();
  for (int tries = 0; tries < 400; ++tries) {
    Spot spot{rolled(dice, 0, settings.width - 1), rolled(dice, 0, settings.height - 1)};
    spot.face = s.nearest[static_cast<std::size_t>(spot.j) * settings.width + spot.i];
    if (spot.face != kNothing) return spot;
  }
  return std::nullopt;
}

MaybeOne nearestFace(Dice& dice, const QuestionScene& s) {
  const auto spot = rolledSpot(dice, s);
  if (!spot) return std::nullopt;
  ExamQuestion q{.kind = "nearest-face", .given = {{"i", double(spot->i)}, {"j", double(spot->j)}}};
  q.number = numberOf(s, spot->face);
  q.text = "In the picture of " + s.name + " at " + sizeOf(s) + ", which face is nearest at pixel " +
           std::to_string(spot->i) + "," + std::to_string(spot->j) +
           "? Faces are numbered from 0 as the scene lists them.";
  q.solution = "`xnewell explain " + s.name + " " + std::to_string(spot->i) + "," + std::to_string(spot->j) +
               "` lists the faces there: face " + std::to_string(numberOf(s, spot->face)) +
               " is the nearest.";
  return q;
}

MaybeOne wrongSort(Dice& dice, const QuestionScene& s) {
  const PictureSettings& settings = s.picture.settings();
  std::vector<std::size_t> wrong;
  for (std::size_t k = 0; k < s.nearest.size(); ++k)
    if (s.nearest[k] != s.byMeanZ[k]) wrong.push_back(k);
  if (wrong.empty()) return std::nullopt;
  const std::size_t at = wrong[static_cast<std::size_t>(rolled(dice, 0, static_cast<int>(wrong.size()) - 1))];
  const int i = static_cast<int>(at % static_cast<std::size_t>(settings.width)),
            j = static_cast<int>(at / static_cast<std::size_t>(settings.width));
  ExamQuestion q{.kind = "wrong-sort", .given = {{"i", double(i)}, {"j", double(j)}}};
  q.number = numberOf(s, s.byMeanZ[at]);
  q.text = "The faces of " + s.name +
           " are sorted by the mean z of their corners and painted, farthest first, in a picture of " +
           sizeOf(s) + ". Face " + std::to_string(numberOf(s, s.nearest[at])) + " is nearest at pixel " +
           std::to_string(i) + "," + std::to_string(j) + ". Which face shows there?";
  q.solution = "Face " + std::to_string(numberOf(s, s.byMeanZ[at])) +
               " has a nearer mean, so it is painted later and hides it.";
  return q;
}

MaybeOne cutsOfTheSort(Dice&, const QuestionScene& s) {
  ExamQuestion q{.kind = "cuts", .given = {}};
  q.number = static_cast<double>(s.sorted.statistics.splits);
  q.text = "How many cuts does the textbook's depth sort make for " + s.name + " in a picture of " +
           sizeOf(s) + "?";
  q.solution =
      "`xnewell trace " + s.name + "` counts them: " + counted(s.sorted.statistics.splits, "cut") + ".";
  return q;
}

/// No pair is asked that rounding alone keeps from an earlier test: a corner that two faces share may miss
/// the snapped plane of the other.
MaybeOne settlingTest(Dice& dice, const QuestionScene& s) {
  std::vector<const Event*> compared;
  const int faces = static_cast<int>(s.picture.snapped().faces.size());
  const Explainer explainer{s.picture.scene().mesh, s.picture.snapped(), s.sorted, true};
  for (const Event& e : s.sorted.events)
    if (e.kind == Event::Kind::Compare && e.P < faces && e.Q < faces && e.test != Test::SamePlane &&
        std::ranges::none_of(explainer.testsMade(e),
                             [&](Test test) { return explainer.failsByRounding(e, test); }))
      compared.push_back(&e);
  if (compared.empty()) return std::nullopt;
  const Event& e =
      *compared[static_cast<std::size_t>(rolled(dice, 0, static_cast<int>(compared.size()) - 1))];
  ExamQuestion q{.kind = "settling-test", .given = {{"P", double(e.P)}, {"Q", double(e.Q)}}};
  q.text = "The depth sort compares P = face " + std::to_string(numberOf(s, e.P)) + " of " + s.name +
           " with Q = face " + std::to_string(numberOf(s, e.Q)) + " in a picture of " + sizeOf(s) +
           ", by tests 1, 2, 3, 4, 5, 3', 4' and 6 in this order. Which test settles the pair?";
  const auto nameOfTest = [](const TestRow& row) {
    return "test " + std::string{row.name} + ": " + std::string{row.asks};
  };
  for (const TestRow& row : kTestRows) {
    if (row.id == e.test) q.right = q.choices.size();
    if (row.id != Test::SamePlane) q.choices.push_back(nameOfTest(row));
  }
  q.solution = "It is test " + std::string{kTestRows[static_cast<std::size_t>(e.test)].name} +
               (q.right == 0 ? "." : ". All tests before it fail.");
  return q;
}

MaybeOne facesAtAPixel(Dice& dice, const QuestionScene& s) {
  const auto spot = rolledSpot(dice, s);
  if (!spot) return std::nullopt;
  const SnappedScene& scene = s.picture.snapped();
  int covering = 0;
  for (const SnappedFace& face : scene.faces) {
    const auto shown = paintedOver(scene, s.picture.settings().width, s.picture.settings().height,
                                   {static_cast<int>(&face - scene.faces.data())});
    covering += shown[static_cast<std::size_t>(spot->j) * s.picture.settings().width + spot->i] != kNothing;
  }
  ExamQuestion q{.kind = "faces-at-pixel", .given = {{"i", double(spot->i)}, {"j", double(spot->j)}}};
  q.number = covering;
  q.text = "How many polygons of " + s.name + " cover the centre of pixel " + std::to_string(spot->i) + "," +
           std::to_string(spot->j) + " in a picture of " + sizeOf(s) + ", hidden ones included?";
  q.solution = "`xnewell explain` lists them in its history: " + std::to_string(covering) + ".";
  return q;
}

MaybeOne backFaces(Dice&, const QuestionScene& s) {
  ExamQuestion q{.kind = "back-faces", .given = {}};
  q.number = static_cast<double>(std::ranges::count_if(s.picture.snapped().faces, &SnappedFace::back));
  q.text = "How many polygons of " + s.name + " show their backs to the eye of a picture of " + sizeOf(s) +
           "? Count those that are in view, hidden ones included.";
  q.solution =
      "Those whose corners run clockwise on the screen: " + std::to_string(static_cast<int>(q.number)) + ".";
  return q;
}

}  // namespace

QuestionScene::QuestionScene(const Scene& scene, const PictureSettings& settings)
    : picture{makePicture(scene, unsorted(settings)).withPlanes()},
      sorted{
          depthSort(picture.snapped(),
                    {.width = settings.width, .height = settings.height, .textbook = true, .record = true})},
      nearest{visibleFaces(picture.snapped(), settings.width, settings.height)},
      byMeanZ{paintedOver(picture.snapped(), settings.width, settings.height,
                          paintingOrder(picture.snapped(), Order::ZMean))},
      name{scene.name} {}

std::vector<QuestionKind> sceneQuestions() {
  return {{"settling-test", settlingTest}, {"wrong-sort", wrongSort},         {"cuts", cutsOfTheSort},
          {"nearest-face", nearestFace},   {"faces-at-pixel", facesAtAPixel}, {"back-faces", backFaces}};
}

}  // namespace xnewell
