// SPDX-License-Identifier: MIT
#include "python/bindings/laws.h"

#include <fmt/format.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <tuple>

#include "kinematics/laws/lone_law.h"
#include "kinematics/peaks.h"
#include "kinematics/shape.h"
#include "numerics/text/units.h"
#include "output/answers/law_output.h"
#include "output/figure/law_figure.h"
#include "problems/law_files/json_text.h"
#include "problems/law_files/law_file.h"
#include "problems/law_files/pieces_json.h"
#include "problems/statement/law_names.h"
#include "python/bindings/module.h"
#include "python/bindings/running.h"
#include "python/bindings/values.h"

namespace camlaw::python {
namespace {

/// Any array of doubles of one dimension that lies in one piece; its numbers are read in place.
using Places = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Out = nb::ndarray<double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// s, v, a, j at some places. Each array is made when it is asked for, and shares the numbers.
///
/// The rows begin at cache lines, and none at the same place of a page as another: processors take
/// a load for one that depends on a store to the same place of another page, and wait.
class MotionArrays {
 public:
  explicit MotionArrays(std::size_t count)
      : count_(count),
        stride_((count / kLine + 1) * kLine + kApart),
        numbers_(static_cast<double*>(::operator new (sizeof(double) * 4 * stride_,
                                                      std::align_val_t{sizeof(double) * kLine}))) {}

  std::span<double> row(std::size_t i) { return {numbers_.get() + i * stride_, count_}; }
  MotionSpans spans() { return {row(0), row(1), row(2), row(3)}; }

 private:
  static constexpr std::size_t kLine = 8;            // numbers in a line of 64 bytes
  static constexpr std::size_t kApart = 13 * kLine;  // a fifth of a page of 4096 bytes
  struct Free {
    void operator()(double* numbers) const {
      ::operator delete (numbers, std::align_val_t{sizeof(double) * kLine});
    }
  };

  std::size_t count_, stride_;
  std::unique_ptr<double, Free> numbers_;
};

Array array_in(nb::handle self, std::size_t i) {
  const std::span<double> row = nb::cast<MotionArrays&>(self).row(i);
  return Array(row.data(), {row.size()}, self);
}

/// More places than this take some tenths of a millisecond, and are worked out beside Python: for
/// fewer, a change of threads would take longer than they do.
constexpr std::size_t kFew = std::size_t{1} << 15U;

/// s, v, a, j at many places, piece by piece. Kept out of what few places run through.
[[gnu::noinline]] void evaluate_beside(const MemberLaw& law, std::span<const double> x,
                                       const MotionSpans& out) {
  constexpr std::size_t kEach = std::size_t{1} << 20U;  // some milliseconds
  run_whole([&](const Work& work) {
    const optim::Deadline deadline({}, work.stop());
    for (std::size_t from = 0; from < x.size(); from += kEach) {
      deadline.check();
      const auto part = [&](auto row) {
        return row.subspan(from, std::min(kEach, row.size() - from));
      };
      evaluate(law.law, part(x), {part(out.s), part(out.v), part(out.a), part(out.j)});
    }
    return true;
  });
}

/// Throws std::invalid_argument for numbers that do not lie where processors want them, as in some
/// views of bytes.
template <class Numbers>
void check_aligned(const Numbers& numbers) {
  if (reinterpret_cast<std::uintptr_t>(numbers.data()) % alignof(double) == 0) return;
  throw std::invalid_argument("an array of numbers is not aligned to 8 bytes; give a copy of it");
}

MotionArrays motion_at(const MemberLaw& law, const Places& x) {
  check_aligned(x);
  MotionArrays result(x.shape(0));
  const std::span<const double> places{x.data(), x.shape(0)};
  if (places.size() > kFew) {
    evaluate_beside(law, places, result.spans());
  } else {
    evaluate(law.law, places, result.spans());
  }
  return result;
}

/// Whether two arrays have a number in common.
bool overlap(std::span<const double> a, std::span<const double> b) {
  const std::less<> before;
  return !a.empty() && !b.empty() && before(a.data(), b.data() + b.size()) &&
         before(b.data(), a.data() + a.size());
}

void check_apart(const MotionSpans& out, std::span<const double> x) {
  const std::array<std::span<const double>, 5> all{x, out.s, out.v, out.a, out.j};
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      if (!overlap(all[i], all[k])) continue;
      throw std::invalid_argument("into: two of x, s, v, a and j share numbers; give five arrays");
    }
  }
}

void motion_into(const MemberLaw& law, const Places& x, const std::array<Out, 4>& out) {
  check_aligned(x);
  for (const Out& row : out) {
    check_aligned(row);
    if (row.shape(0) == x.shape(0)) continue;
    throw std::invalid_argument(
        fmt::format("into: an array has {} numbers, but x has {}", row.shape(0), x.shape(0)));
  }
  const auto span = [](const Out& row) { return std::span<double>(row.data(), row.shape(0)); };
  const std::span<const double> places{x.data(), x.shape(0)};
  const MotionSpans spans{span(out[0]), span(out[1]), span(out[2]), span(out[3])};
  check_apart(spans, places);
  if (places.size() > kFew) {
    evaluate_beside(law, places, spans);
  } else {
    evaluate(law.law, places, spans);
  }
}

double read_value(std::string_view text, const Parameter& parameter, const std::string& what) {
  return parse_quantity(text, parameter.unit, parameter.unit, what);
}

MemberLaw law_by_name(const std::string& text, const std::vector<std::string>& settings,
                      const std::string& folder) {
  const Unlocked released;
  Member member = problems::find_any_law(text, folder, read_value);
  for (const std::string& setting : settings) set_argument(member, setting, read_value);
  return MemberLaw(std::move(member));
}

nb::dict parameters_of(const MemberLaw& law) {
  nb::dict result;
  const auto& parameters = law.member.family->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto& values = law.member.arguments.list(i);
    result[nb::cast(parameters[i].name)] =
        parameters[i].list ? nb::object(nb::cast(values)) : nb::object(nb::cast(values.front()));
  }
  return result;
}

/// Value and place of the highest and the lowest of each quantity; of the smooth pieces alone where
/// `inside`.
nb::dict peaks_of(const MemberLaw& law) {
  const Peaks<double> found = without_lock([&] { return peaks(law.law); });
  nb::dict result;
  for (const auto& [name, quantity] :
       {std::pair{"v", Quantity::Velocity}, std::pair{"a", Quantity::Acceleration},
        std::pair{"j", Quantity::Jerk}, std::pair{"moment", Quantity::Moment}}) {
    const auto &high = found.high(quantity), &low = found.low(quantity);
    result[name] = nb::make_tuple(nb::make_tuple(high.value, high.position),
                                  nb::make_tuple(low.value, low.position));
  }
  return result;
}

nb::dict enclosures_of(const MemberLaw& law) {
  const Peaks<Interval> found = without_lock([&] { return peaks(law.member.law<Interval>()); });
  nb::dict result;
  const auto both = [](const Interval& x) { return nb::make_tuple(x.lower(), x.upper()); };
  for (const auto& [name, quantity] :
       {std::pair{"v", Quantity::Velocity}, std::pair{"a", Quantity::Acceleration},
        std::pair{"j", Quantity::Jerk}, std::pair{"moment", Quantity::Moment}}) {
    result[name] =
        nb::make_tuple(both(found.high(quantity).value), both(found.low(quantity).value));
  }
  return result;
}

/// Seconds that the library's own loop takes for one evaluation, the least of several rounds.
double loop_seconds(const MemberLaw& law, std::size_t count, int rounds) {
  std::vector<double> x(count);
  for (std::size_t i = 0; i < count; ++i) {
    x[i] = static_cast<double>(i) / static_cast<double>(count - 1);
  }
  MotionArrays out(count);
  double best = std::numeric_limits<double>::infinity();
  constexpr int kEach = 50;
  for (int round = 0; round < rounds; ++round) {
    const auto began = std::chrono::steady_clock::now();
    for (int i = 0; i < kEach; ++i) evaluate(law.law, x, out.spans());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    best = std::min(best, took.count() / kEach);
  }
  return best;
}

cli::Figure figure_of(const MemberLaw& law, int points) {
  return cli::motion_figure(law.member.label(), {{.name = "", .law = law.law}}, points);
}

/// A law of the catalogue by its name; of any other the pieces, which alone are the law, and what
/// its family says of itself.
using LawState = std::tuple<std::string, std::optional<std::string>, std::string, std::string,
                            std::vector<std::string>>;

LawState law_state_of(const MemberLaw& law) {
  const Family& family = *law.member.family;
  if (problems::is_of_catalogue(law.member)) return {law.member.name(), {}, "", "", {}};
  return {law.member.name(), problems::law_file(law.law, family.formula, nullptr).dump(),
          family.formula, family.source, family.aliases};
}

Member member_of(const LawState& state) {
  const Unlocked released;
  const auto& [name, pieces, formula, source, aliases] = state;
  if (!pieces) return find_law(name);
  const problems::Json file = problems::parse_json(*pieces);
  const auto ends = file.at("ends").get<std::string>();
  Law<double> law = problems::law_from_json(file.at("pieces"), problems::ends_of(ends));
  LoneLaw about{name, formula, ends, source, aliases, is_symmetric(law)};
  return lone_law(std::move(about), std::move(law));
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const Family& family : catalogue()) names.push_back(family.name);
  for (const Member& law : problems::own_laws()) names.push_back(law.name());
  return names;
}

}  // namespace

void add_laws(nb::module_& module) {
  nb::class_<MotionArrays>(module, "MotionArrays")
      .def_prop_ro("s", [](nb::handle self) { return array_in(self, 0); })
      .def_prop_ro("v", [](nb::handle self) { return array_in(self, 1); })
      .def_prop_ro("a", [](nb::handle self) { return array_in(self, 2); })
      .def_prop_ro("j", [](nb::handle self) { return array_in(self, 3); });
  nb::class_<MemberLaw>(module, "Law")
      .def_prop_ro("name", [](const MemberLaw& law) { return law.member.name(); })
      .def_prop_ro("label", [](const MemberLaw& law) { return law.member.label(); })
      .def_prop_ro("family", [](const MemberLaw& law) { return law.member.family->name; })
      .def_prop_ro("formula", [](const MemberLaw& law) { return law.member.family->formula; })
      .def_prop_ro("ends", [](const MemberLaw& law) { return to_string(law.law.ends()); })
      .def_prop_ro("is_of_catalogue",
                   [](const MemberLaw& law) { return problems::is_of_catalogue(law.member); })
      .def_prop_ro("file",
                   [](const MemberLaw& law) {
                     return problems::law_file_of(problems::called_by_path(law.member).name());
                   })
      .def("at", &motion_at, nb::arg("x").noconvert())
      .def("at_into", &motion_into, nb::arg("x").noconvert(), nb::arg("out").noconvert())
      .def("parameters", &parameters_of)
      .def("peaks", &peaks_of)
      .def("enclosures", &enclosures_of)
      .def("limit_index",
           [](const MemberLaw& law) {
             return without_lock([&] { return limit_index(peaks(law.law)); });
           })
      .def("facts",
           [](const MemberLaw& law) {
             return python_of(
                 without_lock([&] { return cli::json_of(cli::law_document(law.member)); }));
           })
      .def("figure",
           [](const MemberLaw& law, int points) {
             return dict_of(without_lock([&] { return figure_of(law, points); }));
           })
      .def("svg",
           [](const MemberLaw& law) {
             return without_lock([&] { return cli::to_svg(figure_of(law, cli::kMotionPoints)); });
           })
      .def("file_text",
           [](const MemberLaw& law, const std::string& title) {
             return without_lock([&] { return problems::law_text(law.law, title); });
           })
      .def("__getstate__", &law_state_of)
      .def("__setstate__",
           [](MemberLaw& law, const LawState& state) { new (&law) MemberLaw(member_of(state)); })
      .def("loop_seconds", &loop_seconds, nb::arg("count"), nb::arg("rounds"));
  module.def("law", &law_by_name, nb::arg("text"), nb::arg("settings"), nb::arg("folder") = "");
  module.def("law_names", &law_names);
}

}  // namespace camlaw::python
