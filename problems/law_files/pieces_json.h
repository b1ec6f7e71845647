// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/law.h"
#include "numerics/text/file_format.h"
#include "problems/law_files/json_type.h"

/// Laws as JSON, both ways: what is read back is the same law to the last bit.
namespace camlaw::problems {

inline constexpr FileFormat kLawFormat{"camlaw law", 1};

/// The object of a law file (law_file.h).
Json law_file(const Law<double>& law, const std::string& title, const Json& provenance);

/// A list of pieces with begin, end, origin, polynomial, harmonics and curves.
Json pieces_to_json(const Law<double>& law);

/// Throws std::invalid_argument that says which piece and key are wrong, or how the pieces do not
/// make a law.
Law<double> law_from_json(const Json& pieces, Ends ends);

/// "R-U". Throws std::invalid_argument for anything else.
Ends ends_of(const std::string& text);

}  // namespace camlaw::problems
