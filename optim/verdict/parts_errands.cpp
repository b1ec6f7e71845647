// SPDX-License-Identifier: MIT
#include "optim/verdict/parts_errands.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "optim/crew/bytes.h"

namespace camlaw::optim {

// Each visit names every member, so that one which is added is not forgotten.

template <class Archive, class M>
requires std::is_same_v<std::remove_const_t<M>, Mixture>
void visit(Archive& archive, M& mixture) {
  auto& [centres, shares, spreads] = mixture;
  archive(centres), archive(shares), archive(spreads);
}

template <class Archive, class D>
requires std::is_same_v<std::remove_const_t<D>, PartsDraw>
void visit(Archive& archive, D& draw) {
  auto& [mixture, about, seed, from, count] = draw;
  archive(mixture), archive(about), archive(seed), archive(from), archive(count);
}

template <class Archive, class T>
requires std::is_same_v<std::remove_const_t<T>, Tally>
void visit(Archive& archive, T& tally) {
  auto& [sum, squares, largest, hits] = tally;
  archive(sum), archive(squares), archive(largest), archive(hits);
}

template <class Archive, class C>
requires std::is_same_v<std::remove_const_t<C>, PartsCount>
void visit(Archive& archive, C& counted) {
  auto& [failing, doubtful, by_limit, impossible, samples] = counted;
  archive(failing), archive(doubtful), archive(by_limit), archive(impossible), archive(samples);
}

namespace {

/// Whether a draw is one that the drawer knows how to make.
bool fits(const PartsDraw& draw, const PartsDrawer& drawer) {
  const auto& [centres, shares, spreads] = draw.mixture;
  return draw.about < centres.size() && shares.size() == centres.size() &&
         spreads.size() == centres.size() &&
         std::all_of(centres.begin(), centres.end(),
                     [&](const auto& u) { return u.size() == drawer.dimensions(); });
}

/// Draws that are sent together.
using Batch = std::vector<PartsDraw>;

/// As many batches as keep some fifty processes busy: each costs a fraction of a millisecond to
/// send, and a draw may take as little.
std::vector<Batch> batches_of(const std::vector<PartsDraw>& draws) {
  constexpr std::size_t kMost = 512;
  const std::size_t size = (draws.size() + kMost - 1) / kMost;
  std::vector<Batch> batches;
  for (std::size_t first = 0; first < draws.size(); first += size) {
    const auto begin = draws.begin() + static_cast<std::ptrdiff_t>(first);
    const std::size_t count = std::min(size, draws.size() - first);
    batches.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(count));
  }
  return batches;
}

/// The draws of a round.
class Draws final : public Errands {
 public:
  /// `share`: the share of the whole work that was done before, and that of the round.
  Draws(const std::vector<PartsDraw>& draws, std::pair<double, double> share, std::size_t limits,
        const std::function<bool()>& stopped)
      : batches_(batches_of(draws)),
        share_(share),
        limits_(limits),
        stopped_(stopped),
        counted_(batches_.size()) {}

  std::optional<std::size_t> next() override {
    if (next_ == batches_.size() || is_done()) return {};
    return next_++;
  }
  std::optional<std::string> order(std::size_t number) override {
    return bytes_of(batches_[number]);
  }
  void answered(std::size_t number, const std::string& answer) override {
    if (answer.empty() && stopped_()) return;  // it was cut short
    auto counted = counts_in(number, answer);
    if (!counted) {
      return lost(number, "the process answered with something that is not a count of parts");
    }
    counted_[number] = std::move(*counted);
  }
  bool is_answer(std::size_t number, const std::string& answer) const override {
    return counts_in(number, answer).has_value();
  }
  void lost(std::size_t, const std::string& why) override { failure_ = why; }
  double share() const override {
    const auto given = static_cast<double>(next_) / static_cast<double>(batches_.size());
    return share_.first + share_.second * given;
  }
  bool is_done() const override { return !failure_.empty() || stopped_(); }

  /// Those that were counted before the first that was not.
  std::vector<PartsCount> in_order() {
    if (!failure_.empty()) throw std::runtime_error(fmt::format("yield: {}", failure_));
    std::vector<PartsCount> result;
    for (auto& batch : counted_) {
      if (batch.empty()) break;
      for (PartsCount& one : batch) result.push_back(std::move(one));
    }
    return result;
  }

 private:
  /// None where it is not a count of these draws.
  std::optional<std::vector<PartsCount>> counts_in(std::size_t number,
                                                   const std::string& answer) const {
    auto counted = value_of_bytes<std::vector<PartsCount>>(answer);
    const auto fits = [&](const PartsCount& one, const PartsDraw& draw) {
      return one.by_limit.size() == limits_ && one.samples == draw.count;
    };
    const Batch& batch = batches_[number];
    const bool is_whole = counted && counted->size() == batch.size() &&
                          std::equal(counted->begin(), counted->end(), batch.begin(), fits);
    if (!is_whole) return {};
    return counted;
  }

  std::vector<Batch> batches_;
  std::pair<double, double> share_;
  std::size_t limits_;
  const std::function<bool()>& stopped_;
  std::size_t next_ = 0;
  std::vector<std::vector<PartsCount>> counted_;  ///< of each batch; empty: not yet
  std::string failure_;
};

}  // namespace

Service parts_service(const PartsDrawer& drawer) {
  return [&drawer](const std::string& order, const Bench& bench) -> std::optional<std::string> {
    const auto draws = value_of_bytes<Batch>(order);
    if (!draws) return "";
    const auto stopped = [&] { return bench.stop != nullptr && bench.stop->load(); };
    std::vector<PartsCount> counted;
    for (const PartsDraw& draw : *draws) {
      auto one = fits(draw, drawer) ? drawer.count(draw, stopped) : std::nullopt;
      if (!one) return "";
      counted.push_back(std::move(*one));
    }
    return bytes_of(counted);
  };
}

CountParts counted_by(const Hands& hands, const PartsDrawer& drawer, std::size_t planned,
                      const std::function<bool()>& stopped) {
  // Counted over all rounds.
  const auto done = std::make_shared<std::size_t>(0);
  return [&, planned, done](const std::vector<PartsDraw>& draws) {
    std::size_t parts = 0;
    for (const PartsDraw& draw : draws) parts += draw.count;
    const auto all = static_cast<double>(std::max(planned, *done + parts));
    const double before = static_cast<double>(*done) / all;
    Draws errands(draws, {before, static_cast<double>(parts) / all}, drawer.limits(), stopped);
    hands(errands, parts_service(drawer));
    *done += parts;
    return errands.in_order();
  };
}

}  // namespace camlaw::optim
