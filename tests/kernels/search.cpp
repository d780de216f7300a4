#include "tests/kernels/search.h"

#include <algorithm>
#include <cfenv>
#include <set>

namespace xnewell {

const std::array<RoundingMode, 4> kRoundingModes{
    {{FE_TONEAREST, "nearest"}, {FE_UPWARD, "up"}, {FE_DOWNWARD, "down"}, {FE_TOWARDZERO, "zero"}}};

namespace {

/// Sets a rounding mode and goes back to the nearest at its end.
class InRoundingMode {
 public:
  explicit InRoundingMode(int mode) { std::fesetround(mode); }
  ~InRoundingMode() { std::fesetround(FE_TONEAREST); }
  InRoundingMode(const InRoundingMode&) = delete;
  InRoundingMode& operator=(const InRoundingMode&) = delete;
};

using Encodings = std::vector<std::int64_t>;

/// A box of encodings and the worst input that was seen in it.
struct Box {
  Encodings low, high;
  double share = 0;
  Encodings worst;
};
struct LessBad {
  bool operator()(const Box& a, const Box& b) const { return a.share < b.share; }
};

struct Seen {
  double share;
  Encodings at;
};

constexpr std::size_t kKept = 24;        ///< worst inputs that are followed
constexpr std::size_t kMostBoxes = 512;  ///< the less bad ones are forgotten
constexpr int kInHalf = 4;               ///< samples in each half of a box

class Search {
 public:
  Search(const Kernel& kernel, const RoundingMode& mode, int evaluations, std::uint64_t seed)
      : kernel_{kernel}, mode_{mode}, left_{evaluations}, random_{seed} {
    for (const Coordinate& c : kernel.input) {
      low_.push_back(c.encode(c.low));
      high_.push_back(c.encode(c.high));
    }
  }

  Worst worst() {
    const int all = left_;
    sample(all - all * 3 / 10);
    constexpr int kRounds = 3;
    for (int round = 1; round <= kRounds; ++round) {
      const int until = all * 7 / 10 - all * 6 / 10 * round / kRounds;
      bisect(until + (left_ - until) / 2);
      step(until);
    }
    sweep();
    Worst worst;
    if (!kept_.empty()) worst = {kept_.front().share, decoded(kept_.front().at)};
    return worst;
  }

 private:
  [[nodiscard]] std::size_t size() const { return kernel_.input.size(); }

  [[nodiscard]] Numbers decoded(const Encodings& at) const {
    Numbers input(at.size());
    for (std::size_t k = 0; k < at.size(); ++k) input[k] = kernel_.input[k].decode(at[k]);
    return input;
  }

  double evaluate(const Encodings& at) {
    --left_;
    const double share = shareAt(kernel_, decoded(at), mode_);
    if (share > 0 && (kept_.size() < kKept || share > kept_.back().share)) {
      const bool known = std::ranges::any_of(kept_, [&](const Seen& s) { return s.at == at; });
      if (!known) {
        const auto place = std::ranges::upper_bound(kept_, share, std::greater{}, &Seen::share);
        kept_.insert(place, {share, at});
        if (kept_.size() > kKept) kept_.pop_back();
      }
    }
    return share;
  }

  /// Evaluates a random input of each kind until that many evaluations are left.
  void sample(int until) {
    for (unsigned kind = 0; left_ > until; ++kind) {
      const std::size_t hard = kernel_.hard.size();
      Encodings at(size());
      // Two in three are the kernel's own, if it has any.
      if (hard > 0 && kind % 3 != 0) {
        const Numbers input = kernel_.hard[random_.below(hard)](random_);
        for (std::size_t k = 0; k < size(); ++k)
          at[k] = kernel_.input[k].encode(std::clamp(input[k], kernel_.input[k].low, kernel_.input[k].high));
      } else {
        const bool mixed = random_.oneIn(2);
        const unsigned same = static_cast<unsigned>(random_.below(7));
        for (std::size_t k = 0; k < size(); ++k) at[k] = anywhere(k, mixed ? random_.below(7) : same);
      }
      evaluate(at);
    }
  }

  /// A number of the k-th range that is hard for most kernels.
  std::int64_t anywhere(std::size_t k, std::uint64_t kind) {
    const Coordinate& c = kernel_.input[k];
    const double most = std::max(std::abs(c.low), std::abs(c.high));
    double v = 0;
    switch (kind) {
      case 0:
        return random_.integer(low_[k], high_[k]);
      case 1:
        v = random_.oneIn(2) ? c.low : c.high;
        break;
      case 2:  // a decimal number of a file
        v = std::round(random_.uniform(std::max(-1e6, c.low), std::min(1e6, c.high)) * 1000) / 1000;
        break;
      case 3: {  // next to a power of two
        const double power = std::ldexp(random_.sign(), static_cast<int>(random_.integer(-1074, 1023)));
        if (std::abs(power) > most) {
          v = std::ldexp(random_.sign(),
                         static_cast<int>(random_.integer(-60, std::max(-60, std::ilogb(most)))));
        } else {
          v = power;
        }
        const double inside = std::clamp(v, c.low, c.high);
        return std::clamp(c.encode(inside) + random_.integer(-3, 3), low_[k], high_[k]);
      }
      case 4:  // an exponential length from an end
        v = random_.oneIn(2) ? c.low + most * random_.power(-60, 0) : c.high - most * random_.power(-60, 0);
        break;
      case 5:  // a denormal number, or the neighbours of 0
        v = random_.sign() *
            std::ldexp(static_cast<double>(random_.below(9)), -1074 + static_cast<int>(random_.below(53)));
        break;
      default:
        v = random_.uniform(c.low / 2, c.high / 2) * 2;
        break;
    }
    return c.encode(std::clamp(v, c.low, c.high));
  }

  /// A random place of a box. One in two differs from its worst place in one or two coordinates only.
  Encodings within(const Box& box) {
    Encodings at(size());
    if (!box.worst.empty() && random_.oneIn(2)) {
      for (std::size_t k = 0; k < size(); ++k) at[k] = std::clamp(box.worst[k], box.low[k], box.high[k]);
      for (int n = 0; n < 2; ++n) {
        const std::size_t k = random_.below(size());
        at[k] = random_.integer(box.low[k], box.high[k]);
      }
      return at;
    }
    for (std::size_t k = 0; k < size(); ++k) at[k] = random_.integer(box.low[k], box.high[k]);
    return at;
  }

  [[nodiscard]] std::uint64_t width(const Box& box, std::size_t k) const {
    return static_cast<std::uint64_t>(box.high[k]) - static_cast<std::uint64_t>(box.low[k]);
  }

  /// The encodings within `half` of a place.
  [[nodiscard]] Box around(const Seen& seen, std::int64_t half) const {
    Box box{seen.at, seen.at, seen.share, seen.at};
    for (std::size_t k = 0; k < size(); ++k) {
      const auto below = static_cast<std::uint64_t>(seen.at[k]) - static_cast<std::uint64_t>(low_[k]);
      const auto above = static_cast<std::uint64_t>(high_[k]) - static_cast<std::uint64_t>(seen.at[k]);
      box.low[k] = below > static_cast<std::uint64_t>(half) ? seen.at[k] - half : low_[k];
      box.high[k] = above > static_cast<std::uint64_t>(half) ? seen.at[k] + half : high_[k];
    }
    return box;
  }

  void bisect(int until) {
    std::multiset<Box, LessBad> boxes;
    boxes.insert({low_, high_, kept_.empty() ? 0.0 : kept_.front().share, {}});
    for (const Seen& seen : kept_)
      for (const int exponent : {50, 30, 12}) boxes.insert(around(seen, std::int64_t{1} << exponent));
    while (left_ > until && !boxes.empty()) {
      const Box box = *std::prev(boxes.end());
      boxes.erase(std::prev(boxes.end()));
      // Cut one of the widest coordinates.
      std::size_t widest = random_.below(size());
      for (std::size_t k = 0; k < size(); ++k)
        if (std::bit_width(width(box, k)) > std::bit_width(width(box, widest))) widest = k;
      if (width(box, widest) == 0) continue;
      const auto middle =
          static_cast<std::int64_t>(static_cast<std::uint64_t>(box.low[widest]) + width(box, widest) / 2);
      for (const bool upper : {false, true}) {
        Box half = box;
        (upper ? half.low : half.high)[widest] = upper ? middle + 1 : middle;
        const bool holdsWorst = !box.worst.empty() && (box.worst[widest] > middle) == upper;
        if (!holdsWorst) half.share = 0, half.worst.clear();
        for (int n = 0; n < kInHalf; ++n) {
          const Encodings at = within(half);
          const double share = evaluate(at);
          if (half.worst.empty() || share > half.share) half.share = share, half.worst = at;
        }
        boxes.insert(std::move(half));
      }
      if (boxes.size() > kMostBoxes) boxes.erase(boxes.begin());
    }
  }

  /// The worst input takes half of the evaluations, the next a quarter, and so on.
  void step(int until) {
    constexpr std::size_t kFollowed = 4;
    const std::vector<Seen> from{
        kept_.begin(), kept_.begin() + static_cast<std::ptrdiff_t>(std::min(kFollowed, kept_.size()))};
    for (std::size_t rank = 0; rank < from.size(); ++rank) {
      Seen here = from[rank];
      const int end = rank + 1 == from.size() ? until : until + (left_ - until) / 2;
      while (left_ > end) random_.oneIn(2) ? stepAlong(here, end) : stepAside(here);
    }
  }

  [[nodiscard]] int bitsOf(std::size_t k) const {
    return static_cast<int>(
        std::bit_width(static_cast<std::uint64_t>(high_[k]) - static_cast<std::uint64_t>(low_[k])));
  }

  /// Steps along one coordinate, by ever smaller powers of two, as long as this makes the error larger.
  void stepAlong(Seen& here, int end) {
    const std::size_t k = random_.below(size());
    const int bits = bitsOf(k);
    if (bits == 0) return stepAside(here);
    const int top = std::min(bits, 62) - 1;
    const int from = random_.oneIn(2) ? top : static_cast<int>(random_.integer(0, top));
    for (int exponent = from; exponent >= 0; --exponent)
      for (const bool up : {false, true}) {
        if (left_ <= end) return;
        const Box reach = around(here, std::int64_t{1} << exponent);
        Encodings at = here.at;
        at[k] = up ? reach.high[k] : reach.low[k];
        const double share = evaluate(at);
        if (share > here.share) here = {share, at};
      }
  }

  /// Steps along up to three coordinates at once.
  void stepAside(Seen& here) {
    Encodings at = here.at;
    for (auto n = random_.below(3) + 1; n > 0; --n) {
      const std::size_t k = random_.below(size());
      const int bits = bitsOf(k);
      if (bits == 0) continue;
      const Box reach =
          around(here, std::int64_t{1} << random_.below(static_cast<std::uint64_t>(std::min(bits, 62))));
      at[k] = random_.oneIn(2)   ? random_.integer(reach.low[k], reach.high[k])
              : random_.oneIn(2) ? reach.low[k]
                                 : reach.high[k];
    }
    const double share = evaluate(at);
    if (share >= here.share) here = {share, at};
  }

  /// All encodings next to the worst input: each coordinate by itself, then all at once, as far as the
  /// evaluations go.
  void sweep() {
    if (kept_.empty()) return;
    const Encodings centre = kept_.front().at;
    const std::int64_t along = left_ / (4 * static_cast<std::int64_t>(size()));
    for (std::size_t k = 0; k < size(); ++k)
      for (std::int64_t by = -along; by <= along; ++by) {
        Encodings at = centre;
        if (by == 0 || !add(at, k, by)) continue;
        evaluate(at);
      }
    // The largest cube of which there is time for all.
    const Encodings best = kept_.front().at;
    std::int64_t reach = 0;
    while (std::pow(2 * reach + 3, size()) <= left_) ++reach;
    if (reach == 0) return;
    Encodings offset(size(), -reach);
    for (;;) {
      Encodings at = best;
      bool inside = true;
      for (std::size_t k = 0; k < size(); ++k) inside = inside && add(at, k, offset[k]);
      if (inside) evaluate(at);
      std::size_t k = 0;
      while (k < size() && ++offset[k] > reach) offset[k++] = -reach;
      if (k == size()) return;
    }
  }

  /// False if the sum is out of range.
  bool add(Encodings& at, std::size_t k, std::int64_t by) const {
    if (by > 0 ? at[k] > high_[k] - by : at[k] < low_[k] - by) return false;
    at[k] += by;
    return true;
  }

  const Kernel& kernel_;
  const RoundingMode& mode_;
  int left_;  ///< evaluations
  Random random_;
  Encodings low_, high_;
  std::vector<Seen> kept_;  ///< the worst first
};

}  // namespace

double shareAt(const Kernel& kernel, const Numbers& input, const RoundingMode& mode) {
  const Numbers prepared = kernel.prepare ? kernel.prepare(input) : input;
  if (prepared.empty()) return 0;
  const Numbers result = [&] {
    const InRoundingMode rounds{mode.mode};
    return kernel.run(prepared);
  }();
  const bool nearest = mode.mode == FE_TONEAREST;
  if (!nearest && kernel.directed == 0) return 0;
  const double share = kernel.judge(prepared, result);
  if (std::isnan(share)) return kWrong;
  return share / (nearest ? 1.0 : kernel.directed);
}

Worst searchWorst(const Kernel& kernel, const RoundingMode& mode, int evaluations, std::uint64_t seed) {
  return Search{kernel, mode, evaluations, seed}.worst();
}

}  // namespace xnewell
