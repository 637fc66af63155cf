// What there is to grow, to compose, and to draw in.
#include "cli/options/find_style.h"
#include "cli/options/find_template.h"
#include "generator/scene/scene_file.h"
#include "generator/template/read/read_template.h"
#include "python/binding/python.h"

namespace pomona {

namespace {

py::list templates() {
  std::vector<std::filesystem::path> files = all_templates();
  for (const std::filesystem::path& own : own_templates()) files.push_back(own);
  py::list all;
  for (const std::filesystem::path& file : files) {
    const Template fruit = read_template(file);
    all.append(py::make_tuple(file.stem().string(), fruit.title, fruit.parts, file));
  }
  return all;
}

py::list scenes() {
  py::list all;
  for (const std::filesystem::path& file : own_files("scenes"))
    if (is_scene_file(file)) all.append(py::make_tuple(file.stem().string(), read_scene(file).title, file));
  return all;
}

py::list styles() {
  py::list all;
  for (const Style& style : all_known_styles()) all.append(py::make_tuple(style.name, style.title));
  return all;
}

}  // namespace

void bind_catalog(py::module_& module) {
  module.def("templates", &templates);
  module.def("scenes", &scenes);
  module.def("styles", &styles);
}

}  // namespace pomona
