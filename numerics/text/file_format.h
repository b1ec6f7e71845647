// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace camlaw {

/// What a file says that it is, "camlaw law 1": a kind and the version of its format.
struct FileFormat {
  std::string_view kind;  ///< "camlaw law"
  int version;            ///< the newest that this program knows; older ones are read

  std::string text() const;
  /// Throws std::invalid_argument for another kind, and for a version that is newer than this
  /// program's.
  void check(std::string_view stated) const;
};

}  // namespace camlaw
