// SPDX-License-Identifier: MIT
#include <malloc.h>

#include <catch2/catch.hpp>
#include <limits>
#include <numbers>
#include <random>
#include <set>

#include "machines/registry.h"
#include "machines/spine_cutter.h"
#include "numerics/text/units.h"
#include "problems/published/spine_cutter/study.h"
#include "tests/machines/mechanism_fixture.h"
#include "tests/plain.h"

namespace camlaw::problems::mechanism_test {
namespace {

using testing::plain;

using Catch::Matchers::Contains;
using optim::Part, optim::Shape;
using testing::design_of, testing::response_of, testing::TestDesign, testing::with_dwells;

const Mechanism& cutter() { return find_mechanism("spine-cutter"); }
const Mechanism& law_alone() { return find_mechanism("law"); }

std::vector<std::string> parameter_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const auto& parameter : mechanism.parameters) names.push_back(parameter.name);
  return names;
}

/// A response's function of the design; of a curve, at some place.
optim::Function function_at(const optim::Response& response, double angle) {
  return response.is_curve() ? response.curve().at({angle}) : response.function();
}

/// Whether a response is one of a program's dwells, which no law alone has.
bool of_dwells(const Mechanism& mechanism, const MechanismResponse& response) {
  return mechanism.moved_by == MovedBy::Program &&
         (response.name == "residual_amplitude" || response.name == "elastic_loss_speed");
}

}  // namespace

TEST_CASE("mechanisms, parameters and responses are found by name", "[mechanism]") {
  CHECK(cutter().parameter("stroke") == cutter().parameter("S_f"));
  CHECK(cutter().parameter("V") != cutter().parameter("v"));
  CHECK_THROWS_WITH(find_mechanism("spine-cuter"), Contains("spine-cuter") &&
                                                       Contains("did you mean spine-cutter") &&
                                                       Contains("law"));
  CHECK_THROWS_WITH(cutter().parameter("strok"), Contains("'strok'") && Contains("stroke (S_f)"));
  std::set<std::string> names;
  for (const Mechanism& mechanism : mechanisms()) {
    CHECK(names.insert(mechanism.name).second);
    const std::string earlier{earlier_name(mechanism)};
    CHECK((earlier.empty() || names.insert(earlier).second));
    CHECK(&find_mechanism(mechanism.name) == &mechanism);
  }
}

TEST_CASE("every name of a mechanism is its own and leads somewhere", "[mechanism]") {
  for (const Mechanism& mechanism : mechanisms()) {
    std::set<std::string> names;
    for (const auto& p : mechanism.parameters) {
      CHECK(names.insert(p.name).second);
      CHECK(names.insert(p.symbol).second);
      CHECK((p.low <= p.default_value && p.default_value <= p.high));
      CHECK_NOTHROW(convert_unit(p.default_value, p.unit, p.stored));
    }
    for (const auto& response : mechanism.responses) {
      INFO(response.name);
      CHECK(names.insert(response.name).second);
      CHECK(bool(response.number) != bool(response.curve));
      CHECK(response.along.empty() == !response.curve);
      for (const auto& statement : response.shapes) {
        for (const auto& name : statement.varying) {
          if (name != "law") CHECK_NOTHROW(mechanism.parameter(name));
        }
      }
    }
    for (const auto& peak : mechanism.peaks) {
      CHECK(names.insert(peak.name).second);
      CHECK(find_response(mechanism, peak.name).response->curve);
    }
  }
}

TEST_CASE("a response is asked for by its name, a peak's, a part of a curve, or a parameter",
          "[mechanism]") {
  const auto is = [](const char* asked, const char* name, Part part) {
    const ResponseName found = find_response(cutter(), asked);
    REQUIRE(found.response != nullptr);
    return found.response->name == name && found.part == part && found.name == asked &&
           found.unit == found.response->unit;
  };
  CHECK(is("blades_in_contact", "blades_in_contact", Part::Value));
  CHECK(is("inertia_force", "inertia_force", Part::Value));
  CHECK(is("peak_inertia_force", "inertia_force", Part::Magnitude));
  CHECK(is("minimum_cam_radius", "required_cam_radius", Part::Magnitude));
  CHECK(is("peak drive_torque", "drive_torque", Part::Magnitude));
  CHECK(is("highest drive_torque", "drive_torque", Part::Highest));
  CHECK(is("lowest  drive_torque", "drive_torque", Part::Lowest));
  for (const char* name : {"stroke", "S_f"}) {
    const ResponseName stroke = find_response(cutter(), name);
    CHECK(stroke.response == nullptr);
    CHECK(stroke.parameter == cutter().parameter("stroke"));
    CHECK(stroke.unit == "mm");
    CHECK(stroke.name == "stroke");
  }
  CHECK(find_response(law_alone(), "C_Mdyn").response->name == "moment");
}

TEST_CASE("a bad response is refused with what there is", "[mechanism]") {
  const auto says = [](const char* asked, const auto& what) {
    CHECK_THROWS_AS(find_response(cutter(), asked), std::invalid_argument);
    CHECK_THROWS_WITH(find_response(cutter(), asked), what);
  };
  says("inertia_forse", Contains("spine-cutter") && Contains("did you mean inertia_force") &&
                            Contains("camlaw evaluate") && !Contains("; use "));
  says("", Contains("camlaw evaluate") && !Contains("; use "));
  says("peak force", Contains("no curve") && Contains("'force'") && Contains("inertia_force"));
  says("peak blades_in_contact", Contains("blades_in_contact is a number"));
  says("highest ", Contains("highest"));
  says("lowest stroke", Contains("no curve 'stroke'") || Contains("'stroke'"));
}

TEST_CASE("numbers are the formulas in listed units", "[mechanism]") {
  const TestDesign design = design_of(cutter(), "cosine", {}, parameter_names(cutter()));
  const testing::PlainNumbers numbers;
  const SpineCutter m;
  const double degree = std::numbers::pi / 180;
  const auto value = [&](const char* name) {
    return response_of(cutter(), name, design.binding).function().value(design.x);
  };
  CHECK(value("chord_of_contact") == Approx(plain(m.chord_of_contact()) * 1e3).epsilon(1e-14));
  CHECK(value("contact_angle") == Approx(plain(m.contact_angle()) / degree).epsilon(1e-14));
  CHECK(value("blades_in_contact") == Approx(plain(m.blades_in_contact())).epsilon(1e-14));
  CHECK(value("path_per_revolution") ==
        Approx(plain(m.path_per_revolution()) * 1e3).epsilon(1e-14));
  CHECK(value("angular_velocity") == Approx(plain(m.angular_velocity())).epsilon(1e-14));
}

TEST_CASE("numbers have exact derivatives and enclosures that hold", "[mechanism]") {
  for (const auto& response : cutter().responses) {
    if (!response.number) continue;
    INFO(response.name);
    const TestDesign design = design_of(cutter(), "scca", {"a"}, parameter_names(cutter()));
    const auto function = response_of(cutter(), response.name, design.binding).function();
    testing::check_derivatives(function, design.x, 1e-2);
    const auto bounds = function.enclose(design.x);
    const double value = function.value(design.x);
    CHECK((bounds.lower <= value && value <= bounds.upper));
    CHECK(bounds.upper - bounds.lower <= 1e-13 * std::abs(value));
    CHECK(function.inputs().size() == response.uses.indices().size());
  }
}

TEST_CASE("mechanisms are found by the names that they have", "[mechanism]") {
  for (const Mechanism& mechanism : mechanisms()) {
    CHECK(&find_mechanism(mechanism.name) == &mechanism);
  }
  for (const auto& [earlier, name] : {std::pair{"disc-cam-knife", "disc-cam-knife-edge"},
                                      {"disc-cam-swinging-roller", "disc-cam-oscillating-roller"},
                                      {"disc-cam-swinging-flat", "disc-cam-oscillating-flat"},
                                      {"end-cam-swinging", "end-cam-oscillating"}}) {
    CHECK(find_mechanism(earlier).name == name);
    CHECK(earlier_name(find_mechanism(name)) == earlier);
  }
  CHECK(known_mechanism("") == nullptr);
}

TEST_CASE("a parameter is a response too, varying or not", "[mechanism]") {
  const TestDesign design = design_of(cutter(), "cosine", {}, {"depth"});
  const auto depth = response_of(cutter(), "h", design.binding);
  CHECK(depth.name == "depth");
  CHECK(depth.unit == "mm");
  CHECK(depth.shape() == Shape::Linear);
  CHECK(depth.function().value(std::vector{0.7}) == 0.7);
  const auto blades = response_of(cutter(), "blades", design.binding);
  CHECK(blades.shape() == Shape::Linear);
  CHECK(blades.function().inputs().empty());
  CHECK(blades.function().value(design.x) == 17);
  CHECK(blades.function().enclose(design.x).upper == 17);
}

TEST_CASE("a response depends on the parameters that it says it uses, and on no others",
          "[mechanism]") {
  std::uniform_real_distribution<double> uniform(0.95, 1.05);  // what is possible stays so
  for (const Mechanism& mechanism : mechanisms()) {
    std::mt19937 random(11);
    for (const auto& response : mechanism.responses) {
      // A peak may hang on one parameter in one design and on another in the next, and of two cams
      // the one that bears changes where inertia is large, some matter at high speeds alone, and an
      // elastic follower leaves its cam where a steep spring is at rest, and its rate does not
      // count: five are tried.
      const char* const law = "poly-3-4-5";
      const Member moving = of_dwells(mechanism, response) ? with_dwells(law) : find_law(law);
      std::vector<std::vector<double>> designs(5);
      for (const auto& p : mechanism.parameters) {
        const double factor = uniform(random);
        const double large = p.default_value == 0 ? std::min(18.0, 0.3 * p.high) : p.default_value;
        designs[0].push_back(large * factor);
        designs[1].push_back(p.default_value == 0 ? 0.05 * large * factor : large * factor);
        designs[2].push_back(p.unit == "rpm" ? 30 * large * factor : large * factor);
        designs[3].push_back((p.default_value == 0 ? 0.05 * large : large) * factor *
                             (p.name == "speed" ? 10 : 1));
        designs[4].push_back(large * factor * (p.name == "spring_rate" ? 0.02 : 1));
      }
      const TestDesign design = design_of(mechanism, moving, {}, parameter_names(mechanism));
      const auto made = response_of(mechanism, response.name, design.binding);
      bool is_there = false;
      std::vector<optim::Function> functions;  // of a curve at a few places
      for (const double share : {0.07, 0.19, 0.3, 0.42, 0.6, 0.8}) {
        functions.push_back(function_at(made, response.along == "1" ? share : 360 * share));
        if (!made.is_curve()) break;
      }
      // The values, and where a curve breaks if that moves.
      const auto looked_at = [&](const std::vector<double>& parameters) {
        std::vector<double> x(parameters.size());
        for (std::size_t i = 0; i < x.size(); ++i) x[design.binding.variables[i]] = parameters[i];
        std::vector<double> result;
        for (const optim::Function& f : functions) {
          result.push_back(f.value(x));
          if (!std::isfinite(result.back())) result.back() = 0;
        }
        is_there = is_there || result != std::vector<double>(result.size(), 0.0);
        if (!made.is_curve() || !made.curve().breaks_move()) return result;
        const auto breaks = made.curve().trace(x)->breaks();
        result.insert(result.end(), breaks.begin(), breaks.end());
        return result;
      };
      std::vector<std::vector<double>> here;
      for (const std::vector<double>& parameters : designs) {
        here.push_back(looked_at(parameters));
      }
      for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
        INFO(response.name << " and " << mechanism.parameters[i].name);
        bool moves = false;
        for (std::size_t k = 0; k < designs.size() && !moves; ++k) {
          std::vector<double> moved = designs[k];
          moved[i] *= 1.01;
          moves = looked_at(moved) != here[k];
        }
        const bool uses = std::count(response.uses.begin(), response.uses.end(), i) == 1;
        // A mean by turns of a roller: on a cam that does not turn it, its radius cancels.
        const std::string& name = mechanism.parameters[i].name;
        const bool is_load =
            name == "inertia" || name == "friction_torque" || name == "load_torque";
        const bool may_cancel =
            (response.name == "life_revolutions" && name == "roller_radius") ||
            // These decide which flank bears, and which of two edges is farther out.
            (response.name.ends_with("sliding_speed") && is_load) ||
            (response.name == "outer_radius" && name == "rollers");
        CHECK((moves == uses || (uses && may_cancel)));
      }
      INFO(response.name);
      CHECK(is_there);
    }
  }
}

TEST_CASE("the form of a response is the strongest that is stated for what varies", "[mechanism]") {
  struct Case {
    const char *response, *law;
    std::vector<std::string> of_law, of_machine;
    Shape shape;
  };
  const Case cases[] = {
      {"inertia_force", "legendre", {"c"}, {}, Shape::Linear},
      {"inertia_force", "legendre", {"c"}, {"blades", "cam_radius"}, Shape::Linear},
      {"inertia_force", "legendre", {"c"}, {"stroke"}, Shape::General},
      {"inertia_force", "legendre", {"c", "crossover"}, {}, Shape::General},
      {"inertia_force", "scca", {"a"}, {}, Shape::General},
      {"inertia_force", "scca", {}, {"stroke"}, Shape::Linear},
      {"inertia_force", "scca", {}, {"block_speed", "depth"}, Shape::Quasilinear},
      {"inertia_force", "scca", {}, {}, Shape::Linear},
      {"peak_drive_torque", "legendre", {"c"}, {}, Shape::General},
      {"drive_torque", "cosine", {}, {"mass"}, Shape::Linear},
      {"cam_pressure_angle", "fourier", {"a"}, {"cam_radius"}, Shape::Quasilinear},
      {"cam_pressure_angle", "fourier", {"a"}, {"stroke"}, Shape::General},
      {"minimum_cam_radius", "polynomial-7", {"A"}, {"depth"}, Shape::Linear},
      {"blades_in_contact", "scca", {"a"}, {"blades"}, Shape::Linear},
      {"blades_in_contact", "scca", {"a"}, {"depth"}, Shape::Quasilinear},
      {"blades_in_contact", "cosine", {}, {"blades", "depth"}, Shape::Quasiconcave},
      {"chord_of_contact", "cosine", {}, {"cutter_diameter", "depth"}, Shape::Concave},
      {"angular_velocity", "cosine", {}, {"block_speed", "depth"}, Shape::Quasilinear}};
  for (const Case& c : cases) {
    INFO(c.response << " of " << c.law);
    const TestDesign design = design_of(cutter(), c.law, c.of_law, c.of_machine);
    CHECK(response_of(cutter(), c.response, design.binding).shape() == c.shape);
  }
}

namespace {

/// Whether values at two points and at their middle go with a form.
bool goes_with(Shape shape, double a, double middle, double b) {
  const double slack = 1e-9 * (std::abs(a) + std::abs(b) + 1e-9);
  const double low = std::min(a, b) - slack, high = std::max(a, b) + slack;
  switch (shape) {
    case Shape::Linear:
      return std::abs(middle - (a + b) / 2) <= slack;
    case Shape::Convex:
      return middle <= (a + b) / 2 + slack;
    case Shape::Concave:
      return middle >= (a + b) / 2 - slack;
    case Shape::Quasiconvex:
      return middle <= high;
    case Shape::Quasiconcave:
      return middle >= low;
    case Shape::Quasilinear:
      return low <= middle && middle <= high;
    case Shape::General:
      break;
  }
  return true;
}

}  // namespace

TEST_CASE("stated forms hold between pairs of designs", "[mechanism]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.3, 3);
  const char* law = "legendre c=-3,1,-0.3";
  for (const Mechanism& mechanism : mechanisms()) {
    for (const auto& response : mechanism.responses) {
      const bool in_dwells = of_dwells(mechanism, response);
      for (const auto& statement : response.shapes) {
        std::vector<std::string> of_law, of_machine;
        for (const auto& name : statement.varying) {
          if (name == "law") {
            of_law = {in_dwells ? "rise_c" : "c"};
          } else {
            of_machine.push_back(name);
          }
        }
        const Member moving = in_dwells ? with_dwells(law) : find_law(law);
        const TestDesign design = design_of(mechanism, moving, of_law, of_machine);
        const auto made = response_of(mechanism, response.name, design.binding);
        CHECK(made.shape() == statement.shape);
        for (int trial = 0; trial < 200; ++trial) {
          std::vector<double> a = design.x, b = design.x, middle = design.x;
          for (std::size_t i = 0; i < a.size(); ++i) {
            a[i] *= uniform(random);
            b[i] *= uniform(random);
            middle[i] = (a[i] + b[i]) / 2;
          }
          const double place = (response.along == "1" ? 1.0 : 360.0) * uniform(random) / 3.1;
          const auto f = function_at(made, place);
          INFO(response.name << " at " << place << ": " << f.value(a) << ", " << f.value(middle)
                             << ", " << f.value(b));
          REQUIRE(goes_with(statement.shape, f.value(a), f.value(middle), f.value(b)));
        }
      }
    }
  }
}

TEST_CASE("the study's givens are the mechanism's parameters but the cam radius", "[mechanism]") {
  const auto listed = givens(CutterGivens{});
  REQUIRE(listed.size() + 1 == cutter().parameters.size());
  for (std::size_t i = 0; i < listed.size(); ++i) {
    CHECK(listed[i].name == cutter().parameters[i].name);
    CHECK(listed[i].value == Approx(cutter().parameters[i].default_value).epsilon(1e-14));
  }
  CHECK(cutter().parameters.back().name == "cam_radius");
  CutterGivens machine;
  CHECK_THROWS_WITH(set_given(machine, "cam_radius=40 mm"), Contains("'cam_radius'"));
}

TEST_CASE("law bindings refuse what cannot vary", "[mechanism]") {
  const Member spline = find_law("b-spline");
  const auto bind = [&](LawVariable v) { return LawBinding(spline, {v}); };
  CHECK_THROWS_WITH(bind({0}), Contains("degree") && Contains("cannot vary"));
  CHECK_THROWS_WITH(bind({2, 6}), Contains("coefficients") && Contains("6"));
  CHECK_THROWS_WITH(bind({7}), Contains("b-spline"));
  CHECK_THROWS_AS(LawBinding(find_law("scca a=0.9 b=0.9"), {}), std::invalid_argument);
  CHECK_NOTHROW(bind({2, 5}));
}

TEST_CASE("motion of a binding is the law's, of a linear law beyond its range too", "[mechanism]") {
  const LawBinding linear(find_law("legendre c=-3,1"), {{0, 0, 0}, {0, 1, 1}});
  CHECK(linear.is_linear());
  const std::vector<double> values{-7, 2.5};
  CHECK(linear.values_at(values) == values);
  const Law<double> law = linear.law_at<double>(values);
  for (const int order : {0, 1, 2}) {
    const auto motion = linear.motion(0.3, Side::Right, values, order);
    CHECK(motion.value[2] == Approx(law(0.3).a).epsilon(1e-13));
    CHECK(motion.gradient.size() == (order == 0 ? 0 : 2));
    CHECK(motion.hessian.empty());
  }
  const std::vector<double> beyond{-2000, 0};
  CHECK(std::isfinite(linear.motion(0.3, Side::Right, beyond, 0).value[2]));
  CHECK_THROWS_AS(linear.law_at<double>(beyond), std::invalid_argument);
}

namespace {

/// Bytes that were taken from the heap and not given back. 0 where a sanitizer has its own.
double heap() {
  const auto taken = mallinfo2();
  return static_cast<double>(taken.uordblks) + static_cast<double>(taken.hblkhd);
}

/// What twelve designs leave in the heap, as a part of what the binding says of it.
double heap_over_memory(int knots) {
  std::string text = "b-spline degree=3 knots=";
  std::vector<LawVariable> variables;
  std::vector<double> values;
  for (int i = 1; i <= knots; ++i) {
    values.push_back(static_cast<double>(i) / (knots + 1));
    text += (i > 1 ? "," : "") + std::to_string(values.back());
    variables.push_back({1, static_cast<std::size_t>(i - 1), variables.size()});
  }
  text += " coefficients=0";
  for (int i = 1; i < knots + 4; ++i) text += i < (knots + 4) / 2 ? ",0" : ",1";
  const LawBinding binding(find_law(text), variables);
  const double before = heap();
  REQUIRE(before > 0);  // else a sanitizer has its own
  for (int design = 0; design < 12; ++design) {
    values[0] *= 0.99;
    REQUIRE(std::isfinite(binding.motion(0.3, Side::Right, values, 2).value[2]));
  }
  return (heap() - before) / binding.memory();
}

}  // namespace

TEST_CASE(
    "the memory of a law's second derivatives is what it says, of few designs where it is much",
    "[mechanism][heavy]") {
  CHECK(heap_over_memory(12) == Approx(1).epsilon(0.3));
  CHECK(heap_over_memory(100) == Approx(1).epsilon(0.2));
  std::vector<LawVariable> coefficient{{2, 5}};
  CHECK(LawBinding(find_law("b-spline"), coefficient).memory() == 0);
}

}  // namespace camlaw::problems::mechanism_test
