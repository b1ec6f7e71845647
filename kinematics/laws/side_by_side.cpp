// SPDX-License-Identifier: MIT
#include "kinematics/laws/side_by_side.h"

#include <fmt/format.h>

#include "kinematics/shape.h"
#include "numerics/scalar/dual.h"

namespace camlaw {
namespace {

/// The arguments of one of the laws among those of all.
template <class S>
Arguments<S> arguments_of(const LawPart& part, const Arguments<S>& all) {
  const auto begin = all.values().begin() + static_cast<std::ptrdiff_t>(part.first);
  return Arguments<S>({begin, begin + static_cast<std::ptrdiff_t>(part.law->arguments.size())});
}

/// "press: rise 120 deg by cycloidal to 1, dwell 240 deg".
std::string words_of(const LawBeside& beside) {
  const bool is_program = beside.law.family->spans != nullptr;
  return beside.name + ": " + (is_program ? beside.law.family->formula : beside.law.label());
}

/// A law's parameters, and what they must leave together, by names that tell the laws apart.
void add_to(Family& family, const LawBeside& beside, const LawPart& part) {
  for (Parameter parameter : beside.law.family->parameters) {
    const bool is_taken = beside.taken.contains(parameter.name);
    const std::string before = beside.name + (is_taken ? ".law." : ".");
    parameter.name = before + parameter.name;
    if (!parameter.also.empty()) parameter.also = before + parameter.also;
    family.parameters.push_back(std::move(parameter));
  }
  for (const Room& room : beside.law.family->rooms) {
    family.rooms.push_back({beside.name + ": " + room.name,
                            [left = room.left, part]<class S>(const Arguments<S>& all) -> S {
                              return left.make(arguments_of(part, all));
                            },
                            room.linear, room.is_equal});
  }
}

}  // namespace

Member side_by_side(const std::vector<LawBeside>& laws) {
  std::vector<LawPart> parts;
  std::vector<std::vector<double>> values;
  for (const LawBeside& beside : laws) {
    parts.push_back({beside.name, std::make_shared<const Member>(beside.law), values.size()});
    const auto& own = beside.law.arguments.values();
    values.insert(values.end(), own.begin(), own.end());
  }
  Family family{.name = "",
                .aliases = {},
                .formula = "",
                .parameters = {},
                .ends = "of each law",
                .continuity = kSmooth,
                .symmetric = false,
                .source = "stated",
                .maker = [parts]<class S>(const Arguments<S>& all) -> Possible<Law<S>> {
                  for (const LawPart& part : parts) {
                    const auto law = part.law->family->possible(arguments_of(part, all));
                    if (!law) return Impossible{part.name + ": " + law.why()};
                  }
                  return parts.front().law->family->possible(arguments_of(parts.front(), all));
                }};
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const std::string_view mark = i == 0 ? "" : ", ", stop = i == 0 ? "" : "; ";
    family.name += fmt::format("{}{}={}", mark, laws[i].name, laws[i].law.family->name);
    family.formula += fmt::format("{}{}", stop, words_of(laws[i]));
    family.continuity = std::min(family.continuity, laws[i].law.family->continuity);
    add_to(family, laws[i], parts[i]);
  }
  family.parts = parts;
  family.listed = [laws](const Arguments<double>& arguments) {
    std::vector<LawBeside> listed = laws;
    std::size_t first = 0;
    for (LawBeside& beside : listed) {
      const std::size_t count = beside.law.arguments.size();
      for (std::size_t k = 0; k < count; ++k) {
        beside.law.arguments.values()[k] = arguments.list(first + k);
      }
      first += count;
      beside.law = beside.law.listed();
    }
    return side_by_side(listed);
  };
  return {std::make_shared<const Family>(std::move(family)), Arguments<double>(std::move(values))};
}

std::vector<Member> laws_side_by_side(const Member& member) {
  std::vector<Member> laws;
  for (const LawPart& part : member.family->parts) {
    laws.push_back({part.law->family, arguments_of(part, member.arguments)});
  }
  return laws;
}

}  // namespace camlaw
