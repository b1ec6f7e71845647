// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/completion.h"
#include "cli/man_page.h"
#include "output/document/printing.h"
#include "output/document/short_version.h"

namespace camlaw::cli {
namespace {

std::string script(const std::string& shell, const std::vector<CommandPage>& pages) {
  if (shell == "bash") return bash_completion(pages);
  if (shell == "zsh") return zsh_completion(pages);
  if (shell == "fish") return fish_completion(pages);
  throw std::invalid_argument(
      fmt::format("there is no completion for the shell '{}'; use bash, zsh or fish", shell));
}

}  // namespace

Command completion_command() {
  const auto shell = std::make_shared<std::string>();
  return {.name = "completion",
          .help = "Print the script with which a shell completes commands",
          .options = {{.names = "SHELL",
                       .target = shell.get(),
                       .takes = "{bash,zsh,fish}",
                       .help = "bash, zsh or fish",
                       .required = true}},
          .examples = {{"camlaw completion bash > camlaw.bash",
                        "source that file, or put it where bash looks for completions"}},
          .run = [shell] {
            print_data(script(*shell, command_pages(camlaw_program())));
            return kDone;
          }};
}

Command man_command() {
  return {.name = "man",
          .help = "Print the manual page",
          .options = {},
          .examples = {},
          .run =
              [] {
                print_data(man_page(command_pages(camlaw_program()), short_version()));
                return kDone;
              },
          .is_listed = false};
}

}  // namespace camlaw::cli
