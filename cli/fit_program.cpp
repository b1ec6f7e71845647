// SPDX-License-Identifier: MIT
#include "cli/fit_program.h"

#include <fmt/format.h>

#include <stdexcept>

#include "output/document/json.h"
#include "problems/law_files/law_file.h"
#include "problems/statement/default_machine.h"

namespace camlaw::cli {

std::vector<OutputFile> program_files(const std::filesystem::path& folder,
                                      const std::string& source,
                                      const problems::FoundProgram& program) {
  std::vector<OutputFile> files{{folder / "program.toml", program.problem}};
  for (const problems::ProgramLaw& law : program.laws) {
    const Json provenance{{"fitted_to", source}, {"law", "smoothing spline"}};
    files.push_back({folder / law.name, problems::law_text(law.law, law.title, provenance.dump())});
  }
  return files;
}

std::optional<problems::FoundProgram> program_of_lift(const problems::RecordedMotion& motion,
                                                      const problems::ProblemStatement* machine,
                                                      const std::optional<std::string>& out,
                                                      std::vector<std::string>& notes) {
  if (machine != nullptr) {
    try {
      problems::FoundProgram program = problems::found_program(motion, *machine);
      return out ? std::optional(std::move(program)) : std::nullopt;
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(
          fmt::format("--mechanism: the lift gives no program for {}: {}; leave --mechanism out to "
                      "find the laws alone",
                      machine->mechanism->name, error.what()));
    }
  }
  if (!out || problems::why_no_program(motion)) return {};
  const std::string usual = problems::usual_machine(motion.record.samples.unit);
  notes.push_back(fmt::format(
      "the lift does not tell its machine: program.toml takes {} with its default sizes; name "
      "another with --mechanism",
      usual));
  return problems::found_program(motion, problems::asked_machine(usual));
}

}  // namespace camlaw::cli
