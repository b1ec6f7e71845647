// SPDX-License-Identifier: MIT
#include "python/bindings/module.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>

#include "numerics/own_files.h"
#include "numerics/text/units.h"
#include "output/document/short_version.h"
#include "python/bindings/running.h"

NB_MODULE(_camlaw, module) {
  using namespace camlaw::python;
  module.doc() = "The library behind the package camlaw, as it is: use the package.";
  module.def(
      "version", [] { return std::string(camlaw::cli::short_version()); },
      "The name and version that results carry, such as 'camlaw 0.1.0'.");
  module.def("add_own_folder", &camlaw::add_own_folder, nb::arg("folder"),
             "Names a folder with the programs and plug-ins that belong to the library.");
  module.def("quantity", &camlaw::parse_quantity, nb::arg("text"), nb::arg("unit"),
             nb::arg("listed"), nb::arg("what"),
             "The value of a text such as '30 mm' in a unit. Raises InputError.");
  module.def(
      "end_calls", &end_calls,
      "Stops all work of other threads and waits for it: what Python does first at its end.");
  nb::module_::import_("atexit").attr("register")(module.attr("end_calls"));
#ifdef NDEBUG
  // Threads that end with the process keep what they use.
  nb::set_leak_warnings(false);
#endif
  add_errors(module);
  add_laws(module);
  add_problems(module);
  add_mechanisms(module);
  add_batch(module);
  add_model(module);
  add_results(module);
  add_executors(module);
  add_fronts(module);
  add_fits(module);
  add_published(module);
  add_sensitivity(module);
  add_sweeps(module);
  add_exports(module);
}
