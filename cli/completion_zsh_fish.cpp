// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/completion.h"

namespace camlaw::cli {
namespace {

/// Text between single quotes, with a backslash before each of `special`.
std::string escaped(const std::string& text, const std::string& special, const char* quote) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += quote;
      continue;
    }
    if (special.find(c) != std::string::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string in_zsh(const std::string& text) { return escaped(text, "[]:\\", "'\\''"); }
std::string in_fish(const std::string& text) { return escaped(text, "\\", "\\'"); }

/// What zsh does for a value: "_files", "(a b)".
std::string zsh_action(const std::string& kind) {
  const Candidates values = candidates(kind);
  const std::string words = fmt::format("{}", fmt::join(values.words, " "));
  if (values.folders) return "_files -/";
  if (!values.files) return words.empty() ? " " : "(" + words + ")";
  return words.empty()
             ? "_files"
             : fmt::format("_alternative \"names\\:name\\:({})\" \"files\\:file\\:_files\"", words);
}

std::string zsh_option(const OptionPage& option, const std::string& name) {
  const std::string value =
      option.takes.empty() ? ""
                           : fmt::format(":{}:{}", in_zsh(option.takes), zsh_action(option.takes));
  return fmt::format("'{}{}[{}]{}'", option.repeats ? "*" : "", name, in_zsh(option.help), value);
}

std::string zsh_options(const CommandPage& page) {
  std::string text;
  for (const OptionPage& option : page.options) {
    if (option.positional) {
      text += fmt::format(" \\\n        '{}:{}:{}'", option.repeats ? "*" : "",
                          in_zsh(option.names.front()), zsh_action(option.takes));
      continue;
    }
    for (const std::string& name : option.names) text += " \\\n        " + zsh_option(option, name);
  }
  return text;
}

std::string fish_values(const std::string& kind) {
  const Candidates values = candidates(kind);
  std::string words = fmt::format("{}", fmt::join(values.words, " "));
  if (values.folders) words += "(__fish_complete_directories)";
  const std::string files = values.files ? " -F" : "";
  return words.empty() ? files : fmt::format("{} -a '{}'", files, words);
}

std::string fish_option(const CommandPage& page, const OptionPage& option,
                        const std::string& where) {
  std::string text = fmt::format("complete -c camlaw -n '{}'", where);
  if (option.positional) {
    const std::string values = fish_values(option.takes);
    return values.empty() || page.name.empty() ? "" : text + values + "\n";
  }
  for (const std::string& name : option.names) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (!option.takes.empty()) {
    text += (candidates(option.takes).files ? " -r" : " -x") + fish_values(option.takes);
  }
  return text + fmt::format(" -d '{}'\n", in_fish(option.help));
}

}  // namespace

std::string zsh_completion(const std::vector<CommandPage>& pages) {
  std::string commands, branches;
  for (std::size_t i = 1; i < pages.size(); ++i) {
    commands += fmt::format("    '{}:{}'\n", pages[i].name, in_zsh(pages[i].help));
    branches +=
        fmt::format("    {})\n      _arguments -s{} ;;\n", pages[i].name, zsh_options(pages[i]));
  }
  return fmt::format(
      "#compdef camlaw\n# Completion for zsh, printed by 'camlaw completion zsh'.\n"
      "_camlaw() {{\n  local -a commands=(\n{}  )\n"
      "  if (( CURRENT == 2 )); then\n    _describe command commands\n    _arguments{}\n"
      "    return\n  fi\n"
      "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n"
      "  case $command in\n{}  esac\n}}\n\n"
      "if [[ $funcstack[1] == _camlaw ]]; then\n  _camlaw \"$@\"\nelse\n"
      "  compdef _camlaw camlaw\nfi\n",
      commands, zsh_options(pages.front()), branches);
}

std::string fish_completion(const std::vector<CommandPage>& pages) {
  std::string text =
      "# Completion for fish, printed by 'camlaw completion fish'.\ncomplete -c camlaw -f\n";
  for (const OptionPage& option : pages.front().options) {
    text += fish_option(pages.front(), option, "__fish_use_subcommand");
  }
  for (std::size_t i = 1; i < pages.size(); ++i) {
    text += fmt::format("complete -c camlaw -n __fish_use_subcommand -a {} -d '{}'\n",
                        pages[i].name, in_fish(pages[i].help));
    for (const OptionPage& option : pages[i].options) {
      text += fish_option(pages[i], option, "__fish_seen_subcommand_from " + pages[i].name);
    }
  }
  return text;
}

}  // namespace camlaw::cli
