#include "render/deliver/deliver.h"

#include <algorithm>

#include "generator/scene/layout_file.h"
#include "generator/surface/file/surface_file.h"
#include "render/deliver/export_options.h"
#include "render/deliver/mesh_files.h"
#include "render/deliver/model_files.h"
#include "render/deliver/picture_files.h"
#include "render/style/style_file.h"

namespace pomona {

namespace {

Delivered file_of(const Output& output, const SceneViews& scene, const ReadyMeshes& ready, const Order& order,
                  const DeliverOptions& how) {
  Delivered delivered;
  switch (output.format) {
    case Format::ply:
    case Format::obj:
    case Format::stl:
    case Format::glb:
    case Format::usda:
      return mesh_files(output, scene, ready, order, how);
    case Format::pov:
      return pov_files(output, scene.placed, order, how);
    case Format::png:
      return png_files(output, scene, order, how);
    case Format::svg:
      return svg_file(output, scene, order, how);
    case Format::json:
      delivered.add(output.file, [&] { return write_layout(scene.placed); });
      return delivered;
    case Format::xml:
    case Format::urdf:
      return model_files(output, scene.modelled != nullptr ? *scene.modelled : scene.placed, order, how);
    case Format::html:
    case Format::pomona:
      return delivered;
  }
  return delivered;
}

bool is_streamed(const Output& output, const SceneViews& scene) {
  return std::any_of(scene.streams.begin(), scene.streams.end(),
                     [&](const auto& stream) { return stream->file() == output.file; });
}

}  // namespace

Delivered files(const SceneViews& scene, const Order& order, const DeliverOptions& how) {
  const auto needs_ready_meshes = [&](const Output& output) {
    const bool is_cuttable = order.mesh.cuttable && output.format == Format::glb;
    return (output.format == Format::glb || output.format == Format::usda) && !is_streamed(output, scene) &&
           !is_cuttable;
  };
  Delivered delivered;
  ReadyMeshes ready;
  if (std::any_of(order.outputs.begin(), order.outputs.end(), needs_ready_meshes))
    ready = ready_meshes(scene, order, how, delivered);
  for (const Output& output : order.outputs) delivered.add(file_of(output, scene, ready, order, how));
  return delivered;
}

Delivered files(const Scene& scene, const Order& order, const Provenance& provenance) {
  return files({.placed = scene}, order,
               {.style = style_named(drawn_style(order.color)),
                .texture_style = style_named(baked_style(order.color)),
                .provenance = provenance});
}

Delivered surface_files(const OrderedFruit& fruit, const Order& order) {
  const DiffusionSurfaces& surfaces = order.mesh.sheets ? fruit.grown.sheets : fruit.grown.swept;
  Delivered delivered;
  for (const Output& output : order.outputs) {
    if (output.format == Format::ply) delivered.add(output.file, [&] { return write_surfaces(surfaces); });
  }
  return delivered;
}

std::vector<std::unique_ptr<StreamedGlb>> streams_of(const Order& order, const DeliverOptions& how) {
  std::vector<std::unique_ptr<StreamedGlb>> streams;
  const bool needs_no_looks = all_are(order.outputs, {Format::glb, Format::json});
  // An atlas is made of all textures.
  const bool needs_all = atlas_of(order.mesh) == AtlasOf::file && wants_textures(order.mesh);
  if (!order.mesh.maps_dir.empty() || !needs_no_looks || needs_all) return streams;
  StreamedGlbOptions stream{.exported = export_options(order, how), .lod = order.mesh.lod, .bake = bake_options(order)};
  if (stream.bake) stream.exported.style = how.texture_style;
  for (const Output& output : order.outputs) {
    if (output.format == Format::glb) streams.push_back(std::make_unique<StreamedGlb>(output.file, stream));
  }
  return streams;
}

double picture_aspect(const Order& order, const DeliverOptions& how) {
  const PictureSize size = picture_size(order.picture).value_or(how.usual_size);
  return static_cast<double>(size.width) / size.height;
}

}  // namespace pomona
