#include "generator/scene/scene_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/nearest_name.h"
#include "generator/knife/read_knife.h"
#include "generator/order/option_key.h"
#include "generator/scene/read_dish.h"
#include "generator/text/read_name.h"
#include "generator/text/read_range.h"
#include "generator/text/toml_document.h"
#include "generator/text/toml_text.h"

namespace pomona {

namespace {

constexpr Within within_reach{-100, 100};  // metres
constexpr Within size_of_where{0, 10};

glm::dvec2 read_two(const TomlValue& value, Within within) {
  const std::vector<TomlValue> parts = value.values(2, "needs two lengths", "write [\"10cm\", \"-5cm\"]");
  if (parts.empty()) return glm::dvec2(0);
  return {parts[0].length(0, within), parts[1].length(0, within)};
}

/// The table `where` of an entry. Errors are noted in the document.
PieceArrangement read_arrangement(const TomlTable& table) {
  // The order of the names is that of the kinds.
  static const std::vector<std::string> kinds{"heap", "rows", "grid", "scatter", "as-cut"};
  PieceArrangement how;
  how.kind = static_cast<PieceArrangementKind>(table.need("kind").choice(kinds));
  how.at = read_two(table.get("at"), within_reach);
  how.turn = table.get("turn").angle(0, {-360, 360});
  switch (how.kind) {
    case PieceArrangementKind::heap:
      how.within = table.get("within").length(0, size_of_where);
      if (table.has("at") && how.within <= 0)
        table.get("at").error("needs \"within\", too", "say how wide the heap is");
      break;
    case PieceArrangementKind::rows:
      how.columns = table.get("columns").integer(0, 1, 10000);
      how.gap = table.get("gap").length(how.gap, size_of_where);
      break;
    case PieceArrangementKind::grid:
      how.columns = table.get("columns").integer(0, 1, 10000);
      how.spacing = read_two(table.need("spacing"), {1e-3, 10});
      break;
    case PieceArrangementKind::scatter:
      how.gap = table.get("gap").length(how.gap, size_of_where);
      break;
    case PieceArrangementKind::as_cut:
      how.gap = table.get("gap").length(how.gap, size_of_where);
      how.line = table.get("line").length(0, size_of_where);
      how.lean = table.get("lean").angle(how.lean, {0, 60});
      break;
  }
  return how;
}

constexpr int max_variants = 4096;  // limit for one entry, and for the scene
constexpr int max_pieces = static_cast<int>(max_scene_pieces);

glm::dvec3 read_vector(const TomlValue& value, Within within, const glm::dvec3& fallback) {
  const std::vector<TomlValue> parts = value.values(3, "needs three numbers", "write [x, y, z]");
  if (parts.empty()) return fallback;
  return {parts[0].number(0, within), parts[1].number(0, within), parts[2].number(0, within)};
}

void read_view(const TomlTable& table, SceneDescription& scene) {
  const Within metres{-100, 100};
  scene.vertical_field = table.get("field").angle(scene.vertical_field, {1, 120});
  scene.view_direction = read_vector(table.get("direction"), metres, scene.view_direction);
  if (table.has("direction") && glm::length(scene.view_direction) <= 0)
    table.get("direction").error("has no length", "write where the eye is, seen from the dish, as in [0, 0.7, 1]");
  if (!table.has("eye") && !table.has("target")) return;

  if (table.has("direction")) table.get("direction").error("and eye exclude each other", "keep one of them");
  const View view{read_vector(table.need("eye"), metres, {0, 0.3, 0.5}), read_vector(table.need("target"), metres, {}),
                  scene.vertical_field};
  if (view.eye == view.target) table.error("looks from its target at itself", "move the eye away");
  scene.view = view;
}

class SceneReader {
 public:
  SceneReader(std::string_view toml, const std::string& file) : document_(toml, file), file_(file) {}

  SceneDescription read() {
    const TomlTable root = document_.root();
    scene_.file = file_;
    root.need("format").integer(1, 1, 1);
    scene_.name = read_name(root.need("name"), {});
    scene_.title = root.get("title").text(scene_.name);
    scene_.seed = static_cast<std::uint64_t>(root.get("seed").integer(0, 0, std::numeric_limits<int>::max()));
    if (root.has("paper")) scene_.paper = root.get("paper").color();
    scene_.style = root.get("style").text();
    scene_.ground = root.get("ground").boolean(true);
    read_size(root.get("size"));
    read_view(root.get("view").table(), scene_);
    if (root.has("bowl")) scene_.bowl = read_bowl(root.get("bowl").table());
    scene_.bowl_place = root.get("bowl").place();
    scene_.dishes = read_dishes(root.get("dishes"), std::filesystem::path(file_).parent_path(), {"bowl"});
    scene_.total = root.get("total").integer(0, 1, max_pieces);
    scene_.layout = root.get("layout").text();
    scene_.layout_place = root.get("layout").place();
    read_settling(root.get("settle").table());
    read_pieces(root.need("pieces"));
    check_shares(root.get("total"));
    document_.throw_if_any();
    return std::move(scene_);
  }

 private:
  void read_size(const TomlValue& value) {
    const std::vector<TomlValue> size = value.values(2, "needs two numbers", "write [width, height] in pixels");
    if (size.empty()) return;
    scene_.width = size[0].integer(scene_.width, 16, 16384);
    scene_.height = size[1].integer(scene_.height, 16, 16384);
  }

  void read_settling(const TomlTable& table) {
    scene_.friction = table.get("friction").number(scene_.friction, {0, 2});
    scene_.fill = table.get("fill").number(scene_.fill, {0.1, 1});
    scene_.spread = table.get("spread").length(scene_.spread, {1e-3, 10});
    scene_.around = table.get("around").number(scene_.around, {1, 10});
    scene_.attempts = table.get("attempts").integer(scene_.attempts, 1, 20);
  }

  void read_pieces(const TomlValue& value) {
    const std::vector<TomlTable> entries = value.tables();
    if (value.given() && entries.empty()) value.error("is empty", "say what lies in the dish: [[pieces]]");
    int variants = 0;
    std::int64_t placed = scene_.total;
    for (const TomlTable& entry : entries) {
      scene_.pieces.push_back(read_entry(entry));
      const PiecesDescription& pieces = scene_.pieces.back();
      // Each variant has at least one piece; knives decide how many more.
      if (pieces.share <= 0) placed += pieces.total > 0 ? pieces.total : std::int64_t{pieces.count} * pieces.copies;
      if (placed > max_pieces) {
        entry.error("makes more than " + std::to_string(max_pieces) + " pieces of the scene",
                    "lower \"total\", \"copies\" or \"count\"");
        return;
      }
      variants += pieces.count;
      if (variants > max_variants) {
        entry.error("makes more than " + std::to_string(max_variants) + " variants of the scene", "lower \"count\"");
        return;
      }
    }
  }

  /// A total needs shares, and shares need a total.
  void check_shares(const TomlValue& total) const {
    const bool some =
        std::any_of(scene_.pieces.begin(), scene_.pieces.end(), [](const auto& p) { return p.share > 0; });
    if (total.given() && !some) total.error("is of no use where no entry has a \"share\"", "write share = 1 in one");
  }

  /// What may be meant by a name that no dish has.
  std::string hint_of_dishes(const std::string& name) const {
    std::vector<std::string> known;
    for (const DishDescription& dish : scene_.dishes) known.push_back(dish.name);
    return known.empty() ? "describe it: [[dishes]]" : name_hint(name, known);
  }

  /// Reads the dish in or on which the pieces lie.
  void read_dish_of(const TomlTable& table, PiecesDescription& pieces) {
    const TomlValue in = table.get("in"), on = table.get("on");
    if (in.given() && on.given()) on.error("and \"in\" exclude each other", "keep one of them");
    if (!in.given() && !on.given()) return;
    const TomlValue named = on.given() ? on : in;
    pieces.on_top = on.given();
    pieces.dish = named.text();
    if (named.is(TomlNode::Kind::string) && pieces.beside) named.error("and \"beside\" exclude each other", {});
    if (pieces.dish == "bowl" && scene_.bowl && !on.given()) {
      pieces.dish.clear();
      return;
    }
    const auto same = [&](const DishDescription& dish) { return dish.name == pieces.dish; };
    const auto dish = std::find_if(scene_.dishes.begin(), scene_.dishes.end(), same);
    if (dish == scene_.dishes.end()) {
      if (named.is(TomlNode::Kind::string)) named.error("names no dish of this scene", hint_of_dishes(pieces.dish));
      return;
    }
    if (!dish->part_of.empty())
      named.error("is a part of \"" + dish->part_of + "\"", "name \"" + dish->part_of + "\" instead");
    for (const PiecesDescription& other : scene_.pieces)
      if (other.dish == pieces.dish && other.on_top != pieces.on_top)
        named.error("is said to be \"in\" and \"on\" the same dish", "\"" + other.name + "\" is the other way");
  }

  PiecesDescription read_entry(const TomlTable& unnamed) {
    // Messages call the entry by its name, which no other entry may have.
    PiecesDescription pieces;
    const TomlTable table = unnamed.called("pieces \"" + unnamed.get("name").text() + "\"");
    pieces.name = read_name(table.need("name"), names_);
    pieces.place = table.get("name").place();
    names_.push_back(pieces.name);

    // The next keys say which fruit it is, how many variants there are and how far they are from the drawing.
    const TomlValue fruit = table.need("template");
    pieces.template_name = fruit.text();
    pieces.template_place = fruit.place();
    if (fruit.is(TomlNode::Kind::string) && pieces.template_name.empty()) fruit.error("is empty");
    pieces.count = table.get("count").integer(1, 1, max_variants);
    pieces.as_drawn = table.get("as_drawn").boolean(false);
    if (table.has("folds")) pieces.folds = table.get("folds").integer(1, 1, max_folds);
    pieces.variation = table.get("variation").number(1, range_of(order_option("variation")));
    if (pieces.as_drawn && table.has("variation"))
      table.get("variation").error("has no effect on what is as drawn", "keep \"variation\" or \"as_drawn\"");
    pieces.detail = table.get("detail").number(1, range_of(order_option("detail")));
    pieces.size = number_range(table.get("size"), range_of(order_option("scale")));
    pieces.ripeness = number_range(table.get("ripeness"), range_of(order_option("ripeness")));
    pieces.browning = number_range(table.get("browning"), range_of(order_option("browning")));

    // Then come the knives, and which of the pieces are placed how often.
    pieces.knives = read_knives(table.get("knives").values(), std::filesystem::path(file_).parent_path());
    pieces.take = table.get("take").integer(0, 0, max_variants);
    pieces.copies = table.get("copies").integer(1, 1, 10000);
    pieces.total = table.get("total").integer(0, 1, max_pieces);
    pieces.share = table.get("share").number(0, {1e-6, 1e6});
    if (pieces.share > 0 && scene_.total == 0)
      table.get("share").error("is of a total that the scene does not say", "write total = 300 before all [[pieces]]");
    for (const char* other : {"copies", "share"})
      if (pieces.total > 0 && table.has(other)) table.get(other).error("and \"total\" exclude each other", {});
    if (pieces.share > 0 && table.has("copies")) table.get("copies").error("and \"share\" exclude each other", {});
    pieces.smallest = table.get("smallest").number(pieces.smallest, {0, 1});
    pieces.largest = table.get("largest").number(pieces.largest, {0, 1});
    if (pieces.largest < pieces.smallest) table.get("largest").error("is below \"smallest\"", "exchange them");

    // The last keys say when and where the pieces fall.
    pieces.order = table.get("order").integer(0, -1000, 1000);
    pieces.face_up = table.get("face_up").boolean(false);
    pieces.upright = table.get("upright").boolean(false);
    if (pieces.upright && pieces.face_up) table.get("upright").error("and \"face_up\" exclude each other", {});
    pieces.beside = table.get("beside").boolean(false);
    read_dish_of(table, pieces);
    if (table.has("where")) pieces.where = read_arrangement(table.get("where").table());
    return pieces;
  }

  TomlDocument document_;
  std::string file_;
  SceneDescription scene_;
  std::vector<std::string> names_;  ///< names of the entries so far
};

}  // namespace

SceneDescription parse_scene(std::string_view toml, const std::string& file) { return SceneReader(toml, file).read(); }

SceneDescription read_scene(const std::filesystem::path& file) {
  return parse_scene(read_toml_text(file), file.string());
}

bool is_scene_file(const std::filesystem::path& file) {
  // A data set describes dishes, too.
  return has_toml_heading(file, {"[[pieces]]", "[bowl]", "[[dishes]]"}, {"[data]"});
}

}  // namespace pomona
