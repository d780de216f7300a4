#include "tests/kernels/search.h"

#include <algorithm>
#include <bit>
#include <cfenv>
#include <cmath>
#include <random>

namespace xnewell {

const std::array<RoundingMode, 4> kRoundingModes{
    {{FE_TONEAREST, "nearest"}, {FE_UPWARD, "up"}, {FE_DOWNWARD, "down"}, {FE_TOWARDZERO, "zero"}}};

std::int64_t Coordinate::encode(double v) const {
  if (type == Type::Integer) return std::llround(v);
  const std::int64_t least = type == Type::Float ? INT32_MIN : INT64_MIN;
  const std::int64_t bits = type == Type::Float ? std::bit_cast<std::int32_t>(static_cast<float>(v))
                                                : std::bit_cast<std::int64_t>(v);
  return bits >= 0 ? bits : least - bits;
}

double Coordinate::decode(std::int64_t n) const {
  if (type == Type::Integer) return static_cast<double>(n);
  if (type == Type::Double) return std::bit_cast<double>(n >= 0 ? n : INT64_MIN - n);
  return std::bit_cast<float>(static_cast<std::int32_t>(n >= 0 ? n : INT32_MIN - n));
}

namespace {

using Encodings = std::vector<std::int64_t>;

struct Seen {
  double share;
  Encodings at;
};

class Search {
 public:
  Search(const Kernel& kernel, const RoundingMode& mode, int evaluations, std::uint64_t seed)
      : kernel_{kernel}, mode_{mode}, left_{evaluations}, rng_{seed} {}

  Worst worst(const std::vector<Numbers>& start) {
    for (const Numbers& input : start) {
      Encodings at;
      for (std::size_t k = 0; k < size(); ++k) at.push_back(kernel_.input[k].encode(input[k]));
      evaluate(at);
    }
    while (left_ > 0) {
      Encodings at(size());
      const std::uint64_t move = below(120);
      if (kept_.empty() || move < 40) {  // somewhere else
        const std::uint64_t kind = below(14);
        for (std::size_t k = 0; k < size(); ++k) at[k] = anywhere(k, kind < 7 ? kind : below(7));
        if (!kept_.empty() && move < 10) at = scaled(kept_[below(kept_.size())].at);
        evaluate(at);
      } else if (move == 40) {  // a hundred evaluations
        stepAlong(kept_[below(1 + below(kept_.size()))], below(size()));
      } else {
        at = kept_[below(1 + below(kept_.size()))].at;
        for (std::uint64_t n = 1 + below(3); n > 0; --n) {
          const std::size_t k = below(size());
          const std::uint64_t how = below(8);
          at[k] = how == 0   ? anywhere(k, below(7))
                  : how == 1 ? kept_[below(kept_.size())].at[k]
                             : moved(k, at[k], (how < 5 ? 1 : uniform()) * std::exp2(below(63)) * sign());
        }
        evaluate(at);
      }
    }
    if (kept_.empty()) return {};
    return {kept_.front().share, decoded(kept_.front().at)};
  }

 private:
  [[nodiscard]] std::size_t size() const { return kernel_.input.size(); }
  std::uint64_t below(std::uint64_t end) { return rng_() % end; }
  double uniform() { return static_cast<double>(rng_() >> 11) * 0x1p-53; }
  double sign() { return below(2) ? 1 : -1; }

  [[nodiscard]] Numbers decoded(const Encodings& at) const {
    Numbers input;
    for (std::size_t k = 0; k < size(); ++k) input.push_back(kernel_.input[k].decode(at[k]));
    return input;
  }

  double evaluate(const Encodings& at) {
    constexpr std::size_t kKept = 24;  // the worst, that are followed
    --left_;
    const double share = shareAt(kernel_, decoded(at), mode_);
    if (share > 0 && (kept_.size() < kKept || share > kept_.back().share) &&
        std::ranges::find(kept_, at, &Seen::at) == kept_.end()) {
      kept_.insert(std::ranges::upper_bound(kept_, share, std::greater{}, &Seen::share), {share, at});
      if (kept_.size() > kKept) kept_.pop_back();
    }
    return share;
  }

  /// The encoding at that distance, or the end of the range.
  [[nodiscard]] std::int64_t moved(std::size_t k, std::int64_t at, double by) const {
    const Coordinate& c = kernel_.input[k];
    const double to = static_cast<double>(at) + by;
    const std::int64_t low = c.encode(c.low), high = c.encode(c.high);
    if (to <= static_cast<double>(low)) return low;
    if (to >= static_cast<double>(high)) return high;
    return std::clamp(at + static_cast<std::int64_t>(by), low, high);
  }

  /// A number of the k-th range that is hard for most kernels.
  std::int64_t anywhere(std::size_t k, std::uint64_t kind) {
    const Coordinate& c = kernel_.input[k];
    const double most = std::max(std::abs(c.low), std::abs(c.high));
    if (kind == 0) {  // any exponent
      const auto low = static_cast<std::uint64_t>(c.encode(c.low));
      return static_cast<std::int64_t>(low + below(static_cast<std::uint64_t>(c.encode(c.high)) - low + 1));
    }
    const double v = kind == 1   ? below(2) ? c.low : c.high
                     : kind == 2 ? std::round((c.low + uniform() * (c.high - c.low)) * 1000) / 1000
                     : kind == 3 ? std::ldexp(sign(), static_cast<int>(below(90)) - 60)
                     : kind == 4 ? (below(2) ? c.low : c.high) + most * std::exp2(-60 * uniform()) * sign()
                     : kind == 5
                         ? 15 * std::round(48 * uniform() - 24) + std::exp2(4 - 60 * uniform()) * sign()
                         : c.low + uniform() * (c.high - c.low);
    const std::int64_t near = c.encode(std::clamp(v, c.low, c.high));
    return kind == 3 ? moved(k, near, static_cast<double>(below(7)) - 3) : near;
  }

  /// All that are no whole numbers, times a power of two.
  Encodings scaled(Encodings at) {
    const double by = std::exp2(static_cast<double>(below(1020)) * sign());
    for (std::size_t k = 0; k < size(); ++k) {
      const Coordinate& c = kernel_.input[k];
      if (c.type != Coordinate::Type::Integer)
        at[k] = c.encode(std::clamp(by * c.decode(at[k]), c.low, c.high));
    }
    return at;
  }

  void stepAlong(Seen here, std::size_t k) {
    for (int exponent = 62 - static_cast<int>(below(40)); exponent >= 0; --exponent)
      for (const double by : {std::exp2(exponent), -std::exp2(exponent)}) {
        Encodings at = here.at;
        at[k] = moved(k, at[k], by);
        if (left_ <= 0 || at == here.at) continue;
        const double share = evaluate(at);
        if (share > here.share) here = {share, at};
      }
  }

  const Kernel& kernel_;
  const RoundingMode& mode_;
  int left_;  ///< evaluations
  std::mt19937_64 rng_;
  std::vector<Seen> kept_;  ///< the worst first
};

}  // namespace

double shareAt(const Kernel& kernel, In input, const RoundingMode& mode) {
  const Numbers prepared = kernel.prepare ? kernel.prepare(input) : input;
  if (prepared.empty()) return 0;
  std::fesetround(mode.mode);
  const Numbers result = kernel.run(prepared);
  std::fesetround(FE_TONEAREST);
  const double share = kernel.judge(prepared, result);
  return std::isnan(share) ? kWrong : share / (mode.mode == FE_TONEAREST ? 1.0 : kernel.directed);
}

Worst searchWorst(const Kernel& kernel, const std::vector<Numbers>& start, const RoundingMode& mode,
                  int evaluations, std::uint64_t seed) {
  return Search{kernel, mode, evaluations, seed}.worst(start);
}

}  // namespace xnewell
