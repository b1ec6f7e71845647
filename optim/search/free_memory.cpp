// SPDX-License-Identifier: MIT
#include "optim/search/free_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include "optim/search/memory.h"

namespace camlaw::optim {
namespace {

namespace fs = std::filesystem;

constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// The first number of a file; unknown where there is none, as where it says "max".
double number_in(const fs::path& path) {
  std::ifstream file(path);
  double value = 0;
  return file >> value ? value : kUnknown;
}

/// What the kernel could give without taking from others.
double free_of_machine() {
  std::ifstream file("/proc/meminfo");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string name;
    double kibibytes = 0;
    if (words >> name >> kibibytes && name == "MemAvailable:") return 1024 * kibibytes;
  }
  return kUnknown;
}

/// Of what a group has taken, the pages of files that it would give back.
double cached(const fs::path& folder, const std::string& prefix) {
  double result = 0;
  std::ifstream file(folder / "memory.stat");
  std::string name;
  for (double bytes = 0; file >> name >> bytes;) {
    if (name == prefix + "inactive_file" || name == prefix + "active_file") result += bytes;
  }
  return result;
}

/// What is left in a control group and in those around it; the names of its files, and what those
/// in memory.stat begin with.
double free_of_group(const fs::path& root, fs::path group, const char* most, const char* used,
                     const char* prefix) {
  double result = kUnknown;
  while (true) {
    const fs::path folder = root / group.relative_path();
    const double limit = number_in(folder / most), taken = number_in(folder / used);
    if (std::isfinite(limit) && std::isfinite(taken)) {
      result = std::min(result, limit - std::max(0.0, taken - cached(folder, prefix)));
    }
    if (!group.has_relative_path()) return result;
    group = group.parent_path();
  }
}

double free_of_groups() {
  double result = kUnknown;
  std::ifstream file("/proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {  // "0::/path" or "4:memory:/path"
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string kinds = line.substr(first + 1, second - first - 1);
    const fs::path group = line.substr(second + 1);
    if (kinds.empty()) {
      result = std::min(result,
                        free_of_group("/sys/fs/cgroup", group, "memory.max", "memory.current", ""));
    } else if (("," + kinds + ",").find(",memory,") != std::string::npos) {
      result =
          std::min(result, free_of_group("/sys/fs/cgroup/memory", group, "memory.limit_in_bytes",
                                         "memory.usage_in_bytes", "total_"));
    }
  }
  return result;
}

/// What is left of the address space (ulimit -v).
double free_of_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnknown;
  const double pages = number_in("/proc/self/statm");
  const double used = std::isfinite(pages) ? pages * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0;
  return static_cast<double>(limit.rlim_cur) - used;
}

}  // namespace

double free_memory() {
  const double free = std::min({free_of_machine(), free_of_groups(), free_of_address_space()});
  return std::max(0.0, free);
}

int workers_with_room(int workers, const Problem& problem, double allowed) {
  const MemoryNeed need = check_memory(problem, allowed);
  const double room = std::floor(allowed / std::max(need.bytes, 1.0));
  return static_cast<int>(std::min<double>(workers, room));
}

}  // namespace camlaw::optim
