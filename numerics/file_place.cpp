// SPDX-License-Identifier: MIT
#include "numerics/file_place.h"

#include <list>

namespace camlaw {

namespace fs = std::filesystem;

fs::path file_place(const fs::path& path, std::error_code& error) {
  constexpr int kMostLinks = 40;  // as the kernel follows
  error.clear();
  const fs::path whole = fs::absolute(path, error);
  if (error) return path;
  fs::path place = whole.root_path();
  const fs::path relative = whole.relative_path();
  std::list<fs::path> left(relative.begin(), relative.end());
  int links = 0;
  while (!left.empty()) {
    const fs::path name = left.front();
    left.pop_front();
    if (name == "." || (name.empty() && !left.empty())) continue;
    if (name == "..") {
      place = place.parent_path();
      continue;
    }
    const fs::path next = place / name;
    std::error_code ignored;  // what cannot be looked at is no link
    if (!fs::is_symlink(fs::symlink_status(next, ignored))) {
      place = next;
      continue;
    }
    if (++links > kMostLinks) {
      error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
      return path;
    }
    const fs::path target = fs::read_symlink(next, error);
    if (error) return path;
    if (target.is_absolute()) place = target.root_path();
    const fs::path way = target.relative_path();
    left.insert(left.begin(), way.begin(), way.end());
  }
  return place;
}

fs::path file_place(const fs::path& path) {
  std::error_code error;
  fs::path place = file_place(path, error);
  return error ? path : place;
}

}  // namespace camlaw
