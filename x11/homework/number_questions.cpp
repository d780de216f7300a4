#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "shading/color/color_table.h"
#include "shading/light/equation.h"
#include "x11/drawing/wording.h"
#include "x11/homework/questions.h"

namespace xnewell {

/// Questions that can be answered with a sheet of paper.

namespace {

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

}  // namespace

std::vector<QuestionKind> numberQuestions() {
  return {{"cell-linear", cellOfLinear},  {"N.L", cosineByHand},
          {"table-ratio", ratioOfTable},  {"R.V", highlightByHand},
          {"equation", equationByHand},   {"stored-value", storedValue},
          {"attenuation", fadeByHand},    {"gouraud-row", gouraudOnARow},
          {"normal", normalByHand},       {"cell-corrected", cellOfCorrected},
          {"vertex-normal", vertexNormal}};
}

}  // namespace xnewell
