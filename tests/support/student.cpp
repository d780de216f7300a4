#include "tests/support/student.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace student {

namespace {

Triple plus(Triple a, Triple b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Triple minus(Triple a, Triple b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Triple times(double s, Triple a) { return {s * a[0], s * a[1], s * a[2]}; }
double lengthOf(Triple a) { return std::sqrt(dotOf(a, a)); }
Triple unitOf(Triple a) { return lengthOf(a) > 0 ? times(1 / lengthOf(a), a) : a; }

constexpr double kPi = 3.14159265358979323846;

class Drawing {
 public:
  Drawing(const World& world, const Program& program) : w_{world}, p_{program} {
    n_ = unitOf(minus(w_.eye, w_.at));
    u_ = unitOf(crossOf(w_.up, n_));
    v_ = crossOf(n_, u_);
    for (const Triple& point : w_.points) {
      const Triple d = minus(point, w_.eye);
      const double depth = -dotOf(d, n_), scale = 1 / std::tan(w_.fov / 2 * kPi / 180);
      seen_.push_back({dotOf(d, u_) / depth * scale, dotOf(d, v_) / depth * scale, depth});
    }
    low_ = high_ = w_.points[0];
    for (const Triple& point : w_.points)
      for (int k = 0; k < 3; ++k)
        low_[k] = std::min(low_[k], point[k]), high_[k] = std::max(high_[k], point[k]);
    for (int f = 0; f < faces(); ++f)
      nearDepth_ = std::min(nearDepth_, depthOf(f)), farDepth_ = std::max(farDepth_, depthOf(f));
    makeNormals();
    makeTable();
  }

  Result make() {
    if (p_.byMatrices) {
      Result drawn = drawByMatrices(w_, p_, [&](int f) { return cellOf(flatOf(f)); });
      drawn.held = held_;
      for (const int cell : drawn.cell) drawn.red.push_back(cell == 0 ? std::uint8_t{40} : held_[cell]);
      return drawn;
    }
    Result r{p_.width, p_.height, {}, {}, held_};
    const std::size_t pixels = static_cast<std::size_t>(p_.width) * p_.height;
    r.cell.assign(pixels, 0), r.red.assign(pixels, 40);
    nearest_.assign(pixels, 1e300);
    std::vector<std::pair<double, int>> order;
    for (int f = 0; f < faces(); ++f) {
      double far = 0, near = 1e300, sum = 0;
      for (const int k : w_.faces[f])
        far = std::max(far, seen_[k][2]), near = std::min(near, seen_[k][2]), sum += seen_[k][2];
      double key = p_.variant == "zmean" ? sum / double(w_.faces[f].size()) : far;
      if (has("order-nearest-z")) key = near;
      if (has("order-none")) key = 0;
      order.emplace_back(has("order-reversed") ? key : -key, f);
    }
    std::ranges::stable_sort(order, {}, [](const auto& o) { return o.first; });
    for (const auto& [key, f] : order)
      if (!has("cull-front") || back_[f]) paint(r, f);
    if (has("flip-y") || has("turned-180"))
      for (int j = 0; j < r.height / 2; ++j)
        for (int i = 0; i < r.width; ++i) swapPixels(r, i, j, i, r.height - 1 - j);
    if (has("flip-x") || has("turned-180"))
      for (int j = 0; j < r.height; ++j)
        for (int i = 0; i < r.width / 2; ++i) swapPixels(r, i, j, r.width - 1 - i, j);
    return r;
  }

 private:
  [[nodiscard]] bool has(const char* key) const {
    return p_.mistake == key || p_.variant == key || p_.second == key;
  }
  [[nodiscard]] int faces() const { return static_cast<int>(w_.faces.size()); }
  static void swapPixels(Result& r, int i, int j, int x, int y) {
    const int a = j * r.width + i, b = y * r.width + x;
    std::swap(r.cell[a], r.cell[b]), std::swap(r.red[a], r.red[b]);
  }

  /// The sum of the cross products of a fan of triangles; with the mistakes, or without.
  Triple rawNormal(int f, bool mistaken) const {
    Triple sum{};
    const auto& face = w_.faces[f];
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const Triple a = corner(face[0], mistaken);
      sum = plus(sum, crossOf(minus(corner(face[k], mistaken), a), minus(corner(face[k + 1], mistaken), a)));
      if (mistaken && has("three-corners")) break;
    }
    return sum;
  }
  Triple corner(int k, bool mistaken) const {
    if (!mistaken || !has("N-after-projection")) return w_.points[k];
    const double aspect = double(p_.width) / p_.height;
    return {seen_[k][0] / aspect, seen_[k][1], -seen_[k][2]};
  }

  void makeNormals() {
    normal_.resize(w_.faces.size()), back_.resize(w_.faces.size());
    std::vector<Triple> sums(w_.points.size());
    std::vector<int> counts(w_.points.size());
    at_.resize(w_.points.size());
    for (int f = 0; f < faces(); ++f) {
      Triple N = rawNormal(f, true);
      const auto& face = w_.faces[f];
      const Triple world = rawNormal(f, false);
      back_[f] = dotOf(world, minus(w_.eye, w_.points[face[0]])) < 0;
      if (!has("N-not-unit")) N = unitOf(N);
      if (has("N-in-view-coords")) N = {dotOf(N, u_), dotOf(N, v_), dotOf(N, n_)};
      if (has("N-inward")) N = times(-1, N);
      normal_[f] = p_.byMatrices ? normalInView(w_, p_, N) : N;
      for (std::size_t k = 0; k < face.size(); ++k) {
        at_[face[k]].push_back(f), ++counts[face[k]];
        if (has("VN-last-face"))
          sums[face[k]] = N;
        else if (!has("VN-triangles-twice"))
          sums[face[k]] = plus(sums[face[k]], has("VN-area") ? world : N);
      }
      if (has("VN-triangles-twice"))
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
          const Triple a = w_.points[face[0]], b = w_.points[face[k]], c = w_.points[face[k + 1]];
          const Triple one = unitOf(crossOf(minus(b, a), minus(c, a)));
          for (const int point : {face[0], face[k], face[k + 1]}) sums[point] = plus(sums[point], one);
        }
    }
    for (std::size_t k = 0; k < sums.size(); ++k) {
      if (has("VN-mean-not-unit"))
        sums[k] = times(1.0 / std::max(1, counts[k]), sums[k]);
      else if (!has("VN-sum-not-unit") && !has("N-not-unit"))
        sums[k] = unitOf(sums[k]);
    }
    vertexNormal_ = sums;
  }

  [[nodiscard]] char table() const {
    if (has("table-linear")) return 'l';
    return has("table-corrected") ? 'c' : p_.table;
  }
  void makeTable() {
    first_ = table() == 'b' ? 10 : 11;
    for (int i = 0; i < 256; ++i) {
      const int j = std::clamp(i - first_, 0, 239);
      double v = std::clamp((i - 10) / 255.0, 0.0, 1.0);
      if (table() == 'c') v = i < first_ ? 0.0 : p_.I0 * std::pow(1 / p_.I0, ratioSteps(j));
      if (has("table-reversed")) {
        const int k = std::clamp(239 - (i - first_), 0, 239);
        v = table() == 'c' ? p_.I0 * std::pow(1 / p_.I0, k / 239.0) : (k + first_ - 10) / 255.0;
      }
      if (has("table-gamma")) v = std::pow(v, 1 / 2.2);
      if (has("table-i-11")) v = std::max(0.0, (i - 11) / 255.0);
      int sixteen = static_cast<int>(std::lround(std::min(1.0, v) * 65535));
      if (has("table-8-bit-in-16")) sixteen = static_cast<int>(std::lround(v * 255));
      held_[i] = static_cast<std::uint8_t>(sixteen >> 8);
      if (has("8-bits")) held_[i] = static_cast<std::uint8_t>(std::lround(v * 255));
    }
  }
  [[nodiscard]] std::optional<std::uint8_t> withoutTable(double I) const {
    if (has("stores-255-I")) return static_cast<std::uint8_t>(p_.half ? std::lround(255 * I) : long(255 * I));
    if (has("stores-256-I")) return static_cast<std::uint8_t>(std::min(255.0, 256 * I));
    if (has("stores-gamma")) return static_cast<std::uint8_t>(255 * std::pow(I, 1 / 2.2));
    return {};
  }
  [[nodiscard]] double ratioSteps(int j) const {
    if (has("table-r-240-steps")) return j / 240.0;
    return has("table-r-64-steps") ? j / 63.0 : j / 239.0;
  }

  [[nodiscard]] int cellOf(double I) const {
    I = std::max(0.0, I);
    if (has("tone-mapped")) I = I / (1 + I);
    if (!has("I-wraps")) I = std::min(I, 1.0);
    if (has("I-whole")) I = int(I);
    double steps = 239;
    if (has("cell-240I")) steps = 240;
    if (has("cell-255I")) steps = 255;
    double real = steps * I;
    const double r = std::pow(1 / p_.I0, p_.flows ? ratioSteps(1) : 1 / 239.0);
    const bool logarithm = table() == 'c' ? !has("cell-linear-in-corrected") : has("cell-log-in-linear");
    if (logarithm) {
      real = I > 0 ? std::log(I / (has("cell-I0-forgotten") ? 1 : p_.I0)) : 0;
      if (!has("cell-natural-log")) real /= std::log(r);
      real = std::max(0.0, real);
    }
    int cell = static_cast<int>(has("cell-floor") ? std::floor(real) : std::floor(real + 0.5));
    if (has("cell-ceil")) cell = static_cast<int>(std::ceil(real));
    if (has("cell-one-more")) ++cell;
    if (!has("cell-first-forgotten")) cell += has("cell-off-by-one") ? first_ - 1 : first_;
    return has("I-wraps") ? cell % 256 : std::min(cell, 255);
  }

  double lit(Triple P, Triple N, const Surface& s) const {
    double ka = s.ka, kd = s.kd, ks = s.ks;
    if (has("ka-kd-swapped")) std::swap(ka, kd);
    if (has("kd-ks-swapped")) std::swap(kd, ks);
    if (has("ka-forgotten")) ka = 1;
    bool lamp = w_.lamp;
    if (has("L-direction-as-place") || has("L-place-as-direction")) lamp = !lamp;
    Triple to = lamp ? minus(w_.light, P) : w_.light;
    const double d = lengthOf(minus(w_.light, P));
    if (has("L-constant") && lamp) to = minus(w_.light, times(0.5, plus(low_, high_)));
    double f = 1;
    if (w_.lamp) {
      const double far = has("L-constant") ? lengthOf(to) : d;
      f = 1 / (far * far);
      if (has("f-1/d")) f = 1 / far;
      if (!has("f-above-1")) f = std::min(1.0, f);
      if (has("f-forgotten")) f = 1;
    }
    if (has("L-not-moved")) to = lightInView(w_, p_, w_.light, P);
    Triple L = has("L-not-unit") ? to : unitOf(to);
    if (has("L-sign")) L = times(-1, L);
    Triple V = minus(w_.eye, P);
    if (has("V-from-look-at")) V = minus(w_.at, P);
    if (has("V-constant") || has("half-vector-V-constant")) V = minus(w_.eye, w_.at);
    if (has("V-is-eye")) V = w_.eye;
    if (!has("V-not-unit")) V = unitOf(V);
    if (has("V-sign")) V = times(-1, V);
    if (p_.flows && !has("N-one-sided") && dotOf(N, V) < 0) N = times(-1, N);
    double NL = dotOf(N, L);
    if (p_.flows && has("NL-abs")) NL = std::fabs(NL);
    if (p_.flows && has("NL-angle")) NL = std::max(0.0, 1 - std::acos(std::clamp(NL, -1.0, 1.0)) * 2 / kPi);
    if (p_.flows && has("highlight-behind")) NL = std::max(0.0, NL);
    Triple R = minus(times(2 * NL, N), L);
    if (has("R-sign")) R = times(-1, R);
    if (has("R-plus-L")) R = plus(times(2 * NL, N), L);
    if (has("R-without-2")) R = minus(times(NL, N), L);
    double RV = dotOf(R, V);
    if (has("half-vector") || has("half-vector-V-constant")) RV = dotOf(N, unitOf(plus(L, V)));
    if (has("NL-to-the-n")) RV = NL;
    double facing = std::max(0.0, NL);
    if (has("NL-unclamped")) facing = NL;
    if (has("NL-abs")) facing = std::fabs(NL);
    if (has("NL-angle") && !p_.flows)
      facing = std::max(0.0, 1 - std::acos(std::clamp(NL, -1.0, 1.0)) * 2 / kPi);
    double shine = std::max(0.0, RV);
    if (has("R.L")) shine = std::max(0.0, dotOf(R, L));
    if (has("RV-unclamped")) shine = RV;
    if (has("RV-abs")) shine = std::fabs(RV);
    double highlight = ks * std::pow(shine, s.n);
    if (has("n-forgotten")) highlight = ks * shine;
    if (has("n-times")) highlight = ks * s.n * shine;
    if (has("ks-in-the-power")) highlight = std::pow(ks * shine, s.n);
    if (has("spec-times-NL")) highlight *= facing;
    if (const std::string& off = p_.mistake.starts_with("off-") ? p_.mistake : p_.second;
        off.starts_with("off-"))
      return offList(off, {N, L, V, P, NL, dotOf(N, V), RV, d, f, w_.Ip, w_.Ia, s.ka, s.kd, s.ks, s.n});
    const bool asks = !has("highlight-behind") && !(p_.flows && has("NL-unclamped"));
    if (NL <= 0 && asks) highlight = 0;
    if (has("spec-forgotten")) highlight = 0;
    double diffuse = has("diffuse-forgotten") ? 0 : kd * facing;
    double ambient = ka * w_.Ia;
    if (has("Ia-forgotten")) ambient = 0;
    if (has("Ia-twice")) ambient *= 2;
    if (has("f-on-ambient")) ambient *= f;
    if (has("ambient-in-the-dark") && NL > 0) ambient = 0;
    if (has("Ip-not-on-diffuse")) return ambient + f * (diffuse + w_.Ip * highlight);
    if (has("max-for-the-sum")) return std::max({ambient, f * w_.Ip * diffuse, f * w_.Ip * highlight});
    const double Ip = has("Ip-forgotten") ? 1 : w_.Ip;
    if (has("n-on-the-sum")) return ambient + f * Ip * std::pow(kd * facing + (NL > 0 ? ks * shine : 0), s.n);
    return ambient + f * (Ip * diffuse + (has("Ip-not-on-spec") ? 1 : Ip) * highlight);
  }

  [[nodiscard]] double sideOf(int f) const { return back_[f] && !has("N-one-sided") ? -1 : 1; }

  double flatOf(int f) const { return flatOf(f, w_.faces[f]); }
  double flatOf(int f, const std::vector<int>& face) const {
    Triple P{};
    for (const int k : face) P = plus(P, times(1.0 / double(face.size()), w_.points[k]));
    if (has("first-corner")) P = w_.points[face[0]];
    if (!has("first-corner") && !has("mean-of-corners") && face.size() > 3) {
      Triple sum{};
      double weight = 0;
      const Triple a = w_.points[face[0]], N = rawNormal(f, false);
      for (std::size_t k = 1; k + 1 < face.size(); ++k) {
        const Triple b = w_.points[face[k]], c = w_.points[face[k + 1]];
        const double area = dotOf(crossOf(minus(b, a), minus(c, a)), N);
        sum = plus(sum, times(area / 3, plus(a, plus(b, c)))), weight += area;
      }
      if (weight > 0) P = times(1 / weight, sum);
    }
    return lit(P, times(sideOf(f), normal_[f]), w_.surfaces[f]);
  }
  double vertexI(int f, int k) const {
    if (has("gouraud-averages-faces")) {
      double sum = 0;
      for (const int g : at_[k]) sum += flatOf(g) / double(at_[k].size());
      return sum;
    }
    const Triple N = has("VN-own-face") ? normal_[f] : vertexNormal_[k];
    return lit(w_.points[k], times(sideOf(f), N), w_.surfaces[f]);
  }

  void paint(Result& r, int f) {
    char method = p_.method;
    if (has("method-flat")) method = 'f';
    if (has("method-gouraud")) method = 'g';
    if (has("method-phong")) method = 'p';
    const auto& face = w_.faces[f];
    double flat = method == 'f' ? flatOf(f) : 0;
    if (has("depth-cue")) flat = 1 - (depthOf(f) - nearDepth_) / (farDepth_ - nearDepth_);
    const std::size_t from = has("other-diagonal") ? 1 : 0;
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const std::size_t n = face.size();
      const std::array<int, 3> tri{face[from], face[(from + k) % n], face[(from + k + 1) % n]};
      if (has("triangles-apart") && method == 'f') flat = flatOf(f, {tri.begin(), tri.end()});
      fill(r, f, tri, has("depth-cue") ? 'f' : method, flat);
    }
  }
  [[nodiscard]] double depthOf(int f) const {
    double sum = 0;
    for (const int k : w_.faces[f]) sum += seen_[k][2] / double(w_.faces[f].size());
    return sum;
  }
  void fill(Result& r, int f, std::array<int, 3> tri, char method, double flat) {
    std::array<double, 3> x{}, y{}, I{};
    for (int k = 0; k < 3; ++k) {
      const double half = p_.half ? 0.0 : 0.5, scale = p_.height / 2.0;
      x[k] = std::floor(p_.width / 2.0 + scale * seen_[tri[k]][0] - half + 0.5);
      y[k] = std::floor(p_.height / 2.0 - scale * seen_[tri[k]][1] - half + 0.5);
      if (method == 'g') {
        I[k] = vertexI(f, tri[k]);
        if (!has("clamped-late") && !has("I-wraps") && !has("tone-mapped") && !has("I-whole"))
          I[k] = std::clamp(I[k], 0.0, 1.0);
      }
    }
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    const int left = int(std::max(0.0, std::min({x[0], x[1], x[2]}))),
              right = int(std::min(p_.width - 1.0, std::max({x[0], x[1], x[2]})));
    const int top = int(std::max(0.0, std::min({y[0], y[1], y[2]}))),
              bottom = int(std::min(p_.height - 1.0, std::max({y[0], y[1], y[2]})));
    if (area == 0) return;
    for (int j = top; j <= bottom; ++j)
      for (int i = left; i <= right; ++i) {
        std::array<double, 3> b{};
        for (int k = 0; k < 3; ++k) {
          const int a = (k + 1) % 3, c = (k + 2) % 3;
          b[k] = ((x[a] - i) * (y[c] - j) - (x[c] - i) * (y[a] - j)) / area;
        }
        if (b[0] < 0 || b[1] < 0 || b[2] < 0) continue;  // edges are inclusive
        std::array<double, 3> w{};
        double sum = 0;
        for (int k = 0; k < 3; ++k) w[k] = b[k] / seen_[tri[k]][2], sum += w[k];
        const int at = j * p_.width + i;
        if (p_.zbuffer && 1 / sum > nearest_[at]) continue;
        nearest_[at] = 1 / sum;
        for (double& one : w) one /= sum;
        double value = flat;
        if (method == 'g') value = b[0] * I[0] + b[1] * I[1] + b[2] * I[2];
        if (method == 'p') {
          Triple N{}, P{};
          for (int k = 0; k < 3; ++k) {
            const Triple vertex = has("VN-own-face") ? normal_[f] : vertexNormal_[tri[k]];
            const bool onScreen = has("affine") || has("phong-not-renormalised");
            N = plus(N, times(onScreen ? b[k] : w[k], vertex));
            P = plus(P, times(has("affine") ? b[k] : w[k], w_.points[tri[k]]));
          }
          if (!has("phong-not-renormalised") && !has("N-not-unit")) N = unitOf(N);
          value = lit(P, times(sideOf(f), N), w_.surfaces[f]);
        }
        r.cell[at] = cellOf(value);
        if (method == 'g' && has("cells-between"))
          r.cell[at] = int(std::lround(b[0] * cellOf(I[0]) + b[1] * cellOf(I[1]) + b[2] * cellOf(I[2])));
        r.red[at] = held_[r.cell[at]];
        if (const auto direct = withoutTable(std::clamp(value, 0.0, 1.0))) r.red[at] = *direct;
      }
  }

  const World& w_;
  const Program& p_;
  Triple n_{}, u_{}, v_{}, low_{}, high_{};
  std::vector<Triple> seen_;  ///< on the screen, and the depth
  std::vector<Triple> normal_, vertexNormal_;
  std::vector<char> back_;
  std::vector<std::vector<int>> at_;
  std::vector<double> nearest_;
  double nearDepth_ = 1e300, farDepth_ = 0;
  std::array<std::uint8_t, 256> held_{};
  int first_ = 11;
};

}  // namespace

Result draw(const World& world, const Program& program) { return Drawing{world, program}.make(); }

}  // namespace student
