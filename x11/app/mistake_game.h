#pragma once

#include "x11/lessons/lesson.h"

namespace xnewell {

/// The game "which mistake is it?": a lesson of a few steps about one picture. Each step shows the right
/// picture beside one with a mistake in the equation (mistake.h), and offers four mistakes that can be told
/// apart here. A wrong answer shows what that mistake would look like. The same seed gives the same game.
/// @throws std::invalid_argument if the picture shows too few mistakes
[[nodiscard]] Lesson mistakeGame(const Scene& scene, PictureSettings settings, unsigned seed);

}  // namespace xnewell
