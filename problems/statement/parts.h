// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "problems/statement/statement.h"

/// Parts of a machine that are chosen from a catalogue (docs/problem-files.md, "[parts]").
namespace camlaw::problems {

/// The part of this name; null where the problem has none.
const PartStatement* find_part(const ProblemStatement& problem, std::string_view name);
/// The part that a parameter of the machine comes with; null where it comes with none.
const PartStatement* part_of(const ProblemStatement& problem, std::size_t parameter);

/// The part that an input of the mechanism's checks comes with; null where it comes with none.
const PartStatement* part_with_input(const ProblemStatement& problem, std::string_view input);

/// Where among a part's items one is. Case does not count. Throws std::invalid_argument with near
/// names.
std::size_t item_named(const PartStatement& part, std::string_view name);

/// Puts the numbers of a part's item among a machine's constants.
void put_item(const PartStatement& part, std::size_t item, std::vector<double>& constants);
/// Begins with an item of a part of the problem's: its start, and the constants and inputs of
/// checks that it has; limits that [buildable] requires follow these.
void start_with(ProblemStatement& problem, std::string_view part, std::size_t item);
/// Leaves of a part one item, as in a design.
void keep_item(ProblemStatement& problem, std::string_view part, std::size_t item);

/// Whether a part is still to be chosen.
bool chooses_part(const ProblemStatement& problem);

/// The items of a catalogue: a text with a line of names, "name", parameters of the machine or
/// inputs of its checks with their units, such as "face_width [mm]", or X_diameter for a parameter
/// X_radius, and "source".
/// Cells are separated by commas, semicolons or tabs; empty lines and those that begin with # are
/// passed over. `catalogue` names the text in errors, std::invalid_argument.
PartStatement parse_catalogue(const std::string& text, const std::string& catalogue,
                              const Mechanism& mechanism);

}  // namespace camlaw::problems
