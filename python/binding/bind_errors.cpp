// Errors become Python's: pomona.Error with all places, and those that Python has itself.
#include "cli/exhausted.h"
#include "generator/base/error.h"
#include "python/binding/python.h"
#include "python/binding/work.h"

namespace pomona {

namespace {

py::list diagnostics_of(const Error& error) {
  py::list all;
  for (const Diagnostic& one : error.diagnostics()) {
    const auto text = [](const std::string& bytes) {
      return py::str(py::bytes(bytes).attr("decode")("utf-8", "replace"));
    };
    all.append(py::make_tuple(text(one.place.file), one.place.line, one.place.column, text(one.place.element),
                              text(one.message), text(one.hint)));
  }
  return all;
}

/// Raises what the package makes of it.
void raise(const Error& error) {
  const py::object told =
      py::module_::import("pomona._telling").attr("error")(static_cast<int>(error.status()), diagnostics_of(error));
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(told.ptr())), told.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Error& error) {
    raise(error);
  } catch (const py::builtin_exception&) {
    throw;
  } catch (const py::error_already_set&) {
    throw;
  } catch (const std::exception& error) {
    const auto lack = exhausted(error);
    if (!lack) throw;
    PyErr_SetString(PyExc_MemoryError, std::string(*lack).c_str());
  }
}

}  // namespace

void bind_errors(py::module_&) { py::register_exception_translator(translate); }

}  // namespace pomona
