#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "shading/picture/stopwatch.h"
#include "x11/trade/measuring.h"
#include "x11/window/controls.h"

namespace xnewell {

/// --accuracy in a window: after each change of the scene or the view it measures again, and chooses the
/// cheapest short cuts whose picture stays within a limit. A short cut that the user chooses stays as it is.
class AccuracyKeeper {
 public:
  /// `mine` are the axes that the user has chosen. `request` says how long it measures.
  explicit AccuracyKeeper(const AccuracyLimit& limit, std::vector<std::string> mine = {},
                          const TradeRequest& request = {.brief = true, .seconds = kAccuracySeconds})
      : limit_{limit}, mine_{std::move(mine)}, request_{request} {
    request_.within = limit;
  }

  [[nodiscard]] const AccuracyLimit& limit() const { return limit_; }

  /// What the window shows, and where the user may have changed it.
  struct Seen {
    const Scene& scene;
    Setup setup;
    int divisions;      ///< with which the scene was read; 0 if it has no patches
    int width, height;  ///< of the picture
    bool operator==(const Seen& other) const {
      return scene.name == other.scene.name && setup == other.setup && width == other.width &&
             height == other.height;
    }
  };
  /// True if there is nothing to do until something changes.
  [[nodiscard]] bool rests(const Seen& now) const { return settled_ == keyOf(now); }

  /// The setup that the window should have from now on, and why, in a sentence.
  struct News {
    Setup setup;
    std::string says;
  };
  /// Is called from time to time while it does not rest.
  [[nodiscard]] std::optional<News> tick(const Seen& now);

 private:
  struct Key {
    std::string scene;
    Setup setup;
    int width = 0, height = 0;
    bool operator==(const Key&) const = default;
  };
  [[nodiscard]] static Key keyOf(const Seen& now);
  /// What the user asked for: the setup, without what was chosen here.
  [[nodiscard]] Setup askedFor(const Seen& now);
  void measure(const Seen& now);
  [[nodiscard]] News choose(const Seen& now, const Trade& trade, const std::string& failure);

  AccuracyLimit limit_;
  std::vector<std::string> mine_;
  TradeRequest request_;
  std::unique_ptr<Measuring> measuring_;
  std::optional<Key> pending_, settled_;
  Stopwatch steady_;  ///< since the last change
  Setup asked_, used_;
  Configuration chosen_;  ///< made used_ from asked_
};

}  // namespace xnewell
