// Scenes: many cut variants, settled.
#include <optional>
#include <utility>

#include "cli/options/file_kind.h"
#include "cli/options/find_template.h"
#include "cli/options/scene_order.h"
#include "cli/options/written_formats.h"
#include "generator/scene/compose.h"
#include "generator/scene/scene_file.h"
#include "python/binding/array_views.h"
#include "python/binding/keyword_order.h"
#include "python/binding/solid_set.h"
#include "python/binding/work.h"
#include "render/deliver/deliver.h"
#include "render/deliver/ordered_diffuser.h"
#include "render/deliver/scene_page_files.h"

namespace pomona {

namespace {

class ComposedScene : public SolidSet {
 public:
  ComposedScene(Order order, SceneDescription description, Scene scene, std::shared_ptr<const Diffuser> diffuser)
      : SolidSet(std::move(order), OrderTaker::scene, std::move(scene), std::move(diffuser)),
        description_(std::move(description)) {}

  Delivered deliver(const Order& order, const DeliverOptions& how) const override {
    Delivered delivered = files({.placed = scene()}, order, how);
    delivered.add(scene_page_files(description_, scene(), order, how, find_template));
    return delivered;
  }
  const std::vector<Format>& formats() const override { return formats_of(OrderTaker::scene); }
  PictureSize usual_size() const override { return {description_.width, description_.height}; }
  const SceneDescription& description() const { return description_; }

 private:
  SceneDescription description_;
};

using Composed = std::shared_ptr<ComposedScene>;

SceneDescription described(const std::string& word, const std::optional<std::string>& text) {
  if (text) return parse_scene(*text, word);
  const std::filesystem::path file = find_file("scenes", word);
  check_kind(file, FileKind::scene);
  return read_scene(file);
}

Composed compose_scene(const std::string& word, const std::optional<std::string>& text, const py::dict& given,
                       const py::object& progress) {
  const Order asked = with_keywords({}, given, OrderTaker::scene, OrderStep::grow);
  Composed composed;
  run_work(progress, [&](Telltale& telltale) {
    telltale.warnings = idle_growing(asked, OrderTaker::scene);
    SceneDescription description = described(word, text);
    const Order order = completed(asked, description);
    description.seed = *order.fruit.seed;
    const std::shared_ptr<const Diffuser> diffuser = ordered_diffuser(order, telltale.progress);
    ComposeOptions composing = compose_options(order, telltale.progress);
    composing.organs = true;  // ground truth is asked for later
    Composition composition = compose(description, diffuser.get(), composing);
    if (!description.paper) composition.scene.paper = ordered_style(order).paper;
    composed = std::make_shared<ComposedScene>(order, description, std::move(composition.scene), diffuser);
    const std::vector<std::string>& more = composition.report.warnings;
    telltale.warnings.insert(telltale.warnings.end(), more.begin(), more.end());
  });
  return composed;
}

/// 4 x 4 matrices, n of them: each takes its piece from where it grew to where it lies.
py::array_t<double> poses_of(const ComposedScene& composed) {
  const std::vector<Instance>& instances = composed.scene().instances;
  py::array_t<double> poses({std::ssize(instances), py::ssize_t{4}, py::ssize_t{4}});
  auto at = poses.mutable_unchecked<3>();
  for (py::ssize_t i = 0; i < std::ssize(instances); ++i) {
    const Pose& pose = instances[static_cast<std::size_t>(i)].pose;
    const glm::dmat3 turn = glm::mat3_cast(pose.rotation);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) at(i, row, column) = turn[column][row];
      at(i, row, 3) = pose.translation[row];
      at(i, 3, row) = 0;
    }
    at(i, 3, 3) = 1;
  }
  return poses;
}

py::list instances_of(const ComposedScene& composed) {
  py::list all;
  for (const Instance& instance : composed.scene().instances) all.append(py::make_tuple(instance.name, instance.solid));
  return all;
}

}  // namespace

void bind_scene(py::module_& module) {
  py::class_<ComposedScene, SolidSet, Composed>(module, "ComposedScene")
      .def("poses", &poses_of)
      .def("instances", &instances_of)
      .def_property_readonly("name", [](const ComposedScene& composed) { return composed.description().name; })
      .def_property_readonly("title", [](const ComposedScene& composed) { return composed.description().title; })
      .def_property_readonly("seed", [](const ComposedScene& composed) { return composed.description().seed; });
  module.def("scene", &compose_scene);
}

}  // namespace pomona
