#pragma once

#include <gtest/gtest.h>

#include <string_view>

#include "tests/x11/support/staged_view.h"
#include "x11/sides/side_by_side_view.h"

namespace xnewell {

/// A bench on a stage, drawn.
struct ShownSides {
  StagedView stage;
  SideBySideView bench{stage,
                       [this] {
                         return Subject{stage.pictures.scene(), glm::dvec3{0}, 1.5};
                       },
                       [] { return kMaxShades; }};
  explicit ShownSides(const char* scene = "teapot", const xnewell::Setup& setup = {}, int width = 1024,
                      int height = 768)
      : stage{scene, 3, width, height, setup} {
    stage.draw(bench);
  }
  void press(std::string_view letters) {
    for (const char c : letters) {
      stage.press(bench, std::string_view{&c, 1});
      EXPECT_TRUE(stage.taken) << c;
    }
    stage.draw(bench);
  }
  void press(NamedKey key) { stage.press(bench, key), stage.draw(bench); }
  [[nodiscard]] SidesLayout at() const { return layoutOfSides(stage.layout.body); }
  [[nodiscard]] IndexImage A() const { return stage.part(at().A); }
  [[nodiscard]] IndexImage B() const { return stage.part(at().B); }
  [[nodiscard]] IndexImage difference() const { return stage.part(at().difference); }
  /// The body without the numbers, which include measured times.
  [[nodiscard]] IndexImage pictures() const {
    const Rect& body = stage.layout.body;
    return stage.part({body.x, body.y, body.width, at().sections.y - body.y});
  }
  [[nodiscard]] xnewell::Setup setupB() const { return bench.beside(stage.now); }
};

inline Setup ordered(Order order, Shading shading = Shading::Flat) {
  Setup s;
  s.picture.order = order, s.picture.shading = shading;
  return s;
}

}  // namespace xnewell
