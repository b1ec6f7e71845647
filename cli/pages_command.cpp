// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/completion.h"
#include "cli/man_page.h"
#include "cli/printing.h"
#include "cli/version_text.h"

namespace camlaw::cli {
namespace {

std::string script(const std::string& shell, const std::vector<CommandPage>& pages) {
  if (shell == "bash") return bash_completion(pages);
  if (shell == "zsh") return zsh_completion(pages);
  if (shell == "fish") return fish_completion(pages);
  throw std::invalid_argument(
      fmt::format("no completion for the shell '{}'; there are bash, zsh, fish", shell));
}

}  // namespace

void add_completion_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("completion", "Print the script with which a shell completes commands");
  const auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->type_name("{bash,zsh,fish}");
  add_examples(*command, {{"camlaw completion bash > camlaw.bash",
                           "source that file, or put it where bash looks for completions"}});
  command->callback([shell, &app] { print_data(script(*shell, command_pages(app))); });
}

void add_man_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("man", "Print the manual page");
  command->group("");  // for the build, and not listed
  command->callback([&app] { print_data(man_page(command_pages(app), short_version())); });
}

}  // namespace camlaw::cli
