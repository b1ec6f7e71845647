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

/// A smooth piece by its place in the law.
template <class T>
struct NumberedPiece {
  const Piece<T>& piece;
  std::size_t index;

  /// Whether x lies in the piece wherever in their intervals its ends are.
  bool holds(double x) const { return x >= upper(piece.begin) && x <= lower(piece.end); }
};

/// A box and the questions that it has open, a bit for each.
struct OpenBox {
  double low, high;
  unsigned open;
};

/// What boxes are worked out in: kept from box to box for its memory alone.
template <class T>
struct Scratch {
  BoxModels<T> models;
  std::vector<T> bernstein;
  std::vector<double> plain;
  std::vector<OpenBox> left;
};

/// A box of a piece, a quantity's model on it, and that in Bernstein form.
template <class T>
struct ModelledBox {
  const NumberedPiece<T>& in;
  const PeakBox& box;
  const TaylorModel<T>& model;
  const std::vector<T>& bernstein;
  double rounding;  ///< of the Bernstein form
};

/// A question as a box leaves it, and whether the box is done with.
struct Answer {
  Question question;
  bool is_closed;
};

/// The quantity's largest finite size as known so far: where one side has no bound, the other is
/// still found to its own accuracy.
double scale(const Question& question, const Question& opposite) {
  // An interval rounds infinity outwards to the largest double, which counts as infinite here.
  const auto finite = [](double x) { return std::abs(x) < 1e300 ? std::abs(x) : 0.0; };
  return std::max(finite(question.known), finite(opposite.known));
}

/// Of the scale: values that differ by less are the same peak, of which the first counts.
constexpr double kSamePeak = 1e-15;

Extremum better(const Extremum& best, const Extremum& candidate, double margin) {
  const bool first = best.value == -kUnbounded && !std::isnan(candidate.value);
  return first || candidate.value > best.value + margin ? candidate : best;
}

/// The question's value at a point of a piece, of the law's derivatives there.
template <class T, class Derivatives>
T value_at(const Question& question, const Derivatives& d) {
  return T(question.sign) * quantity_from(question.quantity, d)[0];
}

/// With a value that is reached at a point inside a piece, whether or not it is a peak.
template <class T>
Question reached(Question question, const T& value, double x, std::size_t piece) {
  question.known = std::max(question.known, lower(value));
  question.sample = better(question.sample, {value_of(value), x, piece, Where::Sample}, 0);
  return question;
}

/// With the values at an end of a piece.
template <class T>
Questions with_end(Questions questions, const NumberedPiece<T>& in, Where where) {
  const T x = where == Where::Begin ? in.piece.begin : in.piece.end;
  const auto d = derivatives<6>(in.piece, x);
  for (std::size_t i = 0; i < questions.size(); ++i) {
    Question& question = questions[i];
    T value = value_at<T>(question, d);
    if (question.quantity == Quantity::Moment) {
      if (const auto moment = closed_moment(in.piece, x)) value = T(question.sign) * *moment;
    }
    question.known = std::max(question.known, lower(value));
    question.ceiling = std::max(question.ceiling, upper(value));
    question.peak = better(question.peak, {value_of(value), value_of(x), in.index, where},
                           kSamePeak * scale(question, questions[i ^ 1]));
  }
  return questions;
}

/// With the values at places inside pieces; `plain` tells in which.
template <class T>
Questions with_places(Questions questions, const Law<T>& law, const Law<double>& plain,
                      std::span<const double> places) {
  for (const double x : places) {
    const std::size_t index = plain.piece_at(x, Side::Right);
    const NumberedPiece<T> in{law.pieces()[index], index};
    if (!in.holds(x)) continue;
    const auto d = derivatives<6>(in.piece, T(x));
    for (Question& question : questions) {
      question = reached(question, value_at<T>(question, d), x, index);
    }
  }
  return questions;
}

/// Whether a box with this upper bound holds nothing that is better than what is known.
bool is_reached(const Question& question, const Question& opposite, double bound,
                double tolerance) {
  return bound <= question.known + tolerance * scale(question, opposite);
}

Question with_ceiling(Question question, double ceiling) {
  question.ceiling = std::max(question.ceiling, ceiling);
  return question;
}

/// With the values at a box's ends, where these may be better than what is known.
template <class T>
Question with_ends_of(Question question, const ModelledBox<T>& at) {
  const double ends = std::max(lower(T(question.sign) * at.bernstein.front()),
                               lower(T(question.sign) * at.bernstein.back()));
  if (ends + at.rounding <= question.known) return question;
  for (const double x : {at.box.low, at.box.high}) {
    if (!at.in.holds(x)) continue;  // the piece's own ends were looked at
    const auto d = derivatives<6>(at.in.piece, T(x));
    question = reached(question, value_at<T>(question, d), x, at.in.index);
  }
  return question;
}

/// Upper bound of a polynomial with a single peak: where the slope's sign is proved on both sides
/// of u, the peak lies between and is no higher than the slopes allow.
template <class T>
double peak_bound(const TaylorModel<T>& model, double sign, double u) {
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

/// With the single peak of a box.
template <class T>
Question with_peak_inside(Question question, const Question& opposite, const ModelledBox<T>& at,
                          std::vector<double>& plain) {
  plain.clear();
  for (const T& c : at.model.c) plain.push_back(value_of(c));
  const double u = turning_point(plain, question.sign);
  const double x = std::min(at.box.high, std::max(at.box.low, at.box.middle + at.box.radius * u));
  const T value = value_at<T>(question, derivatives<6>(at.in.piece, T(x)));
  if (at.in.holds(x)) question.known = std::max(question.known, lower(value));
  question.peak = better(question.peak, {value_of(value), x, at.in.index, Where::Stationary},
                         kSamePeak * scale(question, opposite));
  return with_ceiling(question, peak_bound(at.model, question.sign, u));
}

/// A polynomial's upper bound by its Bernstein form, and how wide rounding makes its numbers.
struct BernsteinBound {
  double bound, noise;
};
template <class T>
BernsteinBound bernstein_bound(const ModelledBox<T>& at, double sign) {
  const T first = T(sign) * at.bernstein.front();
  BernsteinBound found{upper(first), upper(first) - lower(first)};
  for (const T& b : at.bernstein) {
    const T value = T(sign) * b;
    found.bound = std::max(found.bound, upper(value));
    found.noise = std::max(found.noise, upper(value) - lower(value));
  }
  return {found.bound + at.rounding, found.noise + 2 * at.rounding};
}

/// Looks at the polynomial's course over the box: what its bound does not settle, its turns may.
template <class T>
Answer answer_by_course(Question question, const Question& opposite, const ModelledBox<T>& at,
                        double tolerance, std::vector<double>& plain) {
  const TaylorModel<T>& model = at.model;
  // The middle is reached; its Taylor coefficient is the value itself.
  question = reached(question, T(question.sign) * model.c[0], at.box.middle, at.in.index);
  question = with_ends_of(question, at);
  const auto [bound, noise] = bernstein_bound(at, question.sign);
  const double ceiling = upper(T(bound) + T(model.remainder));
  if (is_reached(question, opposite, ceiling, tolerance)) {
    return {with_ceiling(question, ceiling), true};
  }
  const double accuracy = tolerance * scale(question, opposite);
  if (model.remainder <= 0.25 * accuracy && at.rounding <= accuracy) {
    const Course found = course(at.bernstein, question.sign);
    if (found == Course::PeakAtEnd) {
      const double ends = std::max(upper(T(question.sign) * at.bernstein.front()),
                                   upper(T(question.sign) * at.bernstein.back()));
      return {with_ceiling(question, upper(T(ends) + T(model.remainder))), true};
    }
    if (found == Course::PeakInside) {
      return {with_peak_inside(question, opposite, at, plain), true};
    }
  }
  const double excess = bound + model.remainder - question.known;
  const double width = at.box.high - at.box.low;
  if (width > kSmallestBox) {
    if (!(excess <= 2 * noise + accuracy)) return {question, false};
    if (noise > accuracy && width > kNoisyBox) return {question, false};
  }
  // What keeps the box open is rounding, which no division lessens.
  const double natural = question.sign > 0 ? model.range.upper() : -model.range.lower();
  return {with_ceiling(question, std::isnan(ceiling) ? natural : std::min(ceiling, natural)), true};
}

/// Which of a quantity's two questions, highest and lowest, stay open on a box, of those that are
/// (a bit for each); the questions become what the box tells. `scratch` has the models of the box.
template <class T>
unsigned left_open(std::span<Question, 2> sides, unsigned open, const NumberedPiece<T>& in,
                   const PeakBox& box, double tolerance, Scratch<T>& scratch) {
  const Quantity quantity = sides[0].quantity;
  const Interval range = scratch.models.range(quantity);
  const std::array bounds{range.upper(), -range.lower()};
  for (unsigned side = 0; side < 2; ++side) {
    if (!is_reached(sides[side], sides[side ^ 1], bounds[side], tolerance)) continue;
    sides[side].ceiling = std::max(sides[side].ceiling, bounds[side]);
    open &= ~(1u << side);
  }
  if (open == 0) return open;
  const TaylorModel<T>& model = scratch.models.quantity(quantity);
  scratch.bernstein = model.c;
  const double rounding = to_bernstein(scratch.bernstein);
  const ModelledBox<T> at{in, box, model, scratch.bernstein, rounding};
  for (unsigned side = 0; side < 2; ++side) {
    if ((open >> side & 1u) == 0) continue;
    const auto [question, is_closed] =
        answer_by_course(sides[side], sides[side ^ 1], at, tolerance, scratch.plain);
    sides[side] = question;
    if (is_closed) open &= ~(1u << side);
  }
  return open;
}

/// With the ranges over a box as the upper bounds of what is open.
template <class T>
Questions given_up(Questions questions, unsigned open, const NumberedPiece<T>& in,
                   const PeakBox& box, BoxModels<T>& models) {
  models.expand(in.piece, box);
  for (std::size_t i = 0; i < questions.size(); ++i) {
    if ((open >> i & 1u) == 0) continue;
    const Interval range = models.range(questions[i].quantity);
    const double bound = questions[i].sign > 0 ? range.upper() : -range.lower();
    questions[i].ceiling = std::isnan(bound) ? kUnbounded : std::max(questions[i].ceiling, bound);
  }
  return questions;
}

constexpr unsigned kAllOpen = (1u << (2 * kQuantities)) - 1;
constexpr unsigned kMomentQuestions = 3u << (2 * (kQuantities - 1));

/// The search so far: what is known, and how many boxes it has taken.
struct Searched {
  Questions questions;
  std::size_t boxes = 0;
};

template <class T>
double highest_frequency(const Piece<T>& piece) {
  double highest = 0;
  for (const auto& h : piece.harmonics) highest = std::max(highest, size(h.frequency));
  return highest;
}

/// Answers all questions on a piece, dividing boxes from left to right while some stay open.
template <class T>
Searched with_piece(Searched so_far, const NumberedPiece<T>& in, double tolerance,
                    Scratch<T>& scratch) {
  auto& [questions, boxes] = so_far;
  const double frequency = highest_frequency(in.piece);
  // A closed form of the moment is linear, and its ends were seen.
  const unsigned open = closed_moment(in.piece, 0.5) ? kAllOpen & ~kMomentQuestions : kAllOpen;
  std::vector<OpenBox>& left = scratch.left;
  left.assign({{lower(in.piece.begin), upper(in.piece.end), open}});
  while (!left.empty()) {
    OpenBox next = left.back();
    left.pop_back();
    const PeakBox box(next.low, next.high);
    if (box.radius * frequency <= kWidestAngle) {
      scratch.models.expand(in.piece, box);
      for (std::size_t q = 0; q < kQuantities; ++q) {
        const unsigned asked = next.open >> (2 * q) & 3u;
        if (asked == 0) continue;
        const std::span<Question, 2> sides(&questions[2 * q], 2);
        const unsigned open_yet = left_open(sides, asked, in, box, tolerance, scratch);
        next.open &= ~((asked & ~open_yet) << (2 * q));
      }
    }
    if (next.open == 0) continue;
    if (++boxes > kMostBoxes || box.high - box.low <= kSmallestBox) {
      questions = given_up(questions, next.open, in, box, scratch.models);
      continue;
    }
    left.push_back({box.middle, next.high, next.open});
    left.push_back({next.low, box.middle, next.open});
  }
  return so_far;
}

}  // namespace

template <class T>
Questions search_peaks(const Law<T>& law, const Law<double>& plain, double tolerance,
                       std::span<const double> places) {
  Questions questions = all_questions();
  for (std::size_t i = 0; i < law.pieces().size(); ++i) {
    for (const Where end : {Where::Begin, Where::End}) {
      questions = with_end<T>(questions, {law.pieces()[i], i}, end);
    }
  }
  Searched found{with_places(questions, law, plain, places)};
  Scratch<T> scratch;
  for (std::size_t i = 0; i < law.pieces().size(); ++i) {
    found = with_piece<T>(found, {law.pieces()[i], i}, tolerance, scratch);
  }
  return found.questions;
}

template Questions search_peaks(const Law<double>&, const Law<double>&, double,
                                std::span<const double>);
template Questions search_peaks(const Law<Interval>&, const Law<double>&, double,
                                std::span<const double>);

}  // namespace camlaw::detail
