// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <latch>
#include <string>
#include <thread>
#include <vector>

/// What the tests of the library in several threads share.
namespace camlaw::testing {

/// What `work(i)` gives in `count` threads at once, i from 0.
inline std::vector<std::string> in_threads(int count, const std::function<std::string(int)>& work) {
  std::vector<std::string> results(static_cast<std::size_t>(count));
  std::vector<std::thread> threads;
  std::latch all_there(count);
  for (int i = 0; i < count; ++i) {
    threads.emplace_back([&, i] {
      all_there.arrive_and_wait();
      try {
        results[static_cast<std::size_t>(i)] = work(i);
      } catch (const std::exception& error) {
        results[static_cast<std::size_t>(i)] = std::string("threw: ") + error.what();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  return results;
}

}  // namespace camlaw::testing
