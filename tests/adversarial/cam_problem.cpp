// SPDX-License-Identifier: MIT
#include "tests/adversarial/cam_problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/adversarial/judge.h"
#include "tests/adversarial/statement_text.h"

namespace camlaw::adversary {
namespace {

using std::numbers::pi;
using Kind = Formula::Kind;
constexpr double kDegree = pi / 180;

/// Millimetres and their derivatives by the cam's angle in radians; theory (M1).
struct Lift {
  double s, ds, dds;
};
Lift lift(const Point& m, const Motion& f) {
  return {m[0] * f.s, m[0] * f.v / (2 * pi), m[0] * f.a / (4 * pi * pi)};
}
double omega(double rpm) { return rpm * pi / 30; }

// Where each machine keeps what all followers have: stroke, base radius, speed, mass, spring rate,
// preload, load.
enum : std::size_t { kH, kBase, kSpeed, kMass, kRate, kPreload, kLoad, kRoller, kOffset, kWidth };

/// (M2), N.
double force(const Point& m, const Motion& f) {
  const Lift l = lift(m, f);
  const double w = omega(m[kSpeed]);
  return m[kMass] * w * w * l.dds / 1000 + m[kRate] * l.s + m[kPreload] + m[kLoad];
}

std::vector<Formula> follower_formulas() {
  return {{"displacement", Kind::Displacement,
           [](const Point& m, const Motion& f) { return lift(m, f).s; }},
          {"velocity", Kind::Velocity,
           [](const Point& m, const Motion& f) { return omega(m[kSpeed]) * lift(m, f).ds / 1000; }},
          {"acceleration", Kind::Curve,
           [](const Point& m, const Motion& f) {
             const double w = omega(m[kSpeed]);
             return w * w * lift(m, f).dds / 1000;
           }},
          {"follower_force", Kind::Curve, force},
          {"base_radius", Kind::Number, [](const Point& m, const Motion&) { return m[kBase]; }},
          {"speed", Kind::Number, [](const Point& m, const Motion&) { return m[kSpeed]; }}};
}

/// (M4) of the pitch curve (M5), 1/mm.
double pitch_curvature(const Point& m, const Motion& f) {
  const Lift l = lift(m, f);
  const double e = m[kOffset], prime = m[kBase] + m[kRoller];
  const double y = std::sqrt(prime * prime - e * e) + l.s, across = l.ds - e;
  const double length = std::hypot(y, across);
  return (across * (l.ds + across) - y * (l.dds - y)) / (length * length * length);
}

double slope_less(const Point& m, const Motion& f, double sign, double bound) {
  const Lift l = lift(m, f);
  const double e = m[kOffset], prime = m[kBase] + m[kRoller];
  const double y = std::sqrt(prime * prime - e * e) + l.s;
  return sign * (l.ds - e - std::tan(bound * kDegree) * y);
}

}  // namespace

SegmentLaw random_segment_law(Random& random, bool varying) {
  if (varying) {
    if (random.chance(0.5)) {
      return {"polynomial-7", "A", polynomial_7, {2, 2}, -20, 80, -100, 200, 48};
    }
    return {"polynomial-5", "alpha", polynomial_5, {1, 1}, -15, 10, -30, 30, -3};
  }
  switch (random.below(6)) {
    case 0:
      return {"cosine", "", [](double) { return cosine(); }, {1, 1}};
    case 1:
      return {"cycloidal", "", [](double) { return fourier({}); }};
    case 2:
      return {"poly-3-4-5", "", [](double) { return rest_polynomial(2); }};
    case 3:
      return {"poly-4-5-6-7", "", [](double) { return rest_polynomial(3); }, {3, 3}};
    case 4:
      return {"parabolic", "", [](double) { return parabolic(); }, {1, 1}};
    default:
      return {"cubic", "", [](double) { return rest_polynomial(1); }, {1, 1}};
  }
}

double& Machine::number(const std::string& wanted) {
  for (auto& [own, value] : numbers) {
    if (own == wanted) return value;
  }
  throw std::logic_error("no number " + wanted);
}

Machine roller_cam() {
  Machine m;
  m.name = "disc-cam-roller";
  m.numbers = {{"stroke", 20},     {"base_radius", 40},    {"speed", 300}, {"mass", 1},
               {"spring_rate", 5}, {"spring_preload", 50}, {"load", 0},    {"roller_radius", 10},
               {"offset", 0},      {"face_width", 15}};
  m.formulas = follower_formulas();
  m.formulas.push_back({"pressure_angle", Kind::Curve,
                        [](const Point& p, const Motion& f) {
                          const Lift l = lift(p, f);
                          const double e = p[kOffset], prime = p[kBase] + p[kRoller];
                          return std::atan((l.ds - e) / (std::sqrt(prime * prime - e * e) + l.s)) /
                                 kDegree;
                        },
                        slope_less});
  m.formulas.push_back({"undercut", Kind::Curve, [](const Point& p, const Motion& f) {
                          return p[kRoller] * pitch_curvature(p, f);
                        }});
  m.formulas.push_back({"contact_stress", Kind::Curve, [](const Point& p, const Motion& f) {
                          const Lift l = lift(p, f);
                          const double e = p[kOffset], prime = p[kBase] + p[kRoller];
                          const double slope =
                              (l.ds - e) / (std::sqrt(prime * prime - e * e) + l.s);
                          const double normal = force(p, f) * std::hypot(1, slope);
                          const double sum =
                              1 / (p[kRoller] * (1 - p[kRoller] * pitch_curvature(p, f)));
                          const double elastic = 210e3 / (1 - 0.09);  // MPa; (K1), (K2)
                          return sum > 0 ? std::sqrt(normal / p[kWidth] * sum * elastic / (2 * pi))
                                         : std::numeric_limits<double>::quiet_NaN();
                        }});
  m.possible = [](const Point& p) { return std::abs(p[kOffset]) < p[kBase] + p[kRoller]; };
  return m;
}

Machine flat_cam() {
  Machine m;
  m.name = "disc-cam-flat";
  m.numbers = {{"stroke", 20},     {"base_radius", 40},    {"speed", 300}, {"mass", 1},
               {"spring_rate", 5}, {"spring_preload", 50}, {"load", 0}};
  m.formulas = follower_formulas();
  m.formulas.push_back({"contact_offset", Kind::Curve,
                        [](const Point& p, const Motion& f) { return lift(p, f).ds; }});
  m.formulas.push_back({"profile_radius", Kind::Curve, [](const Point& p, const Motion& f) {
                          const Lift l = lift(p, f);
                          return p[kBase] + l.s + l.dds;
                        }});
  return m;
}

Machine spine_cutter() {
  enum : std::size_t { kStroke_, kDiameter, kBlockSpeed, kDepth, kMoved, kPermitted, kRadius };
  Machine m;
  m.name = "spine-cutter";
  m.numbers = {{"stroke", 40}, {"cutter_diameter", 50}, {"block_speed", 0.3}, {"depth", 0.4},
               {"mass", 2.4},  {"pressure_angle", 30},  {"cam_radius", 35}};
  m.cycle_of_two = true;
  // Over half a turn v and a are those of the law: (S1), (S5), (S6).
  m.formulas = {
      {"displacement", Kind::Displacement,
       [](const Point& p, const Motion& f) { return p[0] * f.s; }},
      {"cam_pressure_angle", Kind::Curve,
       [](const Point& p, const Motion& f) {
         return std::atan(p[0] * (f.v / 2) / (pi * p[kRadius])) / kDegree;
       },
       [](const Point& p, const Motion& f, double sign, double bound) {
         return sign * (p[0] * (f.v / 2) - pi * p[kRadius] * std::tan(bound * kDegree));
       }},
      {"required_cam_radius", Kind::Curve,
       [](const Point& p, const Motion& f) {
         return p[0] * (f.v / 2) / (pi * std::tan(p[kPermitted] * kDegree));
       }},
      {"inertia_force", Kind::Curve,
       [](const Point& p, const Motion& f) {
         const double time = pi * (p[kDiameter] - 2 * p[kDepth]) / 1000 / (2 * p[kBlockSpeed]);
         return p[kMoved] * (f.a / 4) * p[0] / 1000 / (time * time);
       }},
      {"cam_radius", Kind::Number, [](const Point& p, const Motion&) { return p[kRadius]; }}};
  return m;
}

CamProblem::CamProblem(const std::string& kind, Machine machine, Program program)
    : kind_(kind), machine_(std::move(machine)), program_(std::move(program)) {}

void CamProblem::vary(const std::string& name, double lower, double upper, double low,
                      double high) {
  variables_.push_back({name, lower, upper, low, high});
}

int CamProblem::index(const std::string& response) const {
  for (std::size_t i = 0; i < machine_.formulas.size(); ++i) {
    if (machine_.formulas[i].name == response) return static_cast<int>(i);
  }
  throw std::logic_error("no response " + response);
}

void CamProblem::seek(const std::string& response, Part part, bool least) {
  plain_.objective = index(response);
  plain_.part = part;
  plain_.sense = least ? 1 : -1;
  const char* what = part == Part::Magnitude ? "peak "
                     : part == Part::Highest ? "highest "
                     : part == Part::Lowest  ? "lowest "
                                             : "";
  objective_ = objective_text(what + response, least);
}

void CamProblem::limit(const std::string& response, std::optional<double> lower,
                       std::optional<double> upper) {
  plain_.limits.push_back({index(response), lower, upper});
  limits_ += fmt::format("[[constraints]]\nresponse = \"{}\"\n", response);
  if (lower) limits_ += "lower = " + digits(*lower) + "\n";
  if (upper) limits_ += "upper = " + digits(*upper) + "\n";
}

PlainProblem CamProblem::plain() const {
  auto model = std::make_shared<CycleModel>();
  const auto place = [this](const std::string& name) {
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      if (variables_[i].name == name) return static_cast<int>(i);
    }
    return -1;
  };
  std::vector<double> numbers;
  std::vector<int> places;
  for (const auto& [name, value] : machine_.numbers) {
    numbers.push_back(value);
    places.push_back(place(name));
  }
  model->machine = [numbers, places](const Point& x) {
    Point m = numbers;
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (places[i] >= 0) m[i] = x[static_cast<std::size_t>(places[i])];
    }
    return m;
  };
  const bool two = machine_.cycle_of_two;
  const auto own = [](const Point& x, int at, double standard) {
    return at >= 0 ? x[static_cast<std::size_t>(at)] : standard;
  };
  const int rise = place(two ? program_.rise.parameter : "rise_" + program_.rise.parameter);
  const int back = place("return_" + program_.back.parameter), angle = place("rise_angle");
  model->cycle = [=, program = program_](const Point& x) {
    const auto made = [&](const SegmentLaw& law, int at) {
      return law.make(own(x, at, law.standard));
    };
    const LawPtr up = program.file_law ? program.file_law : made(program.rise, rise);
    if (two) {
      return std::vector<Segment>{{0.5, 0, 1, up, program.rise.order},
                                  {0.5, 1, 0, up, program.rise.order}};
    }
    const double first = own(x, angle, program.angles[0]) / 360;
    const double second = program.angles[1] / 360, third = program.angles[2] / 360;
    return std::vector<Segment>{{first, 0, 1, up, program.rise.order},
                                {second, 1, 1},
                                {third, 1, 0, made(program.back, back), program.back.order},
                                {1 - first - second - third, 0, 0}};
  };
  model->possible = machine_.possible;
  model->formulas = machine_.formulas;
  model->places = 360;
  model->is_affine = is_affine_;
  model->places_besides = special_;
  Point middle;
  for (const PlainVariable& v : variables_) middle.push_back((v.low + v.high) / 2);
  model->prepare(middle);
  PlainProblem result = plain_;
  result.model = model;
  result.variables = variables_;
  for (const Formula& f : machine_.formulas) result.names.push_back(f.name);
  return result;
}

double CamProblem::of(const std::string& response, Part part, const Point& x) const {
  PlainProblem asked = plain();
  asked.objective = index(response);
  asked.part = part;
  return objective_of(asked, *asked.model->look(x), grid_of(*asked.model), true);
}

Case CamProblem::made(const Point& start) const {
  Case test;
  test.kind = kind_;
  test.plain = plain();
  std::string text = fmt::format("mechanism = \"{}\"\n[constants]\n", machine_.name);
  for (const auto& [name, value] : machine_.numbers) {
    const bool varies = std::any_of(variables_.begin(), variables_.end(),
                                    [&](const PlainVariable& v) { return v.name == name; });
    if (!varies) text += name + " = " + digits(value) + "\n";
  }
  if (machine_.cycle_of_two) {
    text += "[law]\nname = \"" + program_.rise.name + "\"\n";
  } else {
    text += "[program]\nmatched = \"velocity\"\n";
    const auto segment = [&](const char* name, std::optional<double> angle,
                             const std::string& law) {
      text += fmt::format("[[program.segments]]\nname = \"{}\"\n", name);
      if (angle) text += "angle = " + digits(*angle) + "\n";
      if (!law.empty()) text += "law = \"" + law + "\"\n";
    };
    segment("rise", program_.angles[0], program_.file_law ? "spike.json" : program_.rise.name);
    segment("high", program_.angles[1], "");
    segment("return", program_.angles[2], program_.back.name);
    segment("low", {}, "");
  }
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    const PlainVariable& v = variables_[i];
    text += variable_text(v.name, v.lower, v.upper, start[i]);
  }
  test.text = text + objective_ + limits_;
  return test;
}

}  // namespace camlaw::adversary
