// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/peaks.h"
#include "output/answers/optimum_output.h"
#include "problems/law_files/json_text.h"

/// What a law that was found is measured with.
namespace camlaw::cli {

/// The best law that has a name, on the same problem.
struct NamedRival {
  std::string law;
  double objective;
};

struct Rulers {
  Peaks<double> peaks;
  std::optional<double> lambda;  ///< the limit index; of laws from rest to rest
  /// The least of any law with s' = 0 at both ends and this B at most; of others none.
  std::optional<double> least_acceleration = {};
  /// The least dynamic moment of any such law with this B and this C at most; of others none.
  std::optional<double> least_moment = {};
  int rivals = 0;                       ///< laws of the catalogue that can be used
  bool reoptimised = false;             ///< whether other variables were searched again for each
  bool held = false;                    ///< whether the answer's choices stay for all of them
  bool finished = true;                 ///< false: stopped or out of time before all were tried
  std::optional<NamedRival> best = {};  ///< none: no rival meets the limits
};

/// Measures the law of an answer; none where it has no design. Rivals are the laws of the catalogue
/// at their default parameters, but for splines, that are as smooth inside, up to s'', and whose
/// s' and s'' vanish at the ends where those of the free law must; what else varies is searched
/// again for each.
///
/// `search` says how, with what is left of the time and what may stop it; in up to so many
/// processes at a time where this one has one thread. Where choices would make
/// too many combinations with the rivals, those of the answer stay.
std::optional<Rulers> rulers(const Answer& answer, const optim::OptimiseOptions& search,
                             int workers = 1);

Document rulers_document(const Answer& answer, const Rulers& rulers);

/// The segments of an answer's motion program whose laws are free, each measured as a law of its
/// own. Named laws are not tried in their place.
Document segment_rulers(const Answer& answer);

/// The names of the segments whose laws are free; none where no motion program moves the machine.
std::vector<std::string> free_segments(const problems::ProblemStatement& statement);

}  // namespace camlaw::cli
