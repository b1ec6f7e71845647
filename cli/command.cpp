// SPDX-License-Identifier: MIT
#include "cli/command.h"

namespace camlaw::cli {

Option json_switch(bool& on) { return {"--json", &on, takes::kNothing, "print JSON"}; }

Option set_option(std::vector<std::string>& settings) {
  return {"--set", &settings, takes::kSetting,
          "set a constant or the start of a variable: name=value, such as --set 'stroke=30 mm'"};
}

Option start_option(std::optional<std::string>& result) {
  return {"--start", &result, takes::kResult,
          "start from the design of this result of 'camlaw optimize'"};
}

Option problem_file(std::string& file) {
  return {.names = "FILE",
          .target = &file,
          .takes = takes::kFile,
          .help = "the problem file (TOML)",
          .required = true};
}

}  // namespace camlaw::cli
