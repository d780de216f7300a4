#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "shading/light/equation.h"
#include "shading/picture/surface_evaluator.h"

namespace xnewell {

/// Numbers of up to three channels: of one, or of red, green and blue.
using ByChannel = std::array<double, 3>;

/// One light in the equation at one place.
struct ExplainedLight {
  glm::dvec3 L{0};
  glm::dvec3 R{0};  ///< R of the textbook; H where the form is N.H; L where it is N.L
  double NdotL = 0;
  double cosine = 0;               ///< R.V, or what the form takes for it
  double facing = 0, counted = 0;  ///< what counts for both: max(0, .) unless a mistake says otherwise
  double power = 0;                ///< counted^n; 0 where there is no highlight, as N.L <= 0
  double fatt = 1, spot = 1;
  /// Towards a spot from the place itself, if L and fatt are those of the scene's centre: the share of a cone
  /// is the place's own.
  std::optional<glm::dvec3> ownL = {};
  ByChannel Ip{}, diffuse{}, specular{};  ///< the diffuse term includes the texel
};

/// The illumination equation at one place, with all its numbers.
struct ExplainedEquation {
  /// World. N is 0 where all light is ambient. With a mistake N and V are those that it takes.
  glm::dvec3 P{0}, N{0}, V{0};
  std::array<Reflection, 3> surface{};  ///< by channel, with the surface's colour
  ByChannel Ia{}, ambient{};            ///< `ambient` as often as a mistake counts it
  std::vector<ExplainedLight> lights;   ///< of the scene, or the user's; none where all light is ambient
  ByChannel I{};                        ///< the sum of all terms; it may exceed 1

  /// The terms of all lights in one channel.
  [[nodiscard]] double diffuse(int channel) const;
  [[nodiscard]] double specular(int channel) const;
};

/// Evaluates the equation for one material by the definitions of equation.h, light by light.
class EquationAt {
 public:
  /// `material` is an index into Lighting::materials.
  EquationAt(const Surfaces& surfaces, int material);

  /// P is a place in the world. N is a unit vector towards the side that is lit, or 0 where all light is
  /// ambient. `texel` is what the texture leaves of the diffuse term.
  [[nodiscard]] ExplainedEquation operator()(const glm::dvec3& P, const glm::dvec3& N,
                                             const ByChannel& texel = {1, 1, 1}) const {
    return evaluate(P, N, texel, nullptr);
  }
  /// The equation as a program would have it that shades behind a map of the world: N is the normal of where
  /// the plane goes, L and V are where these directions go (geometry/view/stages.h). `derivative` is that of
  /// the map at P. fatt and spot stay those of the world.
  [[nodiscard]] ExplainedEquation behind(const glm::dmat3& derivative, const glm::dvec3& P,
                                         const glm::dvec3& N) const {
    return evaluate(P, N, {1, 1, 1}, &derivative);
  }

 private:
  [[nodiscard]] ExplainedEquation evaluate(const glm::dvec3& P, const glm::dvec3& N, const ByChannel& texel,
                                           const glm::dmat3* derivative) const;
  [[nodiscard]] ExplainedLight explained(const Light& light, const ExplainedEquation& at,
                                         const ByChannel& texel, const glm::dmat3* derivative) const;

  const Illumination& user_;
  const Lighting& lighting_;
  glm::dvec3 centre_;
  double unit_;
  std::vector<Light> lights_;
  ExplainedEquation everywhere_;  ///< what does not depend on the place
};

/// The equation of each material, made when it is first asked for.
class EquationOf {
 public:
  explicit EquationOf(const Surfaces& surfaces) : s_{surfaces}, made_(surfaces.mesh.materials.size() + 1) {}

  /// Of a face of the mesh.
  [[nodiscard]] const EquationAt& operator()(int face) {
    const int material = s_.mesh.material[face] + 1;
    std::optional<EquationAt>& equation = made_[static_cast<std::size_t>(material)];
    return equation ? *equation : equation.emplace(s_, material);
  }

 private:
  Surfaces s_;
  std::vector<std::optional<EquationAt>> made_;
};

}  // namespace xnewell
