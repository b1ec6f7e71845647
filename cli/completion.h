// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/help.h"

/// Scripts with which shells complete the program's command lines.
namespace camlaw::cli {

/// What stands for an option's value: words, and whether files or folders may as well.
struct Candidates {
  std::vector<std::string> words;
  bool files = false, folders = false;
};

/// Of what an option takes (OptionPage::takes): names of laws, mechanisms, solvers and systems, the
/// words in braces. Names with spaces in them are left out.
Candidates candidates(const std::string& takes);

/// For bash 4.4 and later, zsh 5 and fish 3. The first page is the program's own.
std::string bash_completion(const std::vector<CommandPage>& pages);
std::string zsh_completion(const std::vector<CommandPage>& pages);
std::string fish_completion(const std::vector<CommandPage>& pages);

}  // namespace camlaw::cli
