#include "x11/viewing/view_controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "geometry/exact/box.h"
#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"
#include "shading/explain/equation_at.h"
#include "shading/fill/intensities.h"
#include "shading/picture/cell_use.h"
#include "shading/scene/units.h"
#include "x11/viewing/viewing_page.h"

namespace xnewell {

namespace {

using Kind = Control::Kind;

constexpr double kUpright = 1e-9;  // a lean below this is none
struct ObliqueOption {
  std::string_view name;
  double length;
};
constexpr std::array kObliqueOptions{ObliqueOption{"none", 0.0}, ObliqueOption{"cavalier", 1.0},
                                     ObliqueOption{"cabinet", 0.5}};

/// Changes the view of a setup.
class ViewEditor {
 public:
  ViewEditor(const Subject& subject, ChangeSetup change, Prompt& prompt)
      : subject_{subject}, change_{std::move(change)}, prompt_{prompt} {}

  /// Changes the camera, said in the textbook's terms or, if not `whole`, as it was said: for a plane alone.
  /// What cannot be a view is refused.
  void edit(char key, const std::function<void(CameraSettings&)>& change, bool whole = true) const {
    // A change of its own for undo: in view 1 these letters are other settings.
    change_(static_cast<char>(key | 0x80), [&](Setup& s) {
      CameraSettings next = s.picture.camera;
      try {
        if (whole) {
          next = textbooksOf(cameraOf(s, subject_), subject_.scene);
          if (key != 'p') next.oblique = s.picture.camera.oblique;
        }
        change(next);
        if (!whole) keepOtherPlane(next, s);
        (void)viewMatrices(placeCamera(subject_.scene, next, subject_.aspect).view);
        s.picture.camera = next;
      } catch (const ViewError& e) {
        prompt_.notify(std::string{"No view has that: "} + e.what() + ".");
      }
    });
  }
  /// Moves PRP so that the projectors lean by so much.
  void lean(char key, double length, double angle) const {
    edit(key, [&](CameraSettings& c) {
      const SinCos a = sinCosDegrees(angle);
      const glm::dvec2 middle{(c.window->x + c.window->y) / 2.0, (c.window->z + c.window->w) / 2.0};
      c.prp = glm::dvec3{middle + c.prp->z * length * glm::dvec2{a.cos, a.sin}, c.prp->z};
      const bool named = length == 1.0 || length == 0.5;  // the others have no name in view 1
      c.oblique = named ? std::optional{Oblique{length, angle}} : std::nullopt;
    });
  }

 private:
  /// A plane that nobody has said yet stands around the scene, and makes way for the other one. From then on
  /// it is said.
  void keepOtherPlane(CameraSettings& next, const Setup& before) const {
    const Camera was = cameraOf(before, subject_);
    const ViewSpec now = placeCamera(subject_.scene, next, subject_.aspect).view;
    if (now.back != was.view.back && next.back == before.picture.camera.back)
      next.back = textbooksOf(was, subject_.scene).back;
    if (now.front != was.view.front && next.front == before.picture.camera.front)
      next.front = textbooksOf(was, subject_.scene).front;
  }

  Subject subject_;
  ChangeSetup change_;
  Prompt& prompt_;
};

class ViewControls {
 public:
  ViewControls(const Subject& subject, const Camera& camera, double angle, ChangeSetup change, Prompt& prompt)
      : editor_{std::make_shared<const ViewEditor>(subject, std::move(change), prompt)},
        view_{camera.view},
        angle_{angle},
        unit_{lengthUnit(subject.scene)},
        file_{std::ldexp(unit_, subject.scene.exponent)},
        side_{boxOf(subject.scene.mesh.points).side() / unit_} {
    if (!(side_ > 0.0)) side_ = 1.0;  // as the camera has it for a single point
    side_ = std::max(side_, 1e-12);
  }

  Controls make() {
    addProjection();
    addVector(
        'v', "VRP", {"x", "y", "z"}, view_.vrp / unit_, "the origin of u, v and n, on the view plane",
        lengths(), [](CameraSettings & c) -> auto& { return *c.vrp; }, file_);
    addVector(
        'n', "VPN", {"x", "y", "z"}, shownDirection(view_.vpn),
        "the normal of the view plane, from the scene to you", directions(),
        [](CameraSettings & c) -> auto& { return *(c.vpn = shownDirection(*c.vpn)); }, 1.0);
    addVector(
        'y', "VUP", {"x", "y", "z"}, shownDirection(view_.vup), "the direction that is up in the picture",
        directions(), [](CameraSettings & c) -> auto& { return *(c.vup = shownDirection(*c.vup)); }, 1.0);
    addVector(
        'p', "PRP", {"u", "v", "n"}, view_.prp / unit_,
        parallel() ? "the projectors run from here to the window's middle"
                   : "where the eye is, seen from VRP; off the window's middle the view shears",
        lengths(), [](CameraSettings & c) -> auto& { return *c.prp; }, file_);
    addWindow();
    addPlane('f', "front", view_.front, &CameraSettings::front,
             "n of the front plane: what is nearer is cut off");
    addPlane('b', "back", view_.back, &CameraSettings::back,
             "n of the back plane: what is farther is cut off");
    return std::move(all_);
  }

 private:
  [[nodiscard]] bool parallel() const { return view_.projection == Projection::Parallel; }

  /// A direction whose numbers can be read; one that is very long or short is made a unit vector.
  [[nodiscard]] static glm::dvec3 shownDirection(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.05 && length < 500.0 ? v : unit(v);
  }
  [[nodiscard]] TrackRange lengths() const {
    const int digits = static_cast<int>(std::floor(std::log10(side_)));
    const int decimals = std::clamp(2 - digits, 0, 9);
    const double most = std::pow(10.0, digits + 2);
    return {.low = -most, .high = most, .step = 5.0 * std::pow(10.0, digits - 2), .decimals = decimals};
  }
  [[nodiscard]] static TrackRange directions() {
    return {.low = -1000.0, .high = 1000.0, .step = 0.05, .decimals = 2};
  }

  /// The length of an option, without what rounding made of it.
  [[nodiscard]] static double named(double length) {
    for (const ObliqueOption& option : kObliqueOptions)
      if (std::abs(length - option.length) < kUpright) return option.length;
    return length;
  }

  void addProjection() {
    all_.push_back({.kind = Kind::Choice,
                    .key = 'P',
                    .label = "project",
                    .is = "the projection: in perspective, distant things look smaller",
                    .legend = "projection",
                    .value = parallel() ? 0.0 : 1.0,
                    .options = {"parallel", "perspective"},
                    .set = [editor = editor_](double option) {
                      editor->edit('P', [&](CameraSettings& c) {
                        c.parallel = option == 0.0;
                        c.oblique.reset();
                      });
                    }});
    const Oblique lean = leanOf(view_);
    const bool upright = lean.length < kUpright;
    Control oblique{.kind = Kind::Choice,
                    .key = 'O',
                    .label = "oblique",
                    .is = "how long a line along n is drawn: as long, or half as long",
                    .value = -1.0,
                    .off = parallel() ? std::string{} : "An oblique view is a parallel one: press P first.",
                    .set = [editor = editor_, angle = angle_](double option) {
                      editor->lean('O', kObliqueOptions[static_cast<std::size_t>(option)].length, angle);
                    }};
    for (std::size_t k = 0; k < kObliqueOptions.size(); ++k) {
      oblique.options.emplace_back(kObliqueOptions[k].name);
      if (named(lean.length) == kObliqueOptions[k].length) oblique.value = static_cast<double>(k);
    }
    if (!parallel()) oblique.value = -1.0, oblique.lacking.assign(oblique.options.size(), true);
    all_.push_back(std::move(oblique));
    all_.push_back({.kind = Kind::Slider,
                    .key = 'a',
                    .label = "angle",
                    .is = "the angle to u at which lines along n are drawn, in degrees",
                    .value = angle_,
                    .range = {.low = 0, .high = 360, .step = 5, .decimals = 0},
                    .initially = 45.0,
                    .off = !parallel() ? "An oblique view is a parallel one: press P first."
                           : upright   ? "This view is not oblique: press O first."
                                       : std::string{},
                    .set = [editor = editor_, length = named(lean.length)](double angle) {
                      editor->lean('a', length, angle);
                    }});
  }

  /// Three numbers in a row. `part` finds the vector in the settings; `perUnit` is what a shown 1 is there.
  void addVector(char key, const std::string& name, const std::array<const char*, 3>& axes,
                 const glm::dvec3& shown, const std::string& is, const TrackRange& range,
                 glm::dvec3& (*part)(CameraSettings&), double perUnit) {
    for (int k = 0; k < 3; ++k)
      all_.push_back({.kind = Kind::Number,
                      .key = key,
                      .part = k,
                      .label = name + ' ' + axes[static_cast<std::size_t>(k)],
                      .heading = name,
                      .is = name + ": " + is,
                      .value = shown[k],
                      .range = range,
                      .set = [editor = editor_, key, k, part, perUnit](double value) {
                        editor->edit(key, [&](CameraSettings& c) { part(c)[k] = value * perUnit; });
                      }});
  }

  void addWindow() {
    const std::array<std::pair<const char*, double>, 4> ends{{{"umin", view_.windowMin.x},
                                                              {"umax", view_.windowMax.x},
                                                              {"vmin", view_.windowMin.y},
                                                              {"vmax", view_.windowMax.y}}};
    for (int k = 0; k < 4; ++k)
      all_.push_back({.kind = Kind::Number,
                      .key = 'o',
                      .part = k,
                      .label = std::string{"window "} + ends[static_cast<std::size_t>(k)].first,
                      .heading = "window",
                      .is = "the part of the view plane that fills the picture: umin, umax, vmin, vmax",
                      .value = ends[static_cast<std::size_t>(k)].second / unit_,
                      .range = lengths(),
                      .set = [editor = editor_, k, file = file_](double value) {
                        editor->edit('o', [&](CameraSettings& c) { (*c.window)[k] = value * file; });
                      }});
  }

  void addPlane(char key, const char* name, double n, std::optional<double> CameraSettings::*plane,
                const char* is) {
    TrackRange range = lengths();
    const double reach = std::max(2.0 * side_, 1.25 * std::abs(n) / unit_);
    range.low = -reach, range.high = reach;
    if (!parallel()) range.high = std::max(range.low + 1e-9, std::min(reach, view_.prp.z / unit_));
    all_.push_back({.kind = Kind::Slider,
                    .key = key,
                    .label = name,
                    .is = is,
                    .value = n / unit_,
                    .range = range,
                    .set = [editor = editor_, key, plane, file = file_](double value) {
                      editor->edit(
                          key, [&](CameraSettings& c) { c.*plane = value * file; }, false);
                    }});
  }

  std::shared_ptr<const ViewEditor> editor_;
  ViewSpec view_;  ///< in the scene's units
  double angle_;
  double unit_, file_;  ///< what a shown 1 is in the scene's units and in the file's
  double side_;         ///< of the scene's box, as shown
  Controls all_;
};

}  // namespace

Oblique leanOf(const ViewSpec& view) {
  const glm::dvec2 lean = (glm::dvec2{view.prp} - (view.windowMin + view.windowMax) / 2.0) / view.prp.z;
  const double angle = std::atan2(lean.y, lean.x) * 180.0 / std::numbers::pi;
  return {std::hypot(lean.x, lean.y), angle < 0.0 ? angle + 360.0 : angle};
}

Controls viewControls(const Subject& subject, const Camera& camera, double angle, const ChangeSetup& change,
                      Prompt& prompt) {
  return ViewControls{subject, camera, angle, change, prompt}.make();
}

namespace {

Intensities litAt(const ShadingPoints& points, const Lighting& lighting, int channel) {
  Terms diffuse, specular;
  Intensities lit;
  diffuseIntensities(diffuse, points, lighting, channel);
  specularIntensities(specular, points, lighting, channel);
  addTerms(lit, diffuse, specular, points, lighting, channel);
  return lit;
}

/// All channels at all points, as the equation has them behind a stage.
std::vector<std::vector<FrontBack<double>>> litBehind(const Picture& picture, const ShadingPoints& points,
                                                      const ViewStages& stages, ViewStage stage) {
  const Surfaces surfaces = picture.surfaces();
  const Lighting& lighting = picture.shading().lighting();
  std::vector<std::optional<EquationAt>> equations(picture.scene().mesh.materials.size() + 1);
  std::vector<std::vector<FrontBack<double>>> channels(static_cast<std::size_t>(lighting.channels));
  for (std::size_t k = 0; k < points.count(); ++k) {
    const int material = points.material[k] + 1;
    std::optional<EquationAt>& equation = equations[static_cast<std::size_t>(material)];
    if (!equation) equation.emplace(surfaces, material);
    const glm::dmat3 derivative = stages.derivative(stage, points.at[k]);
    const ByChannel front = equation->behind(derivative, points.at[k], points.N[k]).I;
    const ByChannel back =
        lighting.twoSided ? equation->behind(derivative, points.at[k], -points.N[k]).I : front;
    for (std::size_t c = 0; c < channels.size(); ++c)
      channels[c].push_back({std::clamp(front[c], 0.0, 1.0), std::clamp(back[c], 0.0, 1.0)});
  }
  return channels;
}

/// The cell of the scene's that is nearest to a colour.
std::uint8_t nearestCell(const Palette& palette, const CellRange& cells, const glm::dvec3& color) {
  int best = cells.first;
  double least = std::numeric_limits<double>::infinity();
  for (int cell = cells.first; cell <= cells.last(); ++cell) {
    const Rgb16 c = palette[static_cast<std::size_t>(cell)];
    const glm::dvec3 away = glm::dvec3{c.r, c.g, c.b} / 65535.0 - color;
    const double distance = glm::dot(away, away);
    if (distance < least) least = distance, best = cell;
  }
  return static_cast<std::uint8_t>(best);
}

}  // namespace

LitParts::LitParts(const Picture& picture, const Palette& palette, const ViewStages* stages,
                   ViewStage shadedIn)
    : material_{picture.scene().mesh.material}, of_{picture.colors().ramps()} {
  const Scene& scene = picture.scene();
  const Mesh& mesh = scene.mesh;
  const Lighting& lighting = picture.shading().lighting();
  const bool ofVertices = rowOf(picture.settings().shading).interpolates;
  const Shading method = picture.settings().shading;
  const bool world = !stages || shadedIn == ViewStage::World;
  // The picture has the intensities already, if it evaluates them where this does.
  const bool has = world && (method == Shading::Flat || method == Shading::Gouraud) &&
                   !picture.shading().refined() && !lighting.onlyAmbient() && !lighting.luminance;
  ShadingPoints points;
  if (has && ofVertices) {
    pointOf_ = picture.shading().vertices().ofCorner;
  } else if (ofVertices) {
    Vertices vertices = smoothVertices(scene, picture.settings());
    points = vertexPoints(mesh, vertices);
    pointOf_ = std::move(vertices.ofCorner);
  } else {
    if (!has) points = facePoints(mesh);
    pointOf_.resize(mesh.corners.size());
    for (int face = 0; face < mesh.faceCount(); ++face)
      std::fill(pointOf_.begin() + mesh.firstCorner[face], pointOf_.begin() + mesh.firstCorner[face + 1],
                face);
  }
  std::vector<std::vector<FrontBack<double>>> channels;
  if (!world && !lighting.onlyAmbient())
    channels = litBehind(picture, points, *stages, shadedIn);
  else
    for (int c = 0; c < lighting.channels; ++c)
      channels.push_back(has ? picture.shading().intensities(c).I : litAt(points, lighting, c).I);
  intensities_ = channels.front();
  const auto gray = [&](std::size_t k, double FrontBack<double>::*side) {
    return luminance({channels[0][k].*side, channels[1][k].*side, channels[2][k].*side});
  };
  for (std::size_t k = 0; k < intensities_.size() && lighting.channels == 3; ++k)
    intensities_[k] = {gray(k, &FrontBack<double>::front), gray(k, &FrontBack<double>::back)};
  for (const Ramp& ramp : of_) ramps_.emplace_back(ramp);
  colored_ = channelsOf(picture.colors().plan()) == Channels::Rgb;
  if (!colored_ || lighting.channels != 3) return;
  const CellRange cells = sceneCells(picture);
  for (int face = 0; face < mesh.faceCount(); ++face)
    for (const auto side : {&FrontBack<double>::front, &FrontBack<double>::back}) {
      glm::dvec3 sum{0.0};
      const int first = mesh.firstCorner[face], end = mesh.firstCorner[face + 1];
      for (int corner = first; corner < end; ++corner)
        for (int c = 0; c < 3; ++c)
          sum[c] += channels[static_cast<std::size_t>(c)][static_cast<std::size_t>(pointOf_[corner])].*side;
      cells_.push_back(nearestCell(palette, cells, sum / double(end - first)));
    }
}

}  // namespace xnewell
