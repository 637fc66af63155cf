#include "python/binding/deliverable.h"

#include <span>
#include <utility>

#include "cli/deliver/made_folder.h"
#include "cli/deliver/outputs.h"
#include "cli/options/check_order.h"
#include "cli/options/find_style.h"
#include "generator/base/error.h"
#include "python/binding/array_views.h"
#include "python/binding/keyword_order.h"
#include "python/binding/work.h"

namespace pomona {

namespace {

Order ordered(const Deliverable& what, const py::dict& given) {
  Order order = with_keywords(what.order(), given, what.taker(), what.next_step());
  if (wants_textures(order.mesh) && !what.can_have_textures())
    throw Error(ExitStatus::usage, "--texture comes too late here: cut faces have not kept what colours them",
                what.taker() == OrderTaker::scene ? "give it to scene()" : "give it to cut()");
  return order;
}

/// What was given for this call alone and has no effect is told.
void take_warnings(std::vector<std::string> more, Telltale& telltale) {
  telltale.warnings.insert(telltale.warnings.end(), more.begin(), more.end());
}

std::vector<std::filesystem::path> write(const Deliverable& what, const std::vector<std::string>& paths,
                                         const py::dict& given, const py::object& progress) {
  Order order = ordered(what, given);
  order.outputs = parse_outputs(paths, what.formats());
  check_order(order, what.taker(), {});
  std::vector<std::filesystem::path> written;
  run_work(progress, [&](Telltale& telltale) {
    take_warnings(idle_options(order, what.taker(), what.order()), telltale);
    Delivered delivered = what.deliver(order, deliver_options(what, order, telltale.progress));
    take_warnings(std::move(delivered.warnings), telltale);
    std::vector<OutputFile> files;
    for (DeliveredFile& one : delivered.files) {
      written.push_back(one.file.path);
      files.push_back(std::move(one.file));
    }
    MadeFolder truth(order.picture.aov), maps(order.mesh.maps_dir);
    write_whole(files);
    truth.keep(), maps.keep();
  });
  return written;
}

/// An order of one picture that no file takes.
Order picture_order(const Deliverable& what, const py::dict& given) {
  Order order = ordered(what, given);
  order.outputs = {{"picture.png", Format::png}};
  check_order(order, what.taker(), {});
  return order;
}

py::array render(const Deliverable& what, const py::dict& given, const py::object& progress) {
  const Order order = picture_order(what, given);
  const auto picture = std::make_shared<Image>();
  run_work(progress, [&](Telltale& telltale) {
    DeliverOptions how = deliver_options(what, order, telltale.progress);
    how.take_picture = [&](Image image) { *picture = std::move(image); };
    take_warnings(what.deliver(order, how).warnings, telltale);
  });
  return view_of(&picture->pixels.data()->x, {picture->height, picture->width, 3}, picture);
}

std::vector<std::string> names_of(const auto& numbered) {
  std::vector<std::string> names;
  for (const auto& one : numbered) names.push_back(one.name);
  return names;
}

/// Arrays by name, and what their numbers stand for.
py::dict truth_arrays(const std::shared_ptr<const SeenTruth>& truth) {
  const TruthLayers& layers = truth->layers;
  const auto picture = [&](const auto& numbers) {
    return view_of(numbers.data(), {layers.height, layers.width}, truth);
  };
  py::dict all;
  all["instance"] = picture(layers.instance);
  all["fruit"] = picture(layers.fruit);
  all["part"] = picture(layers.part);
  all["organ"] = picture(layers.organ);
  all["depth"] = picture(layers.depth);
  all["section"] = picture(layers.section);
  all["normal"] = view_of(&layers.normal.data()->x, {layers.height, layers.width, 3}, truth);
  all["instances"] = truth->instances;
  all["fruits"] = names_of(truth->names.fruits);
  all["parts"] = names_of(truth->names.parts);
  return all;
}

py::dict ground_truth_arrays(const Deliverable& what, const py::dict& given, const py::object& progress) {
  const Order order = picture_order(what, given);
  const auto truth = std::make_shared<SeenTruth>();
  run_work(progress, [&](Telltale& telltale) {
    DeliverOptions how = deliver_options(what, order, telltale.progress);
    how.take_truth = [&](SeenTruth seen) { *truth = std::move(seen); };
    take_warnings(what.deliver(order, how).warnings, telltale);
  });
  return truth_arrays(truth);
}

}  // namespace

Style ordered_style(const Order& order) { return find_style(drawn_style(order.color)); }

DeliverOptions deliver_options(const Deliverable& what, const Order& order, const DeliveryProgress& progress) {
  return {.style = ordered_style(order),
          .texture_style = find_style(baked_style(order.color)),
          .provenance = provenance_of(order.fruit),
          .usual_size = what.usual_size(),
          .progress = progress};
}

void bind_deliverable(py::module_& module) {
  py::class_<Deliverable, std::shared_ptr<Deliverable>>(module, "Deliverable")
      .def("write", &write)
      .def("render", &render)
      .def("ground_truth", &ground_truth_arrays);
}

}  // namespace pomona
