// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "problems/statement/statement.h"
#include "problems/statement/toml_entry.h"

/// Laws as a problem file names them.
namespace camlaw::problems {

/// A law by its name and the parameters that the name gives.
struct NamedLaw {
  Member law;
  std::set<std::string> given;
};

/// Reads "cosine", "polynomial-5 alpha=-3"; an entry of the catalogue with a parameter in its name
/// as the member of its family. A file's law is taken from `files` where it is there, else it is
/// read and joins them. Refuses the entry for names and values that are not accepted.
NamedLaw read_law_name(const Entry& name, HeldFiles& files);

/// The laws of the catalogue that a text such as "all", "ends R-R" or "ends R-R, continuity >= 2"
/// stands for, with their default parameters; none where the text is a law's name. Refuses the
/// entry where it holds a condition that is not known, or that no law meets.
std::optional<std::vector<Member>> read_law_class(const Entry& name);

/// Whether a law is the catalogue's own, and found by its name in any process.
bool is_of_catalogue(const Member& law);

/// Laws of a list that are files are called by their paths where their stems would be taken for
/// another law of the list.
void tell_apart(std::vector<Member>& laws);

/// Laws to choose from, in order, and of each whether a class holds it: it is not named itself.
struct LawList {
  std::vector<Member> laws;
  std::vector<bool> is_of_class;
};

/// Beside the free law, whose coefficients are varied, leaves out those laws of classes that have
/// coefficients of this name, as the b-spline: the free law is every such law on its knots. Refuses
/// one that is named.
void leave_to_free_law(const Entry& names, LawList& list);

}  // namespace camlaw::problems
