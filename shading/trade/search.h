#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "shading/trade/measure.h"

namespace xnewell {

/// Which combinations of short cuts are worth a look?
///
/// There are far too many to try all. The search looks at one combination after the other: it paints it once,
/// which tells the error, and roughly the time of each stage. What comes next is always one change (another
/// value of one short cut) away from a combination that was tried. For each such candidate the search
/// predicts time and error from what the same change did when it was last tried beside other values: it
/// multiplied the time of each stage, and it added to the square of the error. A change that was never tried
/// is expected to help, and cheap values come first. The candidate with the most promise is tried, and what
/// it shows corrects the predictions.
///
/// Promise is the time, in times of the fastest combination tried that is as accurate. The search ends when
/// no candidate has any.
class Search {
 public:
  /// `measure` must outlive it. `axes` are those that may change.
  Search(Measure& measure, std::vector<Axis> axes);

  /// Takes over what is known of a configuration.
  void know(const Measured& measured);
  /// Tries the most promising candidate. Returns false if nothing is left to try.
  bool step();

  /// All that was tried, with the times of single runs, but what has no picture.
  [[nodiscard]] const std::vector<Measured>& tried() const { return tried_; }
  /// The indices of the `count` that are nearest to the front. Changes that bring nothing are left out.
  [[nodiscard]] std::vector<int> nearFront(std::size_t count) const;
  /// The values that no combination tried had: "--order bsp, oracle; --divisions 64"; "" if all were tried.
  [[nodiscard]] std::string neverTried() const;

 private:
  /// The index of a value for each axis.
  using Key = std::vector<std::int8_t>;
  struct Dial {
    Axis axis;
    std::vector<double> values;  ///< with the user's own
    int now = 0;                 ///< index of the user's own
    bool ordered = false;        ///< a value is reached from its neighbours alone
  };
  /// A change of one axis.
  struct Move {
    int dial, from, to;
    int node;  ///< that it leads to
  };
  struct Effect {
    bool known = false;
    std::array<double, 4> stages{1, 1, 1, 1};  ///< ratios
    double square = 0;                         ///< added to the square of the RMS error
  };
  /// What is known or predicted of a combination.
  struct Look {
    std::array<double, 4> stages{};  ///< ms
    double square = 0;
    [[nodiscard]] double ms() const { return stages[0] + stages[1] + stages[2] + stages[3]; }
    [[nodiscard]] double rms() const;
  };
  struct Node {
    Key key;
    bool seen = false;  ///< tried, or there is no picture
    bool idle = false;  ///< some of its changes bring nothing
    Look look = {};
    bool expanded = false;
    std::vector<Move> moves = {};  ///< once it is expanded
  };

  [[nodiscard]] Configuration configurationOf(const Key& key) const;
  /// The key without changes that have no effect beside the others.
  [[nodiscard]] Key effective(Key key) const;
  [[nodiscard]] int nodeOf(const Key& key);
  [[nodiscard]] Effect effectOf(const Move& move, const Look& from) const;
  [[nodiscard]] static Look after(const Look& from, const Effect& effect);
  void learn(const Move& move, const Look& from, const Look& to);
  [[nodiscard]] Effect& effect(int dial, int from, int to) { return effects_[dial][from][to]; }
  [[nodiscard]] const Effect& effect(int dial, int from, int to) const { return effects_[dial][from][to]; }
  /// The least time of what is tried and has at most this error; infinite if there is none.
  [[nodiscard]] double leastMs(double rms) const;
  /// Smaller is better.
  [[nodiscard]] double promise(const Look& look) const;
  /// True if a change makes it faster or more accurate, by more than chance.
  [[nodiscard]] static bool helps(const Look& from, const Look& to);
  void expand(int node);
  void take(int node, Measured measured, const Look& look);
  /// True if `simple` has some of the changes of `other`, or none, and is as fast and as accurate.
  [[nodiscard]] bool makesIdle(const Node& simple, const Node& other) const;
  /// True if `simple` has some of the changes of `other`, or none.
  [[nodiscard]] bool isPart(const Key& simple, const Key& other) const;
  /// The move to try next, and from where.
  struct Pick {
    int from = -1;
    Move move = {};
  };
  [[nodiscard]] Pick pick();

  Measure& measure_;
  std::vector<Dial> dials_;
  std::map<Key, int> ids_;
  std::vector<Node> nodes_;
  std::vector<Measured> tried_;
  std::vector<int> nodeOfTried_;
  std::vector<std::vector<std::vector<Effect>>> effects_;  ///< by dial, from and to
};

}  // namespace xnewell
