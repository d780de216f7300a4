#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// A picture that surfaces wear: its texels are the diffuse term. Without end in both directions: it repeats.
struct Texture {
  int width = 0, height = 0;  ///< 1..8192 each
  std::array<std::vector<std::uint8_t>, 3>
      channel;                     ///< RGB, row by row from the top; 255 is all of the light
  std::vector<std::uint8_t> gray;  ///< for pictures of one channel: 0.30 R + 0.59 G + 0.11 B, rounded
  bool colored = false;            ///< whether the channels differ anywhere
};

/// A PNG, rows from the top. @throws as readPng()
[[nodiscard]] Texture readTexture(const std::string& file);

/// How texture coordinates, and Phong's normals and places, are interpolated over the screen: with 1/w, so
/// that they stay in place on the surface, or by a plane, as the first programs did: they swim in
/// perspective.
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
