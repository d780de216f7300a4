#include "x11/emulation.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "shading/quantize.h"

namespace {

int squaredDistance(const glm::ivec3& p, const glm::ivec3& q) {
  const glm::ivec3 d = p - q;
  return d.r * d.r + d.g * d.g + d.b * d.b;
}

int brightness(const glm::ivec3& c) { return 30 * c.r + 59 * c.g + 11 * c.b; }

}  // namespace

OfferedColors::Channel::Channel(unsigned long mask, const std::function<int(unsigned long)>& shown) {
  const unsigned long step = mask & -mask;  // from level to level
  unsigned long level = 0;
  for (int v = 0; v < 256; ++v) {
    const auto distance = [&](unsigned long l) { return std::abs(shown(l) - v); };
    // Equal levels in a row, as where few bits of a stored colour count, are passed too.
    for (unsigned long next = level; next != mask;) {
      next += step;
      if (distance(next) > distance(level)) break;
      level = next;
    }
    shows[v] = shown(level);
    bits[v] = level;
  }
}

OfferedColors::OfferedColors(const ChannelMasks& masks, unsigned long opaque,
                             const std::function<Rgb16(unsigned long)>& shown)
    : opaque_{opaque} {
  channels_.emplace_back(masks.red, [&](unsigned long bits) { return shown(bits).r >> 8; });
  channels_.emplace_back(masks.green, [&](unsigned long bits) { return shown(bits).g >> 8; });
  channels_.emplace_back(masks.blue, [&](unsigned long bits) { return shown(bits).b >> 8; });
}

OfferedColor OfferedColors::nearest(const glm::ivec3& target) const {
  if (!channels_.empty()) {
    OfferedColor found{opaque_, {}};
    for (int c = 0; c < 3; ++c) {
      const int v = std::clamp(target[c], 0, 255);
      found.pixel |= channels_[c].bits[v];
      found.color[c] = channels_[c].shows[v];
    }
    return found;
  }
  const OfferedColor* best = nullptr;
  int least = std::numeric_limits<int>::max();
  for (const OfferedColor& offered : list_)
    if (const int distance = squaredDistance(offered.color, target); distance <= least)
      least = distance, best = &offered;
  return *best;
}

Tile OfferedColors::mixture(const glm::ivec3& wanted) const {
  std::array<OfferedColor, 64> mixed;
  glm::ivec3 owed{0};  // at most 64 * 255, so that squares of it fit an int
  for (OfferedColor& next : mixed) {
    next = nearest(wanted + owed);
    owed += wanted - next.color;
  }
  std::ranges::stable_sort(mixed, [](const OfferedColor& p, const OfferedColor& q) {
    return brightness(p.color) > brightness(q.color);
  });
  Tile tile;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) tile[placeInTile(x, y)] = mixed[bayerRank(x, y)].pixel;
  return tile;
}

void PixelTable::set(int index, unsigned long pixel) {
  pixels_[index] = pixel;
  for (std::array<unsigned long, 256>& place : places_) place[index] = pixel;
}

void PixelTable::set(int index, unsigned long pixel, const Tile& tile) {
  set(index, pixel);
  if (std::ranges::all_of(tile, [&](unsigned long p) { return p == pixel; })) return;
  if (places_.empty()) places_.assign(tile.size(), pixels_);
  for (std::size_t place = 0; place < tile.size(); ++place) places_[place][index] = tile[place];
}

Tile PixelTable::tile(int index) const {
  Tile tile;
  tile.fill(pixels_[index]);
  for (std::size_t place = 0; place < places_.size(); ++place) tile[place] = places_[place][index];
  return tile;
}

bool PixelTable::solid(int index) const {
  return std::ranges::all_of(places_, [&](const auto& place) { return place[index] == pixels_[index]; });
}
