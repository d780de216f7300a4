#include "tests/support/student_sort.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <random>

#include "shading/library/xnewell_run.h"

namespace student {

namespace {

struct Corner {
  double x, y;
};
using Outline = std::vector<Corner>;
/// Nearness a x + b y + c, which is 1 over the depth.
struct Plane {
  double a, b, c;
  [[nodiscard]] double at(Corner p) const { return a * p.x + b * p.y + c; }
};
struct Item {
  int number;
  Outline outline;
  Plane plane;
  std::vector<double> shade;
  double far, near;
  bool marked = false, isPiece = false;
};
constexpr double kEps = 1e-9;

double areaOf(const Outline& p) {
  double sum = 0;
  for (std::size_t k = 1; k + 1 < p.size(); ++k)
    sum += (p[k].x - p[0].x) * (p[k + 1].y - p[0].y) - (p[k].y - p[0].y) * (p[k + 1].x - p[0].x);
  return sum / 2;
}
/// The part where side * (a x + b y + c) > 0.
Outline clipped(const Outline& p, const Plane& line, double side) {
  Outline kept;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Corner u = p[k], v = p[(k + 1) % p.size()];
    const double du = side * line.at(u), dv = side * line.at(v);
    if (du >= 0) kept.push_back(u);
    if ((du > 0 && dv < 0) || (du < 0 && dv > 0)) {
      const double t = du / (du - dv);
      kept.push_back({u.x + t * (v.x - u.x), u.y + t * (v.y - u.y)});
    }
  }
  return kept;
}
Plane minus(const Plane& p, const Plane& q) { return {p.a - q.a, p.b - q.b, p.c - q.c}; }
Triple less(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Triple unit(const Triple& a) {
  const double length = std::sqrt(dotOf(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

class Sort {
 public:
  Sort(const World& w, int width, int height, const char* file, unsigned seed, std::string_view fault)
      : run_{file, width, height}, random_{seed}, fault_{fault} {
    const Triple n = unit(less(w.eye, w.at)), u = unit(crossOf(w.up, n)), v = crossOf(n, u);
    const double scale = height / 2.0 / std::tan(w.fov / 360 * 3.14159265358979323846);
    for (std::size_t f = 0; f < w.faces.size(); ++f) {
      Item P{static_cast<int>(f), {}, {}, {}, 0, 0};
      std::vector<double> nearness;
      for (const int k : w.faces[f]) {
        const Triple d = less(w.points[static_cast<std::size_t>(k)], w.eye);
        const double depth = -dotOf(d, n);
        P.outline.push_back(
            {width / 2.0 + scale * dotOf(d, u) / depth, height / 2.0 - scale * dotOf(d, v) / depth});
        nearness.push_back(1 / depth);
      }
      const Corner a = P.outline[0], b = P.outline[1], c = P.outline[2];
      const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      const double wb = nearness[1] - nearness[0], wc = nearness[2] - nearness[0];
      if (std::abs(area) < 1e-6) continue;
      P.plane.a = (wb * (c.y - a.y) - wc * (b.y - a.y)) / area;
      P.plane.b = (wc * (b.x - a.x) - wb * (c.x - a.x)) / area;
      P.plane.c = nearness[0] - P.plane.a * a.x - P.plane.b * a.y;
      if (area < 0) std::ranges::reverse(P.outline);
      const auto& corners = w.faces[f];
      const auto place = [&](std::size_t k) { return w.points[static_cast<std::size_t>(corners[k])]; };
      const Triple N = unit(crossOf(less(place(1), place(0)), less(place(2), place(0))));
      const double NL = dotOf(N, unit({0.3, 0.5, 0.8}));
      P.shade = {N[0], N[1], N[2], NL, std::floor(20 + 100 * std::abs(NL))};
      insert(P);
    }
    next_ = static_cast<int>(w.faces.size()) + 5;
  }

  Sorted sort() {
    while (!list_.empty() && result_.lines < 20000) step();
    result_.ended = list_.empty() && !stopped_;
    if (has("paints the last one twice") && last_ >= 0) did(result_.lines + 1), run_.paint(last_, -1);
    return result_;
  }

 private:
  using Place = std::list<Item>::iterator;
  [[nodiscard]] bool has(std::string_view fault) const { return fault_ == fault; }
  void did(int line) {
    if (!result_.done) result_.line = line;
    result_.done = true;
  }
  /// The line that is written next.
  int now() { return result_.lines + 1; }
  void wrote() { ++result_.lines; }
  void stop() { stopped_ = true, list_.clear(); }
  bool heads() { return random_() % 2 == 0; }

  void insert(Item P) {
    P.far = 1e300, P.near = -1e300;
    for (const Corner& c : P.outline)
      P.far = std::min(P.far, P.plane.at(c)), P.near = std::max(P.near, P.plane.at(c));
    const auto at = std::ranges::find_if(list_, [&](const Item& Q) {
      return !Q.marked && (Q.far > P.far + kEps || (Q.far > P.far - kEps && heads()));
    });
    list_.insert(at, std::move(P));
  }

  // The tests; a double tells how clearly: positive is yes, in pixels or in nearness.
  static double apart(const Item& P, const Item& Q, double Corner::*along) {
    const auto [p0, p1] = std::ranges::minmax(P.outline, {}, along);
    const auto [q0, q1] = std::ranges::minmax(Q.outline, {}, along);
    return std::max(q0.*along - p1.*along, p0.*along - q1.*along);
  }
  static bool onSide(const Item& of, const Item& from, double side, bool one = false) {
    const Plane ahead = minus(of.plane, from.plane);
    for (const Corner& c : of.outline) {
      if (side * ahead.at(c) < -kEps) return false;
      if (one) return true;
    }
    return true;
  }
  static double widest(const Item& P, const Item& Q) {
    double most = -1e300;
    for (const auto& [of, other] : {std::pair{&P, &Q}, {&Q, &P}})
      for (std::size_t k = 0; k < of->outline.size(); ++k) {
        const Corner a = of->outline[k], b = of->outline[(k + 1) % of->outline.size()];
        double least = 1e300;
        for (const Corner& c : other->outline)
          least = std::min(least, ((b.y - a.y) * (c.x - a.x) - (b.x - a.x) * (c.y - a.y)) /
                                      std::hypot(b.x - a.x, b.y - a.y));
        most = std::max(most, least);
      }
    return most;
  }
  static bool hasCornerIn(const Item& P, const Item& Q) {
    return std::ranges::any_of(P.outline, [&](const Corner& c) {
      for (std::size_t k = 0; k < Q.outline.size(); ++k) {
        const Corner a = Q.outline[k], b = Q.outline[(k + 1) % Q.outline.size()];
        if ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 0) return false;
      }
      return true;
    });
  }
  /// True if nearness differs so little, or outlines miss by so little, that the judge may allow both
  /// answers.
  static bool isClose(const Item& of, const Item& from) {
    const Plane ahead = minus(of.plane, from.plane);
    return std::ranges::any_of(of.outline, [&](const Corner& c) { return std::abs(ahead.at(c)) < 1e-5; });
  }

  bool answer(const Item& P, const Item& Q, const std::string& test) {
    bool right = false, close = false, said = false;
    const bool other = has("test " + test + " has the other sign"),
               one = has("test " + test + " looks at one corner");
    if (test == "1" || test == "2") {
      const auto along = test == "1" ? &Corner::x : &Corner::y;
      const double gap = apart(P, Q, along);
      said = right = gap >= 0, close = std::abs(gap) <= 1;
      if (has("test " + test + " compares the wrong ends"))
        said = std::ranges::min(P.outline, {}, along).*along < std::ranges::min(Q.outline, {}, along).*along;
    } else if (test == "5") {
      const double gap = widest(P, Q);
      said = right = gap >= 0, close = std::abs(gap) <= 1;
      if (has("test 5 is always no")) said = false;
      if (has("test 5 looks for corners inside")) said = !hasCornerIn(P, Q) && !hasCornerIn(Q, P);
    } else {
      const bool ofP = test == "3" || test == "4'";
      const Item &of = ofP ? P : Q, &from = ofP ? Q : P;
      const double side = test[0] == '3' ? -1 : 1;
      said = right = onSide(of, from, side), close = isClose(of, from);
      if (other) said = onSide(of, from, -side);
      if (one) said = onSide(of, from, side, true);
    }
    if (said != right && close) said = right;  // the judge may allow it
    if (said != right) did(now());
    run_.test(P.number, Q.number, test, said), wrote();
    return said;
  }
  /// True if P is nowhere nearer where they overlap.
  static bool nowhereNearer(const Item& P, const Item& Q) {
    Outline both = P.outline;
    for (std::size_t k = 0; k < Q.outline.size() && !both.empty(); ++k) {
      const Corner a = Q.outline[k], b = Q.outline[(k + 1) % Q.outline.size()];
      both = clipped(both, {a.y - b.y, b.x - a.x, (b.y - a.y) * a.x - (b.x - a.x) * a.y}, 1);
    }
    const Plane ahead = minus(P.plane, Q.plane);
    return std::ranges::all_of(both, [&](const Corner& c) { return ahead.at(c) <= kEps; });
  }
  static bool mayGoFirst(const Item& P, const Item& Q) {
    return widest(P, Q) >= 0 || onSide(P, Q, -1) || onSide(Q, P, 1) || nowhereNearer(P, Q);
  }

  void step() {
    const Place P = list_.begin();
    run_.take(P->number), wrote();
    const int taken = result_.lines;
    for (Place Q = std::next(P); Q != list_.end(); ++Q) {
      if (Q->far > P->near + kEps) continue;
      if (has("paints before the last Q is tested") && std::next(Q) == list_.end() && !mayGoFirst(*P, *Q)) {
        did(now());
        break;
      }
      std::vector<std::string> tests{"1", "2", "3", "4", "5"};
      std::shuffle(tests.begin(), tests.end(), random_);
      bool told = false;
      const std::string without{has("no tests 3' and 4'")        ? "'"
                                : fault_.starts_with("no test ") ? fault_.substr(8)
                                                                 : ""};
      for (const std::string& test : tests)
        if (!told && test != without) told = answer(*P, *Q, test);
      if (told) continue;
      if (has("paints instead of moving") && !mayGoFirst(*P, *Q)) {
        did(now());
        break;
      }
      bool first = false;
      if (!has("no tests 3' and 4'") && !has("moves without a test")) {
        first = answer(*P, *Q, "3'") || answer(*P, *Q, "4'");
        if (!first && heads() && fault_.empty()) {  // test 6 is made by some
          const bool yes = nowhereNearer(*P, *Q);
          run_.test(P->number, Q->number, "6", yes), wrote();
          if (yes) continue;
        }
      } else if (has("moves without a test")) {
        first = true;
      }
      if (first && has("no move")) {
        if (again_ == P->number) did(taken);
        again_ = P->number;
        if (++stuck_ > 5) stop();
        return;
      }
      if (first && (!Q->marked || has("no mark"))) {
        const bool isLeftOut = !without.empty() && left(*P, *Q, without);
        if (isLeftOut || (has("moves without a test") && !mayGoFirst(*Q, *P)) ||
            (has("no mark") && Q->marked))
          did(now());
        run_.move(P->number, Q->number), wrote();
        Q->marked = true;
        if (heads()) run_.mark(Q->number), wrote();
        if (has("loses a polygon that was moved")) {
          did(0);
          list_.erase(Q);
        } else {
          list_.splice(list_.begin(), list_, Q);
        }
        if (has("no mark") && ++stuck_ > 200) stop();
        return;
      }
      if (!split(P, Q, without)) stop();
      return;
    }
    paint(*P);
    list_.erase(list_.begin());
  }
  /// True if a test that is not made says yes, clearly.
  static bool left(const Item& P, const Item& Q, const std::string& test) {
    if (test == "3") return onSide(P, Q, -1) && !isClose(P, Q);
    if (test == "4") return onSide(Q, P, 1) && !isClose(Q, P);
    if (test == "5") return widest(P, Q) > 1;
    return (onSide(Q, P, -1) && !isClose(Q, P)) || (onSide(P, Q, 1) && !isClose(P, Q));
  }
  void paint(const Item& P) {
    int cell = static_cast<int>(P.shade[4]);
    if (P.isPiece && has("paints a piece with another cell")) did(now()), ++cell;
    run_.paint(P.number, cell), wrote();
    last_ = P.number;
  }

  static bool crosses(const Item& P, const Item& Q) { return !onSide(P, Q, 1) && !onSide(P, Q, -1); }
  /// Splits one of the two, or another that is marked. False if no plane crosses any.
  bool split(Place P, Place Q, const std::string& without) {
    if (!without.empty() && (without != "'" || !Q->marked) && left(*P, *Q, without)) did(now());
    if (has("splits where no plane crosses"))
      for (Place by = std::next(P); by != list_.end(); ++by)
        if (!crosses(*P, *by) && !isClose(*P, *by)) return did(now()), cut(P, by), true;
    std::vector<std::pair<Place, Place>> ways{{P, Q}, {Q, P}};
    if (heads()) std::swap(ways[0], ways[1]);
    for (Place a = list_.begin(); a != list_.end() && a->marked; ++a)
      for (Place b = list_.begin(); b != list_.end() && b->marked; ++b)
        if (a != b) ways.emplace_back(a, b);
    for (const auto& [of, by] : ways)
      if (crosses(*of, *by)) return cut(of, by), true;
    return false;
  }
  void cut(Place P, Place Q) {
    Plane line = minus(P->plane, Q->plane);
    const Outline right = clipped(P->outline, line, -1);
    if (has("splits by another plane"))
      for (Place R = list_.begin(); R != list_.end(); ++R)
        if (R != P && R != Q && crosses(*P, *R) &&
            std::abs(areaOf(clipped(P->outline, minus(P->plane, R->plane), -1)) - areaOf(right)) > 300) {
          did(now()), line = minus(P->plane, R->plane);
          break;
        }
    Item behind = *P, front = *P;
    behind.outline = clipped(P->outline, line, -1), front.outline = clipped(P->outline, line, 1);
    behind.number = next_++, front.number = next_++;
    for (Item* piece : {&behind, &front}) piece->isPiece = true, piece->marked = false;
    const auto told = [&](const Item& item) {
      xnewell_run::Polygon polygon{item.number, {}, item.shade};
      for (const Corner& c : item.outline) polygon.outline.insert(polygon.outline.end(), {c.x, c.y});
      return polygon;
    };
    xnewell_run::Polygon a = told(behind), b = told(front), whole = told(*P);
    const bool large = areaOf(behind.outline) > 300 && areaOf(front.outline) > 300;
    if (has("exchanges the pieces") && large) did(now()), std::swap(a.outline, b.outline);
    if (has("a gap between the pieces") && large) {
      did(now());
      for (std::size_t k = 0; k < a.outline.size(); ++k)
        a.outline[k] = (a.outline[k] + (k % 2 == 0 ? behind.outline[0].x : behind.outline[0].y)) / 2;
    }
    if (has("the front piece is all of P") && large) did(now()), b.outline = whole.outline;
    if (has("turns the normal of a piece")) {
      did(now());
      for (int k = 0; k < 4; ++k) b.shade[static_cast<std::size_t>(k)] *= -1;
    }
    if (has("shades a piece anew")) did(now()), a.shade[4] += 2;
    run_.split(whole, Q->number, a, b), wrote();
    if (has("keeps a polygon that was split")) did(now()), run_.take(P->number), wrote();
    list_.erase(P);
    if (heads()) std::swap(behind, front);
    if (has("loses a piece"))
      did(0);
    else if (front.outline.size() > 2)
      insert(front);
    if (behind.outline.size() > 2) insert(behind);
  }

  xnewell_run::Run run_;
  std::mt19937 random_;
  std::string_view fault_;
  std::list<Item> list_;
  Sorted result_{.lines = 1};
  int next_ = 0, last_ = -1, again_ = -1, stuck_ = 0;
  bool stopped_ = false;
};

}  // namespace

Sorted writeRun(const World& world, int width, int height, const char* file, unsigned seed,
                std::string_view fault) {
  return Sort{world, width, height, file, seed, fault}.sort();
}

}  // namespace student
