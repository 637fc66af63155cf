#include "cli/options/check_order.h"

#include <algorithm>

#include "cli/deliver/outputs.h"
#include "generator/base/error.h"
#include "render/deliver/live_files.h"

namespace pomona {

namespace {

/// OpenGL draws pieces with two samples along each side of a pixel, which limits the size of their pictures.
void check_picture_size(const Order& order) {
  constexpr int max_side = 16384 / 2;
  const std::optional<PictureSize> size = picture_size(order.picture);
  if (!size || order.cut.section || std::max(size->width, size->height) <= max_side) return;
  if (any_is(order.outputs, {Format::png}))
    throw Error(ExitStatus::usage,
                "--size " + order.picture.size->text + ": pictures of pieces have up to " + std::to_string(max_side) +
                    " pixels a side",
                "write 8192x6144 or less; pictures of --section, and .svg, may have 16384");
}

void check_meshes(const Order& order) {
  const MeshOrder& mesh = order.mesh;
  const bool is_usda_to_standard_output =
      std::any_of(order.outputs.begin(), order.outputs.end(),
                  [](const Output& output) { return output.file == "-" && output.format == Format::usda; });
  if (wants_textures(mesh) && is_usda_to_standard_output)
    throw Error(ExitStatus::usage, "--texture with --format usda makes several files, and standard output is one",
                "write -o FILE.usda");
  if (mesh.lod > 0 && mesh.engine == Engine::godot)
    throw Error(ExitStatus::usage, "--lod: Godot makes levels of detail of its own, and Godot 3 shows ours all at once",
                "leave it out");
  if (mesh.compress == Compression::meshopt && (mesh.instances || mesh.engine != Engine::any || mesh.cuttable))
    throw Error(ExitStatus::usage, "--compress meshopt does not go with --instances, --engine and --cuttable",
                "leave them out: three.js and Babylon.js read what is compressed, engines' importers do not");
  if (mesh.instances && (mesh.engine == Engine::godot || mesh.engine == Engine::unreal))
    throw Error(
        ExitStatus::usage,
        "--instances: " + text_of_option(order_option("engine"), order) + " does not read EXT_mesh_gpu_instancing",
        "leave it out: the meshes of pieces that repeat are shared anyway");
  if (mesh.ripeness_variants.empty()) return;
  const std::string said = "--ripeness-variants " + text_of_option(order_option("ripeness-variants"), order);
  if (!wants_textures(mesh)) throw Error(ExitStatus::usage, said + ": they are textures", "add --texture 512");
  if (mesh.lod > 0) throw Error(ExitStatus::usage, said + ": levels of detail have none", "leave out --lod");
}

void check_grown(const Order& order) {
  const MeshOrder& mesh = order.mesh;
  if (mesh.surfaces && !order.picture.aov.empty())
    throw Error(ExitStatus::usage, "--aov: what one sees through has no one surface at a pixel",
                "leave out --surfaces");
  const bool is_more_than_the_fruit =
      wants_textures(mesh) || mesh.lod > 0 || mesh.surfaces || order.cut.piece > 0 || !order.fruit.seeds.empty();
  if (mesh.cuttable && is_more_than_the_fruit)
    throw Error(ExitStatus::usage, "--cuttable: the file holds the whole fruit, its colours at its vertices",
                "leave out --texture, --texel, --lod, --surfaces, --piece and --seeds");
}

void check_cut(const Order& order) {
  const CutOrder& cut = order.cut;
  if (any_is(order.outputs, live_formats)) check_live_knives(cut.knives);
  if (cut.section && (cut.explode > 1 || cut.piece > 0 || !cut.piece_list.empty() || !order.picture.aov.empty()))
    throw Error(ExitStatus::usage, "--explode, --piece, --pieces and --aov are about pieces: leave out --section");
  if (order.mesh.welded && (cut.section || cut.explode > 1 || cut.piece > 0 || order.mesh.instances))
    throw Error(ExitStatus::usage, "--welded joins the pieces where they grew",
                "leave out --section, --explode, --piece and --instances");
  if (!order.fruit.seeds.empty() && (order.mesh.welded || cut.section || cut.explode > 1 || !cut.piece_list.empty() ||
                                     any_is(order.outputs, live_formats)))
    throw Error(ExitStatus::usage, "--seeds does not go with --section, --explode, --pieces, --welded and .html",
                "leave them out; `pomona grow --seeds` makes pages");
}

/// Several individuals side by side.
void check_family(const Order& order) {
  if (order.fruit.seeds.empty()) return;
  for (const Output& output : order.outputs) {
    if (output.format == Format::ply || output.format == Format::pomona)
      throw Error(ExitStatus::usage, "--seeds: " + output.file.string() + " holds one fruit alone",
                  "write .glb, .usda, .obj, .stl, .pov, .png, .svg or .html");
  }
  if (!order.mesh.ripeness_variants.empty() || order.fruit.growing.as_drawn)
    throw Error(ExitStatus::usage, "--seeds does not go with --ripeness-variants and --as-drawn", "leave them out");
}

}  // namespace

void check_order(const Order& order, OrderTaker taker, const Telling& telling) {
  check_meshes(order);
  check_maps_dir(order);
  if (taker != OrderTaker::plate) check_picture_size(order);
  check_aov(order);
  if (taker == OrderTaker::grow) check_grown(order);
  if (taker == OrderTaker::cut) check_cut(order);
  check_family(order);
  check_other_files(order, telling);
}

}  // namespace pomona
