#pragma once

#include "shading/scene/scene.h"

namespace xnewell {

/// Curved surfaces with other polygons. The scene keeps its units, lights, materials and all faces that are
/// of no curved surface. Nothing is read again.

/// The scene with other divisions of those patches that do not set their own (PatchRun::own).
[[nodiscard]] Scene dividedAnew(const Scene& scene, int divisions);

/// The scene with all curved surfaces as fine as a reference needs: patches, spheres and tori, whatever
/// divisions the file sets. Each has finestDivisions() or more.
[[nodiscard]] Scene finelyDivided(const Scene& scene);
/// True if finelyDivided() has other faces.
[[nodiscard]] bool isCoarse(const Scene& scene);
/// 64, or as many as give no more than 300,000 faces; at least 1. A patch has the square of it. A quarter of
/// a sphere's or a torus' circle has as many, so a sphere counts as 8 patches, and a torus as 16. 0 if
/// nothing is curved.
[[nodiscard]] int finestDivisions(const Scene& scene);

/// The face of `other` that stands for the same part of the surface as a face of `scene`: where their
/// divisions differ, the one at its middle, by parameters. Both are one scene with different divisions.
[[nodiscard]] int sameFaceIn(const Scene& other, const Scene& scene, int face);

}  // namespace xnewell
