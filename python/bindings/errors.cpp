// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "optim/search/memory.h"
#include "python/bindings/module.h"

namespace camlaw::python {
namespace {

/// Raises camlaw.errors.NAME with the library's sentence.
void raise(const char* name, const std::exception& error) {
  const nb::object type = nb::module_::import_("camlaw.errors").attr(name);
  PyErr_SetString(type.ptr(), error.what());
}

}  // namespace

/// Bad input is InputError, what else goes wrong Error, and memory MemoryError.
void add_errors(nb::module_&) {
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const nb::builtin_exception&) {
      throw;
    } catch (const std::invalid_argument& error) {
      raise("InputError", error);
    } catch (const std::bad_alloc&) {
      PyErr_SetString(PyExc_MemoryError, "there is not enough memory for this");
    } catch (const std::logic_error& error) {
      raise("Error", error);
    } catch (const nb::python_error&) {
      throw;
    } catch (const std::exception& error) {
      raise("Error", error);
    }
  });
}

}  // namespace camlaw::python
