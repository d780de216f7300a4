#include "geometry/exact/trig.h"
#include "tests/kernels/big.h"
#include "tests/kernels/kernel.h"

namespace xnewell {

namespace {

/// The angle in [0, 360), then in radians.
Big radians(double degrees) {
  const Big turns = floor(big(degrees) / 360);
  return (big(degrees) - 360 * turns) * degree();
}

/// An angle at an exponential distance from a multiple of 15 degrees, of many turns or few.
double nearMultiple(Random& random) {
  const double multiple = 15.0 * static_cast<double>(random.integer(-24, 24));
  const double turns = random.oneIn(3) ? 360.0 * std::round(random.power(0, 40)) : 0.0;
  return turns + multiple + random.sign() * random.power(-60, 4);
}

}  // namespace

void addTrigKernels(std::vector<Kernel>& kernels) {
  const std::string header = "geometry/exact/trig.h";
  const double largest = 0x1p52;
  const std::vector<std::function<Numbers(Random&)>> angles{
      [](Random& random) { return Numbers{nearMultiple(random)}; },
      [](Random& random) { return Numbers{random.uniform(-360, 360)}; }};

  kernels.push_back(
      {.name = "sine",
       .claim = "2^-51",
       .header = header,
       .input = {doubles(-largest, largest)},
       .run = [](const Numbers& in) { return Numbers{sinCosDegrees(in[0]).sin}; },
       .judge = [](const Numbers& in,
                   const Numbers& out) { return shareOf(out[0], sin(radians(in[0])), 0x1p-51); },
       .hard = angles});
  kernels.push_back(
      {.name = "cosine",
       .claim = "2^-51",
       .header = header,
       .input = {doubles(-largest, largest)},
       .run = [](const Numbers& in) { return Numbers{sinCosDegrees(in[0]).cos}; },
       .judge = [](const Numbers& in,
                   const Numbers& out) { return shareOf(out[0], cos(radians(in[0])), 0x1p-51); },
       .hard = angles});
  kernels.push_back(
      {.name = "tangent",
       .claim = "2^-48 of it, 2^-1000 to 80 degrees",
       .header = header,
       .input = {doubles(-80, 80)},
       .prepare =
           [](const Numbers& in) { return in[0] == 0 || std::abs(in[0]) >= 0x1p-1000 ? in : Numbers{}; },
       .run = [](const Numbers& in) { return Numbers{tanDegrees(in[0])}; },
       .judge =
           [](const Numbers& in, const Numbers& out) {
             const Big exact = tan(big(in[0]) * degree());
             return shareOf(out[0], exact, 0x1p-48 * abs(exact));
           },
       .hard = {angles[0]}});
  kernels.push_back(
      {.name = "arc tangent",
       .claim = "2^-45 degrees",
       .header = header,
       .input = {doubles(-0x1p1000, 0x1p1000), doubles(-0x1p1000, 0x1p1000)},
       .prepare =
           [](const Numbers& in) {
             const auto sized = [](double v) { return v == 0 || std::abs(v) >= 0x1p-1000; };
             return sized(in[0]) && sized(in[1]) ? in : Numbers{};
           },
       .run = [](const Numbers& in) { return Numbers{degreesOf(in[0], in[1])}; },
       .judge =
           [](const Numbers& in, const Numbers& out) {
             const Big exact =
                 in[0] == 0 && in[1] == 0 ? Big{0} : Big{atan2(big(in[0]), big(in[1])) / degree()};
             // -180 stands for 180.
             const double turned = exact > 90 && out[0] < -90 ? out[0] + 360 : out[0];
             const double back = exact < -90 && turned > 90 ? turned - 360 : turned;
             return shareOf(back, exact, 0x1p-45);
           },
       .hard =
           {[](Random& random) {
              const double a = nearMultiple(random) / 2 * 3.141592653589793 / 180,
                           size = random.power(-990, 990);
              return Numbers{size * std::sin(a), size * std::cos(a)};
            },
            [](Random& random) {  // near the ends of the series: 11.25 and 33.75 degrees, and so on
              const double a =
                  11.25 * static_cast<double>(random.integer(-16, 16)) + random.sign() * random.power(-55, 3);
              return Numbers{std::sin(a * 3.141592653589793 / 180), std::cos(a * 3.141592653589793 / 180)};
            }}});
}

}  // namespace xnewell
