// SPDX-License-Identifier: MIT
#include "output/answers/law_output.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "kinematics/peaks.h"
#include "problems/law_files/pieces_json.h"
#include "tests/kinematics/reference_data.h"

namespace camlaw::cli::law_output_test {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// The law's row of the table, as a program reads it.
Json object_of(const Member& law) { return Json::parse(json_of(laws_table({law})).front().dump()); }
Json object_of(const std::string& text) { return object_of(find_law(text)); }

/// A number as the JSON has it, infinities as the issue asks.
double number_in(const Json& value) {
  if (value == "inf") return kInf;
  if (value == "-inf") return -kInf;
  return value.get<double>();
}

/// s(x) from the JSON of a law that is data: sum of c t^k and harmonics, t = x - origin.
double displacement(const Json& pieces, double x) {
  for (const Json& piece : pieces) {
    if (x > piece["end"].get<double>()) continue;
    const double t = x - piece["origin"].get<double>();
    double s = 0, power = 1;
    for (const Json& c : piece["polynomial"]) {
      s += c.get<double>() * power;
      power *= t;
    }
    for (const Json& h : piece["harmonics"]) {
      const double angle = h["frequency"].get<double>() * t;
      s += h["sine"].get<double>() * std::sin(angle) + h["cosine"].get<double>() * std::cos(angle);
    }
    return s;
  }
  return std::nan("");
}

}  // namespace

TEST_CASE("numbers that JSON has no sign for are words or null", "[json]") {
  CHECK(to_json(kInf) == Json("inf"));
  CHECK(to_json(-kInf) == Json("-inf"));
  CHECK(to_json(std::nan("")).is_null());
  CHECK(to_json(1.5) == Json(1.5));
  CHECK(to_json(std::vector<double>{1, kInf}).dump() == "[1.0,\"inf\"]");
  CHECK(to_json(std::vector<double>{}).dump() == "[]");
}

TEST_CASE("numbers keep 17 digits through text and back", "[json]") {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> mantissa(-10, 10);
  for (int i = 0; i < 2000; ++i) {
    const double x = std::ldexp(mantissa(generator), i % 200 - 100);
    REQUIRE(Json::parse(to_json(x).dump()).get<double>() == x);
  }
}

TEST_CASE("every law of the catalogue has the keys that are promised", "[json]") {
  const std::set<std::string> promised{"name",    "aliases",    "parameters", "C_v",    "C_a_max",
                                       "C_a_min", "C_j_max",    "C_j_min",    "C_Mdyn", "lambda",
                                       "ends",    "continuity", "source"};
  for (const Family& family : catalogue()) {
    INFO(family.name);
    const Json object = object_of({&family, family.defaults()});
    for (const std::string& key : promised) CHECK(object.contains(key));
    CHECK(object["name"] == family.name);
    CHECK(object["aliases"].is_array());
    CHECK(object["source"].is_string());
    CHECK((object["continuity"].is_number_integer() || object["continuity"] == "smooth"));
    CHECK((object["lambda"].is_null() || object["lambda"].is_number()));
    CHECK(object["parameters"].size() == family.parameters.size());
    for (const Json& parameter : object["parameters"]) {
      for (const char* key : {"name", "unit", "low", "high", "default", "value", "meaning"}) {
        CHECK(parameter.contains(key));
      }
      CHECK(parameter["value"] == parameter["default"]);
    }
  }
}

TEST_CASE("the constants are the peaks, to the last bit", "[json]") {
  for (const Family& family : catalogue()) {
    INFO(family.name);
    const Member member{&family, family.defaults()};
    const Json object = object_of(member);
    const Peaks<double> peak = peaks(member.law());
    CHECK(number_in(object["C_v"]) == peak.max_velocity());
    CHECK(number_in(object["C_a_max"]) == peak.high(Quantity::Acceleration).value);
    CHECK(number_in(object["C_a_min"]) == peak.low(Quantity::Acceleration).value);
    CHECK(number_in(object["C_j_max"]) == peak.high(Quantity::Jerk).value);
    CHECK(number_in(object["C_j_min"]) == peak.low(Quantity::Jerk).value);
    CHECK(number_in(object["C_Mdyn"]) == peak.max_dynamic_moment());
    const auto lambda = limit_index(peak);
    CHECK(object["lambda"].is_number() == lambda.has_value());
    if (lambda) CHECK(object["lambda"].get<double>() == *lambda);
  }
}

TEST_CASE("the reference table's laws are there under their names with its constants", "[json]") {
  for (const auto& row : testing::read_table("problems/laws/motion_laws.csv")) {
    INFO(row.at("law"));
    const Json object = object_of(row.at("law"));
    CHECK(object["name"] == row.at("law"));
    for (const char* key : {"C_v", "C_a_max", "C_a_min", "C_j_max", "C_j_min", "C_Mdyn"}) {
      const std::string& printed = row.at(key);
      if (printed.empty()) continue;
      INFO(key);
      const double expected = std::stod(printed), ours = number_in(object[key]);
      // The table writes infinities without sign, and infinite for the half-ellipse's moment, which
      // is finite: (4/pi) sqrt(1 - u^2) times (4/pi) 2 u / sqrt(1 - u^2), u = 1 - 2x.
      if (row.at("law") == "half-ellipse-velocity" && key == std::string("C_Mdyn")) {
        CHECK(ours == Approx(32 / (std::acos(-1.0) * std::acos(-1.0))).epsilon(1e-12));
      } else if (std::isinf(expected)) {
        CHECK(std::abs(ours) == std::abs(expected));
        CHECK((ours > 0) == (key != std::string("C_a_min") && key != std::string("C_j_min")));
      } else {
        // The table has at least four digits.
        CHECK(ours == Approx(expected).epsilon(1e-4));
      }
    }
  }
}

TEST_CASE("parameters come with what is set", "[json]") {
  const Json object = object_of("polynomial-5 alpha=-4.25");
  CHECK(object["name"] == "polynomial-5");
  CHECK(object["member"] == "polynomial-5 alpha=-4.25");
  CHECK(object["parameters"][0]["name"] == "alpha");
  CHECK(object["parameters"][0]["value"] == -4.25);
  CHECK(object["parameters"][0]["default"] == -3.0);
  const Json series = object_of("fourier a=0.1,-0.05");
  CHECK(series["parameters"][0]["list"] == true);
  CHECK(series["parameters"][0]["value"] == Json{0.1, -0.05});
}

TEST_CASE("known laws read as they should", "[json]") {
  const Json parabola = object_of("parabolic");  // 2 x^2 and its mirror image: a jumps from 4 to -4
  CHECK(parabola["C_v"].get<double>() == Approx(2).epsilon(1e-14));
  CHECK(parabola["C_a_max"].get<double>() == Approx(4).epsilon(1e-14));
  CHECK(parabola["C_a_min"].get<double>() == Approx(-4).epsilon(1e-14));
  CHECK(parabola["C_j_max"] == "inf");
  CHECK(parabola["C_j_min"] == "-inf");
  CHECK(parabola["C_Mdyn"].get<double>() == Approx(8).epsilon(1e-14));
  CHECK(parabola["lambda"].get<double>() == Approx(1).epsilon(1e-14));
  CHECK(parabola["ends"] == "R-R");
  CHECK(parabola["continuity"] == 1);
  const Json cycloid = object_of("cycloidal");  // s'' = 2 pi sin(2 pi x)
  CHECK(cycloid["C_a_max"].get<double>() == Approx(2 * std::acos(-1.0)).epsilon(1e-14));
  CHECK(cycloid["continuity"] == 2);
  CHECK(object_of("harmonic")["ends"] == "U-U");
  CHECK(object_of("harmonic")["lambda"].is_null());
  CHECK(object_of("constant-velocity")["continuity"] == "smooth");
}

TEST_CASE("the pieces as JSON give the law's displacement", "[json]") {
  int laws = 0;
  for (const Family& family : catalogue()) {
    const Law<double> law = family.make(family.defaults());
    if (!law.is_data()) continue;
    INFO(family.name);
    ++laws;
    const Json pieces = Json::parse(problems::pieces_to_json(law).dump());
    CHECK(pieces.front()["begin"] == 0.0);
    CHECK(pieces.back()["end"] == 1.0);
    for (int i = 0; i <= 64; ++i) {
      CHECK(displacement(pieces, i / 64.0) == Approx(law(i / 64.0, Side::Left).s).margin(1e-13));
    }
  }
  CHECK(laws >= 30);
}

TEST_CASE("pieces with curves name them", "[json]") {
  std::set<std::string> curves;
  for (const char* name : {"half-ellipse-velocity", "elliptic n=1.2", "inclined-sinusoid angle=82",
                           "stoddart exponents=3,4.5,6"}) {
    for (const Json& piece : problems::pieces_to_json(find_law(name).law())) {
      for (const Json& term : piece["curves"]) curves.insert(term["curve"].get<std::string>());
    }
  }
  CHECK(curves == std::set<std::string>{"half-ellipse", "ellipse", "inclined-sine", "power"});
}

TEST_CASE("enclosures hold the constants between them", "[json]") {
  for (const char* name : {"modified-sine", "poly-4-5-6-7", "parabolic", "inclined-sinusoid"}) {
    INFO(name);
    const Member member = find_law(name);
    const Json object = object_of(name);
    const Json proof = Json::parse(json_text(law_document(member)))["enclosures"];
    CHECK(proof.size() == 6);
    for (const auto& [key, bounds] : proof.items()) {
      INFO(key);
      REQUIRE(bounds.size() == 2);
      CHECK(number_in(bounds[0]) <= number_in(object[key]));
      CHECK(number_in(object[key]) <= number_in(bounds[1]));
    }
  }
}

}  // namespace camlaw::cli::law_output_test
