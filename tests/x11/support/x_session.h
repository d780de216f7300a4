#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "shading/color/images.h"
#include "tests/x11/support/x_server.h"

#include "x11/server/colormap.h"
#include "x11/server/read_visuals.h"

namespace xnewell {

/// Shared by the tests of pictures on a server.

inline IndexImage randomImage(int width, int height, unsigned seed) {
  std::mt19937 rng{seed};
  IndexImage image{width, height, 0};
  for (std::uint8_t& p : image.pixels) p = static_cast<std::uint8_t>(rng() >> 24);
  return image;
}

/// 256 colours that differ in their high bytes, so that a round trip can be the identity on indices.
inline Palette distinctPalette() {
  Palette palette;
  for (int i = 0; i < 256; ++i)
    palette[i] = {static_cast<std::uint16_t>(257 * i), static_cast<std::uint16_t>(257 * ((i * 77 + 5) & 255)),
                  static_cast<std::uint16_t>(65535 - 257 * i)};
  return palette;
}

/// A server, a client on it and its colormap, in the order of their lives. No X error may be left over at the
/// end.
struct Session {
  XServer server;
  OwnedDisplay display;
  ServerColormap colormap;
  int strays = strayErrors();
  explicit Session(XServer s, const std::string& visual = {})
      : server{std::move(s)},
        display{openDisplay(server.name())},
        colormap{display.get(),
                 chooseVisual(readVisuals(display.get()),
                              visual.empty() ? std::nullopt : std::optional{parseVisualWish(visual)})} {}
  ~Session() {
    XSync(display.get(), 0);
    EXPECT_EQ(strayErrors(), strays);
  }
  Session(Session&&) = delete;
};

}  // namespace xnewell
