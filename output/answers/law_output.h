// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "kinematics/laws/catalogue.h"
#include "machines/model/mechanism.h"
#include "output/document/document.h"

/// Motion laws as answers.
namespace camlaw::cli {

/// The laws of the catalogue.
std::vector<Member> catalogue_laws();

/// What is known of laws, a row each: names, formula, parameters, ends, peaks, source.
Table laws_table(const std::vector<Member>& laws);
/// A list; programs read the table's.
Document laws_document(const std::vector<Member>& laws);
/// The page docs/laws.md.
Document laws_page();

/// One law: its row of the table, its parameters as they are set, and its peaks with their places
/// and enclosures; for programs its pieces too.
Document law_document(const Member& member);

/// "samples": x, s, v, a, j at `count` even points.
LongList law_samples(const Law<double>& law, int count);

/// A law in a few words, as a design has it: of a motion program its segments.
std::string law_in_words(const Member& law, problems::MovedBy moved);

}  // namespace camlaw::cli
