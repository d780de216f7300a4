#include "shading/fill/texture.h"

#include "shading/color/png.h"

namespace xnewell {

Texture readTexture(const std::string& file) {
  const RgbImage image = readPng(file);
  Texture texture{.width = image.width, .height = image.height, .channel = {}, .gray = {}};
  const std::size_t texels = std::size_t(image.width) * image.height;
  for (int c = 0; c < 3; ++c) {
    texture.channel[c].resize(texels);
    for (std::size_t k = 0; k < texels; ++k) texture.channel[c][k] = image.rgb[3 * k + c];
  }
  texture.gray.resize(texels);
  for (std::size_t k = 0; k < texels; ++k)
    texture.gray[k] = static_cast<std::uint8_t>(
        (30 * texture.channel[0][k] + 59 * texture.channel[1][k] + 11 * texture.channel[2][k] + 50) / 100);
  texture.colored = texture.channel[0] != texture.channel[1] || texture.channel[0] != texture.channel[2];
  return texture;
}

}  // namespace xnewell
