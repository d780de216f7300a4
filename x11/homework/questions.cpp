#include "x11/homework/questions.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <set>

#include "depthsort/depth_sort.h"
#include "depthsort/oracle.h"
#include "depthsort/order.h"
#include "depthsort/pair_tests.h"
#include "depthsort/record/explain.h"
#include "shading/color/color_table.h"
#include "shading/diagnose/face_images.h"
#include "shading/light/equation.h"
#include "shading/picture/picture_cache.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

/// ---- Questions about numbers alone

/// Questions that can be answered with a sheet of paper.

using Maybe = std::optional<ExamQuestion>;

/// A number as few decimals as it has, at most four.
std::string plain(double v) {
  std::string text = fixed(v, 4);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string inBrackets(const glm::dvec3& v) {
  return "(" + plain(v.x) + ", " + plain(v.y) + ", " + plain(v.z) + ")";
}

/// A vector of small whole numbers that is not 0.
glm::dvec3 rolledVector(Dice& dice) {
  glm::dvec3 v{0.0};
  while (v == glm::dvec3{0.0})
    v = {double(rolled(dice, -4, 4)), double(rolled(dice, -4, 4)), double(rolled(dice, -4, 4))};
  return v;
}

void give(ExamQuestion& q, const std::string& name, const glm::dvec3& v) {
  q.given[name + "x"] = v.x, q.given[name + "y"] = v.y, q.given[name + "z"] = v.z;
}

Maybe cellOfLinear(Dice& dice, const QuestionScene&) {
  const double I = rolled(dice, 1, 999, 1000);
  const ColorTable table{TableSettings{}};
  ExamQuestion q{.kind = "cell-linear", .given = {{"I", I}}};
  q.text =
      "The linear table has 240 shades in cells 11 to 250, and color(I) = round(11 + 239 I). Which cell does "
      "I = " +
      plain(I) + " pick?";
  q.number = table.cell(I);
  q.solution = "11 + 239 x " + plain(I) + " = " + fixed(11 + 239 * I, 3) + ", which rounds to " +
               plain(q.number) + ".";
  return q;
}

Maybe cellOfCorrected(Dice& dice, const QuestionScene&) {
  const double I = rolled(dice, 30, 990, 1000);
  const ColorTable table{TableSettings{.kind = TableKind::Corrected}};
  ExamQuestion q{.kind = "cell-corrected", .tolerance = 0, .given = {{"I", I}, {"I0", 0.02}}};
  q.text =
      "The corrected table has 240 shades from cell 11 on. Shade j holds I0 r^j with I0 = 0.02, and shade "
      "239 "
      "holds 1. Which cell is nearest in ratio to I = " +
      plain(I) + "?";
  q.number = table.cell(I);
  q.solution = "r = 50^(1/239) = 1.016503, and j = round(log(I/I0) / log r) = " + plain(q.number - 11) +
               ", so the cell is 11 + j = " + plain(q.number) + ".";
  return q;
}

Maybe ratioOfTable(Dice& dice, const QuestionScene&) {
  const double I0 = rolled(dice, 1, 10, 100);
  const int N = 8 * rolled(dice, 2, 30);
  ExamQuestion q{.kind = "table-ratio", .tolerance = 0.0005, .given = {{"I0", I0}, {"N", double(N)}}};
  q.text = "A corrected table has " + std::to_string(N) +
           " shades. Shade j holds I0 r^j with I0 = " + plain(I0) +
           ", and the last shade holds 1. What is r, to four decimals?";
  q.number = ratioOfShades(I0, N - 1);
  q.solution = "The last shade is j = " + std::to_string(N - 1) + ", so r = (1/I0)^(1/" +
               std::to_string(N - 1) + ") = " + fixed(q.number, 4) + ".";
  return q;
}

Maybe storedValue(Dice& dice, const QuestionScene&) {
  const int cell = rolled(dice, 11, 250);
  const ColorTable table{TableSettings{}};
  ExamQuestion q{.kind = "stored-value", .given = {{"cell", double(cell)}}};
  q.text =
      "In the linear table, cell i holds (i - 10)/255 of the hue. XStoreColors takes values from 0 to 65535. "
      "Which red value is stored in cell " +
      std::to_string(cell) + " if the hue is red?";
  q.number = table.color(cell - 11).r;
  q.solution = "round(65535 x " + std::to_string(cell - 10) + "/255) = " + plain(q.number) + ".";
  return q;
}

Maybe cosineByHand(Dice& dice, const QuestionScene&) {
  const glm::dvec3 N = rolledVector(dice), L = rolledVector(dice);
  ExamQuestion q{.kind = "N.L", .tolerance = 0.002, .given = {}};
  give(q, "N", N), give(q, "L", L);
  q.number = glm::dot(glm::normalize(N), glm::normalize(L));
  q.text = "A surface has the normal " + inBrackets(N) + ", and the direction to the light is " +
           inBrackets(L) +
           "; neither is a unit vector. What is N.L, to three decimals, before it is clamped?";
  q.solution = "Divide both by their lengths, " + fixed(glm::length(N), 4) + " and " +
               fixed(glm::length(L), 4) + "; then N.L = " + fixed(q.number, 3) +
               (q.number < 0 ? ". The equation counts it as 0." : ".");
  return q;
}

Maybe highlightByHand(Dice& dice, const QuestionScene&) {
  glm::dvec3 N = rolledVector(dice), L = rolledVector(dice), V = rolledVector(dice);
  if (glm::dot(N, L) < 0) L = -L;
  if (glm::dot(N, V) < 0) V = -V;
  if (glm::dot(N, L) == 0) return std::nullopt;
  ExamQuestion q{.kind = "R.V", .tolerance = 0.002, .given = {}};
  give(q, "N", N), give(q, "L", L), give(q, "V", V);
  q.number = specularCosine(Form::Textbook, glm::normalize(N), glm::normalize(L), glm::normalize(V));
  q.text = "The normal is " + inBrackets(N) + ", the light is in direction " + inBrackets(L) +
           " and the eye in direction " + inBrackets(V) +
           "; none is a unit vector. What is R.V, to three decimals, before it is clamped?";
  q.solution = "Make all three unit vectors. R = 2 N (N.L) - L, and R.V = " + fixed(q.number, 3) + ".";
  return q;
}

Maybe equationByHand(Dice& dice, const QuestionScene&) {
  const double Ia = rolled(dice, 1, 4, 10), Ip = 1 - Ia, ka = rolled(dice, 5, 10, 10),
               kd = rolled(dice, 4, 10, 10), ks = rolled(dice, 1, 5, 10), NL = rolled(dice, -40, 100, 100),
               RV = rolled(dice, 70, 100, 100);
  const int n = rolled(dice, 2, 12);
  const IlluminationTerms terms = termsOf(Ia, Ip, 1, 1, {ka, kd, ks, n}, NL, RV);
  ExamQuestion q{.kind = "equation",
                 .tolerance = 0.002,
                 .given = {{"Ia", Ia},
                           {"Ip", Ip},
                           {"ka", ka},
                           {"kd", kd},
                           {"ks", ks},
                           {"NL", NL},
                           {"RV", RV},
                           {"n", double(n)}}};
  q.number = std::min(1.0, terms.I);
  q.text = "Ia = " + plain(Ia) + ", Ip = " + plain(Ip) + ", ka = " + plain(ka) + ", kd = " + plain(kd) +
           ", ks = " + plain(ks) + ", n = " + std::to_string(n) + "; N.L = " + plain(NL) +
           " and R.V = " + plain(RV) +
           ". The light does not fade. What is I, to three decimals, after it is clamped to 1?";
  q.solution =
      NL <= 0 ? "N.L is not above 0, so only the ambient term counts: ka Ia = " + fixed(q.number, 3) + "."
              : "ka Ia + Ip [kd N.L + ks (R.V)^n] = " + fixed(terms.I, 4) +
                    ", clamped: " + fixed(q.number, 3) + ".";
  return q;
}

Maybe fadeByHand(Dice& dice, const QuestionScene&) {
  const double d = rolled(dice, 2, 40, 10);
  const bool square = rolled(dice, 0, 1) == 1;
  ExamQuestion q{
      .kind = "attenuation", .tolerance = 0.002, .given = {{"d", d}, {"power", square ? 2.0 : 1.0}}};
  Light light;
  light.kind = LightKind::Point,
  light.attenuation = square ? Attenuation::InverseSquare : Attenuation::Inverse;
  q.number = attenuation(light, d);
  q.text = std::string{"A lamp fades by min(1, "} + (square ? "1/d^2" : "1/d") +
           "). How much of its light is left at the distance d = " + plain(d) + ", to three decimals?";
  q.solution = d < 1 ? "Nearer than 1 the light does not grow: 1." : "It is " + fixed(q.number, 3) + ".";
  return q;
}

Maybe gouraudOnARow(Dice& dice, const QuestionScene&) {
  const int left = rolled(dice, 10, 100), right = left + rolled(dice, 10, 60), x = rolled(dice, left, right);
  const double A = rolled(dice, 5, 95, 100), B = rolled(dice, 5, 95, 100);
  ExamQuestion q{
      .kind = "gouraud-row",
      .tolerance = 0.002,
      .given = {{"left", double(left)}, {"right", double(right)}, {"x", double(x)}, {"A", A}, {"B", B}}};
  q.number = A + (B - A) * (x - left) / (right - left);
  q.text = "On a row of a Gouraud shaded polygon the intensity is " + plain(A) +
           " at x = " + std::to_string(left) + " and " + plain(B) + " at x = " + std::to_string(right) +
           ". What is it at x = " + std::to_string(x) + ", to three decimals?";
  q.solution = plain(A) + " + (" + plain(B) + " - " + plain(A) + ") x " + std::to_string(x - left) + "/" +
               std::to_string(right - left) + " = " + fixed(q.number, 3) + ".";
  return q;
}

Maybe normalByHand(Dice& dice, const QuestionScene&) {
  std::array<glm::dvec3, 3> p{rolledVector(dice), rolledVector(dice), rolledVector(dice)};
  const glm::dvec3 N = glm::cross(p[1] - p[0], p[2] - p[0]);
  if (N == glm::dvec3{0.0}) return std::nullopt;
  const int axis = rolled(dice, 0, 2);
  ExamQuestion q{.kind = "normal", .tolerance = 0.002, .given = {{"axis", double(axis)}}};
  for (int k = 0; k < 3; ++k) give(q, std::string{"p"} + char('0' + k), p[k]);
  q.number = glm::normalize(N)[axis];
  q.text = "A triangle has the corners " + inBrackets(p[0]) + ", " + inBrackets(p[1]) + " and " +
           inBrackets(p[2]) + ", counter-clockwise as seen from its front. What is the " +
           std::string{"xyz"[axis]} + " component of its unit normal, to three decimals?";
  q.solution =
      "(P1 - P0) x (P2 - P0) = " + inBrackets(N) + ", divided by its length: " + fixed(q.number, 3) + ".";
  return q;
}

Maybe vertexNormal(Dice& dice, const QuestionScene&) {
  const glm::dvec3 a = rolledVector(dice), b = rolledVector(dice);
  const glm::dvec3 sum = glm::normalize(a) + glm::normalize(b);
  if (glm::length(sum) < 0.1) return std::nullopt;
  ExamQuestion q{.kind = "vertex-normal", .tolerance = 0.002, .given = {}};
  give(q, "a", a), give(q, "b", b);
  q.number = glm::normalize(sum).z;
  q.text = "Two faces meet at a vertex. Their normals are " + inBrackets(a) + " and " + inBrackets(b) +
           ", not of unit length. Each face counts once. What is the z component of the unit normal at the "
           "vertex, to "
           "three decimals?";
  q.solution = "The sum of the unit normals is " + inBrackets(sum) +
               ", and its unit vector has z = " + fixed(q.number, 3) + ".";
  return q;
}

std::vector<QuestionKind> numberQuestions() {
  return {{"cell-linear", cellOfLinear},  {"N.L", cosineByHand},
          {"table-ratio", ratioOfTable},  {"R.V", highlightByHand},
          {"equation", equationByHand},   {"stored-value", storedValue},
          {"attenuation", fadeByHand},    {"gouraud-row", gouraudOnARow},
          {"normal", normalByHand},       {"cell-corrected", cellOfCorrected},
          {"vertex-normal", vertexNormal}};
}

/// ---- Questions about the scene

/// Questions about a scene: what shows, what hides what, and what the depth sort does.

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

std::vector<QuestionKind> sceneQuestions() {
  return {{"settling-test", settlingTest}, {"wrong-sort", wrongSort},         {"cuts", cutsOfTheSort},
          {"nearest-face", nearestFace},   {"faces-at-pixel", facesAtAPixel}, {"back-faces", backFaces}};
}

/// The characters that mean something in a GIFT file.
std::string inGift(const std::string& text) {
  std::string gift;
  for (const char c : text) {
    if (std::string_view{"~=#{}:\\"}.find(c) != std::string_view::npos) gift += '\\';
    gift += c;
  }
  return gift;
}

/// A number with as many decimals as its tolerance asks for.
/// With the decimals that the question asks for.
std::string numberText(const ExamQuestion& q) {
  return fixed(q.number, q.tolerance >= 0.001 ? 3 : q.tolerance > 0 ? 4 : 0);
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

int rolled(Dice& dice, int low, int high) {
  return low + static_cast<int>(dice() % static_cast<unsigned>(high - low + 1));
}

double rolled(Dice& dice, int low, int high, double per) { return rolled(dice, low, high) / per; }

const std::vector<QuestionKind>& questionKinds() {
  static const std::vector<QuestionKind> all = [] {
    // Those of the scene and those of numbers in turn.
    const std::vector<QuestionKind> numbers = numberQuestions(), scenes = sceneQuestions();
    std::vector<QuestionKind> kinds;
    for (std::size_t k = 0; k < std::max(numbers.size(), scenes.size()); ++k) {
      if (k < numbers.size()) kinds.push_back(numbers[k]);
      if (k < scenes.size()) kinds.push_back(scenes[k]);
    }
    return kinds;
  }();
  return all;
}

std::vector<ExamQuestion> makeQuestions(const QuestionScene& scene, int count, unsigned seed) {
  Dice dice{seed};
  std::vector<ExamQuestion> questions;
  std::set<std::string> texts;
  const std::vector<QuestionKind>& kinds = questionKinds();
  // A kind that the scene has no question of, or no new one, is left out.
  for (std::size_t k = 0, tries = 0;
       static_cast<int>(questions.size()) < count && tries < 50u * static_cast<unsigned>(count) + 500u;
       k = (k + 1) % kinds.size(), ++tries)
    if (auto one = kinds[k].make(dice, scene); one && texts.insert(one->text).second)
      questions.push_back(std::move(*one));
  return questions;
}

std::string questionsAsGift(const std::vector<ExamQuestion>& questions) {
  std::string gift = "// questions in Moodle's GIFT format\n";
  for (std::size_t k = 0; k < questions.size(); ++k) {
    const ExamQuestion& q = questions[k];
    gift += "\n::" + std::to_string(k + 1) + " " + inGift(q.kind) + ":: " + inGift(q.text) + " {";
    if (q.choices.empty()) {
      gift += "#" + numberText(q) + ":" + fixed(q.tolerance, q.tolerance > 0 ? 4 : 0);
    } else {
      for (std::size_t c = 0; c < q.choices.size(); ++c)
        gift += (c == q.right ? "\n  =" : "\n  ~") + inGift(q.choices[c]);
      gift += "\n";
    }
    gift += "####" + inGift(q.solution) + "}\n";
  }
  return gift;
}

QuestionTexts questionsAsText(const std::vector<ExamQuestion>& questions) {
  QuestionTexts all;
  auto& [asked, solved] = all;
  const auto add = [](std::string& to, const std::string& number, const std::string& text) {
    std::string indent = number;
    for (const std::string& line : broken(text, 100)) {
      to += indent + line + '\n';
      indent.assign(number.size(), ' ');
    }
  };
  for (std::size_t k = 0; k < questions.size(); ++k) {
    const ExamQuestion& q = questions[k];
    const std::string number = std::to_string(k + 1) + ". ";
    add(asked, number, q.text);
    const auto letter = [](std::size_t choice) { return std::string{static_cast<char>('a' + choice)}; };
    for (std::size_t c = 0; c < q.choices.size(); ++c)
      asked += "   " + letter(c) + ") " + q.choices[c] + '\n';
    asked += '\n';
    add(solved, number, (q.choices.empty() ? numberText(q) : letter(q.right)) + ". " + q.solution);
  }
  return all;
}

}  // namespace xnewell
