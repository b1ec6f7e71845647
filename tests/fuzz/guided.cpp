// SPDX-License-Identifier: MIT
// camlaw_guided TARGET FOLDER|FILE [-option=value ...]: spoilt files for a reader, looked for by
// libFuzzer, which keeps what reaches code that no file before it has reached in FOLDER. The
// project's own files are put there first. A FILE, such as one that was found, is read alone. The
// options are libFuzzer's (-help=1); what a reader may
// not throw, an error of a sanitizer, 20 s and 1 GB are faults, and the file is written beside.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/fuzz/targets.h"
#include "tests/temporary_folder.h"

namespace camlaw::fuzz {
namespace {

constexpr const char* kLimits[] = {"-timeout=20", "-rss_limit_mb=1024"};

/// libFuzzer's callback knows nothing but bytes.
const Target* chosen = nullptr;

void put_seeds(const Target& target, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const std::string& bytes : corpus(target)) {
    testing::write(folder / ("seed" + std::to_string(++number) + target.ending), bytes);
  }
}

/// What libFuzzer is to be called with in place of our words.
std::vector<std::string> libfuzzer_words(int count, char** words) {
  if (count < 3) {
    throw std::invalid_argument(
        "usage: camlaw_guided problem|law|result|samples|study FOLDER|FILE [-option=value ...]");
  }
  chosen = &find_target(words[1]);
  if (!std::filesystem::is_regular_file(words[2])) put_seeds(*chosen, words[2]);
  std::vector<std::string> own{words[0], words[2]};
  own.insert(own.end(), std::begin(kLimits), std::end(kLimits));
  own.insert(own.end(), words + 3, words + count);
  return own;
}

}  // namespace
}  // namespace camlaw::fuzz

// libFuzzer has the program's beginning and calls these two.

extern "C" int LLVMFuzzerInitialize(int* count, char*** words) {
  static std::vector<std::string> own;
  static std::vector<char*> pointers;
  try {
    own = camlaw::fuzz::libfuzzer_words(*count, *words);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "camlaw_guided: %s\n", error.what());
    std::exit(2);
  }
  for (std::string& word : own) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  *count = static_cast<int>(own.size());
  *words = pointers.data();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // What it throws ends the program, which is a fault that libFuzzer records.
  camlaw::fuzz::chosen->read({reinterpret_cast<const char*>(data), size});
  return 0;
}
