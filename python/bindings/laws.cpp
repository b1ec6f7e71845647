// SPDX-License-Identifier: MIT
#include "python/bindings/laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>

#include "kinematics/limits.h"
#include "kinematics/peaks.h"
#include "numerics/text/units.h"
#include "output/answers/law_output.h"
#include "output/figure/law_figure.h"
#include "problems/law_files/law_file.h"
#include "python/bindings/module.h"
#include "python/bindings/values.h"

namespace camlaw::python {
namespace {

/// Any array of doubles of one dimension that lies in one piece; its numbers are read in place.
using Places = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Out = nb::ndarray<double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// s, v, a, j at some places. Each array is made when it is asked for, and shares the numbers.
class MotionArrays {
 public:
  explicit MotionArrays(std::size_t count) : count_(count) {
    for (auto& row : rows_) row = std::make_unique_for_overwrite<double[]>(count);
  }

  std::span<double> row(std::size_t i) { return {rows_[i].get(), count_}; }
  MotionSpans spans() { return {row(0), row(1), row(2), row(3)}; }

 private:
  std::size_t count_;
  std::array<std::unique_ptr<double[]>, 4> rows_;
};

Array array_in(nb::handle self, std::size_t i) {
  const std::span<double> row = nb::cast<MotionArrays&>(self).row(i);
  return Array(row.data(), {row.size()}, self);
}

MotionArrays motion_at(const NamedLaw& law, const Places& x) {
  MotionArrays result(x.shape(0));
  evaluate(law.law, {x.data(), x.shape(0)}, result.spans());
  return result;
}

void motion_into(const NamedLaw& law, const Places& x, const std::array<Out, 4>& out) {
  const auto span = [](const Out& row) { return std::span<double>(row.data(), row.shape(0)); };
  evaluate(law.law, {x.data(), x.shape(0)},
           {span(out[0]), span(out[1]), span(out[2]), span(out[3])});
}

double read_value(std::string_view text, const Parameter& parameter, const std::string& what) {
  return parse_quantity(text, parameter.unit, parameter.unit, what);
}

NamedLaw law_by_name(const std::string& text, const std::vector<std::string>& settings,
                     const std::string& folder) {
  Member member = problems::find_any_law(text, folder, read_value);
  for (const std::string& setting : settings) set_argument(member, setting, read_value);
  return NamedLaw(std::move(member));
}

nb::dict parameters_of(const NamedLaw& law) {
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
nb::dict peaks_of(const NamedLaw& law) {
  const Peaks<double> found = peaks(law.law);
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

nb::dict enclosures_of(const NamedLaw& law) {
  const Peaks<Interval> found = peaks(law.member.law<Interval>());
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
double loop_seconds(const NamedLaw& law, std::size_t count, int rounds) {
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
  nb::class_<NamedLaw>(module, "Law")
      .def_prop_ro("name", [](const NamedLaw& law) { return law.member.name(); })
      .def_prop_ro("label", [](const NamedLaw& law) { return law.member.label(); })
      .def_prop_ro("family", [](const NamedLaw& law) { return law.member.family->name; })
      .def_prop_ro("formula", [](const NamedLaw& law) { return law.member.family->formula; })
      .def_prop_ro("ends", [](const NamedLaw& law) { return to_string(law.law.ends()); })
      .def("at", &motion_at, nb::arg("x").noconvert())
      .def("at_into", &motion_into, nb::arg("x").noconvert(), nb::arg("out").noconvert())
      .def("parameters", &parameters_of)
      .def("peaks", &peaks_of)
      .def("enclosures", &enclosures_of)
      .def("limit_index", [](const NamedLaw& law) { return limit_index(peaks(law.law)); })
      .def("facts",
           [](const NamedLaw& law) {
             return python_of(cli::json_of(cli::law_document(law.member)));
           })
      .def("figure",
           [](const NamedLaw& law, int points) {
             return dict_of(
                 cli::motion_figure(law.member.label(), {{.name = "", .law = law.law}}, points));
           })
      .def("svg",
           [](const NamedLaw& law) {
             return cli::to_svg(
                 cli::motion_figure(law.member.label(), {{.name = "", .law = law.law}}));
           })
      .def("file_text", [](const NamedLaw& law,
                           const std::string& title) { return problems::law_text(law.law, title); })
      .def("loop_seconds", &loop_seconds, nb::arg("count"), nb::arg("rounds"));
  module.def("law", &law_by_name, nb::arg("text"), nb::arg("settings"), nb::arg("folder") = "");
  module.def("law_names", &law_names);
}

}  // namespace camlaw::python
