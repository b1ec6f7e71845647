// SPDX-License-Identifier: MIT
#include "fitting/motions/law_fit_service.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "fitting/motions/law_fit_samples.h"
#include "optim/crew/bytes.h"
#include "problems/fronts/problem_settings.h"
#include "problems/fronts/study_worker.h"
#include "problems/sweeps/sweep_worker.h"
#include "problems/tolerance/tolerance_worker.h"

namespace camlaw::problems {
namespace {

// Numbers of samples, of which there are many, go as they lie in memory: between processes of one
// version no other form is needed.

std::string as_bytes(const std::vector<double>& numbers) {
  std::string bytes(numbers.size() * sizeof(double), '\0');
  if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

std::vector<double> as_numbers(std::string_view bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  return numbers;
}

void visit_many(optim::Writer& archive, const std::vector<double>& numbers) {
  archive(as_bytes(numbers));
}

void visit_many(optim::Reader& archive, std::vector<double>& numbers) {
  std::string bytes;
  archive(bytes);
  numbers = as_numbers(bytes);
}

/// Two texts as one, of which the first need not be parsed.
struct Pair {
  std::string_view first, second;
};

std::string joined(const std::string& first, const std::string& second) {
  const std::uint64_t size = first.size();
  std::string result(sizeof size, '\0');
  std::memcpy(result.data(), &size, sizeof size);
  return result + first + second;
}

/// None where the text is not such a pair.
std::optional<Pair> pair_of(std::string_view text) {
  std::uint64_t size = 0;
  if (text.size() < sizeof size) return {};
  std::memcpy(&size, text.data(), sizeof size);
  text.remove_prefix(sizeof size);
  if (size > text.size()) return {};
  return Pair{text.substr(0, size), text.substr(size)};
}

}  // namespace
}  // namespace camlaw::problems

namespace camlaw::optim {

template <>
inline constexpr int kLast<Loss> = static_cast<int>(Loss::Cauchy);
template <>
inline constexpr int kLast<problems::Skew> = static_cast<int>(problems::Skew::Free);

// Each visit names every member, so that one which is added is not forgotten.

template <class Archive, class P>
requires std::is_same_v<std::remove_const_t<P>, FittedParameter>
void visit(Archive& archive, P& parameter) {
  auto& [name, unit, value, standard_deviation, low, high, at_bound, identifiable] = parameter;
  archive(name), archive(unit), archive(value), archive(standard_deviation), archive(low);
  archive(high), archive(at_bound), archive(identifiable);
}

template <class Archive, class D>
requires std::is_same_v<std::remove_const_t<D>, FreeDirection>
void visit(Archive& archive, D& direction) {
  auto& [parameters, changes] = direction;
  archive(parameters), archive(changes);
}

void visit(Writer& archive, const SquareMatrix& matrix) {
  archive(matrix.size());
  archive(std::vector<double>(matrix.data(), matrix.data() + matrix.size() * matrix.size()));
}

void visit(Reader& archive, SquareMatrix& matrix) {
  std::size_t size = 0;
  std::vector<double> entries;
  archive(size), archive(entries);
  if (size > entries.size() || entries.size() != size * size) return;
  matrix = SquareMatrix(size);
  std::copy(entries.begin(), entries.end(), matrix.data());
}

template <class Archive, class F>
requires std::is_same_v<std::remove_const_t<F>, FitResult>
void visit(Archive& archive, F& fit) {
  auto& [parameters, covariance, residuals, weights, sum_of_squares, rms, largest,
         degrees_of_freedom, sigma, loss_scale, merit, converged, followed, rank, condition,
         free_directions, iterations, evaluations, reason, reason_but_bounds] = fit;
  archive(parameters), archive(covariance);
  static_cast<void>(residuals), static_cast<void>(weights);  // they go before the bytes
  archive(sum_of_squares), archive(rms), archive(largest), archive(degrees_of_freedom);
  archive(sigma), archive(loss_scale), archive(merit), archive(converged), archive(followed);
  archive(rank), archive(condition), archive(free_directions), archive(iterations);
  archive(evaluations), archive(reason), archive(reason_but_bounds);
}

}  // namespace camlaw::optim

namespace camlaw::problems {

struct SamplesOfOrders {
  MotionSamples samples;
  MotionGuess guess;
  optim::Loss loss = optim::Loss::None;
  std::optional<double> loss_scale;
  double confidence = 0;
};

/// What is asked beside these.
struct LawFitOrder {
  std::string family;
  std::vector<std::vector<double>> arguments;
  Skew skew = Skew::Held;
  std::optional<MotionGuess> like;
  std::optional<double> least_sum;
};

template <class Archive, class S>
requires std::is_same_v<std::remove_const_t<S>, MotionSamples>
void visit(Archive& archive, S& samples) {
  auto& [place, value, order, place_unit, unit, length_unit, resolution, each, left_out, lacking] =
      samples;
  visit_many(archive, place), visit_many(archive, value);
  archive(order), archive(place_unit), archive(unit);
  archive(length_unit), archive(resolution), archive(each), archive(left_out), archive(lacking);
}

template <class Archive, class G>
requires std::is_same_v<std::remove_const_t<G>, MotionGuess>
void visit(Archive& archive, G& guess) {
  auto& [begin, end, from, to] = guess;
  archive(begin), archive(end), archive(from), archive(to);
}

template <class Archive, class O>
requires std::is_same_v<std::remove_const_t<O>, SamplesOfOrders>
void visit(Archive& archive, O& of) {
  auto& [samples, guess, loss, loss_scale, confidence] = of;
  archive(samples), archive(guess), archive(loss), archive(loss_scale), archive(confidence);
}

template <class Archive, class O>
requires std::is_same_v<std::remove_const_t<O>, LawFitOrder>
void visit(Archive& archive, O& of) {
  auto& [family, arguments, skew, like, least_sum] = of;
  archive(family), archive(arguments), archive(skew), archive(like);
  archive(least_sum);
}

/// Without the family, which whoever ordered the fit knows.
template <class Archive, class F>
requires std::is_same_v<std::remove_const_t<F>, LawFit>
void visit(Archive& archive, F& of) {
  auto& [law, fit, skew, base, numbers, criterion, weight, begin, end, from, to, inflation] = of;
  archive(law.arguments.values()), archive(fit), archive(skew), archive(base), archive(numbers);
  archive(criterion), archive(weight), archive(begin), archive(end), archive(from), archive(to);
  archive(inflation);
}

std::string samples_of_orders(const MotionSamples& samples, const MotionGuess& guess,
                              const LawFitOptions& options) {
  return optim::bytes_of(
      SamplesOfOrders{samples, guess, options.loss, options.loss_scale, options.confidence});
}

std::string law_fit_order(const std::string& samples, const Member& law,
                          const LawFitOptions& options) {
  return joined(samples,
                optim::bytes_of(LawFitOrder{law.family->name, law.arguments.values(), options.skew,
                                            options.like, options.least_sum}));
}

std::optional<LawFit> law_fit_answer(const std::string& answer, const Member& law) {
  const auto pair = pair_of(answer);
  optim::Reader reader(pair ? pair->second : "");
  bool is_possible = false;
  reader(is_possible);
  LawFit fit{law, {}};
  if (is_possible) reader(fit);
  if (!reader.ended_well()) {
    throw std::runtime_error("the process of this fit answered with something that is not a fit");
  }
  if (!is_possible) return std::nullopt;
  // Residuals first, then as many weights.
  fit.fit.residuals = as_numbers(pair->first);
  const auto middle =
      fit.fit.residuals.begin() + static_cast<std::ptrdiff_t>(fit.fit.residuals.size() / 2);
  fit.fit.weights.assign(middle, fit.fit.residuals.end());
  fit.fit.residuals.erase(middle, fit.fit.residuals.end());
  return fit;
}

namespace {

/// The samples of the order before, which most orders have too.
struct Kept {
  std::string bytes;
  LawFitOptions options;
  std::unique_ptr<const LawFitSamples> samples;

  /// False where the bytes are not such samples.
  bool take(std::string_view own) {
    if (samples && own == bytes) return true;
    const auto of = optim::value_of_bytes<SamplesOfOrders>(own);
    if (!of || of->samples.place.size() != of->samples.value.size()) return false;
    samples = std::make_unique<LawFitSamples>(of->samples, of->guess, of->loss);
    options.loss = of->loss;
    options.loss_scale = of->loss_scale;
    options.confidence = of->confidence;
    bytes = own;
    return true;
  }
};

}  // namespace

optim::Service law_fit_service(const std::vector<Member>& laws) {
  std::map<std::string, FamilyOf> own;
  for (const Member& law : laws) own.emplace(law.family->name, law.family);
  return [own, kept = std::make_shared<Kept>()](
             const std::string& order, const optim::Bench& bench) -> std::optional<std::string> {
    const auto pair = pair_of(order);
    auto of = optim::value_of_bytes<LawFitOrder>(pair ? pair->second : "");
    if (!of || !kept->take(pair->first)) return "";
    const auto at = own.find(of->family);
    const Member law{at != own.end() ? at->second : FamilyOf(&find_family(of->family)),
                     Arguments<double>(std::move(of->arguments))};
    LawFitOptions options = kept->options;
    options.skew = of->skew;
    options.like = of->like;
    options.least_sum = of->least_sum;
    options.stop = bench.stop;
    const auto fit = possible_law_fit(*kept->samples, law, options);
    optim::Writer writer;
    writer(bool(fit));
    if (!fit) return joined("", writer.take());
    writer(*fit);
    return joined(as_bytes(fit->fit.residuals) + as_bytes(fit->fit.weights), writer.take());
  };
}

namespace {

std::string fits_of(const std::string& versions) {
  return optim::bytes_of(std::vector<std::string>{"fits of laws", versions});
}

}  // namespace

optim::WorkerProgram law_fit_program() { return {worker_path(), fits_of(problem_versions())}; }

optim::Service service_of_worker_or_fits(const std::string& problem) {
  if (problem == fits_of(problem_versions())) return law_fit_service({});
  if (auto sweep = service_of_sweep(problem)) return *sweep;
  if (auto tolerance = service_of_tolerance(problem)) return *tolerance;
  return service_of_worker(problem);
}

}  // namespace camlaw::problems
