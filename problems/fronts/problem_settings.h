// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "optim/study/record.h"
#include "problems/statement/statement.h"

/// A problem as data that stands alone: what a record keeps of it, and what a process is sent that
/// works on it.
namespace camlaw::problems {

/// Of a problem that was read from `text`: that, its source, what was set beside it, the laws and
/// files that the text refers to, the versions of camlaw and its libraries.
optim::StudySettings problem_settings(const ProblemStatement& statement);
/// The problem of such settings. Throws std::invalid_argument where a law file is not what it was.
ProblemStatement stated_problem(const optim::StudySettings& settings);

/// The settings that only a sweep, and only a yield, has.
inline constexpr const char* kSweepSetting = "sweep";
inline constexpr const char* kYieldSetting = "yield";
/// What a study of such settings is of: "a sweep", "a yield", else "a front".
std::string_view kind_of_study(const optim::StudySettings& settings);

/// "camlaw 0.1.0, ipopt 3.11.9, ...".
std::string problem_versions();

/// Throws std::invalid_argument for settings that lack it.
const std::string& find_setting(const optim::StudySettings& settings, const char* name);
/// What was set beside the file; studies of earlier programs have none.
std::vector<std::string> set_of(const optim::StudySettings& settings);
/// The files beside the problem; studies of problems without any, and of earlier programs, have
/// none.
HeldFiles files_of(const optim::StudySettings& settings);
/// Throws std::invalid_argument where the laws of two settings differ.
void check_laws(const std::string& its, const std::string& now);

/// Throws std::invalid_argument: "the study cannot be resumed: " and why.
[[noreturn]] void refuse_to_resume(const std::string& why);
/// Refuses a study of another kind than `wanted`, and names the command that continues it.
void check_kind(const optim::StudySettings& its, std::string_view wanted);
/// Refuses a study that was made with another problem file.
void check_same_problem(const optim::StudySettings& its, const optim::StudySettings& mine);
/// Refuses one that was made with other laws, whose files beside the problem (laws, tables,
/// catalogues) held something else, or where one of these settings was another.
void check_same_settings(const optim::StudySettings& its, const optim::StudySettings& mine,
                         std::initializer_list<const char*> names);

}  // namespace camlaw::problems
