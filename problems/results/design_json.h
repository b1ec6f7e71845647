// SPDX-License-Identifier: MIT
#pragma once

#include "problems/law_files/json_type.h"
#include "problems/statement/bind.h"

namespace camlaw::problems {

/// The object that a result has under "design": `source` (the file's name), `path` (where the file
/// stood, if the problem was read from one), `problem` (its text),
/// `set` (what was set beside it, as set_values takes it), `law_files` by name, `tables` by name
/// where there are any, `law` where there were several to choose from, `variables` by name. Numbers
/// keep every digit. Null where x is no design.
Json recorded_design(const BoundProblem& bound, const std::vector<std::size_t>& options,
                     optim::Design x);

}  // namespace camlaw::problems
