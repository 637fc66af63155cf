#include "generator/scene/scene_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "generator/knife/read_knife.h"
#include "generator/template/read/read_name.h"
#include "generator/template/read/read_paint.h"
#include "generator/template/read/svg_path.h"
#include "generator/template/read/toml_document.h"
#include "generator/template/read/toml_text.h"

namespace pomona {

namespace {

constexpr int most_pieces = 4096;  // of one entry, and of the scene

glm::dvec3 read_vector(const TomlValue& value, Within within, const glm::dvec3& fallback) {
  if (!value.given()) return fallback;
  const std::vector<TomlValue> parts = value.values();
  if (parts.size() != 3) {
    if (value.is(TomlNode::Kind::array)) value.error("needs three numbers", "write [x, y, z]");
    return fallback;
  }
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

/// A profile that can be turned: one open simple line from the axis to the axis, in the right half plane.
std::string fault_of_profile(const std::vector<Curve>& curves) {
  if (curves.size() != 1) return "must be one line";
  const Curve& curve = curves[0];
  if (curve.closed || curve.points.size() < 4) return "must be an open line of some length";
  if (curve.points.front().x != 0 || curve.points.back().x != 0) return "must begin and end on the axis, x = 0";
  for (std::size_t i = 1; i + 1 < curve.points.size(); ++i)
    if (!(curve.points[i].x > 0)) return "must lie right of the axis, x > 0, between its ends";
  if (!is_simple(curve)) return "crosses itself";
  double area = 0;  // counter-clockwise: up the outside, down the inside
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    area += curve.points[i - 1].x * curve.points[i].y - curve.points[i].x * curve.points[i - 1].y;
  if (!(area > 0)) return "must go up along the outside and come down along the inside";
  for (const glm::dvec2& p : curve.points)
    if (std::max(p.x, std::fabs(p.y)) > 10) return "lies more than 10 m from the axis";
  return {};
}

Curve read_profile(const TomlValue& value, double unit) {
  if (!value.is(TomlNode::Kind::string)) {
    value.text();  // notes that it is none
    return {};
  }
  try {
    std::vector<Curve> curves = parse_svg_path(value.text(), {.unit = unit});
    const std::string fault = fault_of_profile(curves);
    if (!fault.empty()) {
      value.error(fault, "draw the clay from the axis below, up the outside, over the rim and down the inside");
      return {};
    }
    double lowest = curves[0].points[0].y;
    for (const glm::dvec2& p : curves[0].points) lowest = std::min(lowest, p.y);
    for (glm::dvec2& p : curves[0].points) p.y -= lowest;
    return std::move(curves[0]);
  } catch (const BadPath& bad) {
    value.error(bad.what(), bad.hint);
    return {};
  }
}

BowlDescription read_bowl(const TomlTable& table) {
  BowlDescription bowl;
  const double unit = table.get("unit").length(1e-3, {1e-6, 1});
  bowl.profile = read_profile(table.need("profile"), unit);
  bowl.color = read_ramp<Color>(table.get("color"), Color(0.8f), [](const TomlValue& v) { return v.color(); });
  bowl.around = table.get("around").integer(bowl.around, 16, 512);
  bowl.along = table.get("along").integer(bowl.along, 16, 512);
  return bowl;
}

/// A number, or the two ends of a range to draw from, [0.6, 1.4].
std::optional<Within> read_range(const TomlValue& value, Within within) {
  if (!value.given()) return {};
  if (!value.is(TomlNode::Kind::array)) {
    const double number = value.number(within.low, within);
    return Within{number, number};
  }
  const std::vector<TomlValue> ends = value.values();
  if (ends.size() != 2) {
    value.error("needs two numbers", "write [lowest, highest], or one number");
    return {};
  }
  const Within range{ends[0].number(within.low, within), ends[1].number(within.high, within)};
  if (range.high < range.low) value.error("is empty", "write the lower end first");
  return range;
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
    scene_.layout = root.get("layout").text();
    scene_.layout_place = root.get("layout").place();
    read_settling(root.get("settle").table());
    read_pieces(root.need("pieces"));
    document_.throw_if_any();
    return std::move(scene_);
  }

 private:
  void read_size(const TomlValue& value) {
    if (!value.given()) return;
    const std::vector<TomlValue> size = value.values();
    if (size.size() != 2) {
      if (value.is(TomlNode::Kind::array)) value.error("needs two numbers", "write [width, height] in pixels");
      return;
    }
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
    int total = 0;
    for (const TomlTable& entry : entries) {
      scene_.pieces.push_back(read_entry(entry));
      total += scene_.pieces.back().count;
      if (total > most_pieces) {
        entry.error("makes more than " + std::to_string(most_pieces) + " variants of the scene", "lower \"count\"");
        return;
      }
    }
  }

  PiecesDescription read_entry(const TomlTable& unnamed) {
    // Messages call the entry by its name, which no other entry may have.
    PiecesDescription pieces;
    const TomlTable table = unnamed.called("pieces \"" + unnamed.get("name").text() + "\"");
    pieces.name = read_name(table.need("name"), names_);
    names_.push_back(pieces.name);

    // The next keys say which fruit it is, how many variants there are and how far they are from the drawing.
    const TomlValue fruit = table.need("template");
    pieces.template_name = fruit.text();
    pieces.template_place = fruit.place();
    if (fruit.is(TomlNode::Kind::string) && pieces.template_name.empty()) fruit.error("is empty");
    pieces.count = table.get("count").integer(1, 1, most_pieces);
    pieces.as_drawn = table.get("as_drawn").boolean(false);
    if (table.has("folds")) pieces.folds = table.get("folds").integer(1, 1, most_folds);
    pieces.variation = table.get("variation").number(1, {0, 2});
    if (pieces.as_drawn && table.has("variation"))
      table.get("variation").error("has no effect on what is as drawn", "keep \"variation\" or \"as_drawn\"");
    pieces.ripeness = read_range(table.get("ripeness"), {0, 2});
    pieces.browning = read_range(table.get("browning"), {0, 1});

    // Then come the knives, and which of the pieces are placed how often.
    pieces.knives = read_knives(table.get("knives").values(), std::filesystem::path(file_).parent_path());
    pieces.take = table.get("take").integer(0, 0, most_pieces);
    pieces.copies = table.get("copies").integer(1, 1, 1000);
    pieces.smallest = table.get("smallest").number(pieces.smallest, {0, 1});
    pieces.largest = table.get("largest").number(pieces.largest, {0, 1});
    if (pieces.largest < pieces.smallest) table.get("largest").error("is below \"smallest\"", "exchange them");

    // The last keys say when and where the pieces fall.
    pieces.order = table.get("order").integer(0, -1000, 1000);
    pieces.face_up = table.get("face_up").boolean(false);
    pieces.beside = table.get("beside").boolean(false);
    return pieces;
  }

  TomlDocument document_;
  std::string file_;
  SceneDescription scene_;
  std::vector<std::string> names_;  ///< of the entries so far
};

}  // namespace

SceneDescription parse_scene(std::string_view toml, const std::string& file) { return SceneReader(toml, file).read(); }

SceneDescription read_scene(const std::filesystem::path& file) {
  return parse_scene(read_toml_text(file), file.string());
}

bool is_scene_file(const std::filesystem::path& file) { return has_toml_heading(file, {"[[pieces]]", "[bowl]"}); }

}  // namespace pomona
