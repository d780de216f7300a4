#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "shading/light/equation.h"
#include "shading/scene/picture_settings.h"

namespace xnewell {

/// How a program goes about the assignment: what it does at each step, right, allowed or mistaken. The
/// default is what the settings of the picture ask for; each row of hypothesis.h differs in a step or two.
/// The evaluator (other_program.h) computes what a program that works in such a way would show.

enum class NormalWay {
  Unit,
  Newell,
  CornerProduct,
  InViewing,
  NotTurned,
  ByMatrix,
  Scaled,
  Warped,
  WarpedDeep,
  WarpedInPixels,
  ThreeCorners
};
/// At vertices. The sum is made a unit vector unless the name says otherwise.
enum class VertexWay { AsAsked, TrianglesTwice, LastFace, OwnFace, SumNotUnit, MeanNotUnit };
enum class TowardsLight { Unit, NotUnit, DirectionAsPlace, PlaceAsDirection, FarPlace, NotMoved, Constant };
enum class TowardsEye { Unit, NotUnit, PlaceOfEye, FromLookAt, Constant };
/// What becomes of the terms: their sum, the largest of all or of diffuse and specular; I / (1 + I), 1 -
/// e^-I, or the whole part of I.
enum class SumWay { Sum, Largest, LargerOfLight, Tone, Exponential, Whole };
enum class CentroidWay { OfArea, FirstCorner, MeanOfCorners, OfTriangle };
enum class CellWay {
  Nearest,
  OneLess,
  OneMore,
  Upwards,
  By240,
  By255,
  Truncated,
  FromZero,
  Ratios,
  Ratio240,
  Ratio64,
  NaturalLog,
  NoI0,
  NoI0Wraps,
  Even
};
/// The last three store no table: the picture has 255 I, 256 I up to 255, or 255 I^(1/2.2) itself. Whole
/// numbers are the nearest, or cut off as the cells of the CellWay are.
enum class StoreWay {
  AsAsked,
  Rounded8,
  Minus11,
  EightIn16,
  Ratio240,
  Ratio64,
  Backwards,
  Gamma,
  Gamma8,
  By255,
  By256,
  ByGamma
};
/// Which faces show: the nearest; as listed; the nearest painted first; sorted by nearest z; no fronts.
enum class PaintWay { Nearest, Listed, Reversed, NearestZ, BacksOnly };

/// A number that is another one wherever the scene has `was`.
enum class NumberOf { n, ka, kd, ks, Ia, Ip, I0 };
struct OtherNumber {
  NumberOf which = NumberOf::n;
  double was = 0, is = 0;
  bool operator==(const OtherNumber&) const = default;
};

struct ViewMistake;

/// Without a value a step is as the settings ask for.
struct Approach {
  EquationWay equation = {};
  std::optional<Shading> method = {};
  std::optional<Form> form = {};
  bool cellWraps = false;  ///< I is not clamped, and the cell overflows a byte
  NormalWay normal = NormalWay::Unit;
  bool oneSided = false;
  std::optional<NormalRule> rule = {};  ///< of normals at vertices
  VertexWay vertex = VertexWay::AsAsked;
  TowardsLight light = TowardsLight::Unit;
  TowardsEye eye = TowardsEye::Unit;
  bool ambientInTheDark = false;  ///< the ambient term counts only where no light does
  SumWay sum = SumWay::Sum;
  bool noKa = false, swapsKaKd = false;
  std::optional<Attenuation> fade = {};
  bool fadesAbove1 = false, ambientFades = false;
  CentroidWay centroid = CentroidWay::OfArea;
  int threeFrom = 0;           ///< NormalWay::ThreeCorners begins with this corner
  bool meansOfFaces = false;   ///< Gouraud: a vertex has the mean intensity of the faces around it
  bool longNormals = false;    ///< Phong: interpolated normals are not made unit vectors
  bool onScreen = false;       ///< Phong, textures: interpolated over the screen, not in perspective
  bool otherDiagonal = false;  ///< a polygon's fan of triangles is around its second corner
  bool byRows = false;         ///< Gouraud: along the edges, then along the row
  bool clampsLate = false;     ///< Gouraud: intensities are clamped at the pixel, not at the vertices
  bool cellsBetween = false;   ///< Gouraud: cells are interpolated, not intensities
  CellWay cell = CellWay::Nearest;
  StoreWay store = StoreWay::AsAsked;
  std::optional<TableKind> table = {};  ///< another kind, for cells and for what they hold
  PaintWay paint = PaintWay::Nearest;
  const ViewMistake* view = nullptr;  ///< of the viewing transformation; null for none

  // Numbers that a user might have said otherwise.
  std::optional<OtherNumber> number = {};
  double nTimes = 1;
  glm::dvec3 lightSigns{1};  ///< of x, y and z of each light
  bool swapsLightYz = false;
  bool operator==(const Approach&) const = default;

  /// Does otherwise what another program does otherwise.
  void add(const Approach& other);
  /// What is as the settings ask for has its value.
  [[nodiscard]] Approach with(const PictureSettings& settings) const;
};

}  // namespace xnewell
