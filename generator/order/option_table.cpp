#include "generator/order/option_table.h"

#include <algorithm>

#include "generator/base/error.h"
#include "generator/order/typed_values.h"
#include "generator/piece/piece_origin.h"

namespace pomona {

namespace {

const std::vector<OrderTaker> of_fruit = {OrderTaker::grow, OrderTaker::cut, OrderTaker::plate};
const std::vector<OrderTaker> of_solids = {OrderTaker::grow, OrderTaker::cut, OrderTaker::scene, OrderTaker::batch};
const std::vector<OrderTaker> of_pieces = {OrderTaker::cut, OrderTaker::batch};
const std::vector<OrderTaker> of_all = {OrderTaker::grow, OrderTaker::cut, OrderTaker::plate, OrderTaker::scene,
                                        OrderTaker::batch};

const std::vector<Format> solid_formats = {Format::ply, Format::glb, Format::usda, Format::obj, Format::stl,
                                           Format::pov, Format::png, Format::svg,  Format::xml, Format::urdf};
const std::vector<Format> colored_formats = {Format::ply,    Format::glb, Format::usda, Format::obj,
                                             Format::pov,    Format::png, Format::svg,  Format::html,
                                             Format::pomona, Format::xml, Format::urdf};
const std::vector<Format> glb_and_usda = {Format::glb, Format::usda};

std::vector<OrderOption> fruit_options() {
  using enum OrderTaker;
  return {
      {.name = "seed",
       .value = CountValue{member_of<&Order::fruit, &FruitOrder::seed>},
       .usual = "0",
       .help = "Variant to grow; 0 = as drawn",
       .takers = {grow, cut, plate, scene},
       .makes_piece = true,
       .step = OrderStep::grow},
      {.name = "index",
       .value = CountValue{member_of<&Order::fruit, &FruitOrder::index>},
       .help = "Which of the seed's variants, as files of scenes and batches tell it; with it seed 0 is a variant",
       .takers = of_fruit,
       .makes_piece = true,
       .step = OrderStep::grow},
      {.name = "seeds",
       .value = ParsedValue{read_seeds, seeds_text},
       .type = "SEEDS",
       .help = "Several variants side by side, at one scale: 1-5, or 0,2,7",
       .takers = {grow, cut},
       .excludes = "seed",
       .step = OrderStep::grow},
      {.name = "as-drawn",
       .value = FlagValue{member_of<&Order::fruit, &FruitOrder::growing, &GrowOptions::as_drawn>},
       .help = "The curves as drawn, whatever the seed; grains follow it",
       .takers = {grow, cut, plate, batch},
       .need = OptionNeed::a_variant,
       .makes_piece = true,
       .step = OrderStep::grow},
      {.name = "variation",
       .value = NumberValue{member_of<&Order::fruit, &FruitOrder::growing, &GrowOptions::variation>, 0, 2},
       .help = "How far variants stray: 0 = as drawn, 1 = natural, 2 = wild",
       .takers = of_all,
       .need = OptionNeed::a_variant,
       .makes_piece = true,
       .step = OrderStep::grow},
      {.name = "curves-only",
       .value = FlagValue{member_of<&Order::fruit, &FruitOrder::growing, &GrowOptions::curves_only>},
       .help = "Vary the horizontal curves alone, as in the paper, whatever the template says",
       .takers = of_all,
       .need = OptionNeed::a_variant,
       .makes_piece = true,
       .step = OrderStep::grow},
      {.name = "folds",
       .value = OptionalWholeValue{member_of<&Order::fruit, &FruitOrder::growing, &GrowOptions::folds>, 1, max_folds},
       .help = "Another number of folds than drawn",
       .takers = {grow, cut, plate, batch},
       .makes_piece = true,
       .step = OrderStep::grow},
      {.name = "ripeness",
       .value = OptionalNumberValue{member_of<&Order::fruit, &FruitOrder::growing, &GrowOptions::ripeness>, 0, 2},
       .help = "0 = unripe, 1 = as drawn, 2 = overripe, where the template says how it ripens",
       .takers = {grow, cut, plate, batch},
       .makes_piece = true,
       .step = OrderStep::grow},
      {.name = "scale",
       .value = NumberValue{member_of<&Order::fruit, &FruitOrder::growing, &GrowOptions::scale>, 0.05, 20},
       .help = "Times the size that it grows to",
       .takers = {grow, cut, plate, batch},
       .makes_piece = true,
       .step = OrderStep::grow},
      {.name = "detail",
       .value = NumberValue{member_of<&Order::fruit, &FruitOrder::growing, &GrowOptions::detail>, 0.1, 4},
       .help = "How finely surfaces are divided, relative to the template; above 1 grains, too, and all stays in place",
       .takers = of_all,
       .makes_piece = true,
       .step = OrderStep::grow},
  };
}

std::vector<OrderOption> cut_options() {
  using enum OrderTaker;
  return {
      {.name = "knife",
       .value = KnivesValue{},
       .type = "KNIFE",
       .help = "Where to cut, as below; further knives cut the pieces again",
       .takers = {cut},
       .makes_piece = true,
       .step = OrderStep::cut},
      {.name = "browning",
       .value = NumberValue{member_of<&Order::fruit, &FruitOrder::growing, &GrowOptions::browning>, 0, 1},
       .help = "How long the cut faces have lain in air: 0 = just cut, 1 = long, where the template says how",
       .takers = {cut, plate, batch},
       .makes_piece = true,
       .step = OrderStep::cut},
      {.name = "faces",
       .value = choice_value<&Order::cut, &CutOrder::faces>({"fine", "coarse"}),
       .help = "How finely cut faces are triangulated; scenes have coarse ones",
       .takers = of_pieces,
       .heeded = solid_formats,
       .makes_piece = true,
       .step = OrderStep::cut},
      {.name = "piece",
       .value = WholeValue{member_of<&Order::cut, &CutOrder::piece>, 1, 1000000},
       .help = "The piece of this number alone, in the order of cutting; of a fruit in several bodies one of these",
       .takers = {grow, cut, batch},
       .heeded = solid_formats,
       .makes_piece = true,
       .step = OrderStep::cut},
      {.name = "pieces",
       .value = TextValue{member_of<&Order::cut, &CutOrder::piece_list>},
       .type = "FILE",
       .help = "Also write what there is to know of each piece to this file (JSON)",
       .takers = {cut}},
      {.name = "section",
       .value = FlagValue{member_of<&Order::cut, &CutOrder::section>},
       .help = "Write the cut faces instead of the pieces (.ply, .png, .svg)",
       .takers = {cut},
       .step = OrderStep::cut},
      {.name = "explode",
       .value = NumberValue{member_of<&Order::cut, &CutOrder::explode>, 1, 10},
       .help = "Move pieces apart: the centre of each so many times as far from the middle of all",
       .takers = of_pieces,
       .heeded = solid_formats},
      {.name = "crumbs",
       .value = FlagValue{member_of<&Order::cut, &CutOrder::crumbs>},
       .help = "Keep bits that are less than a millionth of the fruit together",
       .takers = of_pieces,
       .heeded = solid_formats,
       .need = OptionNeed::pieces,
       .step = OrderStep::cut},
  };
}

std::vector<OrderOption> color_options() {
  using enum OrderTaker;
  return {
      {.name = "quality",
       .value = choice_value<&Order::color, &ColorOrder::quality>(quality_names()),
       .help = "The error of the diffusion, nothing else",
       .takers = of_all,
       .makes_piece = true,
       .step = OrderStep::cut},
      {.name = "diffuser",
       .value = choice_value<&Order::color, &ColorOrder::diffuser>({"cpu", "gl", "harmonic", "walk", "auto"}),
       .usual = "cpu",
       .help = "How colour diffuses: cpu = positive mean values, gl = the same by OpenGL, auto = gl on a graphics card",
       .takers = of_all,
       .makes_piece = true,
       .step = OrderStep::cut},
      {.name = "style",
       .value = ParsedValue{[](Order& o, const std::string& text) { o.color.style = text; },
                            [](const Order& o) {
                              const ColorOrder& color = o.color;
                              const std::string word =
                                  source_word(color.style_word.empty() ? color.style : color.style_word);
                              const ColorOrder unsaid;
                              const std::string usual =
                                  wants_textures(o.mesh) ? baked_style(unsaid) : drawn_style(unsaid);
                              return word == usual ? std::string() : word;
                            }},
       .type = "STYLE",
       .help = "Look of pictures and textures: a name from `pomona list --styles` or a style file (.toml); ink unless "
               "said, "
               "of textures photo, of plates plate",
       .takers = of_all,
       .heeded = colored_formats,
       .makes_piece = true},
  };
}

std::vector<OrderOption> texture_options() {
  using enum OrderTaker;
  return {
      {.name = "texture",
       .value = WholeValue{member_of<&Order::mesh, &MeshOrder::texture>, 64, 8192},
       .unit = "texels",
       .help = "Bake colours into a texture of N x N texels instead of vertices",
       .takers = of_solids,
       .heeded = glb_and_usda,
       .makes_piece = true},
      {.name = "texel",
       .value = ParsedValue{read_texel, [](const Order& o) { return o.mesh.texel.text; }},
       .type = "LENGTH",
       .help = "Bake colours into textures with texels of this size (0.2mm) instead of a size of their own",
       .takers = of_solids,
       .heeded = glb_and_usda,
       .excludes = "texture",
       .makes_piece = true},
      {.name = "maps",
       .value = choice_value<&Order::mesh, &MeshOrder::maps>({"color", "all"}),
       .help = "Of textures: color = base colour alone; all = normal, occlusion, roughness and thickness, too",
       .takers = of_solids,
       .heeded = glb_and_usda,
       .need = OptionNeed::textures,
       .makes_piece = true},
      {.name = "atlas",
       .value = choice_value<&Order::mesh, &MeshOrder::atlas>({"none", "piece", "file"}),
       .usual = "none",
       .help = "One material for each piece, as is usual with --engine godot, unreal and unity, or one for the whole "
               "file; and one atlas, where there are textures",
       .takers = of_solids,
       .heeded = glb_and_usda,
       .makes_piece = true},
      {.name = "maps-dir",
       .value = TextValue{member_of<&Order::mesh, &MeshOrder::maps_dir>},
       .type = "FOLDER",
       .help = "The textures as .png, too, in this folder, with part numbers",
       .takers = {grow, cut, scene}},
      {.name = "ripeness-variants",
       .value = ParsedValue{read_ripeness_variants, ripeness_variants_text},
       .type = "R,R,...",
       .help = ".glb, .usda with textures: as variants these ripenesses, too, as in 0.3,1,1.7",
       .takers = {grow, cut, batch},
       .heeded = glb_and_usda},
  };
}

std::vector<OrderOption> mesh_options() {
  using enum OrderTaker;
  return {
      {.name = "lod",
       .value = WholeValue{member_of<&Order::mesh, &MeshOrder::lod>, 1, 6},
       .help =
           ".glb, .usda: each solid at so many further levels of detail, with a half, a quarter, ... of the triangles",
       .takers = of_solids,
       .heeded = glb_and_usda,
       .makes_piece = true},
      {.name = "engine",
       .value = choice_value<&Order::mesh, &MeshOrder::engine>({"any", "godot", "unreal", "unity", "blender"}),
       .help = ".glb: names as this engine's importer expects them, and shapes to collide with; for Blender levels "
               "side by side",
       .takers = of_solids,
       .heeded = glb_and_usda,
       .makes_piece = true},
      {.name = "compress",
       .value = choice_value<&Order::mesh, &MeshOrder::compress>({"none", "meshopt"}),
       .help = ".glb: arrays coded by meshoptimizer, in a third to a fifth of the bytes; not every program reads it",
       .takers = of_solids,
       .heeded = {Format::glb},
       .makes_piece = true},
      {.name = "up",
       .value = choice_value<&Order::mesh, &MeshOrder::up>({"y", "z"}),
       .help = ".usda: the axis that points up; simulators want z",
       .takers = of_solids,
       .heeded = {Format::usda},
       .makes_piece = true},
      {.name = "hulls",
       .value = WholeValue{member_of<&Order::mesh, &MeshOrder::hulls>, 1, 64},
       .help = "Convex parts, at most, that a piece collides with: of more than one hollows stay open",
       .takers = of_solids,
       .heeded = {Format::glb, Format::usda, Format::xml, Format::urdf},
       .makes_piece = true},
      {.name = "welded",
       .value = FlagValue{member_of<&Order::mesh, &MeshOrder::welded>},
       .help = "The pieces as they grew, joined by welds that hold as much as what they share of a cut face",
       .takers = {cut},
       .heeded = {Format::usda, Format::xml}},
      {.name = "instances",
       .value = FlagValue{member_of<&Order::mesh, &MeshOrder::instances>},
       .help = ".glb, .usda: pieces that repeat are one node with many places, one prim",
       .takers = of_solids,
       .heeded = glb_and_usda},
      {.name = "feature-ids",
       .value = FlagValue{member_of<&Order::mesh, &MeshOrder::feature_ids>},
       .help = ".glb: parts as EXT_mesh_features, too",
       .takers = of_solids,
       .heeded = {Format::glb},
       .makes_piece = true},
      {.name = "cuttable",
       .value = FlagValue{member_of<&Order::mesh, &MeshOrder::cuttable>},
       .help = ".glb: carries the fruit's asset as well, for programs that cut it",
       .takers = {grow},
       .heeded = {Format::glb}},
      {.name = "sheets",
       .value = FlagValue{member_of<&Order::mesh, &MeshOrder::sheets>},
       .help = ".ply: everything the diffuser sees, blur split, grains included",
       .takers = {grow},
       .heeded = {Format::ply}},
      {.name = "surfaces",
       .value = FlagValue{member_of<&Order::mesh, &MeshOrder::surfaces>},
       .help = "Meshes and pictures: all surfaces, seen through each other",
       .takers = {grow},
       .heeded = {Format::glb, Format::usda, Format::obj, Format::stl, Format::pov, Format::png, Format::svg}},
  };
}

std::vector<OrderOption> picture_options() {
  using enum OrderTaker;
  return {
      {.name = "size",
       .value = ParsedValue{read_picture_extent,
                            [](const Order& o) { return o.picture.size ? o.picture.size->text : std::string(); }},
       .type = "SIZE",
       .unit = "pixels",
       .help = "Size of pictures in pixels, WIDTHxHEIGHT; with --dpi also as in 120x90mm",
       .takers = of_all,
       .heeded = picture_formats},
      {.name = "dpi",
       .value = NumberValue{member_of<&Order::picture, &PictureOrder::dpi>, 10, 2400},
       .unit = "pixels per inch",
       .help = "Pixels per inch that .png and .svg tell programs which print them",
       .takers = of_all,
       .heeded = picture_formats},
      {.name = "view",
       .value = ParsedValue{read_viewpoint,
                            [](const Order& o) { return o.picture.view ? o.picture.view->text : std::string(); }},
       .type = view_type(),
       .unit = "degrees",
       .help = "Where pictures look from, or AZIMUTH,ELEVATION in degrees",
       .takers = of_solids,
       .heeded = picture_formats,
       .need = OptionNeed::pieces},
      {.name = "aov",
       .value = TextValue{member_of<&Order::picture, &PictureOrder::aov>},
       .type = "FOLDER",
       .help = "With a .png of solids: ids, depth, normals, masks and annotations of what it shows, in this folder",
       .takers = {grow, cut, scene}},
      {.name = "aov-format",
       .value = choice_value<&Order::picture, &PictureOrder::aov_format>({"png", "exr"}),
       .help = "png = a 16-bit picture a layer, exr = one file with Cryptomatte",
       .takers = {grow, cut, scene},
       .need = OptionNeed::ground_truth},
      {.name = "threads",
       .value = WholeValue{member_of<&Order::threads, &Threads::count>, 0, 1024},
       .help = "Threads to use; 0 = all. The result does not depend on it",
       .takers = {grow, cut, plate, scene}},
  };
}

}  // namespace

const std::vector<OrderOption>& order_options() {
  static const std::vector<OrderOption> table = [] {
    std::vector<OrderOption> all;
    for (const auto& group :
         {fruit_options(), cut_options(), color_options(), texture_options(), mesh_options(), picture_options()})
      all.insert(all.end(), group.begin(), group.end());
    return all;
  }();
  return table;
}

const OrderOption& order_option(std::string_view name) {
  const std::vector<OrderOption>& table = order_options();
  const auto found = std::find_if(table.begin(), table.end(), [&](const OrderOption& o) { return o.name == name; });
  if (found == table.end()) throw Error(ExitStatus::bug, "no option is called " + std::string(name));
  return *found;
}

bool has_option(OrderTaker taker, const OrderOption& option) {
  return std::find(option.takers.begin(), option.takers.end(), taker) != option.takers.end();
}

std::string flag_of(const OrderOption& option) { return "--" + option.name; }

std::string key_of(const OrderOption& option) {
  std::string key = option.name;
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

}  // namespace pomona
