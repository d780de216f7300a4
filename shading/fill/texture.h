#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// A picture on a surface: its texels show in the diffuse term (TexelUse). It repeats without end in both
/// directions.
struct Texture {
  int width = 0, height = 0;  ///< 1..8192 each
  std::array<std::vector<std::uint8_t>, 3>
      channel;                     ///< RGB, row by row from the top; 255 reflects all of the light
  std::vector<std::uint8_t> gray;  ///< for pictures of one channel: 0.30 R + 0.59 G + 0.11 B, rounded
  bool colored = false;            ///< whether the channels differ somewhere
};

/// Reads a PNG file. @throws as readPng()
[[nodiscard]] Texture readTexture(const std::string& file);

/// How texture coordinates, and Phong's normals and places, are interpolated over the screen. `perspective`
/// divides by w, so that they stay in place on the surface. `affine` uses a plane, as the first programs did:
/// in a perspective view the texture seems to swim.
enum class TextureMapping { Perspective, Affine };
struct TextureMappingRow {
  TextureMapping id;
  std::string_view name;
};
inline constexpr std::array kTextureMappings{
    TextureMappingRow{TextureMapping::Perspective, "perspective"},
    TextureMappingRow{TextureMapping::Affine, "affine"},
};

}  // namespace xnewell
