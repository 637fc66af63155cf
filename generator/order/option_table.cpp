#include "generator/order/option_table.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "generator/base/error.h"
#include "generator/base/nearest_name.h"
#include "generator/base/shell_words.h"
#include "generator/base/units.h"
#include "generator/knife/parse_knife.h"
#include "generator/order/typed_values.h"
#include "generator/piece/piece_origin.h"

namespace pomona {

namespace {

const std::vector<OrderTaker> of_fruit = {OrderTaker::grow, OrderTaker::cut, OrderTaker::plate};
const std::vector<OrderTaker> of_solids = {OrderTaker::grow, OrderTaker::cut, OrderTaker::scene, OrderTaker::batch};
const std::vector<OrderTaker> of_pieces = {OrderTaker::cut, OrderTaker::batch};
const std::vector<OrderTaker> of_all = {OrderTaker::grow, OrderTaker::cut, OrderTaker::plate, OrderTaker::scene,
                                        OrderTaker::batch};

const std::vector<Format> solid_formats = {Format::ply, Format::glb, Format::usda, Format::obj,
                                           Format::stl, Format::pov, Format::png,  Format::svg};
const std::vector<Format> colored_formats = {Format::ply, Format::glb, Format::usda, Format::obj,   Format::pov,
                                             Format::png, Format::svg, Format::html, Format::pomona};
const std::vector<Format> glb_and_usda = {Format::glb, Format::usda};

bool is_met(OptionNeed need, const Order& order) {
  switch (need) {
    case OptionNeed::nothing:
      return true;
    case OptionNeed::a_variant:
      return order.fruit.seed.value_or(0) != 0 || order.fruit.index || !order.fruit.seeds.empty();
    case OptionNeed::pieces:
      return !order.cut.section;
    case OptionNeed::textures:
      return wants_textures(order.mesh);
    case OptionNeed::ground_truth:
      return !order.picture.aov.empty();
  }
  return true;
}

/// What is told of an option whose need is not met.
const char* words_of(OptionNeed need) {
  switch (need) {
    case OptionNeed::a_variant:
      return "is about variants, and seed 0 is as drawn: --seed 1 is one";
    case OptionNeed::pieces:
      return "is about pieces: a section has none";
    case OptionNeed::textures:
      return "is about textures: --texture 1024 asks for them";
    case OptionNeed::ground_truth:
      return "is about --aov, which is not there";
    default:
      return "";
  }
}

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
       .help = "Tessellation of the surfaces, relative to the template's",
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
                              const std::string word = source_word(o.color.style);
                              return word == "ink" ? std::string() : word;
                            }},
       .type = "STYLE",
       .help =
           "Look of pictures: a name from `pomona list --styles` or a style file (.toml); ink unless said, of plates "
           "plate",
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
       .value = choice_value<&Order::mesh, &MeshOrder::engine>({"any", "godot", "unreal", "unity"}),
       .help = ".glb: names as this engine's importer expects them, and convex hulls to collide with",
       .takers = of_solids,
       .heeded = {Format::glb},
       .makes_piece = true},
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

/// As few figures as say it.
std::string number_text(double number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

std::string range_fault(const std::string& text, double low, double high, bool whole) {
  const std::optional<double> value = parse_number(text);
  const bool fits = value && *value >= low && *value <= high;
  if (fits && (!whole || text.find_first_not_of("+-0123456789") == std::string::npos)) return {};
  return "\"" + text + "\" is not a " + (whole ? "whole " : "") + "number from " + number_text(low) + " to " +
         number_text(high);
}

std::string choice_fault(const std::string& text, const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), text) != words.end()) return {};
  std::string known;
  for (const std::string& word : words) known += (known.empty() ? "" : ", ") + word;
  const std::optional<std::string> near = nearest_name(text, words);
  return "\"" + text + "\" is none of " + known + (near ? ": did you mean " + *near + "?" : "");
}

std::optional<std::uint64_t> count_of(const std::string& text) {
  std::uint64_t count = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return count;
}

std::string empty_fault(const std::string& text) { return text.empty() ? "\"\" says nothing: leave it out" : ""; }

struct FaultOf {
  const std::string& text;
  std::string operator()(const FlagValue&) const { return choice_fault(text, {"true", "false"}); }
  std::string operator()(const WholeValue& v) const { return range_fault(text, v.low, v.high, true); }
  std::string operator()(const OptionalWholeValue& v) const { return range_fault(text, v.low, v.high, true); }
  std::string operator()(const NumberValue& v) const { return range_fault(text, v.low, v.high, false); }
  std::string operator()(const OptionalNumberValue& v) const { return range_fault(text, v.low, v.high, false); }
  std::string operator()(const CountValue&) const {
    return count_of(text) ? "" : "\"" + text + "\" is not a whole number from 0 to 18446744073709551615";
  }
  std::string operator()(const ChoiceValue& v) const { return choice_fault(text, v.words); }
  std::string operator()(const TextValue&) const { return empty_fault(text); }
  std::string operator()(const ParsedValue&) const { return empty_fault(text); }
  std::string operator()(const KnivesValue&) const { return empty_fault(text); }
};

/// Of a text without a fault.
struct Read {
  const std::string& text;
  Order& order;
  int whole() const { return static_cast<int>(*parse_number(text)); }
  void operator()(const FlagValue& v) const { v.in(order) = text == "true"; }
  void operator()(const WholeValue& v) const { v.in(order) = whole(); }
  void operator()(const OptionalWholeValue& v) const { v.in(order) = whole(); }
  void operator()(const NumberValue& v) const { v.in(order) = *parse_number(text); }
  void operator()(const OptionalNumberValue& v) const { v.in(order) = *parse_number(text); }
  void operator()(const CountValue& v) const { v.in(order) = count_of(text); }
  void operator()(const ChoiceValue& v) const {
    v.set(order, static_cast<std::size_t>(std::find(v.words.begin(), v.words.end(), text) - v.words.begin()));
  }
  void operator()(const TextValue& v) const { v.in(order) = text; }
  void operator()(const ParsedValue& v) const { v.read(order, text); }
  void operator()(const KnivesValue&) const { order.cut.knives.push_back(parse_knife(text)); }
};

struct TextOf {
  Order& order;  // which nothing here changes
  std::string operator()(const FlagValue& v) const { return v.in(order) ? "true" : ""; }
  std::string operator()(const WholeValue& v) const {
    const int number = v.in(order);
    return number < v.low ? "" : std::to_string(number);
  }
  std::string operator()(const OptionalWholeValue& v) const {
    return v.in(order) ? std::to_string(*v.in(order)) : std::string();
  }
  std::string operator()(const NumberValue& v) const {
    return v.in(order) < v.low ? std::string() : number_text(v.in(order));
  }
  std::string operator()(const OptionalNumberValue& v) const {
    return v.in(order) ? number_text(*v.in(order)) : std::string();
  }
  std::string operator()(const CountValue& v) const {
    return v.in(order) ? std::to_string(*v.in(order)) : std::string();
  }
  std::string operator()(const ChoiceValue& v) const {
    const std::optional<std::size_t> place = v.get(order);
    return place ? v.words[*place] : std::string();
  }
  std::string operator()(const TextValue& v) const { return v.in(order); }
  std::string operator()(const ParsedValue& v) const { return v.text(order); }
  std::string operator()(const KnivesValue&) const {
    std::string texts;
    for (const Knife& knife : order.cut.knives) texts += (texts.empty() ? "" : " ") + knife.text;
    return texts;
  }
};

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

std::string fault_of_option(const OrderOption& option, const std::string& text) {
  return std::visit(FaultOf{text}, option.value);
}

void read_option(const OrderOption& option, const std::string& text, Order& order, bool none_is_zero) {
  const auto* whole = std::get_if<WholeValue>(&option.value);
  if (none_is_zero && whole != nullptr && whole->low > 0 && text == "0") return void(whole->in(order) = 0);
  const std::string fault = fault_of_option(option, text);
  if (!fault.empty()) throw Error(ExitStatus::usage, flag_of(option) + ": " + fault);
  std::visit(Read{text, order}, option.value);
}

std::string text_of_option(const OrderOption& option, const Order& order) {
  Order copy = order;
  return std::visit(TextOf{copy}, option.value);
}

bool is_ordered(const OrderOption& option, const Order& order, const Order& usual) {
  return text_of_option(option, order) != text_of_option(option, usual);
}

std::string piece_words(const Order& order, const std::vector<OrderOption>& table) {
  std::string words;
  for (const OrderOption& option : table) {
    if (!option.makes_piece || !is_ordered(option, order)) continue;
    if (option.need == OptionNeed::textures && !is_met(option.need, order)) continue;
    if (std::holds_alternative<KnivesValue>(option.value)) {
      for (const Knife& knife : order.cut.knives) words += " --knife " + shell_word(knife.text);
      continue;
    }
    words += " " + flag_of(option);
    if (!std::holds_alternative<FlagValue>(option.value)) words += " " + shell_word(text_of_option(option, order));
  }
  return words;
}

std::vector<std::string> idle_options(const Order& order, OrderTaker taker, const Order& usual,
                                      const std::vector<OrderOption>& table) {
  // Scenes and batches draw variants by seeds of their own.
  const bool has_own_seeds = taker == OrderTaker::scene || taker == OrderTaker::batch;
  std::vector<std::string> warnings;
  for (const OrderOption& option : table) {
    if (!has_option(taker, option) || !is_ordered(option, order, usual)) continue;
    if (!option.heeded.empty() && !any_is(order.outputs, option.heeded)) {
      warnings.push_back(flag_of(option) + " is about " + endings_of(option.heeded) + ": no output is one");
    } else if (!is_met(option.need, order) && !(has_own_seeds && option.need == OptionNeed::a_variant)) {
      warnings.push_back(flag_of(option) + " " + words_of(option.need));
    }
  }
  return warnings;
}

}  // namespace pomona
