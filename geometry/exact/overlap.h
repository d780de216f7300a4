#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace xnewell {

/// The closed intervals that an item occupies in six dimensions. They are in single precision because memory
/// bandwidth limits the search.
struct ItemBox {
  int item = 0;
  int group = 0;  ///< two items of one group are never reported as a pair
  /// Eight values are compared at once; the last two are always 0.
  std::array<float, 8> low{}, high{};
};

/// True if the boxes overlap in every dimension. Boxes that only touch overlap.
[[nodiscard]] bool overlap(const ItemBox& P, const ItemBox& Q);

/// A cut of a set of boxes in two, at the coordinate `at` of an axis.
struct BoxCut {
  int axis = -1;  ///< -1 if no cut is worth its cost
  float at = 0.0f;
};

/// A set of at most this many boxes is not cut: each box is compared with every other.
constexpr std::size_t kFewBoxes = 64;

/// Chooses where to cut a set of boxes in two: at the median of a sample, along the axis that leaves the
/// fewest pairs of different groups to compare.
[[nodiscard]] BoxCut chooseCut(std::span<const ItemBox> boxes);

/// Boxes are measured anew at most this many times, each time in finer units.
constexpr int kMostRefinements = 4;

/// Cells that divide up to three of the six dimensions evenly: those in which boxes are narrowest beside the
/// room that they lie in. Boxes that overlap are both in one of the cells.
class BoxCells {
 public:
  /// Chooses the cells from a sample of the boxes, which boxAt(0..count - 1) returns. They are about so many
  /// boxes wide.
  template <class BoxAt>
  BoxCells(std::size_t count, const BoxAt& boxAt, double boxesWide = 4.0)
      : BoxCells{sampleOf(count, boxAt), count, boxesWide} {}

  /// The boxes, cell by cell, as indices: those of cell c are [begin[c], begin[c + 1]). A box is in each cell
  /// that it reaches into. There are no cells if cells would not separate the boxes.
  struct Lists {
    std::vector<int> begin, boxes;
    [[nodiscard]] int cells() const { return begin.empty() ? 0 : static_cast<int>(begin.size()) - 1; }
    [[nodiscard]] std::span<const int> operator[](int c) const {
      return {boxes.data() + begin[c], boxes.data() + begin[c + 1]};
    }
  };
  template <class BoxAt>
  [[nodiscard]] Lists lists(std::size_t count, const BoxAt& boxAt) const {
    constexpr std::size_t kMostCellsOfABox = 4;  // on the average
    const int cells = axes_[0].cells * axes_[1].cells * axes_[2].cells;
    Lists lists;
    if (cells < 8) return lists;
    std::vector<int> begin(cells + 2);  // moved by one place, so that filling the lists moves it back
    std::size_t entries = 0;
    for (std::size_t k = 0; k < count; ++k) {
      forCells(boxAt(k), [&](int c) { ++begin[c + 2], ++entries; });
      if (entries > kMostCellsOfABox * count) return lists;
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    lists.boxes.resize(entries);
    for (std::size_t k = 0; k < count; ++k)
      forCells(boxAt(k), [&](int c) { lists.boxes[begin[c + 1]++] = static_cast<int>(k); });
    begin.pop_back();
    lists.begin = std::move(begin);
    return lists;
  }

 private:
  BoxCells(std::span<const ItemBox> sample, std::size_t boxes, double boxesWide);
  template <class BoxAt>
  [[nodiscard]] static std::vector<ItemBox> sampleOf(std::size_t count, const BoxAt& boxAt) {
    constexpr std::size_t kSample = 256;
    std::vector<ItemBox> sample(std::min(kSample, count));
    for (std::size_t s = 0; s < sample.size(); ++s) sample[s] = boxAt(s * count / sample.size());
    return sample;
  }
  struct Axis {
    int axis = 0, cells = 1;
    float from = 0.0f, perUnit = 0.0f;
    /// The cell of a coordinate. It grows with x, so the cells of two intervals that overlap do, too.
    [[nodiscard]] int cellOf(float x) const {
      return static_cast<int>(std::clamp((x - from) * perUnit, 0.0f, static_cast<float>(cells - 1)));
    }
  };
  /// Calls visit(cell) for each cell that the box reaches into.
  template <class Visit>
  void forCells(const ItemBox& box, const Visit& visit) const {
    const auto& [x, y, z] = axes_;
    const int x1 = x.cellOf(box.high[x.axis]), y1 = y.cellOf(box.high[y.axis]),
              z1 = z.cellOf(box.high[z.axis]), z0 = z.cellOf(box.low[z.axis]);
    for (int i = x.cellOf(box.low[x.axis]); i <= x1; ++i)
      for (int j = y.cellOf(box.low[y.axis]); j <= y1; ++j)
        for (int k = z0; k <= z1; ++k) visit((i * y.cells + j) * z.cells + k);
  }

  std::array<Axis, 3> axes_;
};

/// So many boxes are put into cells first.
constexpr std::size_t kManyBoxes = 4096;

template <class Visit, class Refine>
void byHalves(std::span<ItemBox> boxes, const Visit& visit, const Refine& refine, int refined);

/// Calls visit(item, item) for every pair of overlapping boxes of different groups, more than once for some
/// pairs. It puts many boxes into cells, and searches each cell by itself. It halves a set of fewer boxes, or
/// of boxes that cells do not separate, again and again. A box across a cut belongs to both halves. When few
/// boxes are left, or no cut separates them, it compares each box with all boxes of other groups. It
/// overwrites `boxes`. Before it compares more than a few, it calls refine(boxes): this may replace them with
/// boxes of the same items in finer units, if single precision blurs them, and then returns true.
template <class Visit, class Refine>
void forOverlapping(std::span<ItemBox> boxes, const Visit& visit, const Refine& refine, int refined = 0) {
  if (boxes.size() < kManyBoxes) return byHalves(boxes, visit, refine, refined);
  const auto boxAt = [&](std::size_t k) -> const ItemBox& { return boxes[k]; };
  const BoxCells::Lists lists = BoxCells{boxes.size(), boxAt}.lists(boxes.size(), boxAt);
  if (lists.cells() == 0) return byHalves(boxes, visit, refine, refined);
  std::vector<ItemBox> inCell;
  for (int c = 0; c < lists.cells(); ++c) {
    if (lists[c].size() < 2) continue;
    inCell.clear();
    for (const int k : lists[c]) inCell.push_back(boxes[k]);
    byHalves(std::span{inCell}, visit, refine, refined);
  }
}

template <class Visit, class Refine>
void byHalves(std::span<ItemBox> boxes, const Visit& visit, const Refine& refine, int refined) {
  const BoxCut cut = chooseCut(boxes);
  if (cut.axis >= 0) {
    // Sort the boxes into three runs: below the cut, above it, across it. The last two runs form one half.
    // That half is done first; then the boxes across the cut are copied to the place of those above it, to
    // form the other half with those below.
    const auto above = std::partition(boxes.begin(), boxes.end(),
                                      [&](const ItemBox& box) { return box.high[cut.axis] < cut.at; });
    const auto across =
        std::partition(above, boxes.end(), [&](const ItemBox& box) { return box.low[cut.axis] >= cut.at; });
    // The sample predicted that the halves are smaller. Check this for the whole set, or the recursion might
    // not end.
    const auto few = static_cast<std::ptrdiff_t>(boxes.size() / 20);
    if (above - boxes.begin() > few && across - above > few) {
      const std::vector<ItemBox> both(across, boxes.end());
      byHalves(std::span<ItemBox>(above, boxes.end()), visit, refine, refined);
      byHalves(std::span<ItemBox>(boxes.begin(), std::copy(both.begin(), both.end(), above)), visit, refine,
               refined);
      return;
    }
  }
  if (boxes.size() > kFewBoxes && refined < kMostRefinements && refine(boxes))
    return forOverlapping(boxes, visit, refine, refined + 1);
  if (boxes.size() > kFewBoxes) std::ranges::sort(boxes, {}, &ItemBox::group);
  std::size_t run = 0;  // where the run of boxes of the same group as box i begins
  for (std::size_t i = 1; i < boxes.size(); ++i) {
    if (boxes[i].group != boxes[i - 1].group) run = i;
    for (std::size_t j = 0; j < run; ++j)
      if (overlap(boxes[j], boxes[i]) && boxes[j].group != boxes[i].group)
        visit(boxes[j].item, boxes[i].item);
  }
}

/// The same for boxes that have no finer units.
template <class Visit>
void forOverlapping(std::span<ItemBox> boxes, const Visit& visit) {
  forOverlapping(boxes, visit, [](std::span<ItemBox>) { return false; });
}

}  // namespace xnewell
