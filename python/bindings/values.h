// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <string>
#include <vector>

#include "output/document/document.h"
#include "output/figure/chart.h"
#include "problems/law_files/json_text.h"

/// The library's values as Python has them.
namespace camlaw::python {

namespace nb = nanobind;

using Array = nb::ndarray<nb::numpy, double, nb::ndim<1>>;

/// A numpy array that takes the numbers over: nothing is copied.
Array array_of(std::vector<double> values);

/// A fact of an answer: objects become dicts in their order, lists lists, null None.
nb::object python_of(const problems::Json& value);

/// A figure as data, for whoever draws it: title, subtitle, columns and panels, each with its axes,
/// lines and markers. Lines are arrays.
nb::dict dict_of(const cli::Figure& figure);

}  // namespace camlaw::python
