// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "numerics/text/file_text.h"
#include "optim/study/recorded_executor.h"
#include "problems/fronts/front_study.h"
#include "tests/paths.h"

namespace camlaw::testing {

/// Writes a finished study of the spine cutter's front.
inline void make_cutter_study(const std::string& path, std::size_t points) {
  const std::string file = testing::source("problems/spine_cutter/front.toml");
  problems::FrontSettings settings;
  settings.points = points;
  const problems::FrontStudy study(problems::file_text(file, "problem file"), file, settings);
  optim::StudyRecord record = optim::StudyRecord::create(path, study.settings());
  optim::DirectExecutor direct(study.space(), study.options().solve);
  optim::RecordedExecutor recorded(study.space(), record, &direct);
  study.run(recorded);
}

}  // namespace camlaw::testing
