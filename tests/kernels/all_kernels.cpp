#include "tests/kernels/kernel.h"

namespace xnewell {

std::vector<Kernel> allKernels() {
  std::vector<Kernel> kernels;
  addTrigKernels(kernels);
  addExactKernels(kernels);
  addModelKernels(kernels);
  addViewKernels(kernels);
  addPlaneKernels(kernels);
  addDoubtKernels(kernels);
  addRecordKernels(kernels);
  addRegionKernels(kernels);
  addColorKernels(kernels);
  addLightKernels(kernels);
  addSpecularKernels(kernels);
  addFillKernels(kernels);
  addTextureKernels(kernels);
  return kernels;
}

}  // namespace xnewell
