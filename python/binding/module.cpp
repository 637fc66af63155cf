// pomona._core: what Python knows of Pomona. The package pomona (python/pomona) makes a door of it.
#include "generator/base/version.h"
#include "python/binding/python.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "What the package pomona stands on. Use that one.";
  module.attr("version") = pybind11::str(pomona::version);
  pomona::bind_errors(module);
  pomona::bind_options(module);
  pomona::bind_deliverable(module);
  pomona::bind_solids(module);
  pomona::bind_fruit(module);
  pomona::bind_scene(module);
  pomona::bind_catalog(module);
}
