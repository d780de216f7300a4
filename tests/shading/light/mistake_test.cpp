#include "shading/light/mistake.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <set>

namespace xnewell::THIS_FILE {

namespace {

struct Values {
  double diffuse, specular;
};

/// What each mistake computes, written out by hand from its name, for the textbook's form. N, L and V are
/// unit vectors; kd = 0.9, ks = 0.4, f = 0.5, Ip = 0.7.
Values byHand(Mistake mistake, const glm::dvec3& N, const glm::dvec3& L, const glm::dvec3& V, int n) {
  const double kd = 0.9, ks = 0.4, fIp = 0.35;
  const double NL = N.x * L.x + N.y * L.y + N.z * L.z;
  const double NV = N.x * V.x + N.y * V.y + N.z * V.z;
  const double LV = L.x * V.x + L.y * V.y + L.z * V.z;
  const double RV = 2 * NL * NV - LV;
  const auto pos = [](double v) { return v > 0 ? v : 0; };
  const double lit = NL > 0 ? 1 : 0, d = fIp * kd * pos(NL), s = lit * fIp * ks * std::pow(pos(RV), n);
  switch (mistake) {
    case Mistake::None:
    case Mistake::NotUnitN:  // that is for whoever makes N
    case Mistake::NoAmbient:
    case Mistake::TwiceAmbient:
      return {d, s};
    case Mistake::FacingUnclamped:
      return {fIp * kd * NL, s};
    case Mistake::FacingAbsolute:
      return {fIp * kd * std::abs(NL), s};
    case Mistake::FacingByAngle:
      return {fIp * kd * pos(1 - std::acos(NL) / std::acos(0.0)), s};
    case Mistake::ReflectedUnclamped:
      return {d, lit * fIp * ks * std::pow(RV, n)};
    case Mistake::ReflectedAbsolute:
      return {d, lit * fIp * ks * std::pow(std::abs(RV), n)};
    case Mistake::HighlightBehind:
      return {d, fIp * ks * std::pow(pos(RV), n)};
    case Mistake::InwardN:  // R stays
      return {fIp * kd * pos(-NL), NL < 0 ? fIp * ks * std::pow(pos(RV), n) : 0};
    case Mistake::ReversedL:
      return {fIp * kd * pos(-NL), NL < 0 ? fIp * ks * std::pow(pos(-RV), n) : 0};
    case Mistake::ReversedV:
    case Mistake::ReversedR:  // the same by algebra
      return {d, lit * fIp * ks * std::pow(pos(-RV), n)};
    case Mistake::RWithout2:
      return {d, lit * fIp * ks * std::pow(pos(NL * NV - LV), n)};
    case Mistake::PowerOfSum: {
      const double sum = kd * pos(NL) + ks * pos(RV);
      const double both = fIp * std::pow(sum, n), share = sum > 0 ? ks * pos(RV) / sum : 0;
      return {both * (1 - share), lit * both * share};
    }
    case Mistake::NoPower:
      return {d, lit * fIp * ks * pos(RV)};
    case Mistake::KsInPower:
      return {d, lit * fIp * std::pow(ks * pos(RV), n)};
    case Mistake::HighlightTimesFacing:
      return {d, s * pos(NL)};
    case Mistake::SwappedKs:
      return {d * ks / kd, s * kd / ks};
    case Mistake::NoIp:
      return {d / 0.7, s / 0.7};
    case Mistake::IpNotOnHighlight:
      return {d, s / 0.7};
    case Mistake::NoDiffuse:
      return {0, s};
    case Mistake::NoSpecular:
      return {d, 0};
  }
  return {NAN, NAN};
}

glm::dvec3 anyDirection(std::mt19937& random) {
  std::uniform_real_distribution<double> number{-1.0, 1.0};
  return glm::normalize(glm::dvec3{number(random), number(random), number(random)});
}

}  // namespace

// Each row computes what its name says, in front of the light and behind it, for even and odd n. On some
// place each of them differs from the course's equation, or it is one that changes no term of a light.
TEST(Mistake, ComputesWhatItsNameSays) {
  const Reflection surface[2] = {{0.5, 0.9, 0.4, 3}, {0.5, 0.9, 0.4, 6}};
  for (const MistakeRow& row : kMistakes) {
    SCOPED_TRACE(row.name);
    EXPECT_EQ(&row, &rowOf(row.id));
    double differs = 0;
    for (unsigned seed = 0; seed < 2'000; ++seed) {
      std::mt19937 random{seed};
      const EquationVectors at{anyDirection(random), anyDirection(random), anyDirection(random)};
      const Reflection& one = surface[seed % 2];
      const LightTerms terms = lightTerms(row.id, 0.5, 0.7, one, at, Form::Textbook);
      const Values hand = byHand(row.id, at.N, at.L, at.V, one.n);
      ASSERT_NEAR(terms.diffuse, hand.diffuse, 1e-12) << seed;
      ASSERT_NEAR(terms.specular, hand.specular, 1e-12) << seed;
      const IlluminationTerms course = termsOf(0.0, 0.7, 0.5, 1.0, one, glm::dot(at.N, at.L),
                                               specularCosine(Form::Textbook, at.N, at.L, at.V));
      differs = std::max(
          {differs, std::abs(terms.diffuse - course.diffuse), std::abs(terms.specular - course.specular)});
      if (row.id != Mistake::None) continue;
      ASSERT_EQ(terms.diffuse, course.diffuse);
      ASSERT_EQ(terms.specular, course.specular);
    }
    const bool elsewhere = row.id == Mistake::None || row.longN || row.ambient != 1.0;
    EXPECT_EQ(differs > 0.01, !elsewhere);
  }
}

// Names are those of options: unique, without blanks. Each row has words for every place that shows them.
TEST(Mistake, HasNamesAndWords) {
  std::set<std::string_view> names;
  for (const MistakeRow& row : kMistakes) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(row.name.find(' '), std::string_view::npos) << row.name;
    EXPECT_FALSE(row.label.empty() || row.words.empty()) << row.name;
    EXPECT_TRUE(row.is.ends_with('.')) << row.name;
  }
}

}  // namespace xnewell::THIS_FILE
