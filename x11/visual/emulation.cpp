#include "x11/visual/emulation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "shading/color/color_difference.h"
#include "shading/color/quantize.h"

namespace xnewell {

namespace {

int squaredDistance(const glm::ivec3& p, const glm::ivec3& q) {
  const glm::ivec3 d = p - q;
  return d.r * d.r + d.g * d.g + d.b * d.b;
}

std::array<std::vector<OfferedLevel>, 3> levelsIn(const ChannelMasks& masks,
                                                  const std::function<Rgb16(unsigned long)>& shown) {
  std::array<std::vector<OfferedLevel>, 3> levels;
  const std::array channels{masks.red, masks.green, masks.blue};
  for (int c = 0; c < 3; ++c) {
    const unsigned long step = channels[c] & -channels[c];
    for (unsigned long l = 0; l < levelsOf(channels[c]); ++l)
      levels[c].push_back({l * step, eightBits(shown(l * step))[c]});
  }
  return levels;
}

int brightness(const glm::ivec3& c) { return 30 * c.r + 59 * c.g + 11 * c.b; }

}  // namespace

OfferedColors::Channel::Channel(const std::vector<OfferedLevel>& offered) : levels{offered.size()} {
  for (int v = 0; v < 256; ++v) {
    const OfferedLevel* best = &offered.front();
    for (const OfferedLevel& level : offered)
      if (std::abs(level.value - v) <= std::abs(best->value - v)) best = &level;
    shows[v] = best->value;
    bits[v] = best->bits;
  }
}

OfferedColors::OfferedColors(const std::array<std::vector<OfferedLevel>, 3>& levels, unsigned long opaque)
    : channels_{levels.begin(), levels.end()}, opaque_{opaque} {}

OfferedColors::OfferedColors(const ChannelMasks& masks, unsigned long opaque,
                             const std::function<Rgb16(unsigned long)>& shown)
    : OfferedColors{levelsIn(masks, shown), opaque} {}

std::size_t OfferedColors::size() const {
  std::size_t size = channels_.empty() ? list_.size() : 1;
  for (const Channel& channel : channels_) size *= channel.levels;
  return size;
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

std::vector<int> OfferedColors::Channel::around(int v) const {
  constexpr std::size_t kEitherSide = 2;
  std::vector<int> found{v};
  for (const int step : {-1, 1}) {
    int last = v;
    const std::size_t enough = found.size() + kEitherSide;
    for (int at = v + step; at >= 0 && at < 256 && found.size() < enough; at += step)
      if (bits[at] != bits[last]) found.push_back(last = at);
  }
  return found;
}

std::vector<OfferedColor> OfferedColors::around(const glm::ivec3& target) const {
  if (channels_.empty()) return list_;
  const auto valuesOf = [&](int c) { return channels_[c].around(std::clamp(target[c], 0, 255)); };
  const std::vector<int> greens = valuesOf(1), blues = valuesOf(2);
  std::vector<OfferedColor> found;
  for (const int red : valuesOf(0))
    for (const int green : greens)
      for (const int blue : blues) found.push_back(nearest({red, green, blue}));
  return found;
}

OfferedColors::Parts OfferedColors::partsOf(const glm::ivec3& wanted) const {
  Parts parts;
  glm::ivec3 owed{0};  // |each component| <= 64 * 255, so its square fits an int
  for (OfferedColor& next : parts) {
    next = nearest(wanted + owed);
    owed += wanted - next.color;
  }
  return parts;
}

double OfferedColors::miss(const glm::ivec3& wanted, bool mixed) const {
  if (!mixed) return glm::distance(glm::dvec3{nearest(wanted).color}, glm::dvec3{wanted});
  const Parts parts = partsOf(wanted);
  glm::dvec3 mean{0};
  for (const OfferedColor& part : parts) mean += glm::dvec3{part.color} / 64.0;
  double variance = 0;
  for (const OfferedColor& part : parts) {
    const glm::dvec3 d = glm::dvec3{part.color} - mean;
    variance += glm::dot(d, d) / 64.0;
  }
  return glm::distance(mean, glm::dvec3{wanted}) + std::sqrt(variance / 64.0);
}

Tile OfferedColors::mixture(const glm::ivec3& wanted) const {
  Parts mixed = partsOf(wanted);
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

namespace {

/// One colour to choose, and the earlier choices between which its lightness must lie. The rows are in the
/// order of choice.
struct Choice {
  Cell cell;
  std::optional<Cell> above, below;
};
using enum Cell;
constexpr std::array kChoices{
    Choice{Black, {}, {}},      Choice{White, {}, {}},          Choice{Paper, {}, {}},
    Choice{WellLine, {}, {}},   Choice{Well, {}, WellLine},     Choice{Soft, WellLine, Paper},
    Choice{Faint, Soft, Paper}, Choice{WellText, Faint, White}, Choice{Rule, {}, Paper},
    Choice{Panel, Rule, Paper}, Choice{Ink, {}, Soft},          Choice{P, WellLine, Rule},
    Choice{Q, WellLine, Paper}, Choice{Good, {}, Panel},        Choice{Alarm, {}, Panel},
    Choice{Focus, Rule, Paper},
};
static_assert(kChoices.size() == kCells);

/// If words miss their colour by more than this (CIEDE2000), they had better be black. With 3:3:2 bits no
/// colour misses by more than 13. Where blue has fewer levels, the nearest to gray is an orange, which misses
/// by 28.
constexpr double kStrange = 20;

Lab labOf(const glm::ivec3& c) {
  const auto wide = [](int v) { return static_cast<std::uint16_t>(257 * v); };
  return labFromSrgb(Rgb16{wide(c.r), wide(c.g), wide(c.b)});
}

}  // namespace

ToolColors chooseToolColors(const OfferedColors& offered, const std::array<glm::ivec3, kCells>& wanted,
                            const std::array<std::optional<OfferedColor>, kCells>& has) {
  ToolColors chosen{};
  const auto of = [&](Cell cell) -> OfferedColor& { return chosen[static_cast<int>(cell)]; };
  for (const auto& [cell, above, below] : kChoices) {
    const int role = static_cast<int>(cell);
    if (has[role]) {
      chosen[role] = *has[role];
      continue;
    }
    const Lab aim = labOf(wanted[role]);
    bool within = false;  // true if the best so far lies between its two neighbours
    double least = std::numeric_limits<double>::infinity();
    for (const OfferedColor& c : offered.around(wanted[role])) {
      const Lab lab = labOf(c.color);
      const bool between =
          !(above && lab.L <= labOf(of(*above).color).L) && !(below && lab.L >= labOf(of(*below).color).L);
      const double difference = ciede2000(lab, aim);
      if (between == within ? difference >= least : within) continue;
      within = between, least = difference, chosen[role] = c;
    }
  }
  for (const Cell text : {Faint, Soft, Ink, Good, Alarm, P}) {
    const glm::ivec3 color = of(text).color;
    const double miss = ciede2000(labOf(color), labOf(wanted[static_cast<int>(text)]));
    if (miss > kStrange || color == of(Paper).color || color == of(Panel).color) of(text) = of(Black);
  }
  if (of(WellText).color == of(Well).color) of(WellText) = of(White);
  return chosen;
}

}  // namespace xnewell
