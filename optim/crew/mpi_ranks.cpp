// SPDX-License-Identifier: MIT
#include "optim/crew/mpi_ranks.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <condition_variable>
#include <csignal>
#include <deque>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "numerics/own_files.h"
#include "optim/crew/bytes.h"
#include "optim/crew/mpi_plugin.h"

#define CAMLAW_TEXT_OF(name) #name
#define CAMLAW_TEXT(name) CAMLAW_TEXT_OF(name)

namespace camlaw::optim {
namespace {

constexpr const char* kMpiPlugin = "camlaw-mpi.so";

/// What a message is, by its first letter.
constexpr char kProblem = 'p', kOrders = 'o', kCancel = 'c', kEnd = 'e';
constexpr char kAnswers = 'a', kRefusal = 'r';

/// Between looks for messages, as MPI's own waiting keeps a core busy.
constexpr std::chrono::microseconds kBetweenLooks{200};

/// Orders on their way out, answers on their way back.
struct Parcel {
  std::size_t number = 0;
  std::vector<std::string> texts = {};
  double seconds = 0;
};

template <class Archive, class P>
requires std::is_same_v<std::remove_const_t<P>, Parcel>
void visit(Archive& archive, P& p) { archive(p.number), archive(p.texts), archive(p.seconds); }

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string name_of_this(int rank) {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  return fmt::format("rank {} on {}", rank, host.data());
}

/// One parcel after the other, carried out by a thread while another one listens.
class RankBench {
 public:
  explicit RankBench(Service service) : service_(std::move(service)) {}
  RankBench(const RankBench&) = delete;
  RankBench& operator=(const RankBench&) = delete;
  ~RankBench() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    cancel();
    changed_.notify_all();
    thread_.join();
  }

  void put(Parcel parcel) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(parcel));
    changed_.notify_all();
  }
  /// Drops what waits, and has what is under way end early.
  void cancel() {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
    if (busy_) stop_ = true;
  }
  /// What has been carried out; waits for it a little.
  std::deque<Parcel> take() {
    std::unique_lock lock(mutex_);
    done_changed_.wait_for(lock, kBetweenLooks, [this] { return !done_.empty(); });
    return std::exchange(done_, {});
  }

 private:
  /// What is not an answer is a search that is lost.
  std::string answer_to(const std::string& order) {
    try {
      return service_(order, {.stop = &stop_}).value_or("");
    } catch (const std::exception&) {
      return "";
    }
  }

  void work() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
      if (ended_) return;
      Parcel parcel = std::move(waiting_.front());
      waiting_.pop_front();
      stop_ = false;
      busy_ = true;
      lock.unlock();
      const double began = seconds_now();
      for (std::string& text : parcel.texts) text = answer_to(text);
      parcel.seconds = seconds_now() - began;
      lock.lock();
      busy_ = false;
      if (!stop_) done_.push_back(std::move(parcel));
      done_changed_.notify_all();
    }
  }

  Service service_;
  std::mutex mutex_;
  std::condition_variable changed_, done_changed_;
  std::deque<Parcel> waiting_, done_;
  bool ended_ = false, busy_ = false;
  std::atomic<bool> stop_{false};
  std::thread thread_{[this] { work(); }};
};

}  // namespace

struct MpiRanks::Plugin {
  CamlawMpi mpi{};
};

MpiRanks::MpiRanks() : plugin_(std::make_unique<Plugin>()) {
  const auto path = own_file(kMpiPlugin);
  if (!path) {
    throw std::runtime_error(
        fmt::format("MPI is a plug-in, {}, which is not installed: it is built where MPI is, such "
                    "as by the packages of packages-mpi.txt; the Debian package camlaw-mpi has it",
                    kMpiPlugin));
  }
  // Global, as an MPI loads parts of its own that look for what it has. Its own libraries first
  // (DEEPBIND): the sequential MUMPS of Ipopt brings functions by MPI's names that know one rank.
  void* plugin = dlopen(path->c_str(), RTLD_NOW | RTLD_GLOBAL | RTLD_DEEPBIND);
  void* open = plugin != nullptr ? dlsym(plugin, CAMLAW_TEXT(CAMLAW_MPI)) : nullptr;
  if (open == nullptr) throw std::runtime_error(fmt::format("{}: {}", kMpiPlugin, dlerror()));
  if (const char* error = reinterpret_cast<CamlawMpiOpen>(open)(&plugin_->mpi)) {
    throw std::runtime_error(error);
  }
  under_way_.resize(static_cast<std::size_t>(size()));
  heard_.resize(under_way_.size());
}

MpiRanks::~MpiRanks() {
  if (rank() == 0) {
    for (int other = 1; other < size(); ++other) tell(other, {kEnd});
  }
  plugin_->mpi.close();
}

int MpiRanks::rank() const { return plugin_->mpi.rank; }
int MpiRanks::size() const { return plugin_->mpi.size; }

std::optional<std::pair<int, std::string>> MpiRanks::message() {
  int rank = 0;
  std::size_t count = 0;
  if (plugin_->mpi.probe(&rank, &count) == 0) return {};
  std::string bytes(count, '\0');
  if (const char* error = plugin_->mpi.receive(bytes.data())) throw std::runtime_error(error);
  return std::pair{rank, std::move(bytes)};
}

/// Where a rank is gone look_for_the_gone() tells.
void MpiRanks::tell(int rank, const std::string& bytes) {
  plugin_->mpi.send(rank, bytes.data(), bytes.size());
}

void MpiRanks::serve(const std::function<Service(const std::string&)>& service_of) {
  // An interrupt is sent to all ranks at once, and is for rank 0 to handle.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  std::unique_ptr<RankBench> bench;
  std::string refusal;
  while (true) {
    if (bench) {
      for (const Parcel& done : bench->take()) tell(0, kAnswers + bytes_of(done));
    } else {
      std::this_thread::sleep_for(kBetweenLooks);
    }
    const auto arrived = message();
    if (!arrived) continue;
    const std::string_view bytes = arrived->second;
    const std::string content(bytes.substr(1));
    switch (bytes[0]) {
      case kEnd:
        return;
      case kCancel:
        if (bench) bench->cancel();
        break;
      case kProblem:
        bench.reset();
        refusal.clear();
        try {
          bench = std::make_unique<RankBench>(service_of(content));
        } catch (const std::exception& error) {
          refusal = fmt::format("{}: {}", name_of_this(rank()), error.what());
        }
        break;
      case kOrders:
        if (auto parcel = value_of_bytes<Parcel>(content); parcel && bench) {
          bench->put(std::move(*parcel));
        } else {
          tell(0, kRefusal + bytes_of(Parcel{parcel ? parcel->number : 0, {refusal}}));
        }
        break;
      default:
        break;
    }
  }
}

void MpiRanks::give(const std::string& problem) {
  if (size() < 2) {
    throw std::runtime_error(
        "MPI has started one process alone, which would wait for others: start at least two, as in "
        "'mpirun -n 3 camlaw pareto FILE --executor mpi'");
  }
  for (int other = 1; other < size(); ++other) tell(other, kProblem + problem);
}

std::size_t MpiRanks::workers() {
  std::size_t count = 0;
  for (int other = 1; other < size(); ++other) count += plugin_->mpi.is_gone(other) == 0;
  return count;
}

void MpiRanks::send(std::size_t parcel, const std::vector<std::string>& orders) {
  int least = 0;
  for (int other = 1; other < size(); ++other) {
    if (plugin_->mpi.is_gone(other) != 0) continue;
    const auto load = [&](int rank) {
      const auto r = static_cast<std::size_t>(rank);
      return std::pair(under_way_[r].size(), -heard_[r]);  // a rank that hangs is not heard
    };
    if (least == 0 || load(other) < load(least)) least = other;
  }
  if (least == 0) throw std::runtime_error("every rank but this one has ended");
  under_way_[least].push_back(parcel);
  tell(least, kOrders + bytes_of(Parcel{parcel, orders}));
}

void MpiRanks::take(int rank, const std::string& bytes, std::vector<Arrival>& arrived) {
  auto parcel = value_of_bytes<Parcel>(std::string_view(bytes).substr(1));
  if (!parcel)
    throw std::runtime_error(fmt::format("rank {} sent something that is not an answer", rank));
  std::erase(under_way_[static_cast<std::size_t>(rank)], parcel->number);
  heard_[static_cast<std::size_t>(rank)] = now();
  Arrival arrival{.parcel = parcel->number, .seconds = parcel->seconds};
  if (bytes[0] == kRefusal) {
    arrival.refused = parcel->texts.at(0);
  } else {
    arrival.answers = std::move(parcel->texts);
  }
  arrived.push_back(std::move(arrival));
}

void MpiRanks::look_for_the_gone(std::vector<Arrival>& arrived) {
  for (int other = 1; other < size(); ++other) {
    std::vector<std::size_t>& lost = under_way_[static_cast<std::size_t>(other)];
    if (lost.empty() || plugin_->mpi.is_gone(other) == 0) continue;
    const bool is_alone = lost.size() == 1;
    for (const std::size_t parcel : lost) {
      arrived.push_back(
          {.parcel = parcel, .died = fmt::format("rank {} has ended", other), .shared = !is_alone});
    }
    lost.clear();
  }
}

std::vector<Arrival> MpiRanks::wait(double seconds) {
  std::vector<Arrival> arrived;
  const double until = now() + seconds;
  while (true) {
    while (const auto next = message()) take(next->first, next->second, arrived);
    look_for_the_gone(arrived);
    if (!arrived.empty() || now() >= until) return arrived;
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

void MpiRanks::cancel() {
  for (int other = 1; other < size(); ++other) tell(other, {kCancel});
  for (auto& parcels : under_way_) parcels.clear();
}

double MpiRanks::now() const { return seconds_now(); }

}  // namespace camlaw::optim
