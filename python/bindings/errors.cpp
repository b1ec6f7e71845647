// SPDX-License-Identifier: MIT
#include <cctype>
#include <stdexcept>
#include <string>
#include <string_view>

#include "optim/search/memory.h"
#include "python/bindings/module.h"

namespace camlaw::python {
namespace {

/// A sentence with the program's switches as keywords: "--form-tolerance is for" becomes
/// "form_tolerance is for".
std::string in_keywords(const std::string& sentence) {
  std::string result;
  bool is_switch = false;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    const bool begins = i == 0 || std::string_view(" '\"(").find(sentence[i - 1]) < 4;
    const bool is_named = i + 2 < sentence.size() && std::islower(sentence[i + 2]) != 0;
    if (begins && is_named && sentence.compare(i, 2, "--") == 0) {
      is_switch = true;
      ++i;
      continue;
    }
    is_switch = is_switch && (std::islower(sentence[i]) != 0 || sentence[i] == '-');
    result += is_switch && sentence[i] == '-' ? '_' : sentence[i];
  }
  return result;
}

/// Raises camlaw.errors.NAME with the library's sentence.
void raise(const char* name, const std::string& sentence) {
  const nb::object type = nb::module_::import_("camlaw.errors").attr(name);
  PyErr_SetString(type.ptr(), sentence.c_str());
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
      raise("InputError", in_keywords(error.what()));
    } catch (const std::bad_alloc&) {
      PyErr_SetString(PyExc_MemoryError, "there is not enough memory for this");
    } catch (const std::logic_error& error) {
      raise("Error", error.what());
    } catch (const nb::python_error&) {
      throw;
    } catch (const std::exception& error) {
      raise("Error", error.what());
    }
  });
}

}  // namespace camlaw::python
