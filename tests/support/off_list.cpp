#include "tests/support/student.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace student {

namespace {

double sq(double v) { return v * v; }

/// The terms without Ia, f and Ip; the last two multiply d and s.
struct Terms {
  double a, d, s, fog = 1;
};
using Changed = std::function<void(Terms& t, const Place& p, double c, double r, double lit)>;
using Added = std::function<double(double a, double d, double s)>;

const std::map<std::string, Changed> kTerms{
{"half-lambert", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * (p.NL + 1) / 2; }},
{"half-lambert-2", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * sq((p.NL + 1) / 2); }},
{"squared", [](Terms& t, const Place& p, double c, double, double) { t.d = p.kd * c * c; }},
{"root", [](Terms& t, const Place& p, double c, double, double) { t.d = p.kd * std::sqrt(c); }},
{"power-1.5", [](Terms& t, const Place& p, double c, double, double) { t.d = p.kd * std::pow(c, 1.5); }},
{"cubed", [](Terms& t, const Place& p, double c, double, double) { t.d = p.kd * c * c * c; }},
{"smoothstep", [](Terms& t, const Place& p, double c, double, double) { t.d = p.kd * c * c * (3 - 2 * c); }},
{"step", [](Terms& t, const Place& p, double c, double, double) { t.d = c > 0 ? p.kd : 0; }},
{"toon", [](Terms& t, const Place& p, double c, double, double) { t.d = p.kd * std::floor(4 * c) / 4; }},
{"angle-180", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * (1 - std::acos(p.NL) / 3.14159265); }},
{"cos-of-degrees", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * std::max(0.0, std::cos(std::acos(p.NL) * 57.29578)); }},
{"sine", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * std::sqrt(std::max(0.0, 1 - p.NL * p.NL)); }},
{"one-minus", [](Terms& t, const Place& p, double c, double, double) { t.d = p.kd * (1 - c); }},
{"least-0.2", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * std::max(0.2, p.NL); }},
{"back-half", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * (p.NL < 0 ? -0.5 * p.NL : p.NL); }},
{"NV", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * std::fabs(p.NV); }},
{"NL-NV", [](Terms& t, const Place& p, double c, double, double) { t.d = p.kd * c * std::fabs(p.NV); }},
{"seeliger", [](Terms& t, const Place& p, double c, double, double) { t.d = p.kd * c / std::max(0.01, c + std::fabs(p.NV)); }},
{"minnaert", [](Terms& t, const Place& p, double c, double, double) { t.d = p.kd * c * std::pow(c * std::fabs(p.NV), 0.3); }},
{"oren-nayar", [](Terms& t, const Place& p, double c, double, double) { t.d = p.kd * c * (1 - 0.4 * (1 - c * std::fabs(p.NV))); }},
{"number-kd-squared", [](Terms& t, const Place& p, double, double, double) { t.d *= p.kd; }},
{"number-ks-for-kd", [](Terms& t, const Place& p, double c, double, double) { t.d = p.ks * c; }},
{"number-kd-forgotten", [](Terms& t, const Place&, double c, double, double) { t.d = c; }},
{"number-kd-less-ks", [](Terms& t, const Place& p, double, double, double) { t.d *= 1 - p.ks; }},
{"number-kd-plus-ka", [](Terms& t, const Place& p, double c, double, double) { t.d = (p.kd + p.ka) * c; }},
{"number-diffuse-half", [](Terms& t, const Place&, double, double, double) { t.d /= 2; }},
{"number-diffuse-twice", [](Terms& t, const Place&, double, double, double) { t.d *= 2; }},
{"diffuse-less", [](Terms& t, const Place&, double, double, double) { t.d = -t.d; }},
{"NL-to-n-diffuse", [](Terms& t, const Place& p, double c, double, double) { t.d = p.kd * std::pow(c, p.n); }},
{"abs-N", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * std::max(0.0, std::fabs(p.N[0]) * p.L[0] + std::fabs(p.N[1]) * p.L[1] + std::fabs(p.N[2]) * p.L[2]); }},
{"N-without-z", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * std::max(0.0, p.N[0] * p.L[0] + p.N[1] * p.L[1]); }},
{"N-only-z", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * std::max(0.0, p.N[2]); }},
{"N-yz-swapped", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * std::max(0.0, p.N[0] * p.L[0] + p.N[2] * p.L[1] + p.N[1] * p.L[2]); }},
{"N-rounded", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * std::max(0.0, std::round(2 * p.N[0]) / 2 * p.L[0] + std::round(2 * p.N[1]) / 2 * p.L[1] + std::round(2 * p.N[2]) / 2 * p.L[2]); }},
{"dot-of-abs", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * (std::fabs(p.N[0] * p.L[0]) + std::fabs(p.N[1] * p.L[1]) + std::fabs(p.N[2] * p.L[2])); }},
{"dot-minus-z", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * std::max(0.0, p.N[0] * p.L[0] + p.N[1] * p.L[1] - p.N[2] * p.L[2]); }},
{"largest-of-dot", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * std::max({0.0, p.N[0] * p.L[0], p.N[1] * p.L[1], p.N[2] * p.L[2]}); }},
{"wrapped-light", [](Terms& t, const Place& p, double, double, double) { t.d = p.kd * std::max(0.0, (p.NL + 0.3) / 1.3); }},
{"number-no-highlight-n", [](Terms& t, const Place& p, double, double, double lit) { t.s = lit * p.ks; }},
{"number-n-plus-1", [](Terms& t, const Place& p, double, double r, double lit) { t.s = lit * p.ks * std::pow(r, p.n + 1); }},
{"number-n-half", [](Terms& t, const Place& p, double, double r, double lit) { t.s = lit * p.ks * std::pow(r, p.n / 2.0); }},
{"number-n-squared", [](Terms& t, const Place& p, double, double r, double lit) { t.s = lit * p.ks * std::pow(r, p.n * p.n); }},
{"number-n-by-ten", [](Terms& t, const Place& p, double, double r, double lit) { t.s = lit * p.ks * std::pow(r, 10.0 * p.n); }},
{"number-n-3.1", [](Terms& t, const Place& p, double, double r, double lit) { t.s = lit * p.ks * std::pow(r, p.n * 1.033); }},
{"n-outside", [](Terms& t, const Place& p, double, double, double) { t.s *= p.n; }},
{"n-over", [](Terms& t, const Place& p, double, double r, double lit) { t.s = lit * p.ks * r / p.n; }},
{"n-to-RV", [](Terms& t, const Place& p, double, double r, double lit) { t.s = lit * p.ks * std::pow(p.n, r) / p.n; }},
{"schlick", [](Terms& t, const Place& p, double, double r, double lit) { t.s = lit * p.ks * r / std::max(0.01, p.n - p.n * r + r); }},
{"gauss", [](Terms& t, const Place& p, double, double r, double lit) { t.s = lit * p.ks * std::exp(-p.n * (1 - r)); }},
{"number-normalised", [](Terms& t, const Place& p, double, double, double) { t.s *= (p.n + 2) / 8.0; }},
{"fresnel", [](Terms& t, const Place& p, double, double, double) { t.s *= std::pow(1 - std::fabs(p.NV), 2); }},
{"spec-times-NV", [](Terms& t, const Place& p, double, double, double) { t.s *= std::fabs(p.NV); }},
{"spec-over-NV", [](Terms& t, const Place& p, double, double, double) { t.s /= std::max(0.2, std::fabs(p.NV)); }},
{"spec-times-NL-squared", [](Terms& t, const Place&, double c, double, double) { t.s *= c * c; }},
{"number-spec-times-kd", [](Terms& t, const Place& p, double, double, double) { t.s *= p.kd; }},
{"number-spec-squared", [](Terms& t, const Place& p, double, double, double) { t.s *= t.s / std::max(0.01, p.ks); }},
{"number-spec-half", [](Terms& t, const Place&, double, double, double) { t.s /= 2; }},
{"number-spec-twice", [](Terms& t, const Place&, double, double, double) { t.s *= 2; }},
{"spec-less", [](Terms& t, const Place&, double, double, double) { t.s = -t.s; }},
{"number-kd-for-ks", [](Terms& t, const Place& p, double, double r, double lit) { t.s = lit * p.kd * std::pow(r, p.n); }},
{"number-ks-forgotten", [](Terms& t, const Place& p, double, double r, double lit) { t.s = lit * std::pow(r, p.n); }},
{"spec-step", [](Terms& t, const Place& p, double, double r, double lit) { t.s = r > 0.9 ? lit * p.ks : 0; }},
{"LV", [](Terms& t, const Place& p, double, double, double lit) { t.s = lit * p.ks * std::pow(std::max(0.0, dotOf(p.L, p.V)), p.n); }},
{"NV-to-n", [](Terms& t, const Place& p, double, double, double lit) { t.s = lit * p.ks * std::pow(std::fabs(p.NV), p.n); }},
{"H-long", [](Terms& t, const Place& p, double, double, double lit) { t.s = lit * p.ks * std::pow(std::max(0.0, p.NL + p.NV), p.n); }},
{"H-mean", [](Terms& t, const Place& p, double, double, double lit) { t.s = lit * p.ks * std::pow(std::max(0.0, (p.NL + p.NV) / 2), p.n); }},
{"R-without-L", [](Terms& t, const Place& p, double, double, double lit) { t.s = lit * p.ks * std::pow(std::max(0.0, 2 * p.NL * p.NV), p.n); }},
{"R-half-L", [](Terms& t, const Place& p, double, double, double lit) { t.s = lit * p.ks * std::pow(std::max(0.0, 2 * p.NL * p.NV - dotOf(p.L, p.V) / 2), p.n); }},
{"R-of-L", [](Terms& t, const Place& p, double, double, double lit) { t.s = lit * p.ks * std::pow(std::max(0.0, 2 * p.NL * dotOf(p.L, p.V) - p.NV), p.n); }},
{"R-with-3", [](Terms& t, const Place& p, double, double, double lit) { t.s = lit * p.ks * std::pow(std::clamp(3 * p.NL * p.NV - dotOf(p.L, p.V), 0.0, 1.0), p.n); }},
{"rim", [](Terms& t, const Place& p, double, double, double) { t.s += 0.3 * std::pow(1 - std::fabs(p.NV), 3); }},
{"V-is-z", [](Terms& t, const Place& p, double, double, double lit) { t.s = lit * p.ks * std::pow(std::max(0.0, 2 * p.NL * p.N[2] - p.L[2]), p.n); }},
{"RV-by-angle", [](Terms& t, const Place& p, double, double r, double lit) { t.s = lit * p.ks * std::pow(std::max(0.0, 1 - std::acos(std::min(1.0, r)) / 1.5707963), p.n); }},
{"mean-of-cosines", [](Terms& t, const Place& p, double c, double r, double lit) { t.s = lit * p.ks * std::pow((c + r) / 2, p.n); }},
{"product-of-cosines", [](Terms& t, const Place& p, double c, double r, double lit) { t.s = lit * p.ks * std::pow(c * r, p.n); }},
{"ambient-by-NV", [](Terms& t, const Place& p, double, double, double) { t.a *= std::fabs(p.NV); }},
{"ambient-by-NL", [](Terms& t, const Place&, double c, double, double) { t.a *= c; }},
{"ambient-in-the-light", [](Terms& t, const Place&, double, double, double lit) { t.a *= lit; }},
{"ambient-hemisphere", [](Terms& t, const Place& p, double, double, double) { t.a *= (1 + p.N[2]) / 2; }},
{"number-ambient-half", [](Terms& t, const Place&, double, double, double) { t.a /= 2; }},
{"number-ambient-thrice", [](Terms& t, const Place&, double, double, double) { t.a *= 3; }},
{"number-ambient-kd", [](Terms& t, const Place& p, double, double, double) { t.a = p.kd * p.Ia; }},
{"number-ambient-Ip", [](Terms& t, const Place& p, double, double, double) { t.a *= p.Ip; }},
{"number-ambient-Ip-for-Ia", [](Terms& t, const Place& p, double, double, double) { t.a = p.ka * p.Ip; }},
{"number-ambient-ka-alone", [](Terms& t, const Place& p, double, double, double) { t.a = p.ka; }},
{"number-ambient-squared", [](Terms& t, const Place&, double, double, double) { t.a *= t.a; }},
{"ambient-less", [](Terms& t, const Place&, double, double, double) { t.a = -t.a; }},
{"number-Ip-squared", [](Terms& t, const Place& p, double, double, double) { t.d *= p.Ip, t.s *= p.Ip; }},
{"number-Ia-for-Ip", [](Terms& t, const Place& p, double, double, double) { t.d *= p.Ia / p.Ip, t.s *= p.Ia / p.Ip; }},
{"Ip-on-ambient-too", [](Terms& t, const Place& p, double, double, double) { t.a *= p.Ip, t.d *= 1.2; }},
{"by-distance", [](Terms& t, const Place& p, double, double, double) { t.d /= 1 + 0.2 * p.d, t.s /= 1 + 0.2 * p.d; }},
{"fog", [](Terms& t, const Place& p, double, double, double) { t.fog = std::exp(-0.1 * p.d); }},
{"f-squared", [](Terms& t, const Place& p, double, double, double) { t.d *= p.f, t.s *= p.f; }},
};
const std::map<std::string, Added> kSums{
    {"product", [](double a, double d, double s) { return a + d * (1 + s); }},
    {"screen", [](double a, double d, double s) { return 1 - (1 - a) * (1 - d) * (1 - s); }},
    {"root-of-squares", [](double a, double d, double s) { return std::sqrt(a * a + d * d + s * s); }},
    {"larger-of-two", [](double a, double d, double s) { return std::max(a, d + s); }},
    {"least",
     [](double a, double d, double s) {
       return std::min({a + 0.3, d + 0.3, s + 0.3});
     }},
    {"mean", [](double a, double d, double s) { return (a + d + s) / 3; }},
    {"half", [](double a, double d, double s) { return (a + d + s) / 2; }},
    {"number-less-0.1", [](double a, double d, double s) { return a + d + s - 0.1; }},
    {"number-plus-0.1", [](double a, double d, double s) { return a + d + s + 0.1; }},
    {"lifted", [](double a, double d, double s) { return 0.5 + (a + d + s) / 2; }},
    {"I-squared", [](double a, double d, double s) { return sq(a + d + s); }},
    {"I-root", [](double a, double d, double s) { return std::sqrt(std::max(0.0, a + d + s)); }},
    {"I-at-most-0.8", [](double a, double d, double s) { return std::min(0.8, a + d + s); }},
    {"I-in-eighths", [](double a, double d, double s) { return std::round(8 * (a + d + s)) / 8; }},
    {"I-in-tenths", [](double a, double d, double s) { return std::floor(10 * (a + d + s)) / 10; }},
    {"I-sine",
     [](double a, double d, double s) { return std::sin(1.5707963 * std::clamp(a + d + s, 0.0, 1.0)); }},
    {"I-times-1.1", [](double a, double d, double s) { return 1.1 * (a + d + s); }},
    {"I-times-0.9", [](double a, double d, double s) { return 0.9 * (a + d + s); }},
    {"contrast", [](double a, double d, double s) { return 0.5 + 1.5 * (a + d + s - 0.5); }},
    {"diffuse-under-highlight", [](double a, double d, double s) { return a + d * (1 - s) + s; }},
    {"number-highlight-in-ambient", [](double a, double d, double s) { return a * (1 + s) + d; }},
    {"wrapped", [](double a, double d, double s) { return (a + d + s) - std::floor(a + d + s); }},
    {"ambient-times-rest", [](double a, double d, double s) { return a * (d + s) * 5; }},
    {"tone-by-2", [](double a, double d, double s) { return 2 * (a + d + s) / (1 + 2 * (a + d + s)); }},
    {"log", [](double a, double d, double s) { return std::log(1 + a + d + s); }},
};

}  // namespace

const std::vector<std::string>& offListKeys() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> keys;
    for (const auto& [key, change] : kTerms) keys.push_back("off-" + key);
    for (const auto& [key, sum] : kSums) keys.push_back("off-" + key);
    return keys;
  }();
  return all;
}

double offList(const std::string& key, const Place& p) {
  const double c = std::max(0.0, p.NL), r = std::max(0.0, p.RV), lit = p.NL > 0 ? 1 : 0;
  Terms t{p.ka * p.Ia, p.kd * c, lit * p.ks * std::pow(r, p.n)};
  const auto change = kTerms.find(key.substr(4));
  if (change != kTerms.end()) change->second(t, p, c, r, lit);
  t.d *= p.f * p.Ip, t.s *= p.f * p.Ip;
  const auto sum = kSums.find(key.substr(4));
  return t.fog * (sum != kSums.end() ? sum->second(t.a, t.d, t.s) : t.a + t.d + t.s);
}

}  // namespace student
