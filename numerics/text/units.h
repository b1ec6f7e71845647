// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace camlaw::optim {
class LibraryMutex;
}

/// Numbers as people write them, with units, through udunits: "40 mm", "30deg", "300 rpm". From any
/// thread: udunits, whose reader of texts is not made for threads, takes one at a time.
namespace camlaw {

/// The value of `text` in `unit` (udunits spelling, also deg and rpm; "1" for a plain number).
/// Units in the text are read as people write them (numerics/text/unit_spelling.h); of a speed
/// 1/min and Hz count revolutions. A number without a unit is taken in `listed`, the unit that the
/// quantity is listed in. `what` names the quantity in errors. Throws std::invalid_argument where
/// the number or unit cannot be read or is of another kind ("stroke: '30 deg' is an angle, a length
/// is wanted, such as 40 mm").
double parse_quantity(std::string_view text, const std::string& unit, const std::string& listed,
                      const std::string& what);

/// How large one of a unit is that is written by people, such as "Grad" or "1/min", in `unit`.
/// Throws std::invalid_argument where it cannot be read, is of another kind or ambiguous.
double unit_as_written(std::string_view written, const std::string& unit);

/// A value in one unit, converted to another of the same kind.
double convert_unit(double value, const std::string& from, const std::string& to);

/// Held while udunits works (numerics/library_mutex.h). A program that calls udunits itself holds
/// it meanwhile, where other threads may read quantities.
optim::LibraryMutex& unit_mutex();

}  // namespace camlaw
