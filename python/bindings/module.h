// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>

/// The parts of the module camlaw._camlaw, a file each.
namespace camlaw::python {

namespace nb = nanobind;

void add_errors(nb::module_& module);
void add_laws(nb::module_& module);
void add_problems(nb::module_& module);
void add_mechanisms(nb::module_& module);
void add_batch(nb::module_& module);
void add_model(nb::module_& module);
void add_results(nb::module_& module);
void add_executors(nb::module_& module);
void add_fronts(nb::module_& module);
void add_fits(nb::module_& module);
void add_published(nb::module_& module);
void add_sensitivity(nb::module_& module);
void add_sweeps(nb::module_& module);
void add_exports(nb::module_& module);

}  // namespace camlaw::python
