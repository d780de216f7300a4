#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/model/mesh.h"
#include "tests/support/near_judge.h"

namespace xnewell {

/// Seeded scenes in which surfaces nearly touch, each with a camera, as near_judge.h takes them.
enum class Near { Rugs, TiledWall, Sheets, Cards, Cycle, Triangles, Boxes };
struct NearRow {
  Near id;
  std::string_view name;
};
inline constexpr std::array kNear{
    NearRow{Near::Rugs, "rugs above a floor, the eye close to it"},
    NearRow{Near::TiledWall, "a wall of tiles with decals"},
    NearRow{Near::Sheets, "sheets that are nearly parallel"},
    NearRow{Near::Cards, "cards in layers"},
    NearRow{Near::Cycle, "planks that lie over one another in a cycle, nearly in one plane"},
    NearRow{Near::Triangles, "triangles nearly in one plane, the eye close to them"},
    NearRow{Near::Boxes, "boxes on a floor, with decals"},
};

struct NearScene {
  Mesh mesh;                ///< rounded to decimals, in units of the file
  std::vector<int> madeIn;  ///< as judged() takes it
  double u = 0;
  JudgedCamera camera;
};

/// The scene of a family. `seed` selects 3 to 17 decimals, the kind of the view, the size (1e-6 to 1e6) and
/// the rest. A wall has 10 x 10 to `mostTiles` x `mostTiles` tiles.
[[nodiscard]] NearScene nearScene(Near family, unsigned seed, int mostTiles);

/// The number of the face plus 1 that the program shows at each sample, 0 for none.
[[nodiscard]] std::vector<std::uint32_t> shownFaces(const Mesh& mesh, const JudgedCamera& camera, int width,
                                                    int height);

}  // namespace xnewell
