#include "render/deliver/picture_files.h"

#include <filesystem>
#include <string>
#include <utility>

#include "generator/base/version.h"
#include "render/deliver/export_options.h"
#include "render/export/pov.h"
#include "render/export/svg.h"
#include "render/gl/context.h"
#include "render/gl/scene_picture.h"
#include "render/image/png.h"
#include "render/marks/marks.h"
#include "render/picture/light_direction.h"
#include "render/picture/view_within.h"
#include "render/strokes/scene_parts.h"
#include "render/truth/ground_truth.h"

namespace pomona {

namespace {

/// A scene with its view for a picture of this size.
struct Framed {
  Scene scene;
  PictureSize size;
  std::vector<PlateLayer> plate;  ///< layers around and over it
};

/// The view of the order, or one that fits a picture of this shape, or the figure on a plate.
Scene fitted(Scene scene, const PictureSize& size, const std::optional<Plate>& plate, const Order& order,
             const Style& style) {
  if (!order.picture.view && !scene.view.fitted) return scene;
  const glm::dvec3 direction = order.picture.view ? order.picture.view->direction : scene.view.eye - scene.view.target;
  const glm::dvec2 picture(size.width, size.height);
  const glm::dvec2 room = plate ? plate->figure().high - plate->figure().low : picture;
  std::optional<glm::dvec3> light;
  if (style.shadow.strength > 0) light = light_direction(View{.eye = direction, .target = glm::dvec3(0)}, style.light);
  scene.view = fitted_view(scene, direction, room.x / room.y, light);
  if (plate) scene.view = view_within(scene.view, picture, plate->figure().low, plate->figure().high);
  return scene;
}

Framed framed(const SceneViews& views, const Order& order, const DeliverOptions& how) {
  const Scene& scene = views.shown != nullptr ? *views.shown : views.placed;
  const PictureSize size = picture_size(order.picture).value_or(how.usual_size);
  std::optional<Plate> plate;
  if (how.style.plate && views.plate_text && !scene.solids.empty())
    plate.emplace(how.style, *views.plate_text, scene.solids[0].look->part_names, size.width, size.height);
  Framed framed{fitted(scene, size, plate, order, how.style), size, {}};
  if (plate)
    framed.plate = plate->layers(scene_parts(framed.scene, size.width, size.height),
                                 pixels_per_metre(framed.scene.view, size.height));
  return framed;
}

Image painted(const Framed& framed, const Style& style, Threads threads) {
  GlContext context;
  return draw_scene(context, framed.scene, style,
                    {.width = framed.size.width, .height = framed.size.height, .threads = threads});
}

/// The ground truth, by the same view.
Delivered truth_files(const Output& picture, const Framed& framed, const Order& order, const DeliverOptions& how) {
  const TruthOptions options{.width = framed.size.width,
                             .height = framed.size.height,
                             .file_name = picture.file.filename().string(),
                             .made_by = std::string("pomona ") + version,
                             .seed = how.provenance.seeds.front(),
                             .format = order.picture.aov_format,
                             .threads = order.threads};
  Delivered delivered;
  for (TruthFile& file : delivered.times.time("truth", [&] { return ground_truth(framed.scene, options); }))
    delivered.files.push_back({{std::filesystem::path(order.picture.aov) / file.name, std::move(file.bytes)}, true});
  return delivered;
}

SeenTruth seen_truth(const Framed& framed, Threads threads) {
  check_opaque(framed.scene);
  SeenTruth truth{.names = truth_naming(framed.scene), .layers = {}, .instances = {}};
  truth.layers = truth_layers(framed.scene, truth.names, framed.size.width, framed.size.height, threads);
  for (const Instance& instance : framed.scene.instances) truth.instances.push_back(instance.name);
  return truth;
}

/// Hatching or stipple, if the style draws tones by marks; they follow OpenGL's picture.
SvgMarks marks_on(const Framed& framed, const Style& style, Threads threads) {
  if (!style.marks) return {};
  Style paint = style;
  paint.ink = false;
  paint.marks.reset();
  return {marks_of(painted(framed, paint, threads), framed.scene.paper, *style.marks),
          style.ink_color.value_or(InkStyle().color)};
}

}  // namespace

Delivered png_files(const Output& output, const SceneViews& scene, const Order& order, const DeliverOptions& how) {
  const Framed shown = framed(scene, order, how);
  Delivered delivered;
  if (how.take_truth) {
    how.take_truth(delivered.times.time("truth", [&] { return seen_truth(shown, order.threads); }));
    return delivered;
  }
  Image image = delivered.times.time("style", [&] { return painted(shown, how.style, order.threads); });
  draw(shown.plate, image);
  image.dpi = order.picture.dpi;
  if (how.take_picture) {
    how.take_picture(std::move(image));
    return delivered;
  }
  delivered.add(output.file, [&] { return write_png(image); });
  if (!order.picture.aov.empty()) delivered.add(truth_files(output, shown, order, how));
  return delivered;
}

Delivered svg_file(const Output& output, const SceneViews& scene, const Order& order, const DeliverOptions& how) {
  const Framed shown = framed(scene, order, how);
  const StrokeOptions options{.width = shown.size.width, .height = shown.size.height, .threads = order.threads};
  Delivered delivered;
  const auto strokes = delivered.times.time("style", [&] { return scene_strokes(shown.scene, how.style, options); });
  const SvgMarks marks = delivered.times.time("style", [&] { return marks_on(shown, how.style, order.threads); });
  if (!how.style.ink && marks.marks.empty())
    delivered.warnings.push_back("the style " + how.style.name + " has no ink: " + output.file.string() +
                                 " holds no lines");
  delivered.add(output.file, [&] {
    return write_svg(shown.scene, strokes, {shown.size.width, shown.size.height, order.picture.dpi},
                     made_by(how.provenance), shown.plate, marks);
  });
  return delivered;
}

Delivered pov_files(const Output& output, const Scene& scene, const Order& order, const DeliverOptions& how) {
  // The strokes of the camera that is in the file.
  SceneInk ink{.width = how.usual_size.width, .height = how.usual_size.height, .strokes = {}};
  const StrokeOptions options{.width = ink.width, .height = ink.height, .threads = order.threads};
  Delivered delivered;
  ink.strokes = delivered.times.time("style", [&] { return scene_strokes(scene, how.style, options); });
  const std::string stem = output.file.stem().string();
  const ExportOptions as_mesh = export_options(order, how);
  for (NamedFile& file : delivered.times.time("write", [&] { return write_pov(scene, stem, as_mesh, ink); }))
    delivered.files.push_back({.file = {output.file.parent_path() / file.name, std::move(file.bytes)}});
  return delivered;
}

}  // namespace pomona
