// SPDX-License-Identifier: MIT
#include "machines/cams/arm_clearance.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <queue>

#include "machines/model/inner_numbers.h"

namespace camlaw::problems {
namespace {

using optim::Bounds, optim::Curve, optim::Function, optim::Place, optim::Trace;
using optim::packed, optim::packed_size;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kTurn = 360;

/// Distance of (x, y) from the line between the roller's centre (cx, cy) and the pivot (d, 0).
/// Where the arm runs through the cam, depths count: a point beside that line on the other side
/// than the cam's centre is at a distance below 0.
template <class T>
T distance_from_arm(const T& x, const T& y, const T& cx, const T& cy, const T& d, bool depths) {
  using std::sqrt;
  const T ax = d - cx, ay = -cy, px = x - cx, py = y - cy, length = ax * ax + ay * ay;
  const double along = value_of(px * ax + py * ay) / value_of(length);
  if (along <= 0) return sqrt(px * px + py * py);
  if (along >= 1) return sqrt((x - d) * (x - d) + y * y);
  const T across = (px * ay - py * ax) / sqrt(length);
  return value_of(across) < 0 && !depths ? T(-across) : across;
}

/// (M43) Of z: the point touched, the roller's centre, the pivot's distance, and the angles, deg,
/// at which the arm stands and the point is touched.
enum Of { ContactX, ContactY, CentreX, CentreY, Pivot, ArmAt, TouchedAt, kNumbers };

struct Gap {
  double turn;
  bool depths;

  template <class T>
  T operator()(std::span<const T> z) const {
    using std::cos;
    using std::sin;
    const T angle = number<T>(turn * kDegree) * (z[ArmAt] - z[TouchedAt]);
    const T c = cos(angle), s = sin(angle);
    return distance_from_arm(T(z[ContactX] * c - z[ContactY] * s),
                             T(z[ContactX] * s + z[ContactY] * c), z[CentreX], z[CentreY], z[Pivot],
                             depths);
  }
};

double whole_turn(double angle) { return angle - kTurn * std::floor(angle / kTurn); }

/// The places of a clearance, deg.
struct Meeting {
  double arm_at = 0, touched_at = 0, gap = std::nan("");
  bool is_through = false;  ///< the arm runs through the cam: it is a depth
};

/// A place, and whether a break holds it: from there on the curve is another.
struct HeldPlace {
  Place place;
  bool is_held = false;
};

HeldPlace held_place(double angle, const std::vector<double>& breaks) {
  constexpr double kBeside = 1e-6;  // deg: what the steps of a search leave
  for (const double at : breaks) {
    if (std::abs(angle - at) > kBeside) continue;
    return {{at, at > breaks.front() && (angle < at || at == breaks.back())}, true};
  }
  return {{angle}, false};
}

/// A disc that holds a point over a stretch.
struct Disc {
  double x, y, radius;
};

/// Two curves as one point over the angle.
class PointTrace {
 public:
  PointTrace(std::unique_ptr<Trace> x, std::unique_ptr<Trace> y)
      : x_(std::move(x)), y_(std::move(y)), breaks_(x_->breaks()) {}

  const std::vector<double>& breaks() const { return breaks_; }
  std::array<double, 2> at(double angle) const {
    const Place place{whole_turn(angle)};
    return {x_->at(place)[0], y_->at(place)[0]};
  }
  /// Over [from, to], which may pass breaks and the end of the turn.
  Disc disc(double from, double to) const {
    Interval x = Interval::empty(), y = Interval::empty();
    const double width = std::max(to - from, kTurn / kFinest);
    const double begin = whole_turn(from), end = begin + (to - from);
    for (int lap = 0; lap < 3; ++lap) {
      for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
        const double a = breaks_[i] + lap * kTurn, b = breaks_[i + 1] + lap * kTurn;
        if (b < begin || a > end) continue;
        add(i, std::max(begin, a) - lap * kTurn, std::min(end, b) - lap * kTurn, width, x, y);
      }
    }
    const double mx = (x.lower() + x.upper()) / 2, my = (y.lower() + y.upper()) / 2;
    const double hx = std::max(x.upper() - mx, mx - x.lower());
    const double hy = std::max(y.upper() - my, my - y.lower());
    return {mx, my, std::hypot(hx, hy)};
  }

 private:
  static constexpr double kFinest = 1 << 22;
  using Box = std::pair<Interval, Interval>;

  /// Adds the cells that hold [from, to], no wider than `width`: they are what is remembered.
  void add(std::size_t stretch, double from, double to, double width, Interval& x,
           Interval& y) const {
    const double a = breaks_[stretch], length = breaks_[stretch + 1] - a;
    int level = 0;
    while (std::ldexp(length, -level) > width) ++level;
    const double cell = std::ldexp(length, -level);
    const long last = (1L << level) - 1;
    const auto index = [&](double angle) {
      return std::clamp(static_cast<long>(std::floor((angle - a) / cell)), 0L, last);
    };
    for (long i = index(from); i <= index(to); ++i) {
      const auto [bx, by] = box(stretch, level, i);
      x = boost::numeric::hull(x, bx);
      y = boost::numeric::hull(y, by);
    }
  }
  Box box(std::size_t stretch, int level, long i) const {
    const auto [at, is_new] = known_.try_emplace({stretch, level, i});
    if (is_new) {
      const double a = breaks_[stretch], b = breaks_[stretch + 1];
      const double cell = std::ldexp(b - a, -level);
      const double from = a + cell * static_cast<double>(i);
      const double to = i + 1 == (1L << level) ? b : std::min(b, from + cell);
      const Bounds x = x_->enclose(from, to), y = y_->enclose(from, to);
      at->second = {Interval(x.lower, x.upper), Interval(y.lower, y.upper)};
    }
    return at->second;
  }

  std::unique_ptr<Trace> x_, y_;
  std::vector<double> breaks_;
  mutable std::map<std::tuple<std::size_t, int, long>, Box> known_;
};

/// The arm and the profile of one design.
class Sight {
 public:
  Sight(PointTrace contact, PointTrace centre, double pivot, double turn)
      : contact_(std::move(contact)), centre_(std::move(centre)), pivot_(pivot), turn_(turn) {}

  /// The least that samples lead to, or the depth of an arm that meets the profile; not a number
  /// where the machine is not possible.
  Meeting least() const {
    constexpr double kNone = 1e-7;  // mm: what the steps leave where the two meet
    const Meeting beside = least(false);
    if (!(beside.gap < kNone)) return beside;
    Meeting through = least(true);
    if (!(through.gap < beside.gap)) return beside;
    through.is_through = true;
    return through;
  }

  /// No arm comes nearer, by enclosures of parts of the two cycles, of what was found above 0. At
  /// most `enough` below that, unless it takes too long.
  double proved(double found, double enough) const {
    struct Part {
      double from, to, apart_from, apart_to, least;  ///< of the arm's angle; less that touched
      bool operator<(const Part& other) const { return least > other.least; }
    };
    constexpr int kMostParts = 150000;
    std::priority_queue<Part> parts;
    double done = optim::kInfinity;  // of what needs no further look
    int looked = 0;
    const auto look = [&](double from, double to, double apart_from, double apart_to) {
      const double least = bound(from, to, apart_from, apart_to);
      ++looked;
      if (std::isnan(least)) {  // there is no enclosure
        done = -optim::kInfinity;
      } else if (least >= found - enough) {
        done = std::min(done, least);
      } else {
        parts.push({from, to, apart_from, apart_to, least});
      }
    };
    const std::vector<double>& breaks = centre_.breaks();
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      for (int k = 0; k < 16; ++k) {
        look(breaks[i], breaks[i + 1], kTurn * k / 16, kTurn * (k + 1) / 16);
      }
    }
    while (!parts.empty() && looked < kMostParts && done > -optim::kInfinity) {
      const Part part = parts.top();
      parts.pop();
      const double middle = (part.from + part.to) / 2,
                   apart = (part.apart_from + part.apart_to) / 2;
      if (splits_arm(part.from, part.to, part.apart_from, part.apart_to)) {
        look(part.from, middle, part.apart_from, part.apart_to);
        look(middle, part.to, part.apart_from, part.apart_to);
      } else {
        look(part.from, part.to, part.apart_from, apart);
        look(part.from, part.to, apart, part.apart_to);
      }
    }
    // Of a distance 0 is the least there is, and says nothing of a depth.
    const double least = std::min({done, parts.empty() ? found : parts.top().least, found});
    return least > 0 ? least : -optim::kInfinity;
  }

 private:
  Meeting least(bool depths) const {
    constexpr int kSamples = 180;
    constexpr std::size_t kStarts = 4;
    const std::vector<Meeting> all = nearest_samples(kSamples, depths);
    std::vector<Meeting> starts;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (std::isnan(all[i].gap)) return {};
      const Meeting& before = all[(i + all.size() - 1) % all.size()];
      const Meeting& after = all[(i + 1) % all.size()];
      if (all[i].gap <= before.gap && all[i].gap <= after.gap) starts.push_back(all[i]);
    }
    std::stable_sort(starts.begin(), starts.end(),
                     [](const Meeting& x, const Meeting& y) { return x.gap < y.gap; });
    starts.resize(std::min(starts.size(), kStarts));
    Meeting least = starts.front();
    for (const Meeting& start : starts) {
      const Meeting found = descended(start, kTurn / kSamples, depths);
      if (found.gap < least.gap) least = found;
    }
    return least;
  }

  /// For evenly spread places of the arm the nearest of as many points of the profile.
  std::vector<Meeting> nearest_samples(int count, bool depths) const {
    const auto angle = [count](int i) { return kTurn * (i + 0.5) / count; };
    std::vector<std::array<double, 2>> touched, turns;
    for (int i = 0; i < count; ++i) {
      touched.push_back(contact_.at(angle(i)));
      const double turned = turn_ * kDegree * kTurn * i / count;
      turns.push_back({std::cos(turned), std::sin(turned)});
    }
    std::vector<Meeting> result;
    for (int i = 0; i < count; ++i) {
      const std::array<double, 2> arm = centre_.at(angle(i));
      Meeting best{angle(i), angle(i), std::nan("")};
      for (int k = 0; k < count; ++k) {
        const auto [x, y] = touched[static_cast<std::size_t>(k)];
        const auto [c, s] = turns[static_cast<std::size_t>((i - k + count) % count)];
        const double gap =
            distance_from_arm(x * c - y * s, x * s + y * c, arm[0], arm[1], pivot_, depths);
        if (!(gap >= best.gap)) best = {angle(i), angle(k), gap};
        if (std::isnan(gap)) break;
      }
      result.push_back(best);
    }
    return result;
  }
  double gap_at(const std::array<double, 2>& touched, const std::array<double, 2>& centre,
                double arm_at, double touched_at, bool depths) const {
    const std::array<double, kNumbers> z{touched[0], touched[1], centre[0], centre[1],
                                         pivot_,     arm_at,     touched_at};
    return Gap{turn_, depths}(std::span<const double>(z));
  }
  /// By steps along both angles and both diagonals, halved where none leads lower.
  Meeting descended(Meeting here, double step, bool depths) const {
    constexpr double kLeast = 1e-8;
    constexpr std::array<std::array<int, 2>, 8> kWays{
        {{1, 1}, {-1, -1}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}}};
    while (step > kLeast) {
      bool lower = false;
      for (const auto& way : kWays) {
        const double arm_at = whole_turn(here.arm_at + step * way[0]);
        const double touched_at = whole_turn(here.touched_at + step * way[1]);
        const double gap =
            gap_at(contact_.at(touched_at), centre_.at(arm_at), arm_at, touched_at, depths);
        if (!(gap < here.gap)) continue;
        here = {arm_at, touched_at, gap};
        lower = true;
        break;
      }
      if (!lower) step /= 2;
    }
    return here;
  }
  /// How much the middle of a part may be off by, from the arm's angle and from the other one.
  struct Reach {
    Disc touched, centre;
    double turned;  ///< by half the range of the angle between them
  };
  Reach reach(double from, double to, double apart_from, double apart_to) const {
    const Disc touched = contact_.disc(from - apart_to, to - apart_from);
    const double far = std::hypot(touched.x, touched.y) + touched.radius;
    return {touched, centre_.disc(from, to), far * (apart_to - apart_from) / 2 * kDegree};
  }
  bool splits_arm(double from, double to, double apart_from, double apart_to) const {
    const Reach r = reach(from, to, apart_from, apart_to);
    const double share = (to - from) / ((to - from) + (apart_to - apart_from));
    return r.centre.radius + share * r.touched.radius > r.turned + (1 - share) * r.touched.radius;
  }
  /// What no pair of these angles comes below: the distance of the middles, less how far each may
  /// be from its middle, and a little for rounding.
  double bound(double from, double to, double apart_from, double apart_to) const {
    const Reach r = reach(from, to, apart_from, apart_to);
    const double apart = (apart_from + apart_to) / 2;
    const double middle =
        gap_at({r.touched.x, r.touched.y}, {r.centre.x, r.centre.y}, apart, 0, false);
    return middle - (r.touched.radius + r.centre.radius + r.turned) -
           1e-12 * (middle + r.touched.radius + pivot_);
  }

  PointTrace contact_, centre_;
  double pivot_;
  double turn_;
};

/// Second derivatives by the two angles. A place moves in the directions in which the clearance
/// bends; where it is level, as while both rest, it may stay.
class Level {
 public:
  explicit Level(const Eigen::Matrix2d& bends) : solver_(bends) {}

  Eigen::Vector2d solved(const Eigen::Vector2d& right) const {
    Eigen::Vector2d result = Eigen::Vector2d::Zero();
    for (Eigen::Index k = 0; k < 2; ++k) {
      const double bend = solver_.eigenvalues()[k];
      const auto way = solver_.eigenvectors().col(k);
      if (bend > 1e-9 * solver_.eigenvalues()[1]) result += way * (way.dot(right) / bend);
    }
    return result;
  }

 private:
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver_;
};

class ClearanceKernel final : public optim::Kernel {
 public:
  ClearanceKernel(const ArmAndProfile& of, const Binding& binding)
      : beside_(detail::kernel_of(Gap{of.turn, false})),
        through_(detail::kernel_of(Gap{of.turn, true})),
        turn_(of.turn) {
    const MechanismResponse* const seen[] = {&of.contact_x, &of.contact_y, &of.centre_x,
                                             &of.centre_y};
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      curves_[k] = seen[k]->curve(binding, optim::Shape::General);
    }
    const auto& varying = binding.parameters;
    const auto at = std::find(varying.begin(), varying.end(), of.pivot_distance);
    pivot_ = binding.constants[of.pivot_distance];
    if (at != varying.end()) {
      pivot_variable_ = binding.variables[static_cast<std::size_t>(at - varying.begin())];
    }
  }

  double value(std::span<const double> u) const override { return sight(u).least().gap; }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    std::vector<double> unused(packed_size(u.size()));
    return hessian(u, g, unused);
  }
  /// The places move with the design, as that of a peak does: f_uu - f_uq f_qq^-1 f_qu.
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override;
  bool is_searched() const override { return true; }
  Bounds enclose(std::span<const double> u) const override {
    constexpr double kShare = 2e-3, kLeast = 1e-3;  // of the clearance; mm
    const Sight here = sight(u);
    const double found = here.least().gap;
    if (std::isnan(found)) return {};
    const double enough = std::max(kLeast, kShare * found);
    if (found <= enough) return {-optim::kInfinity, found};  // how deep it is no part tells
    return {here.proved(found, enough), found * (1 + 1e-12)};
  }

 private:
  /// By the design, then by the angles of the arm and of the point touched.
  struct Derivatives {
    Eigen::VectorXd first;
    Eigen::MatrixXd second;
  };
  using Places = std::array<HeldPlace, 2>;  // of the arm and of the point touched
  Derivatives derived(std::span<const double> u, const Places& at, bool is_through) const;

  double pivot(std::span<const double> u) const {
    return pivot_variable_ ? u[*pivot_variable_] : pivot_;
  }
  Sight sight(std::span<const double> u) const {
    return {PointTrace(curves_[ContactX]->trace(u), curves_[ContactY]->trace(u)),
            PointTrace(curves_[CentreX]->trace(u), curves_[CentreY]->trace(u)), pivot(u), turn_};
  }

  std::array<std::shared_ptr<const Curve>, 4> curves_;
  std::shared_ptr<const optim::Kernel> beside_, through_;
  double turn_;
  double pivot_ = 0;
  std::optional<std::size_t> pivot_variable_;
};

ClearanceKernel::Derivatives ClearanceKernel::derived(std::span<const double> u, const Places& at,
                                                      bool is_through) const {
  const auto n = static_cast<Eigen::Index>(u.size());
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(kNumbers, n + 2);
  std::array<Eigen::MatrixXd, 4> bends;
  std::array<double, kNumbers> z{0, 0, 0, 0, pivot(u), at[0].place.angle, at[1].place.angle};
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const bool touched = k < CentreX;
    const Eigen::Index own = n + (touched ? 1 : 0), row = static_cast<Eigen::Index>(k);
    const Place place = at[touched ? 1 : 0].place;
    const std::array<double, 3> along = curves_[k]->trace(u)->at(place);
    const Function f = curves_[k]->at(curves_[k]->tied(place, u));
    const std::vector<std::size_t>& inputs = f.inputs();
    std::vector<double> slope(inputs.size()), second(packed_size(inputs.size()));
    f.hessian(u, slope, second);
    const std::vector<double> moved = curves_[k]->slope_gradient(place, u);
    Eigen::MatrixXd& bend = bends[k] = Eigen::MatrixXd::Zero(n + 2, n + 2);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const auto a = static_cast<Eigen::Index>(inputs[i]);
      slopes(row, a) = slope[i];
      for (std::size_t j = 0; j <= i; ++j) {
        const auto b = static_cast<Eigen::Index>(inputs[j]);
        bend(a, b) = bend(b, a) = second[packed(i, j)];
      }
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      bend(i, own) = bend(own, i) =
          moved.empty() ? std::nan("") : moved[static_cast<std::size_t>(i)];
    }
    slopes(row, own) = along[1];
    bend(own, own) = along[2];
    z[k] = along[0];
  }
  if (pivot_variable_) slopes(Pivot, static_cast<Eigen::Index>(*pivot_variable_)) = 1;
  slopes(ArmAt, n) = 1;
  slopes(TouchedAt, n + 1) = 1;
  std::vector<double> own(kNumbers), second(packed_size(kNumbers));
  (is_through ? through_ : beside_)->hessian(z, own, second);
  Eigen::MatrixXd outer(kNumbers, kNumbers);
  for (std::size_t i = 0; i < kNumbers; ++i) {
    for (std::size_t k = 0; k < kNumbers; ++k) {
      outer(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          second[packed(std::max(i, k), std::min(i, k))];
    }
  }
  Derivatives result;
  result.second = slopes.transpose() * outer * slopes;
  for (std::size_t k = 0; k < curves_.size(); ++k) result.second += own[k] * bends[k];
  result.first = slopes.transpose() * Eigen::Map<const Eigen::VectorXd>(own.data(), kNumbers);
  return result;
}

double ClearanceKernel::hessian(std::span<const double> u, std::span<double> g,
                                std::span<double> h) const {
  constexpr int kSteps = 3;
  constexpr double kNear = 1e-2;  // deg: farther no step of Newton's is meant to lead
  const auto n = static_cast<Eigen::Index>(u.size());
  const Meeting found = sight(u).least();
  if (std::isnan(found.gap)) {
    std::fill(g.begin(), g.end(), found.gap);
    std::fill(h.begin(), h.end(), found.gap);
    return found.gap;
  }
  Places at{held_place(found.arm_at, curves_[CentreX]->trace(u)->breaks()),
            held_place(found.touched_at, curves_[ContactX]->trace(u)->breaks())};
  const auto level = [&](const Derivatives& d) {
    Eigen::Matrix2d bends = d.second.bottomRightCorner<2, 2>();
    for (Eigen::Index k = 0; k < 2; ++k) {
      if (!at[static_cast<std::size_t>(k)].is_held) continue;
      bends.row(k).setZero();
      bends.col(k).setZero();
    }
    return Level(bends);
  };
  Derivatives d = derived(u, at, found.is_through);
  for (int step = 0; step < kSteps; ++step) {
    const Eigen::Vector2d by = level(d).solved(d.first.tail<2>());
    if (!(by.norm() < kNear)) break;
    for (std::size_t k = 0; k < 2; ++k) {
      Place& place = at[k].place;
      if (!at[k].is_held) place.angle = whole_turn(place.angle - by[static_cast<Eigen::Index>(k)]);
    }
    d = derived(u, at, found.is_through);
  }
  const Level places = level(d);
  Eigen::MatrixXd reduced = d.second.topLeftCorner(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d moved = places.solved(d.second.row(i).tail<2>().transpose());
    reduced.row(i) -= (d.second.topRightCorner(n, 2) * moved).transpose();
  }
  for (std::size_t i = 0; i < u.size(); ++i) {
    const auto a = static_cast<Eigen::Index>(i);
    g[i] = d.first[a];
    for (std::size_t k = 0; k <= i; ++k) {
      h[packed(i, k)] = reduced(a, static_cast<Eigen::Index>(k));
    }
  }
  return found.gap;
}

/// One list of parameters and another, increasing.
std::vector<std::size_t> united(const std::vector<std::size_t>& a,
                                const std::vector<std::size_t>& b) {
  std::vector<std::size_t> result;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

}  // namespace

MechanismResponse arm_clearance(MechanismResponse response, ArmAndProfile of) {
  response.sees_law = true;
  response.uses = {of.pivot_distance};
  for (const auto* curve : {&of.contact_x, &of.contact_y, &of.centre_x, &of.centre_y}) {
    response.uses = united(response.uses, curve->uses);
  }
  response.number = [of](const Binding& binding, optim::Shape shape) {
    std::vector<std::size_t> all(design_size(binding));
    std::iota(all.begin(), all.end(), std::size_t{0});
    return Function(std::move(all), std::make_shared<ClearanceKernel>(of, binding), shape);
  };
  return response;
}

}  // namespace camlaw::problems
