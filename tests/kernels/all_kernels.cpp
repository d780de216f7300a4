#include "tests/kernels/kernel.h"

namespace xnewell {

std::vector<Kernel> allKernels() {
  std::vector<Kernel> kernels;
  addTrigKernels(kernels);
  addExactKernels(kernels);
  addModelKernels(kernels);
  addViewKernels(kernels);
  addPlaneKernels(kernels);
  addColorKernels(kernels);
  addLightKernels(kernels);
  addFillKernels(kernels);
  return kernels;
}

}  // namespace xnewell
