// pybind11, as every source of the binding includes it.
#pragma once

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace pomona {

namespace py = pybind11;

// Each adds what its source binds.
void bind_errors(py::module_& module);
void bind_options(py::module_& module);
void bind_deliverable(py::module_& module);
void bind_solids(py::module_& module);
void bind_fruit(py::module_& module);
void bind_scene(py::module_& module);
void bind_catalog(py::module_& module);

}  // namespace pomona
