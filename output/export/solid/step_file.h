// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/export/length_unit.h"
#include "output/export/solid/solid.h"

/// Solids as STEP files (ISO 10303-21, application protocol 214), by Open CASCADE in a plug-in that
/// is loaded when it is first asked for.
namespace camlaw::problems {

struct StepHeader {
  std::string name;                ///< of the product
  std::string program;             ///< what the file is from
  std::vector<std::string> lines;  ///< of the description
  LengthUnit unit = kMillimetre;   ///< in which lengths are written
};

struct StepText {
  std::string text;
  double volume = 0;      ///< mm^3, as Open CASCADE integrates it
  std::size_t faces = 0;  ///< how many the solid has
};

/// Whether there is a plug-in.
bool has_step();
/// Throws std::invalid_argument where there is no plug-in, in a sentence on how to get it.
void require_step();

/// The file, the same for the same solid. Throws std::invalid_argument as require_step does, and
/// std::runtime_error where Open CASCADE cannot build the solid, finds it not valid or not closed,
/// or has for its volume another than volume_of.
StepText step_text(const Solid& solid, const StepHeader& header);

/// "open-cascade 7.6.3", or that this build has none.
std::string step_version();

}  // namespace camlaw::problems
