// SPDX-License-Identifier: MIT
// camlaw_fuzz TARGET [COUNT] [SEED]: spoilt files for a reader, any number of them. Ends with 1 at
// the first one that is neither read nor refused, or takes too long, and writes it to
// "spoilt.TARGET".
#include <cstdio>
#include <ctime>
#include <fstream>

#include "tests/fuzz/mutations.h"
#include "tests/fuzz/targets.h"

namespace camlaw::fuzz {
namespace {

constexpr double kLongest = 20;  // seconds of the processor for one file

/// What is wrong about how a file was taken; empty where nothing is.
std::string fault_of(const Target& target, const std::string& file) {
  const std::clock_t began = std::clock();
  try {
    target.read(file);
  } catch (const std::exception& error) {
    return error.what();
  }
  const double spent = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  return spent > kLongest ? "it takes too long" : "";
}

int run(const Target& target, long count, unsigned long seed) {
  const auto seeds = corpus(target);
  std::mt19937_64 random(seed);
  for (long i = 0; i < count; ++i) {
    const std::string file = mutated(seeds, target.is_text ? Shape::Text : Shape::Binary, random);
    const std::string fault = fault_of(target, file);
    if (fault.empty()) continue;
    std::ofstream("spoilt." + target.name, std::ios::binary) << file;
    std::printf("%s: file %ld of seed %lu: %s\n", target.name.c_str(), i, seed, fault.c_str());
    return 1;
  }
  std::printf("%s: %ld spoilt files of seed %lu were read or refused\n", target.name.c_str(), count,
              seed);
  return 0;
}

}  // namespace
}  // namespace camlaw::fuzz

int main(int count, char** words) {
  if (count < 2) {
    std::fputs("usage: camlaw_fuzz problem|table|law|result|samples|study [COUNT] [SEED]\n",
               stderr);
    return 2;
  }
  try {
    return camlaw::fuzz::run(camlaw::fuzz::find_target(words[1]),
                             count > 2 ? std::stol(words[2]) : 10000,
                             count > 3 ? std::stoul(words[3]) : 1);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "camlaw_fuzz: %s\n", error.what());
    return 2;
  }
}
