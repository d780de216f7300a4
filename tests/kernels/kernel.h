#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/kernels/encoding.h"
#include "tests/kernels/random.h"

namespace xnewell {

/// A kernel is a small piece of the program's arithmetic whose header claims a bound for its error.

/// Half of a unit in the last place of 1: the most that a rounding to nearest changes a double, relatively.
inline constexpr double kU = 0x1p-53;

/// Doubles, whatever the type of the coordinate.
using Numbers = std::vector<double>;

struct Kernel {
  std::string name;
  std::string claim;   ///< the bound, in the words of the header
  std::string header;  ///< which claims it
  std::vector<Coordinate> input = {};
  /// Makes what the program gets of an input, such as unit vectors of any vectors. It always rounds to
  /// nearest. Without it, the program gets the input itself. An empty result stands for an input of which the
  /// header claims nothing.
  std::function<Numbers(const Numbers&)> prepare = {};
  /// The program's own code. It runs in the rounding mode that is searched.
  std::function<Numbers(const Numbers& prepared)> run = {};
  /// The error of `result`, by rational or 256-bit arithmetic, as a share of the bound. A kernel that claims
  /// to be exact has a share above 1 where it is wrong; where it is right, the share says how near to wrong
  /// its estimate came. An input of which the header claims nothing has the share 0.
  std::function<double(const Numbers& prepared, const Numbers& result)> judge = {};
  /// Makes inputs that are likely to be hard, besides those that every kernel gets.
  std::vector<std::function<Numbers(Random&)>> hard = {};
  /// How many times the bound is when the processor does not round to nearest: each rounding may then be off
  /// by a whole last bit instead of half of one. 0: nothing is claimed then, but the program must end.
  double directed = 2;
  /// Evaluations, in those of an ordinary kernel: less for one whose reference takes long.
  double effort = 1;
};

/// All kernels, in the order of the rooms.
[[nodiscard]] std::vector<Kernel> allKernels();

// Each is defined in the file of its name.
void addTrigKernels(std::vector<Kernel>& kernels);
void addExactKernels(std::vector<Kernel>& kernels);
void addModelKernels(std::vector<Kernel>& kernels);
void addViewKernels(std::vector<Kernel>& kernels);
void addPlaneKernels(std::vector<Kernel>& kernels);
void addDoubtKernels(std::vector<Kernel>& kernels);
void addRecordKernels(std::vector<Kernel>& kernels);
void addRegionKernels(std::vector<Kernel>& kernels);
void addColorKernels(std::vector<Kernel>& kernels);
void addLightKernels(std::vector<Kernel>& kernels);
void addSpecularKernels(std::vector<Kernel>& kernels);
void addFillKernels(std::vector<Kernel>& kernels);
void addTextureKernels(std::vector<Kernel>& kernels);

/// The share of an exact kernel that is wrong.
inline constexpr double kWrong = 1e9;

}  // namespace xnewell
