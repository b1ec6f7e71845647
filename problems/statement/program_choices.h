// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "kinematics/program/program.h"
#include "problems/statement/law_names.h"
#include "problems/statement/statement.h"
#include "problems/statement/toml_reader.h"

/// The programs that segments make which may choose among laws.
namespace camlaw::problems {

/// A segment as the file states it, with a choice of laws.
struct StatedSegment {
  const Entry* entry;
  ProgramSegment segment;
  LawList list = {};  ///< empty: it rests or joins
};

/// Refuses more combinations of laws than a search goes through.
void check_count(const Entry& list, const std::vector<StatedSegment>& stated);

/// A combination of the segments' laws: of each segment which of its laws, where it has some.
using Chosen = std::vector<std::size_t>;

/// Every combination, the last segment's laws fastest.
std::vector<Chosen> combinations(const std::vector<StatedSegment>& stated);

std::vector<ProgramSegment> segments_of(const std::vector<StatedSegment>& stated,
                                        const Chosen& chosen);

/// A combination of which no program can be made.
struct Unfit {
  Chosen chosen;
  std::string why;
};

/// Why a combination of laws that the file names is refused.
std::string not_fitting(const Unfit& one, std::size_t count);

/// The laws of classes that fit in no combination, and the combinations of others that do not fit.
/// Refuses a law that the file names and that fits in none.
std::vector<LeftOut> left_out_of(const Entry& list, const std::vector<StatedSegment>& stated,
                                 const std::vector<Unfit>& unfit, std::size_t count);

/// Whether a class holds one of the laws that a combination chooses.
bool has_law_of_class(const std::vector<StatedSegment>& stated, const Chosen& chosen);

}  // namespace camlaw::problems
