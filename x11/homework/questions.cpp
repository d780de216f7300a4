#include "x11/homework/questions.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>
#include <random>
#include <set>

#include "depthsort/depth_sort.h"
#include "depthsort/oracle.h"
#include "depthsort/order.h"
#include "depthsort/pair_tests.h"
#include "depthsort/record/explain.h"
#include "geometry/view/view.h"
#include "shading/color/color_table.h"
#include "shading/color/png.h"
#include "shading/diagnose/scene_for.h"
#include "shading/light/equation.h"
#include "shading/picture/picture_cache.h"
#include "x11/drawing/wording.h"
#include "x11/homework/reports.h"

namespace xnewell {

namespace {

/// ---- Questions about numbers alone

/// Questions that can be answered with a sheet of paper.

using Maybe = std::optional<ExamQuestion>;
using Dice = std::mt19937;
struct QuestionKind {
  std::string_view name;
  Maybe (*make)(Dice&, const QuestionScene&);  ///< nothing where the scene has none
};

/// A whole number in [low, high], and a number in steps of 1/per. (The distributions of the standard library
/// may differ from machine to machine.)
int rolled(Dice& dice, int low, int high) {
  return low + static_cast<int>(dice() % static_cast<unsigned>(high - low + 1));
}
double rolled(Dice& dice, int low, int high, double per) { return rolled(dice, low, high) / per; }

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

Maybe cellOfLinear(Dice& dice, const QuestionScene&) {
  const double I = rolled(dice, 1, 999, 1000);
  const ColorTable table{TableSettings{}};
  ExamQuestion q;
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
  ExamQuestion q;
  q.text =
      "The corrected table has 240 shades from cell 11 on. Shade j holds I0 r^j with I0 = 0.02, and shade "
      "239 "
      "holds 1. Which cell is nearest in ratio to I = " +
      plain(I) + "?";
  q.number = table.cell(I);
  q.solution = "r = 50^(1/239) = 1.016503. log(I/I0) / log r = " +
               fixed(std::log(I / 0.02) / std::log(ratioOfShades(0.02, 239)), 2) +
               ", so j = " + plain(q.number - 11) + " and the cell is 11 + j = " + plain(q.number) + ".";
  return q;
}

Maybe ratioOfTable(Dice& dice, const QuestionScene&) {
  const double I0 = rolled(dice, 1, 10, 100);
  const int N = 8 * rolled(dice, 2, 30);
  ExamQuestion q{.tolerance = 0.0005};
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
  ExamQuestion q;
  q.text =
      "In the linear table, cell i holds (i - 10)/255 of the hue. XStoreColors takes values from 0 to 65535. "
      "Which red value is stored in cell " +
      std::to_string(cell) + " if the hue is red?";
  q.number = table.color(cell - 11).r;
  q.solution = "round(65535 x " + std::to_string(cell - 10) + "/255) = " + plain(q.number) + ".";
  return q;
}

/// "sqrt(14) = 3.7417"
std::string lengthOf(const glm::dvec3& v) {
  return "sqrt(" + plain(glm::dot(v, v)) + ") = " + fixed(glm::length(v), 4);
}

Maybe cosineByHand(Dice& dice, const QuestionScene&) {
  const glm::dvec3 N = rolledVector(dice), L = rolledVector(dice);
  ExamQuestion q{.tolerance = 0.002};
  q.number = glm::dot(glm::normalize(N), glm::normalize(L));
  q.text = "A surface has the normal " + inBrackets(N) + ", and the direction to the light is " +
           inBrackets(L) +
           "; neither is a unit vector. What is N.L, to three decimals, before it is clamped?";
  q.solution = "As they stand, N.L = " + plain(glm::dot(N, L)) + ". The lengths are " + lengthOf(N) +
               " and " + lengthOf(L) + ". Divided by both: " + fixed(q.number, 3) +
               (q.number < 0 ? ". The equation counts it as 0." : ".");
  return q;
}

/// Makes a question of choices: the right number, and up to three that mistakes of shading/light give. Each
/// must differ from all others. False if there are less than two mistakes that do.
bool offer(ExamQuestion& q, Dice& dice, bool (*isMeant)(const MistakeRow&),
           const std::function<double(const MistakeRow&)>& given) {
  struct Choice {
    double value;
    std::string_view made;
  };
  std::vector<Choice> choices{{q.number, ""}};
  std::vector<const MistakeRow*> rows;
  for (const MistakeRow& row : kMistakes)
    if (row.id != Mistake::None && isMeant(row)) rows.push_back(&row);
  while (!rows.empty() && choices.size() < 4) {
    const auto at = rows.begin() + rolled(dice, 0, static_cast<int>(rows.size()) - 1);
    const double value = given(**at);
    if (std::ranges::none_of(choices, [&](const Choice& c) { return std::abs(c.value - value) < 0.005; }))
      choices.push_back({value, (*at)->words});
    rows.erase(at);
  }
  if (choices.size() < 3) return false;
  std::swap(choices[0],
            choices[static_cast<std::size_t>(rolled(dice, 0, static_cast<int>(choices.size()) - 1))]);
  for (const Choice& c : choices) {
    const std::string number = fixed(c.value, 3);
    if (c.made.empty())
      q.right = q.choices.size();
    else
      q.solution += ' ' + number + ": " + std::string{c.made} + '.';
    q.choices.push_back(number);
  }
  return true;
}

Maybe highlightByHand(Dice& dice, const QuestionScene&) {
  const glm::dvec3 N = rolledVector(dice);
  glm::dvec3 L = rolledVector(dice), V = rolledVector(dice);
  if (glm::dot(N, L) < 0) L = -L;
  if (glm::dot(N, V) < 0) V = -V;
  if (glm::dot(N, L) == 0) return std::nullopt;
  ExamQuestion q{.tolerance = 0.002};
  const glm::dvec3 n = glm::normalize(N), l = glm::normalize(L), v = glm::normalize(V);
  q.number = specularCosine(Form::Textbook, n, l, v);
  q.text = "The normal is " + inBrackets(N) + ", the light is in direction " + inBrackets(L) +
           " and the eye in direction " + inBrackets(V) +
           "; none is a unit vector. What is R.V, to three decimals, before it is clamped?";
  q.solution = "Divided by their lengths, N = " + inBrackets(n) + ", L = " + inBrackets(l) +
               " and V = " + inBrackets(v) + ". N.L = " + fixed(glm::dot(n, l), 4) +
               ", R = 2 N (N.L) - L = " + inBrackets(2.0 * n * glm::dot(n, l) - l) +
               ", and R.V = " + fixed(q.number, 3) + ".";
  const auto ofVectors = [](const MistakeRow& row) { return row.changesVectors(); };
  const auto cosine = [&](const MistakeRow& row) {
    return lightTerms(row.id, 1, 1, {0, 0, 1, 1}, {row.longN ? N : n, l, v}, Form::Textbook).cosine;
  };
  return offer(q, dice, ofVectors, cosine) ? Maybe{std::move(q)} : std::nullopt;
}

Maybe equationByHand(Dice& dice, const QuestionScene&) {
  const double Ia = rolled(dice, 1, 4, 10), Ip = 1 - Ia, ka = rolled(dice, 5, 10, 10),
               kd = rolled(dice, 4, 10, 10), ks = rolled(dice, 1, 5, 10), NL = rolled(dice, -40, 100, 100),
               RV = rolled(dice, 70, 100, 100);
  const int n = rolled(dice, 2, 12);
  const IlluminationTerms terms = termsOf(Ia, Ip, 1, 1, {ka, kd, ks, n}, NL, RV);
  ExamQuestion q{.tolerance = 0.002};
  q.number = std::min(1.0, terms.I);
  q.text = "Ia = " + plain(Ia) + ", Ip = " + plain(Ip) + ", ka = " + plain(ka) + ", kd = " + plain(kd) +
           ", ks = " + plain(ks) + ", n = " + std::to_string(n) + "; N.L = " + plain(NL) +
           " and R.V = " + plain(RV) +
           ". The light does not fade. What is I, to three decimals, after it is clamped to 1?";
  q.solution =
      NL <= 0 ? "N.L is not above 0, so only the ambient term counts: ka Ia = " + fixed(q.number, 3) + "."
              : "ka Ia = " + fixed(ka * Ia, 4) + "; kd N.L = " + fixed(kd * NL, 4) +
                    "; (R.V)^n = " + fixed(std::pow(RV, n), 4) +
                    ", so ks (R.V)^n = " + fixed(ks * std::pow(RV, n), 4) +
                    "; the sum of both times Ip = " + fixed(terms.diffuse + terms.specular, 4) +
                    ". Together I = " + fixed(terms.I, 3) + ".";
  // Vectors with these two cosines.
  const double sine = std::sqrt(1 - NL * NL), off = std::sqrt(1 - RV * RV);
  const EquationVectors at{{0, 0, 1}, {sine, 0, NL}, {-sine * RV - NL * off, 0, NL * RV - sine * off}};
  const auto ofNumbers = [](const MistakeRow& row) { return !row.changesVectors(); };
  const auto I = [&](const MistakeRow& row) {
    const LightTerms light = lightTerms(row.id, 1, Ip, {ka, kd, ks, n}, at, Form::Textbook);
    return std::clamp(row.ambient * ka * Ia + light.diffuse + light.specular, 0.0, 1.0);
  };
  return offer(q, dice, ofNumbers, I) ? Maybe{std::move(q)} : std::nullopt;
}

Maybe fadeByHand(Dice& dice, const QuestionScene&) {
  const double d = rolled(dice, 11, 40, 10);
  const bool square = rolled(dice, 0, 1) == 1;
  ExamQuestion q{.tolerance = 0.002};
  Light light;
  light.kind = LightKind::Point,
  light.attenuation = square ? Attenuation::InverseSquare : Attenuation::Inverse;
  q.number = attenuation(light, d);
  q.text = std::string{"A lamp fades by min(1, "} + (square ? "1/d^2" : "1/d") +
           "). How much of its light is left at the distance d = " + plain(d) + ", to three decimals?";
  q.solution =
      "1/" + plain(d) + (square ? " squared" : "") + " = " + fixed(q.number, 3) + ", which is below 1.";
  return q;
}

Maybe gouraudOnARow(Dice& dice, const QuestionScene&) {
  const int left = rolled(dice, 10, 100), right = left + rolled(dice, 10, 60),
            x = rolled(dice, left + 1, right - 1);
  const double A = rolled(dice, 5, 95, 100), B = rolled(dice, 5, 95, 100);
  ExamQuestion q{.tolerance = 0.002};
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
  ExamQuestion q{.tolerance = 0.002};
  q.number = glm::normalize(N)[axis];
  q.text = "A triangle has the corners " + inBrackets(p[0]) + ", " + inBrackets(p[1]) + " and " +
           inBrackets(p[2]) + ", counter-clockwise as seen from its front. What is the " +
           std::string{"xyz"[axis]} + " component of its unit normal, to three decimals?";
  q.solution = "P1 - P0 = " + inBrackets(p[1] - p[0]) + " and P2 - P0 = " + inBrackets(p[2] - p[0]) +
               ". Their cross product is " + inBrackets(N) + ", of length " + lengthOf(N) + ". " +
               plain(N[axis]) + " divided by it is " + fixed(q.number, 3) + ".";
  return q;
}

Maybe vertexNormal(Dice& dice, const QuestionScene&) {
  const glm::dvec3 a = rolledVector(dice), b = rolledVector(dice);
  const glm::dvec3 sum = glm::normalize(a) + glm::normalize(b);
  if (glm::length(sum) < 0.1) return std::nullopt;
  ExamQuestion q{.tolerance = 0.002};
  q.number = glm::normalize(sum).z;
  q.text = "Two faces meet at a vertex. Their normals are " + inBrackets(a) + " and " + inBrackets(b) +
           ", not of unit length. Each face counts once. What is the z component of the unit normal at the "
           "vertex, to "
           "three decimals?";
  q.solution = "The unit normals are " + inBrackets(glm::normalize(a)) + " and " +
               inBrackets(glm::normalize(b)) + "; their sum is " + inBrackets(sum) + ", of length " +
               fixed(glm::length(sum), 4) + ". Its z divided by that is " + fixed(q.number, 3) + ".";
  return q;
}

/// ---- Questions about the scene

/// Questions about a scene: what shows, what hides what, and what the depth sort does.

PictureSettings unsorted(PictureSettings settings) {
  settings.order = Order::Unsorted, settings.adapt = 0;
  return settings;
}

std::string sizeOf(const QuestionScene& s) {
  return sizeText(s.picture.settings().width, s.picture.settings().height);
}

int numberOf(const QuestionScene& s, int face) { return s.picture.snapped().faces[face].number; }

/// A polygon as the lines below a question have it: corners in pixels, with two decimals, in the order of the
/// model. All answers are computed from these, and are to be had by hand.
constexpr double kClear = 0.2;  ///< pixels: what decides a question is no nearer than this
struct Polygon {
  int face;  ///< its place in the snapped scene
  std::string name;
  std::vector<glm::dvec3> corners;

  Polygon(const QuestionScene& s, int f) : face{f}, name{"face " + std::to_string(numberOf(s, f))} {
    const SnappedScene& scene = s.picture.snapped();
    const SnappedFace& of = scene.faces[f];
    const glm::dvec3 unit{kGrid, kGrid, std::ldexp(double{kGrid}, -scene.zShift)};
    for (int k = of.first; k < of.first + of.count; ++k)
      corners.push_back(glm::round(glm::dvec3{scene.vertices[k]} / unit * 100.0) / 100.0);
    if (of.back) std::ranges::reverse(corners);
  }
  [[nodiscard]] std::string line() const {
    std::string all = name + ":";
    for (const glm::dvec3& c : corners) all += ' ' + inBrackets(c);
    return all;
  }
  /// Twice the area, positive if the corners run counter-clockwise on the screen.
  [[nodiscard]] double area() const {
    double sum = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const glm::dvec3 &a = corners[k], &b = corners[(k + 1) % corners.size()];
      sum += a.y * b.x - a.x * b.y;
    }
    return sum;
  }
  /// How far a place lies inside the nearest edge; negative outside.
  [[nodiscard]] double inside(const glm::dvec2& at) const {
    double least = 1e9;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const glm::dvec2 a{corners[k]}, b{corners[(k + 1) % corners.size()]};
      if (a != b)
        least =
            std::min(least, ((at.x - a.x) * (b.y - a.y) - (at.y - a.y) * (b.x - a.x)) / glm::length(b - a));
    }
    return least;
  }
  /// z of the plane through three corners that lie far apart.
  [[nodiscard]] double z(const glm::dvec2& at) const {
    glm::dvec3 n{0};
    for (std::size_t k = 2; k < corners.size(); ++k)
      if (const glm::dvec3 one = glm::cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
          std::abs(one.z) > std::abs(n.z))
        n = one;
    return corners[0].z - (n.x * (at.x - corners[0].x) + n.y * (at.y - corners[0].y)) / n.z;
  }
  [[nodiscard]] double meanZ() const {
    double sum = 0;
    for (const glm::dvec3& c : corners) sum += c.z;
    return sum / static_cast<double>(corners.size());
  }
};

void list(ExamQuestion& q, const QuestionScene& s, const std::vector<Polygon>& polygons) {
  const ViewSpec& view = s.picture.camera().view;
  const glm::dmat3 R = vrcRotation(view);
  q.text +=
      " Their corners are below, in the order of the scene: x and y in pixels from the top left, and z, "
      "larger nearer. ";
  q.text += view.projection == Projection::Perspective
                ? "The eye is at " +
                      inBrackets((view.vrp + glm::transpose(R) * view.prp) *
                                 std::ldexp(1.0, s.picture.scene().exponent)) +
                      ", and"
                : "It is a parallel projection, and";
  q.text += " the view plane has the normal " + inBrackets(glm::transpose(R)[2]) + " in the world.";
  for (const Polygon& one : polygons) q.lines.push_back(one.line());
}

constexpr std::size_t kMostPolygons = 6;

struct Spot {
  int i = 0, j = 0;
  std::vector<Polygon> covering;
  [[nodiscard]] glm::dvec2 at() const { return {i + 0.5, j + 0.5}; }
  [[nodiscard]] std::string text() const {
    return "at the centre of pixel " + std::to_string(i) + "," + std::to_string(j) +
           ", which is at x = " + plain(i + 0.5) + ", y = " + plain(j + 0.5);
  }
};
/// Whether the box around a polygon holds a place.
bool holds(const Polygon& one, const glm::dvec2& at) {
  glm::dvec2 low{one.corners[0]}, high = low;
  for (const glm::dvec3& c : one.corners)
    low = glm::min(low, glm::dvec2{c}), high = glm::max(high, glm::dvec2{c});
  return glm::all(glm::lessThanEqual(low, at)) && glm::all(glm::lessThanEqual(at, high));
}

/// The pixel, if at least `least` polygons clearly cover its centre, and none nearly does.
std::optional<Spot> spotAt(const QuestionScene& s, int i, int j, std::size_t least) {
  Spot spot{i, j, {}};
  for (int f = 0; f < std::ssize(s.picture.snapped().faces); ++f) {
    Polygon one{s, f};
    if (!holds(one, spot.at())) continue;
    if (one.area() < 0) std::ranges::reverse(one.corners);
    const double inside = one.inside(spot.at());
    if (std::abs(inside) < kClear) return std::nullopt;
    if (inside > 0) spot.covering.emplace_back(s, f);
  }
  if (spot.covering.size() < least || spot.covering.size() > kMostPolygons) return std::nullopt;
  return spot;
}
std::optional<Spot> rolledSpot(Dice& dice, const QuestionScene& s, std::size_t least) {
  const PictureSettings& settings = s.picture.settings();
  for (int tries = 0; tries < 400; ++tries) {
    const int i = rolled(dice, 0, settings.width - 1), j = rolled(dice, 0, settings.height - 1);
    if (auto spot = spotAt(s, i, j, least)) return spot;
  }
  return std::nullopt;
}

Maybe nearestZ(Dice& dice, const QuestionScene& s) {
  const auto spot = rolledSpot(dice, s, 2);
  if (!spot) return std::nullopt;
  ExamQuestion q{.tolerance = 0.5};
  std::vector<double> z;
  for (const Polygon& one : spot->covering) {
    z.push_back(one.z(spot->at()));
    q.solution += one.name + " has z = " + fixed(z.back(), 1) + " there; ";
  }
  const auto best = std::ranges::max_element(z);
  q.number = *best;
  const Polygon& shown = spot->covering[static_cast<std::size_t>(best - z.begin())];
  std::ranges::sort(z);
  if (z.back() - z[z.size() - 2] < 2) return std::nullopt;
  q.text = "These polygons of " + s.name + " cover a place in a picture of " + sizeOf(s) + ", " +
           spot->text() + ". What is the z of the nearest one there, to one decimal?";
  list(q, s, spot->covering);
  q.solution =
      "The plane through three corners of each gives its z: " + q.solution + shown.name + " is the nearest.";
  return q;
}

Maybe wrongSort(Dice& dice, const QuestionScene& s) {
  const PictureSettings& settings = s.picture.settings();
  std::vector<std::size_t> wrong;
  for (std::size_t k = 0; k < s.nearest.size(); ++k)
    if (s.nearest[k] != s.byMeanZ[k]) wrong.push_back(k);
  if (wrong.empty()) return std::nullopt;
  const std::size_t at = wrong[static_cast<std::size_t>(rolled(dice, 0, static_cast<int>(wrong.size()) - 1))];
  const auto spot = spotAt(s, static_cast<int>(at % static_cast<std::size_t>(settings.width)),
                           static_cast<int>(at / static_cast<std::size_t>(settings.width)), 2);
  if (!spot) return std::nullopt;
  ExamQuestion q;
  q.number = numberOf(s, s.byMeanZ[at]);
  q.text = "These polygons of " + s.name +
           " are sorted by the mean z of their corners and painted, farthest first, in a "
           "picture of " +
           sizeOf(s) + ". All cover the place " + spot->text() +
           ". Another polygon shows there than the nearest one. Which face?";
  list(q, s, spot->covering);
  std::vector<double> means;
  for (const Polygon& one : spot->covering) {
    means.push_back(one.meanZ());
    q.solution += (q.solution.empty() ? "The mean z is " : ", ") + fixed(means.back(), 1) + " of " + one.name;
  }
  std::ranges::sort(means);
  if (means.back() - means[means.size() - 2] < kClear) return std::nullopt;
  q.solution += ". The largest is painted last: face " + plain(q.number) + ", although face " +
                std::to_string(numberOf(s, s.nearest[at])) + " is nearer there.";
  return q;
}

/// Where the plane of one polygon cuts an edge of another.
Maybe placeOfCut(Dice& dice, const QuestionScene& s) {
  std::vector<const Event*> splits;
  const int faces = static_cast<int>(s.picture.snapped().faces.size());
  for (const Event& e : s.sorted.events)
    if (e.kind == Event::Kind::Split && e.P < faces && e.Q < faces) splits.push_back(&e);
  if (splits.empty()) return std::nullopt;
  const Event& e = *splits[static_cast<std::size_t>(rolled(dice, 0, static_cast<int>(splits.size()) - 1))];
  const Polygon P{s, e.P}, Q{s, e.Q};
  const std::size_t k = static_cast<std::size_t>(rolled(dice, 0, static_cast<int>(P.corners.size()) - 1));
  const glm::dvec3 &A = P.corners[k], &B = P.corners[(k + 1) % P.corners.size()];
  const double a = A.z - Q.z(A), b = B.z - Q.z(B);
  const bool alongX = std::abs(B.x - A.x) > std::abs(B.y - A.y);
  if (a * b >= 0 || std::abs(a) < 5 || std::abs(b) < 5) return std::nullopt;
  const glm::dvec3 cut = A + (B - A) * (a / (a - b));
  const std::string axis = alongX ? "x" : "y";
  ExamQuestion q{.tolerance = 0.5};
  q.number = alongX ? cut.x : cut.y;
  q.text = "In a picture of " + sizeOf(s) + ", the depth sort cuts P = " + P.name + " of " + s.name +
           " by the plane of Q = " + Q.name + ". At which " + axis +
           " does the cut meet the edge of P from " + inBrackets(A) + " to " + inBrackets(B) +
           ", to one decimal?";
  list(q, s, {P, Q});
  q.solution = "At the first corner the plane of Q has z = " + fixed(Q.z(A), 1) + ", so the corner is " +
               fixed(a, 1) + " in front of it; the second corner is " + fixed(b, 1) +
               " in front. So the cut is at t = " + fixed(a, 1) + "/(" + fixed(a, 1) + " - " + fixed(b, 1) +
               ") = " + fixed(a / (a - b), 4) + " of the edge, where " + axis + " = " + fixed(q.number, 1) +
               ".";
  return q;
}

/// No pair is asked that rounding alone keeps from an earlier test: a corner that two faces share may miss
/// the snapped plane of the other.
Maybe settlingTest(Dice& dice, const QuestionScene& s) {
  std::vector<const Event*> compared;
  const int faces = static_cast<int>(s.picture.snapped().faces.size());
  Explainer explainer{s.picture.scene().mesh, s.picture.snapped(), s.sorted, true};
  for (const Event& e : s.sorted.events) {
    if (e.kind != Event::Kind::Compare || e.P >= faces || e.Q >= faces || e.test == Test::SamePlane) continue;
    const std::vector<Test> made = explainer.testsMade(e);
    // By hand, two polygons in one plane pass test 3, which the sort does not make for them.
    const bool onePlane = std::ranges::find(made, Test::Projections) != made.end() &&
                          std::ranges::find(made, Test::PBehindQ) == made.end();
    if (!onePlane &&
        std::ranges::none_of(made, [&](Test test) { return explainer.failsByRounding(e, test); }))
      compared.push_back(&e);
  }
  if (compared.empty()) return std::nullopt;
  const Event& e =
      *compared[static_cast<std::size_t>(rolled(dice, 0, static_cast<int>(compared.size()) - 1))];
  ExamQuestion q;
  const Polygon P{s, e.P}, Q{s, e.Q};
  constexpr double kLeast = 100;  // twice the square pixels: in smaller ones two decimals are too few
  if (std::min(std::abs(P.area()), std::abs(Q.area())) < kLeast) return std::nullopt;
  q.text = "The depth sort compares P = " + P.name + " of " + s.name + " with Q = " + Q.name +
           " in a picture of " + sizeOf(s) +
           ", by tests 1, 2, 3, 4, 5, 3', 4' and 6 in this order. Which test settles the pair?";
  list(q, s, {P, Q});
  for (const TestRow& row : kTestRows) {
    if (row.id == e.test) q.right = q.choices.size();
    if (row.id != Test::SamePlane)
      q.choices.push_back("test " + std::string{row.name} + ": " + std::string{row.asks});
  }
  explainer.call(Called::PAndQ);
  for (const Test test : explainer.testsMade(e))
    q.solution += (q.solution.empty() ? "" : " ") + explainer.sentence(e, test);
  return q;
}

Maybe facesAtAPixel(Dice& dice, const QuestionScene& s) {
  auto spot = rolledSpot(dice, s, 2);
  if (!spot) return std::nullopt;
  const double covering = static_cast<double>(spot->covering.size());
  std::string inside, outside;
  for (const Polygon& one : spot->covering) inside += (inside.empty() ? "" : ", ") + one.name;
  // Others whose boxes hold the place.
  for (int f = 0; f < std::ssize(s.picture.snapped().faces) && spot->covering.size() < kMostPolygons; ++f) {
    const Polygon one{s, f};
    if (!holds(one, spot->at())) continue;
    if (std::ranges::find(spot->covering, f, &Polygon::face) != spot->covering.end()) continue;
    outside += (outside.empty() ? "" : ", ") + one.name;
    spot->covering.push_back(one);
  }
  if (outside.empty()) return std::nullopt;
  std::ranges::sort(spot->covering, {}, &Polygon::face);
  ExamQuestion q;
  q.number = covering;
  q.text = "How many of these polygons of " + s.name + " cover a place in a picture of " + sizeOf(s) + ", " +
           spot->text() + ", hidden ones included?";
  list(q, s, spot->covering);
  q.solution = "The place is on the inner side of all edges of " + inside + ", and outside an edge of " +
               outside + ": " + plain(q.number) + ".";
  return q;
}

Maybe backFaces(Dice& dice, const QuestionScene& s) {
  std::vector<int> all;
  for (int f = 0; f < std::ssize(s.picture.snapped().faces); ++f) all.push_back(f);
  while (all.size() > kMostPolygons)
    all.erase(all.begin() + rolled(dice, 0, static_cast<int>(all.size()) - 1));
  ExamQuestion q;
  std::vector<Polygon> polygons;
  for (const int f : all) {
    const Polygon& one = polygons.emplace_back(s, f);
    if (std::abs(one.area()) < 4) return std::nullopt;
    q.number += one.area() < 0;
    q.solution += one.name + (one.area() < 0 ? ": clockwise; " : ": counter-clockwise; ");
  }
  q.text = "How many of these polygons of " + s.name + " show their backs to the eye of a picture of " +
           sizeOf(s) + ", hidden ones included? From its front, a polygon's corners run counter-clockwise.";
  list(q, s, polygons);
  q.solution =
      "On the screen the corners run, " + q.solution + "so " + plain(q.number) + " show their backs.";
  return q;
}

/// Those of numbers and those of the scene in turn.
constexpr std::array kQuestionKinds{
    QuestionKind{"cell-linear", cellOfLinear},  QuestionKind{"settling-test", settlingTest},
    QuestionKind{"N.L", cosineByHand},          QuestionKind{"wrong-sort", wrongSort},
    QuestionKind{"table-ratio", ratioOfTable},  QuestionKind{"cut-place", placeOfCut},
    QuestionKind{"R.V", highlightByHand},       QuestionKind{"nearest-z", nearestZ},
    QuestionKind{"equation", equationByHand},   QuestionKind{"faces-at-pixel", facesAtAPixel},
    QuestionKind{"stored-value", storedValue},  QuestionKind{"back-faces", backFaces},
    QuestionKind{"attenuation", fadeByHand},    QuestionKind{"gouraud-row", gouraudOnARow},
    QuestionKind{"normal", normalByHand},       QuestionKind{"cell-corrected", cellOfCorrected},
    QuestionKind{"vertex-normal", vertexNormal}};

/// The characters that mean something in a GIFT file.
std::string inGift(const std::string& text) {
  std::string gift;
  for (const char c : text) {
    if (std::string_view{"~=#{}:\\"}.find(c) != std::string_view::npos) gift += '\\';
    gift += c;
  }
  return gift;
}

/// A number with the decimals that the question asks for.
std::string numberText(const ExamQuestion& q) {
  return fixed(q.number, q.tolerance >= 0.1 ? 1 : q.tolerance >= 0.001 ? 3 : q.tolerance > 0 ? 4 : 0);
}

/// 0, 1 and -1 are guessed.
bool isGuessed(const ExamQuestion& q) {
  if (!q.choices.empty() && q.tolerance == 0) return false;
  return std::abs(q.number) < 0.001 || std::abs(std::abs(q.number) - 1) < 0.001;
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
      name{scene.name} {
  const CellPlan plan{settings.table.kind};
  const Picture right = makePicture(scene, settings, plan[Cell::Well]);
  png = encodePng(right.image(), right.palette(plan));
}

std::vector<ExamQuestion> makeQuestions(const QuestionScene& scene, int count, unsigned seed) {
  Dice dice{seed};
  std::vector<ExamQuestion> questions;
  std::set<std::string> texts;
  // A kind that the scene has no question of, or no new one, is left out.
  for (std::size_t k = 0, tries = 0;
       static_cast<int>(questions.size()) < count && tries < 50u * static_cast<unsigned>(count) + 500u;
       k = (k + 1) % kQuestionKinds.size(), ++tries)
    if (auto one = kQuestionKinds[k].make(dice, scene); one && !isGuessed(*one)) {
      one->kind = kQuestionKinds[k].name;
      std::string all = one->text;
      for (const std::string& line : one->lines) all += '\n' + line;
      if (texts.insert(all).second) questions.push_back(std::move(*one));
    }
  return questions;
}

std::string questionsAsGift(const std::vector<ExamQuestion>& questions, const std::string& png) {
  std::string gift = "// questions in Moodle's GIFT format\n";
  for (std::size_t k = 0; k < questions.size(); ++k) {
    const ExamQuestion& q = questions[k];
    std::string text = q.text;
    if (!q.lines.empty()) {
      text = element("p", q.text) + imageElement(png);
      for (const std::string& line : q.lines) text += element("p", line);
      std::ranges::replace(text, '\n', ' ');
    }
    gift += "\n::" + std::to_string(k + 1) + " " + inGift(q.kind) +
            "::" + (q.lines.empty() ? " " : "[html]") + inGift(text) + " {";
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
    for (const std::string& line : q.lines) add(asked, std::string(number.size(), ' '), line);
    const auto letter = [](std::size_t choice) { return std::string{static_cast<char>('a' + choice)}; };
    for (std::size_t c = 0; c < q.choices.size(); ++c)
      asked += "   " + letter(c) + ") " + q.choices[c] + '\n';
    asked += '\n';
    add(solved, number, (q.choices.empty() ? numberText(q) : letter(q.right)) + ". " + q.solution);
  }
  return all;
}

}  // namespace xnewell
