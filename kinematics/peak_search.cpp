// SPDX-License-Identifier: MIT
#include "kinematics/peak_search.h"

#include "numerics/polynomial/bernstein.h"

namespace camlaw::detail {
namespace {

/// Boxes this narrow are closed as they are: what is left inside is below rounding.
constexpr double kSmallestBox = 1e-12;

/// Rounding in a high degree's Bernstein form is divided away down to boxes of this width.
constexpr double kNoisyBox = 0.002;

/// No law of use needs so many boxes; past it what is open keeps its range as the answer.
constexpr std::size_t kMostBoxes = 100000;

Questions all_questions() {
  Questions result;
  for (std::size_t i = 0; i < kQuantities; ++i) {
    result[2 * i] = {.quantity = static_cast<Quantity>(i), .sign = 1};
    result[2 * i + 1] = {.quantity = static_cast<Quantity>(i), .sign = -1};
  }
  return result;
}

template <class T>
class PeakSearch {
 public:
  PeakSearch(const Law<T>& law, const Law<double>& plain, double tolerance)
      : law_(law), plain_(plain), questions_(all_questions()), tolerance_(tolerance) {}

  Questions run(std::span<const double> places) {
    for (piece_ = 0; piece_ < law_.pieces().size(); ++piece_) {
      look_at_end(Where::Begin);
      look_at_end(Where::End);
    }
    for (const double x : places) look_at(x);
    for (piece_ = 0; piece_ < law_.pieces().size(); ++piece_) {
      const Piece<T>& piece = law_.pieces()[piece_];
      highest_frequency_ = 0;
      for (const auto& h : piece.harmonics) {
        highest_frequency_ = std::max(highest_frequency_, size(h.frequency));
      }
      unsigned open = (1u << questions_.size()) - 1;
      if (closed_moment(piece, 0.5)) open &= ~kMomentQuestions;  // linear: its ends were seen
      divide(lower(piece.begin), upper(piece.end), open);
    }
    return questions_;
  }

 private:
  static constexpr unsigned kMomentQuestions = 3u << (2 * (kQuantities - 1));

  /// The quantity's largest finite size as known so far: where one side has no bound, the other is
  /// still found to its own accuracy.
  double scale(std::size_t i) const {
    // An interval rounds infinity outwards to the largest double, which counts as infinite here.
    const auto finite = [](double x) { return std::abs(x) < 1e300 ? std::abs(x) : 0.0; };
    return std::max(finite(questions_[i].known), finite(questions_[i ^ 1].known));
  }

  static void propose(Extremum& best, Extremum candidate, double margin) {
    const bool first = best.value == -kUnbounded && !std::isnan(candidate.value);
    if (first || candidate.value > best.value + margin) best = candidate;
  }

  void look_at_end(Where where) {
    const Piece<T>& piece = law_.pieces()[piece_];
    const T x = where == Where::Begin ? piece.begin : piece.end;
    const auto d = derivatives<6>(piece, x);
    for (std::size_t i = 0; i < questions_.size(); ++i) {
      Question& question = questions_[i];
      T value = quantity_from(question.quantity, d)[0];
      if (question.quantity == Quantity::Moment) {
        if (const auto moment = closed_moment(piece, x)) value = *moment;
      }
      value = T(question.sign) * value;
      question.known = std::max(question.known, lower(value));
      question.ceiling = std::max(question.ceiling, upper(value));
      propose(question.peak, {value_of(value), value_of(x), piece_, where}, 1e-15 * scale(i));
    }
  }

  /// Whether x lies in the piece wherever in their intervals its ends are.
  bool is_inside(double x) const {
    const Piece<T>& piece = law_.pieces()[piece_];
    return x >= upper(piece.begin) && x <= lower(piece.end);
  }

  /// Takes the values at a point inside a piece as reached.
  void look_at(double x) {
    piece_ = plain_.piece_at(x, Side::Right);
    if (!is_inside(x)) return;
    const auto d = derivatives<6>(law_.pieces()[piece_], T(x));
    for (Question& question : questions_) {
      const T value = T(question.sign) * quantity_from(question.quantity, d)[0];
      question.known = std::max(question.known, lower(value));
      propose(question.sample, {value_of(value), x, piece_, Where::Sample}, 0);
    }
  }

  /// Answers the open questions on [low, high], dividing while some stay open.
  void divide(double low, double high, unsigned open) {
    const Box box(low, high);
    if (box.radius * highest_frequency_ <= kWidestAngle) {
      models_.expand(law_.pieces()[piece_], box);
      for (std::size_t q = 0; q < kQuantities; ++q) {
        const unsigned pair = open >> (2 * q) & 3u;
        if (pair != 0) open &= ~(answer(q, pair, box) << (2 * q));
      }
    }
    if (open == 0) return;
    if (++boxes_ > kMostBoxes || box.high - box.low <= kSmallestBox) return give_up(box, open);
    divide(low, box.middle, open);
    divide(box.middle, high, open);
  }

  /// Takes the ranges over a box as the upper bounds.
  void give_up(const Box& box, unsigned open) {
    models_.expand(law_.pieces()[piece_], box);
    for (std::size_t i = 0; i < questions_.size(); ++i) {
      if ((open >> i & 1u) == 0) continue;
      const Interval range = models_.range(questions_[i].quantity);
      const double bound = questions_[i].sign > 0 ? range.upper() : -range.lower();
      questions_[i].ceiling =
          std::isnan(bound) ? kUnbounded : std::max(questions_[i].ceiling, bound);
    }
  }

  /// Which of a quantity's two questions (bits of `open`) the box answers.
  unsigned answer(std::size_t q, unsigned open, const Box& box) {
    const Interval range = models_.range(static_cast<Quantity>(q));
    unsigned left = open;
    if (close(2 * q, range.upper())) left &= ~1u;
    if (close(2 * q + 1, -range.lower())) left &= ~2u;
    if (left == 0) return open;
    const TaylorModel<T>& model = models_.quantity(static_cast<Quantity>(q));
    bernstein_ = model.c;
    rounding_ = to_bernstein(bernstein_);
    for (unsigned side = 0; side < 2; ++side) {
      if ((left >> side & 1u) != 0 && answer_by_course(2 * q + side, model, box)) {
        left &= ~(1u << side);
      }
    }
    return open & ~left;
  }

  /// Closes a box whose upper bound is as good as reached.
  bool close(std::size_t i, double bound) {
    Question& question = questions_[i];
    if (!(bound <= question.known + tolerance_ * scale(i))) return false;
    question.ceiling = std::max(question.ceiling, bound);
    return true;
  }

  bool answer_by_course(std::size_t i, const TaylorModel<T>& model, const Box& box) {
    Question& question = questions_[i];
    // The middle is reached; its Taylor coefficient is the value itself.
    const T middle = T(question.sign) * model.c[0];
    question.known = std::max(question.known, lower(middle));
    propose(question.sample, {value_of(middle), box.middle, piece_, Where::Sample}, 0);
    reach_ends(i, box);
    T highest = T(question.sign) * bernstein_.front();
    double bound = upper(highest), noise = upper(highest) - lower(highest);
    for (const T& b : bernstein_) {
      const T value = T(question.sign) * b;
      bound = std::max(bound, upper(value));
      noise = std::max(noise, upper(value) - lower(value));
    }
    bound += rounding_;
    noise += 2 * rounding_;
    if (close(i, upper(T(bound) + T(model.remainder)))) return true;
    const double tolerance = tolerance_ * scale(i);
    if (model.remainder <= 0.25 * tolerance && rounding_ <= tolerance) {
      const Course found = course(bernstein_, question.sign);
      if (found == Course::PeakAtEnd) {
        const double ends = std::max(upper(T(question.sign) * bernstein_.front()),
                                     upper(T(question.sign) * bernstein_.back()));
        question.ceiling = std::max(question.ceiling, upper(T(ends) + T(model.remainder)));
        return true;
      }
      if (found == Course::PeakInside) {
        polish(i, model, box);
        return true;
      }
    }
    const double excess = bound + model.remainder - question.known;
    const double width = box.high - box.low;
    if (width > kSmallestBox) {
      if (!(excess <= 2 * noise + tolerance)) return false;
      if (noise > tolerance && width > kNoisyBox) return false;
    }
    // What keeps the box open is rounding, which no division lessens.
    const double natural = question.sign > 0 ? model.range.upper() : -model.range.lower();
    const double ceiling = upper(T(bound) + T(model.remainder));
    question.ceiling =
        std::max(question.ceiling, std::isnan(ceiling) ? natural : std::min(ceiling, natural));
    return true;
  }

  /// Takes the values at a box's ends as reached.
  void reach_ends(std::size_t i, const Box& box) {
    Question& question = questions_[i];
    const double ends = std::max(lower(T(question.sign) * bernstein_.front()),
                                 lower(T(question.sign) * bernstein_.back()));
    if (ends + rounding_ <= question.known) return;
    for (const double x : {box.low, box.high}) {
      if (!is_inside(x)) continue;  // the piece's own ends were looked at
      const auto d = derivatives<6>(law_.pieces()[piece_], T(x));
      const T value = T(question.sign) * quantity_from(question.quantity, d)[0];
      question.known = std::max(question.known, lower(value));
      propose(question.sample, {value_of(value), x, piece_, Where::Sample}, 0);
    }
  }

  /// The single peak of a box.
  void polish(std::size_t i, const TaylorModel<T>& model, const Box& box) {
    Question& question = questions_[i];
    plain_coefficients_.clear();
    for (const T& c : model.c) plain_coefficients_.push_back(value_of(c));
    const double u = turning_point(plain_coefficients_, question.sign);
    const double x = std::min(box.high, std::max(box.low, box.middle + box.radius * u));
    const auto d = derivatives<6>(law_.pieces()[piece_], T(x));
    const T value = T(question.sign) * quantity_from(question.quantity, d)[0];
    if (is_inside(x)) question.known = std::max(question.known, lower(value));
    propose(question.peak, {value_of(value), x, piece_, Where::Stationary}, 1e-15 * scale(i));
    question.ceiling = std::max(question.ceiling, peak_bound(model, question.sign, u));
  }

  /// Upper bound of a polynomial with a single peak: where the slope's sign is proved on both sides
  /// of u, the peak lies between and is no higher than the slopes allow.
  static double peak_bound(const TaylorModel<T>& model, double sign, double u) {
    for (double reach = 1e-8; reach < 4; reach *= 4) {
      const double left = std::max(-1.0, u - reach), right = std::min(1.0, u + reach);
      const T rise = T(sign) * value_and_slope(model.c, T(left)).second;
      const T fall = T(sign) * value_and_slope(model.c, T(right)).second;
      const bool proved = (lower(rise) >= 0 || left == -1) && (upper(fall) <= 0 || right == 1);
      if (!proved) continue;
      // |p'(w)| <= |p'(u)| + h (|p''(u)| + h max |p'''|) for |w - u| <= h.
      const auto [value, slope] = value_and_slope(model.c, T(u));
      T bend(0.0), twist(0.0);
      for (std::size_t k = model.c.size(); k-- > 2;) {
        const double pairs = static_cast<double>(k * (k - 1));
        bend = bend * T(u) + T(pairs) * model.c[k];
        twist = twist + T(pairs * static_cast<double>(k - 2)) * T(size(model.c[k]));
      }
      const T h(step_up(std::max(right - u, u - left)));
      const T steepest = T(size(slope)) + (T(size(bend)) + twist * h) * h;
      return upper(T(sign) * value + steepest * h + T(model.remainder));
    }
    return kUnbounded;
  }

  const Law<T>& law_;
  const Law<double>& plain_;
  Questions questions_;
  double tolerance_;
  std::size_t piece_ = 0;
  double highest_frequency_ = 0;
  std::size_t boxes_ = 0;
  BoxModels<T> models_;
  std::vector<T> bernstein_;
  double rounding_ = 0;  ///< of bernstein_
  std::vector<double> plain_coefficients_;
};

}  // namespace

template <class T>
Questions search_peaks(const Law<T>& law, const Law<double>& plain, double tolerance,
                       std::span<const double> places) {
  return PeakSearch<T>(law, plain, tolerance).run(places);
}

template Questions search_peaks(const Law<double>&, const Law<double>&, double,
                                std::span<const double>);
template Questions search_peaks(const Law<Interval>&, const Law<double>&, double,
                                std::span<const double>);

}  // namespace camlaw::detail
