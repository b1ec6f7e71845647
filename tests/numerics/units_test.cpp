// SPDX-License-Identifier: MIT
#include "numerics/text/units.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace camlaw::problems::units_test {
namespace {

using Catch::Matchers::Contains;
constexpr double kPi = std::numbers::pi;

Approx near(double value) { return Approx(value).epsilon(1e-14); }

double length(const std::string& text) { return parse_quantity(text, "m", "mm", "stroke"); }
double angle(const std::string& text) { return parse_quantity(text, "rad", "deg", "tilt"); }
double plain(const std::string& text) { return parse_quantity(text, "1", "1", "blades"); }

/// The error for a text, or "accepted" with the value that was made of it.
std::string complaint(double (*parse)(const std::string&), const std::string& text) {
  try {
    return "accepted: " + std::to_string(parse(text));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("lengths, angles, velocities, speeds and masses are read in their usual units",
          "[units]") {
  CHECK(length("40 mm") == near(0.040));
  CHECK(length("4 cm") == near(0.040));
  CHECK(length("0.04 m") == near(0.040));
  CHECK(length("1 inch") == near(0.0254));  // by definition
  CHECK(length("250 um") == near(250e-6));
  CHECK(length("250 µm") == near(250e-6));
  CHECK(angle("30 deg") == near(kPi / 6));
  CHECK(angle("0.5 rad") == near(0.5));
  CHECK(angle("1 rev") == near(2 * kPi));
  CHECK(parse_quantity("18 m/min", "m/s", "m/s", "speed") == near(18.0 / 60));
  CHECK(parse_quantity("1 km/h", "m/s", "m/s", "speed") == near(1.0 / 3.6));
  CHECK(parse_quantity("300 rpm", "rad/s", "rpm", "speed") == near(300 * 2 * kPi / 60));
  CHECK(parse_quantity("300", "rad/s", "rpm", "speed") == near(10 * kPi));
  CHECK(parse_quantity("2400 g", "kg", "kg", "mass") == near(2.4));
  CHECK(parse_quantity("2.4 kg", "kg", "kg", "mass") == near(2.4));
  CHECK(plain("17") == 17);
}

TEST_CASE("a number without a unit is taken in the unit it is listed in", "[units]") {
  CHECK(length("40") == near(0.040));
  CHECK(angle("30") == near(kPi / 6));
  CHECK(parse_quantity("40", "mm", "mm", "stroke") == 40);
  CHECK(parse_quantity("40", "m", "m", "stroke") == 40);
  CHECK(parse_quantity("40 mm", "m", "m", "stroke") == near(0.040));
}

TEST_CASE("units are read as engineers write them", "[units]") {
  const auto read = [](const std::string& text, const std::string& unit) {
    return parse_quantity(text, unit, unit, "it");
  };
  for (const char* text : {"30 Grad", "30°", "30 °", "30 deg", "30 degrees"}) {
    INFO(text);
    CHECK(angle(text) == near(kPi / 6));
  }
  CHECK(angle("100 gon") == near(kPi / 2));
  CHECK(angle("500 mrad") == near(0.5));
  CHECK(angle("500 µrad") == near(0.0005));
  for (const char* text : {"300 1/min", "300 min-1", "300 min^-1", "300 min⁻¹", "300 U/min",
                           "300 Umdr/min", "300 RPM", "5 Hz"}) {
    INFO(text);
    CHECK(parse_quantity(text, "rad/s", "rpm", "speed") == near(10 * kPi));
  }
  CHECK(read("5 Hz", "Hz") == 5);  // where a frequency is wanted it stays one
  CHECK(read("2 Nm", "N m") == 2);
  CHECK(read("2500 Nmm", "N m") == near(2.5));
  CHECK(read("2 kNm", "N m") == near(2000));
  CHECK(read("3 Nm/rad", "N m/rad") == 3);
  CHECK(read("3 kgm2", "kg m2") == 3);
  CHECK(read("3 kg·m²", "kg m2") == 3);
  CHECK(read("3 kgm²", "kg m2") == 3);
  CHECK(read("20 kgcm2", "kg m2") == near(0.002));
  CHECK(length("1 in") == near(0.0254));
  CHECK(length("1\"") == near(0.0254));
  CHECK(length("2 inches") == near(0.0508));
  CHECK(read("800 mPa", "MPa") == near(8e-7));  // what it says; `check` names such a bound
  CHECK(unit_as_written("Grad", "deg") == near(1));
  CHECK(unit_as_written("U/min", "rpm") == near(1));
}

TEST_CASE("prefixes of angles that nobody means are refused, and small grad named", "[units]") {
  for (const char* text : {"30 mdeg", "30 krad", "30 Mrad", "30 Grade", "3 kdeg", "3 mgon"}) {
    CHECK_THAT(complaint(angle, text), Contains("tilt") && Contains("is not a unit"));
  }
  CHECK_THAT(complaint(angle, "30 grad"), Contains("tilt") && Contains("deg") && Contains("gon"));
  CHECK_THROWS_AS(unit_as_written("grad", "deg"), std::invalid_argument);
  CHECK_THAT(complaint(plain, "1e"), Contains("power of ten needs its exponent"));
  CHECK_THAT(complaint(length, "5 PS"), Contains("petasiemens") && Contains("horsepower"));
  // Per second may be radians or turns.
  CHECK_THROWS_AS(parse_quantity("5 1/s", "rad/s", "rpm", "speed"), std::invalid_argument);
}

TEST_CASE("spaces around number and unit do not matter", "[units]") {
  for (const char* text : {"0.4mm", "0.4 mm", "  0.4 mm", "0.4   mm", "0.4mm  ", " 0.4 ", "4e-1 mm",
                           "400e-3mm", ".4 mm", "0.00004e4"}) {
    INFO("'" << text << "'");
    CHECK(length(text) == near(0.0004));
  }
  CHECK(length("-3 mm") == near(-0.003));
  CHECK(angle("-90deg") == near(-kPi / 2));
}

TEST_CASE("a quantity of another kind is refused and named", "[units]") {
  CHECK_THAT(complaint(length, "30 deg"), Contains("stroke") && Contains("30 deg") &&
                                              Contains("an angle") &&
                                              Contains("a length is needed") && Contains("mm"));
  CHECK_THAT(complaint(angle, "3mm"), Contains("tilt") && Contains("3mm") &&
                                          Contains("is a length") &&
                                          Contains("an angle is needed") && Contains("deg"));
  CHECK_THAT(complaint(length, "2 kg"), Contains("is a mass"));
  CHECK_THAT(complaint(length, "2 m/s"), Contains("is a velocity"));
  CHECK_THAT(complaint(length, "2 mm^2"), Contains("is an area") && Contains("a length is needed"));
  CHECK_THAT(complaint(length, "2 m^4"),
             Contains("another kind") && Contains("a length is needed"));
}

TEST_CASE("a plain number is not an angle and an angle no plain number", "[units]") {
  CHECK_THAT(complaint(plain, "17 deg"),
             Contains("blades") && Contains("is an angle") && Contains("a plain number is needed"));
  CHECK_THAT(complaint(plain, "17 rad"), Contains("a plain number is needed"));
  CHECK_THAT(complaint(plain, "17 mm"), Contains("is a length"));
  CHECK_THAT(complaint(angle, "30 1"), Contains("tilt") && Contains("an angle is needed"));
  CHECK_THROWS_AS(convert_unit(1, "1", "rad"), std::invalid_argument);
  CHECK_THROWS_AS(convert_unit(1, "deg", "1"), std::invalid_argument);
}

TEST_CASE("a reciprocal is of another kind", "[units]") {
  // udunits calls mm and 1/mm convertible, by inverting the number.
  CHECK_THAT(complaint(length, "5 1/mm"), Contains("stroke") && Contains("a length is needed"));
  CHECK_THAT(complaint(length, "5 mm^-1"), Contains("stroke") && Contains("a length is needed"));
  CHECK_THROWS_AS(parse_quantity("5 s/m", "m/s", "m/s", "speed"), std::invalid_argument);
  CHECK_THROWS_AS(parse_quantity("2 s", "rad/s", "rpm", "speed"), std::invalid_argument);
  CHECK_THROWS_AS(convert_unit(2, "s", "1/s"), std::invalid_argument);
}

TEST_CASE("an error calls a kind by its name", "[units]") {
  CHECK_THAT(complaint(length, "5 rpm"), Contains("is an angular velocity"));
  CHECK_THAT(complaint(length, "5 s"), Contains("is a time"));
  CHECK_THAT(complaint(length, "5 N"), Contains("is a force"));
  CHECK_THAT(complaint(length, "5 1"), Contains("is a plain number"));
  CHECK_THAT(complaint(length, "5 MPa"), Contains("is a stress"));
  CHECK_THAT(complaint(length, "5 N/mm"), Contains("is a spring rate"));
  CHECK_THAT(complaint(length, "5 kW"), Contains("is a power"));
  CHECK_THAT(complaint(length, "5 N m"), Contains("is a torque or an energy"));
  CHECK_THAT(complaint(plain, "50 %"), !Contains("is an angle"));
}

TEST_CASE("unknown units and garbage are refused with what is accepted", "[units]") {
  CHECK_THAT(complaint(length, "40 foos"),
             Contains("stroke") && Contains("foos") && Contains("is not a unit") && Contains("mm"));
  CHECK_THAT(complaint(length, "40,5 mm"),
             Contains("stroke") && Contains("use a point for the decimals"));
  CHECK_THAT(complaint(length, "1e999 mm"),
             Contains("stroke") && Contains("beyond the range of numbers"));
  CHECK_THAT(complaint(plain, "4 foos"), Contains("is not a unit") && !Contains("1 1"));
  for (const char* text : {"", "   ", "mm", "forty mm", "--3 mm", "e5 mm", "= 4"}) {
    INFO("'" << text << "'");
    CHECK_THAT(complaint(length, text),
               Contains("stroke") && Contains("is not a number") && Contains("mm"));
  }
  CHECK_THAT(complaint(plain, "seventeen"), Contains("blades") && Contains("is not a number"));
  for (const char* text : {"4 mm;", "4 mm)", "4 mm mm", "4 (mm", "4 mm/", "17 %%"}) {
    INFO("'" << text << "'");
    CHECK_THAT(complaint(length, text), Contains("stroke") && Contains("a length is needed"));
  }
}

TEST_CASE("a second number is not taken for a part of the unit", "[units]") {
  // udunits has units such as "2 mm" and ".5 mm"; to people they are slips of the pen.
  for (const char* text : {"0.4.5mm", "0.4 2 mm", "30-5 mm", "1 m @ 5", "1 mm 3"}) {
    INFO("'" << text << "'");
    CHECK_THAT(complaint(length, text), Contains("stroke") && Contains("a length is needed"));
  }
  CHECK_THAT(complaint(plain, "17 3"), Contains("blades") && !Contains("is an angle"));
}

TEST_CASE("what is not a finite number never becomes one", "[units]") {
  for (const char* text : {"nan", "NaN", "nan mm", "inf", "-inf mm", "infinity"}) {
    INFO(text);
    const std::string outcome = complaint(length, text);
    CHECK_THAT(outcome, Contains("is not a number") || Contains("nan") || Contains("inf"));
  }
}

TEST_CASE("conversion there and back gives the same value", "[units]") {
  struct Pair {
    const char *from, *to;
    double factor;
  };
  const Pair pairs[] = {
      {"mm", "m", 1e-3},        {"deg", "rad", kPi / 180}, {"rpm", "rad/s", kPi / 30},
      {"km/h", "m/s", 1 / 3.6}, {"kg", "g", 1e3},          {"N m", "N mm", 1e3},
      {"MPa", "N/mm^2", 1},     {"m/s", "mm/s", 1e3},      {"1", "1", 1},
      {"rev", "deg", 360}};
  for (const auto& [from, to, factor] : pairs) {
    INFO(from << " to " << to);
    for (const double value : {-7.25, 0.0, 1e-9, 0.4, 17.0, 3e8}) {
      CHECK(convert_unit(value, from, to) == near(value * factor));
      CHECK(convert_unit(convert_unit(value, from, to), to, from) == near(value));
      CHECK(convert_unit(value, from, from) == value);
    }
  }
  CHECK(std::isnan(convert_unit(std::numeric_limits<double>::quiet_NaN(), "mm", "m")));
}

TEST_CASE("conversion between kinds names both units", "[units]") {
  CHECK_THROWS_WITH(convert_unit(1, "mm", "kg"), Contains("'mm'") && Contains("'kg'"));
  CHECK_THROWS_WITH(convert_unit(1, "foo", "kg"), Contains("'foo'") && Contains("'kg'"));
  CHECK_THROWS_AS(convert_unit(1, "mm", ""), std::invalid_argument);
}

}  // namespace camlaw::problems::units_test
