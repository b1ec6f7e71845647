// SPDX-License-Identifier: MIT
#include "fitting/constants/printed_constants.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <cctype>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "machines/registry.h"
#include "numerics/text/names.h"
#include "numerics/text/units.h"

namespace camlaw::problems {
namespace {

std::string without_blanks(std::string_view text) {
  return std::string(trimmed(text, " \t\r\n\f\v"));
}

/// The number that a text begins with, as it is written.
std::string written_number(const std::string& text) {
  std::size_t end = 0;
  const auto is_digit = [&](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
  };
  if (end < text.size() && (text[end] == '-' || text[end] == '+')) ++end;
  while (is_digit(end) || (end < text.size() && text[end] == '.')) ++end;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    const std::size_t sign =
        end + 1 < text.size() && (text[end + 1] == '-' || text[end + 1] == '+');
    if (is_digit(end + 1 + sign)) {
      end += 1 + sign;
      while (is_digit(end)) ++end;
    }
  }
  return text.substr(0, end);
}

struct Digits {
  int significant = 0;
  double half_unit = 0;  ///< of the last one
};

/// "35.56": four digits, half a unit 0.005. Zeros at the end count: they are printed.
Digits digits_of(const std::string& number) {
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  const std::string mantissa = number.substr(0, e);
  const int exponent = e < number.size() ? std::stoi(number.substr(e + 1)) : 0;
  const std::size_t dot = std::min(mantissa.find('.'), mantissa.size());
  const int decimals = dot < mantissa.size() ? static_cast<int>(mantissa.size() - dot - 1) : 0;
  Digits result;
  result.half_unit = 0.5 * std::pow(10.0, exponent - decimals);
  bool leading = true;
  for (const char c : mantissa) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) continue;
    leading = leading && c == '0';
    result.significant += !leading;
  }
  result.significant = std::max(result.significant, 1);
  return result;
}

/// What mechanism "law" calls the constants of VDI 2143 and others.
std::string name_in_law(const std::string& name) {
  for (const auto& [printed, ours] :
       {std::pair{"C_a_max", "highest acceleration"}, std::pair{"C_a_min", "lowest acceleration"},
        std::pair{"C_j_max", "highest jerk"}, std::pair{"C_j_min", "lowest jerk"},
        std::pair{"C_max", "highest acceleration"}, std::pair{"C_min", "lowest acceleration"},
        std::pair{"D_max", "highest jerk"}, std::pair{"D_min", "lowest jerk"}}) {
    if (name == printed) return ours;
  }
  return name;
}

bool knows(const Mechanism& mechanism, const std::string& name) {
  try {
    return find_response(mechanism, name).response != nullptr;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

/// Responses of which the word is a part of the name.
std::vector<std::string> with_word(const Mechanism& mechanism, const std::string& word) {
  std::vector<std::string> result;
  const auto look = [&](const std::string& name) {
    if (name.find(word) != std::string::npos) result.push_back(name);
  };
  for (const NamedPeak& peak : mechanism.peaks) look(peak.name);
  for (const MechanismResponse& response : mechanism.responses) {
    if (response.number) look(response.name);
  }
  return result;
}

PrintedConstant named(const std::string& name, const Mechanism& machine) {
  const Mechanism& law = find_mechanism("law");
  PrintedConstant constant;
  constant.name = name;
  const std::string in_law = name_in_law(name);
  if (knows(machine, name)) {
    constant.of = &machine;
    constant.response = find_response(machine, name);
  } else if (knows(law, in_law)) {
    constant.of = &law;
    constant.response = find_response(law, in_law);
  } else {
    const auto words = name.size() > 2 ? with_word(machine, name) : std::vector<std::string>{};
    if (words.size() > 1) {
      throw std::invalid_argument(fmt::format("constant '{}': there are {}; name one of them", name,
                                              fmt::join(words, ", ")));
    }
    constant.of = &machine;
    constant.response = find_response(machine, words.empty() ? name : words.front());
  }
  const MechanismResponse* response = constant.response.response;
  if (response == nullptr) {
    throw std::invalid_argument(
        fmt::format("constant '{}': it is a size of the machine, which the problem file states, "
                    "not a printed result",
                    name));
  }
  if (response->curve && constant.response.part == optim::Part::Value) {
    throw std::invalid_argument(
        fmt::format("constant '{}': it is a curve; name its 'peak {}', 'highest {}' or 'lowest {}'",
                    name, name, name, name));
  }
  return constant;
}

void read_value(PrintedConstant& constant, const std::string& text) {
  constant.text = text;
  const std::string what = fmt::format("constant '{}'", constant.name);
  const std::string& unit = constant.response.unit;
  if (text == "inf" || text == "-inf") {
    constant.value = text == "inf" ? std::numeric_limits<double>::infinity()
                                   : -std::numeric_limits<double>::infinity();
    constant.low = constant.high = constant.value;
    constant.digits = 1;
    return;
  }
  const std::size_t plus = text.find("+-");
  const std::string printed = without_blanks(std::string_view(text).substr(0, plus));
  const std::string number = written_number(printed);
  constant.value = parse_quantity(printed, unit, unit, what);
  const Digits digits = digits_of(number);
  constant.digits = digits.significant;
  double room = 0;
  if (plus != std::string::npos) {
    room =
        parse_quantity(without_blanks(std::string_view(text).substr(plus + 2)), unit, unit, what);
    if (!(room > 0) || !std::isfinite(room))
      throw std::invalid_argument(what + ": its tolerance must be above zero and finite");
    // As many digits as that leaves certain.
    const double share = std::abs(constant.value) / (2 * room);
    constant.digits = share > 1 ? 1 + static_cast<int>(std::floor(std::log10(share))) : 1;
  } else {
    // The half unit in the unit that the number is written in.
    const std::string half =
        fmt::format("{:.17g}", digits.half_unit) + printed.substr(number.size());
    room = std::abs(parse_quantity(half, unit, unit, what));
  }
  constant.low = constant.value - room;
  constant.high = constant.value + room;
}

}  // namespace

std::vector<PrintedConstant> parse_constants(std::string_view text, const Mechanism& machine) {
  std::vector<PrintedConstant> result;
  std::vector<std::string> parts;
  boost::algorithm::split(parts, text, [](char c) { return c == ','; });
  for (std::string& part : parts) {
    part = without_blanks(part);
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) {
      throw std::invalid_argument(fmt::format(
          "constants: '{}' is not a constant; write name=value, such as C_v=1.6125, C_a=4.66",
          part));
    }
    PrintedConstant constant = named(without_blanks(part.substr(0, equals)), machine);
    read_value(constant, without_blanks(std::string_view(part).substr(equals + 1)));
    const bool twice = std::any_of(result.begin(), result.end(), [&](const PrintedConstant& other) {
      return other.of == constant.of && other.response.response == constant.response.response &&
             other.response.part == constant.response.part;
    });
    if (twice) {
      throw std::invalid_argument(fmt::format("constant '{}': it appears twice", constant.name));
    }
    result.push_back(std::move(constant));
  }
  return result;
}

}  // namespace camlaw::problems
