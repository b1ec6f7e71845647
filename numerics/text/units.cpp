// SPDX-License-Identifier: MIT
#include "numerics/text/units.h"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "numerics/library_mutex.h"
#include "numerics/own_files.h"
#include "numerics/text/dimension.h"
#include "numerics/text/names.h"
#include "numerics/text/unit_kinds.h"
#include "numerics/text/unit_spelling.h"

namespace camlaw {
namespace {

using Unit = std::unique_ptr<ut_unit, decltype(&ut_free)>;
using Converter = std::unique_ptr<cv_converter, decltype(&cv_free)>;

/// The unit database with the abbreviations that engineers use and udunits lacks.
ut_system* unit_system() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    // A package that brings udunits along brings its database too; else udunits knows where it is.
    const auto own = own_file("udunits2.xml");
    ut_system* loaded = ut_read_xml(own ? own->c_str() : nullptr);
    if (loaded == nullptr) throw std::runtime_error("units: the udunits database cannot be read");
    for (const auto& [name, meaning] : {std::pair{"deg", "arc_degree"},
                                        {"rpm", "revolution/minute"},
                                        {"rev", "revolution"},
                                        {"gon", "0.9 arc_degree"}}) {
      ut_unit* unit = ut_parse(loaded, meaning, UT_UTF8);
      ut_map_name_to_unit(name, UT_UTF8, unit);  // keeps what the database has of that name
      ut_free(unit);
    }
    return loaded;
  }();
  return system;
}

Unit find_unit(const std::string& name) {
  return {ut_parse(unit_system(), name.c_str(), UT_UTF8), &ut_free};
}

/// Whether angle is part of a unit; udunits counts the radian as a plain number otherwise.
bool has_angle(const Unit& unit) {
  std::array<char, 256> definition{};
  ut_format(unit.get(), definition.data(), definition.size(), UT_ASCII | UT_DEFINITION);
  return std::string_view(definition.data()).find("rad") != std::string_view::npos;
}

/// Whether two units measure the same: equal dimensions (not reciprocal ones, which udunits would
/// convert too), and angle in both or in neither.
bool same_kind(const Unit& a, const Unit& b) {
  const Unit ratio(ut_divide(a.get(), b.get()), &ut_free);
  return ratio && ut_is_dimensionless(ratio.get()) != 0 && has_angle(a) == has_angle(b);
}

/// The converter from one unit to another, which is kept: machines list many numbers in few units.
const cv_converter* converter_between(const std::string& from, const std::string& to) {
  static std::map<std::pair<std::string, std::string>, Converter> kept;
  const auto found = kept.find({from, to});
  if (found != kept.end()) return found->second.get();
  const Unit source = find_unit(from), target = find_unit(to);
  if (!source || !target || !same_kind(source, target)) {
    throw std::invalid_argument(fmt::format("units: '{}' cannot be converted to '{}'", from, to));
  }
  Converter made(ut_get_converter(source.get(), target.get()), &cv_free);
  return kept.emplace(std::pair(from, to), std::move(made)).first->second.get();
}

/// What kind of quantity a unit measures, for messages.
std::string kind_of(const Unit& unit) {
  if (same_kind(unit, find_unit("1"))) return "a plain number";
  for (const UnitKind& kind : kUnitKinds) {
    if (same_kind(unit, find_unit(kind.unit))) return kind.name;
  }
  return "a quantity of another kind";
}

/// Whether text is written as a unit: names with one-digit powers, joined by spaces, points, stars
/// or strokes; "1/" may lead. What udunits reads beyond that (numbers, offsets, brackets) is a slip
/// of the pen here.
bool is_unit_text(std::string_view text) {
  if (text == "1" || text == "%") return true;
  if (text.starts_with("1/")) text.remove_prefix(2);
  const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0 || c >= 0x80; };
  const auto skip = [&](auto accepted, std::size_t most) {
    std::size_t n = 0;
    while (n < std::min(most, text.size()) && accepted(static_cast<unsigned char>(text[n]))) ++n;
    text.remove_prefix(n);
    return n;
  };
  while (true) {
    if (skip(is_letter, text.size()) == 0) return false;
    skip([](unsigned char c) { return c == '^'; }, 1);
    skip([](unsigned char c) { return c == '-'; }, 1);
    skip([](unsigned char c) { return std::isdigit(c) != 0; }, 1);
    if (text.empty()) return true;
    if (skip([](unsigned char c) { return c == ' ' || c == '.' || c == '*' || c == '/'; }, 1) ==
        0) {
      return false;
    }
  }
}

/// Whether a name is one of an angle, but not one that people use: udunits reads "mdeg" and "Grad".
bool is_odd_angle(std::string_view name) {
  if (is_angle_name(name)) return false;
  const Unit unit = find_unit(std::string(name));
  return unit && same_kind(unit, find_unit("rad"));
}

/// A unit as people write it; none where it is not one.
Unit read_unit(std::string_view written) {
  const std::string spelled = spelled_out(written);
  bool odd = false;
  for_each_name(spelled, [&](std::string_view name) { odd = odd || is_odd_angle(name); });
  if (odd || !is_unit_text(spelled)) return {nullptr, &ut_free};
  return find_unit(spelled);
}

/// The same where a quantity in `target` is wanted: of a speed 1/min counts revolutions.
Unit read_unit(std::string_view written, const Unit& target) {
  Unit unit = read_unit(written);
  if (!unit || same_kind(unit, target) || !counts_turns(spelled_out(written))) return unit;
  Unit turns(ut_multiply(unit.get(), find_unit("rev").get()), &ut_free);
  return turns && same_kind(turns, target) ? std::move(turns) : std::move(unit);
}

/// ", such as 1 mm"; of a plain number nothing.
std::string example(const std::string& listed) {
  return listed == "1" ? "" : fmt::format(", such as 1 {}", listed);
}

/// Why a text does not begin with a number.
std::string number_refusal(std::string_view text, std::errc error, const std::string& listed) {
  if (error == std::errc::result_out_of_range) {
    return fmt::format("'{}' is beyond the range of numbers", text);
  }
  return fmt::format("'{}' is not a number{}", text,
                     listed == "1" ? "" : " with a unit" + example(listed));
}

/// What a person did who wrote 4,0.
bool has_decimal_comma(std::string_view rest) {
  return rest.size() > 1 && rest[0] == ',' &&
         std::isdigit(static_cast<unsigned char>(rest[1])) != 0;
}

/// Powers of the base units in what the library says of a unit, "0.001 m.kg.s-2", and the unit of
/// that size 1.
SiUnit si_unit_of(const std::string& unit, std::string_view definition) {
  const auto refuse = [&](const char* why) {
    throw std::invalid_argument(fmt::format("'{}' {}", unit, why));
  };
  if (definition.find_first_of("@(") != std::string_view::npos) {
    refuse("has a scale of its own, which does not begin at 0; formulas use SI units");
  }
  const std::size_t first = definition.find(' ');
  std::string_view rest =
      first == std::string_view::npos ? definition : definition.substr(first + 1);
  SiUnit result{{},
                rest.empty() || std::isdigit(static_cast<unsigned char>(rest[0])) != 0
                    ? std::string("1")
                    : std::string(rest)};
  while (result.unit != "1" && !rest.empty()) {
    const std::string_view part = rest.substr(0, rest.find('.'));
    rest.remove_prefix(std::min(rest.size(), part.size() + 1));
    const std::size_t letters = std::min(part.find_first_of("-0123456789"), part.size());
    const std::string_view name = part.substr(0, letters);
    int exponent = 1;
    std::from_chars(part.data() + letters, part.data() + part.size(), exponent);
    const auto* const base = std::find(Dimension::kUnits.begin(), Dimension::kUnits.end(), name);
    if (base != Dimension::kUnits.end()) {
      result.dimension.powers[static_cast<std::size_t>(base - Dimension::kUnits.begin())] =
          exponent;
    } else if (name != "rad") {
      refuse("is not a unit that formulas know");
    }
  }
  return result;
}

}  // namespace

optim::LibraryMutex& unit_mutex() {
  static optim::LibraryMutex mutex;
  return mutex;
}

double convert_unit(double value, const std::string& from, const std::string& to) {
  const std::lock_guard lock(unit_mutex());
  return cv_convert_double(converter_between(from, to), value);
}

double unit_as_written(std::string_view written, const std::string& unit) {
  if (const auto why = ambiguous(written)) throw std::invalid_argument(*why);
  const std::lock_guard lock(unit_mutex());
  const Unit target = find_unit(unit), source = read_unit(written, target);
  if (!source || !same_kind(source, target)) {
    throw std::invalid_argument(
        fmt::format("units: '{}' cannot be converted to '{}'", written, unit));
  }
  const Converter converter(ut_get_converter(source.get(), target.get()), &cv_free);
  return cv_convert_double(converter.get(), 1);
}

SiUnit si_unit(const std::string& unit) {
  const std::lock_guard lock(unit_mutex());
  const Unit found = find_unit(unit);
  std::array<char, 256> definition{};
  if (!found ||
      ut_format(found.get(), definition.data(), definition.size(), UT_ASCII | UT_DEFINITION) < 0) {
    throw std::invalid_argument(fmt::format("'{}' is not a unit", unit));
  }
  return si_unit_of(unit, definition.data());
}

WrittenUnit written_unit(std::string_view written) {
  if (const auto why = ambiguous(written)) throw std::invalid_argument(*why);
  std::string spelled = spelled_out(written);
  if (counts_turns(spelled)) {
    throw std::invalid_argument(
        fmt::format("'{}' may or may not mean revolutions; write rpm, or [1/s]", written));
  }
  {
    const std::lock_guard lock(unit_mutex());
    if (!read_unit(written)) {
      throw std::invalid_argument(fmt::format("'{}' is not a unit", written));
    }
  }
  SiUnit si = si_unit(spelled);
  return {std::move(si), std::move(spelled)};
}

double parse_quantity(std::string_view text, const std::string& unit, const std::string& listed,
                      const std::string& what) {
  text = trimmed(text);
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) {
    throw std::invalid_argument(fmt::format("{}: {}", what, number_refusal(text, error, listed)));
  }
  const std::string given(trimmed(text.substr(static_cast<std::size_t>(end - text.data()))));
  if (given.empty()) return convert_unit(value, listed, unit);
  if (given.front() == ':') {
    throw std::invalid_argument(
        fmt::format("{}: '{}' is a range; a single value is needed here", what, text));
  }
  if (has_decimal_comma(given)) {
    throw std::invalid_argument(
        fmt::format("{}: '{}' has a comma; use a point for the decimals", what, text));
  }
  if (const auto why = ambiguous(given)) {
    throw std::invalid_argument(fmt::format("{}: {}", what, *why));
  }
  const std::lock_guard lock(unit_mutex());
  const Unit target = find_unit(unit), source = read_unit(given, target);
  if (!source) {
    throw std::invalid_argument(fmt::format("{}: '{}' is not a unit; {} is needed{}", what, given,
                                            kind_of(target), example(listed)));
  }
  if (!same_kind(source, target)) {
    throw std::invalid_argument(fmt::format("{}: '{}' is {}; {} is needed{}", what, text,
                                            kind_of(source), kind_of(target), example(listed)));
  }
  const Converter converter(ut_get_converter(source.get(), target.get()), &cv_free);
  return cv_convert_double(converter.get(), value);
}

}  // namespace camlaw
