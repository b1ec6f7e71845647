// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "optim/search/trail.h"

namespace camlaw::optim {

/// Of a problem that states where its model has numbers (Problem::domain): where the best design,
/// at which it has numbers, lies beside an edge of the domain and is not settled, searches on with
/// the functions that decide kept above 0, each by a share of what it changes over the variables'
/// ranges; the share becomes less from one search to the next. So a search moves along the edge
/// that it ran into.
void search_along_edge(const Setting& setting, Trail& trail);

/// Goes back to the design at which the conditions of optimality held along the edge, where later
/// stages have only come closer to the same edge.
void keep_from_edge(const Setting& setting, Trail& trail);

/// Says of a best design that is_at_edge() what is known of it, and what is not proved.
std::string words_at_edge(const Setting& setting, const Trail& trail);

}  // namespace camlaw::optim
