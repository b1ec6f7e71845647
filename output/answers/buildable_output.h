// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/document/document.h"
#include "problems/statement/buildable.h"

/// Whether a design can be built, beside every verdict.
namespace camlaw::cli {

/// The verdict of a design as people read it first, for the page with a badge.
struct Headline {
  std::string text;
  bool spoilt;  ///< the design cannot be built: nothing about it is shown as good
};
/// "certified optimum", and of a design that cannot be built "certified optimum of the limits
/// stated; cannot be built: undercut 1.11 at 60 deg".
Headline headline(const std::string& verdict, const problems::Buildability& found);

/// "buildable: 3 checks hold, 1 fails, 2 are not checked"; empty of a machine without checks.
std::string buildable_words(const problems::Buildability& found);

/// "holds", "fails: undercut, wall", and where nothing fails but something is not checked
/// "not checked: contact"; empty of a machine without checks.
std::string buildable_in_short(const problems::Buildability& found);

/// Each check with its answer.
Table buildable_table(const problems::Buildability& found);

/// All of it for programs; null of a machine without checks.
Json buildable_json(const problems::Buildability& found);

/// The words, the table, and for programs "buildable".
Document buildable_document(const problems::Buildability& found);

}  // namespace camlaw::cli
