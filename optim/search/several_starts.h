// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/search/trail.h"

/// The searches from several starts of one problem, and when one of them ends the search.
namespace camlaw::optim {

/// From how many starts is searched, unless one of them ends the search.
int count_of_starts(const Setting& setting);

/// Searches from one start, whatever came of the others. `stated`: the scales of the start that the
/// problem states, where they are known.
FromStart search_one(const Setting& setting, int number, FirstStart first,
                     const Scales* stated = nullptr);

/// Whether no other start need be tried after the search from one.
bool ends_search(const FromStart& start);

/// What the model threw in the search from a start ends the search.
struct ModelThrew {};

/// Searches from one start or several; of the first of them what is known is taken. `ends` gets the
/// objective where each start ended, infinite where that is no design.
void search_starts(const Setting& setting, Trail& trail, std::vector<double>& ends,
                   std::vector<FromStart> known);

}  // namespace camlaw::optim
