#include "generator/template/read/read_detail.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

#include "generator/template/read/read_depth.h"
#include "generator/template/read/read_example.h"

namespace pomona {

namespace {

constexpr std::size_t max_details = 2 * max_details_of_a_face;
constexpr Within detail_size{5e-5, 0.1};   // metres
constexpr Within detail_length{5e-5, 10};  // metres

const std::vector<std::string> kind_names = {"fibres", "cells", "speckles", "streaks", "net", "example"};
const std::vector<std::string> run_names = {"none", "to_skin", "along", "around"};
const std::vector<std::string> face_names = {"cut", "skin"};

/// The face on which a kind of detail lies unless `on` says otherwise.
DetailFace usual_face(DetailKind kind) {
  const bool is_inside = kind == DetailKind::fibres || kind == DetailKind::cells || kind == DetailKind::example;
  return is_inside ? DetailFace::cut : DetailFace::skin;
}

/// Reads one name of a part, or several.
std::vector<int> read_parts(const TomlValue& value, const Template& fruit) {
  std::vector<int> parts;
  if (fruit.parts.empty()) return parts;
  if (!value.is(TomlNode::Kind::array)) {
    if (value.given()) parts.push_back(value.choice(fruit.parts));
    return parts;
  }
  for (const TomlValue& name : value.values()) parts.push_back(name.choice(fruit.parts));
  if (parts.empty()) value.error("names no part");
  return parts;
}

/// Reads a length, or the smallest and the largest.
void read_sizes(const TomlValue& value, DetailSketch& detail) {
  if (!value.is(TomlNode::Kind::array)) {
    detail.size = detail.smallest = value.length(detail.size, detail_size);
    return;
  }
  const auto sizes = value.values(2, "has not two lengths", "write the least and the most: [\"0.3mm\", \"1mm\"]");
  if (sizes.empty()) return;
  detail.smallest = sizes[0].length(detail.smallest, detail_size);
  detail.size = sizes[1].length(detail.size, detail_size);
  if (detail.smallest > detail.size) value.error("is least first, then most");
}

/// Reads where the detail moves colours: towards a colour, or in a direction of OKLab.
void read_change(const TomlTable& table, DetailSketch& detail) {
  detail.amount = table.need("amount").number(0, {-1, 1});
  const TomlValue color = table.get("color"), axis = table.get("axis");
  if (color.given()) {
    detail.color = color.color();
    if (axis.given()) axis.error("is there beside a color", "keep one of them");
    if (detail.amount < 0) table.get("amount").error("is below 0, and a color is gone towards", "write 0 to 1");
  }
  const auto numbers = axis.values(3, "must have three numbers", "[1, 0, 0] is from dark to light");
  if (numbers.empty()) return;
  for (int i = 0; i < 3; ++i)
    detail.axis[i] = static_cast<float>(numbers[static_cast<std::size_t>(i)].number(0, {-1, 1}));
  if (detail.axis == glm::vec3(0)) axis.error("has no direction", "[1, 0, 0] is from dark to light");
}

/// The largest radius and half the height of the drawn fruit, which scale patterns that run around it.
void measure(const Template& fruit, DetailSketch& detail) {
  const HeightRange heights = drawn_heights(fruit);
  if (heights.high > heights.low) detail.middle = 0.5 * (heights.high - heights.low);
  double reach = 0;
  for (const SurfaceSketch& surface : fruit.surfaces)
    for (const glm::dvec2& point : surface.vertical.points) reach = std::max(reach, point.x);
  if (reach > 0) detail.reach = reach;
}

/// Keys that say how drawn marks look, where an example shows it.
constexpr std::array drawn_keys = {"width", "density", "softness", "wander", "variety", "color", "axis"};

void read_marks(const TomlTable& table, DetailSketch& detail) {
  detail.width = table.get("width").number(detail.width, {0, 1});
  detail.density = table.get("density").number(detail.density, {0.01, 0.99});
  detail.softness = table.get("softness").number(detail.softness, {0, 1});
  detail.wander = table.get("wander").number(detail.wander, {0, 2});
  detail.variety = table.get("variety").number(detail.variety, {0, 1});
  read_change(table, detail);
  if (table.has("example")) table.get("example").error("is there, but the kind is another", "write kind = \"example\"");
}

/// \param known details before, whose tiles are shared.
void read_tile(const TomlTable& table, const Template& fruit, const std::vector<DetailSketch>& known,
               DetailSketch& detail) {
  for (const char* key : drawn_keys)
    if (table.has(key)) table.get(key).error("is of drawn marks, and an example shows its own", "leave it out");
  if (table.get("size").is(TomlNode::Kind::array))
    table.get("size").error("is the width of one tile", "write one length");
  detail.amount = table.need("amount").number(0, {0, 1});
  const std::filesystem::path folder = std::filesystem::path(fruit.file).parent_path();
  const TomlValue value = table.need("example");
  const std::string path = value.is(TomlNode::Kind::string) ? (folder / value.text()).string() : std::string();
  const auto same = std::find_if(known.begin(), known.end(),
                                 [&](const DetailSketch& other) { return other.tile && other.tile->path == path; });
  detail.tile = same != known.end() ? same->tile : read_example(value, folder);
}

DetailSketch read_detail(const TomlTable& table, const Template& fruit, const std::vector<DetailSketch>& known) {
  // A detail has a kind, and lies on the cut faces or the skin of some parts.
  DetailSketch detail;
  detail.kind = static_cast<DetailKind>(table.need("kind").choice(kind_names));
  detail.face = static_cast<DetailFace>(table.get("on").choice(face_names, static_cast<int>(usual_face(detail.kind))));
  detail.parts = read_parts(table.need("part"), fruit);

  // The next keys say how large its marks are, and which way they run.
  read_sizes(table.need("size"), detail);
  detail.run = static_cast<DetailRun>(table.get("run").choice(run_names));
  detail.length = table.get("length").length(detail.size, detail_length);
  if (table.has("length") && detail.run == DetailRun::none)
    table.get("length").error("is along a run, and there is none", "write run = \"to_skin\", \"along\" or \"around\"");

  // The last keys say what it does to colours, near which of them, and how deep below the skin.
  if (detail.kind == DetailKind::example) {
    read_tile(table, fruit, known, detail);
  } else {
    read_marks(table, detail);
  }
  if (table.has("near")) detail.near = table.get("near").color();
  detail.near_within = table.get("near_within").number(detail.near_within, {1e-3, 10});
  detail.depth = read_depth_ramp(table.get("depth"), 1, {0, 1});
  detail.relief = table.get("relief").length(0, {-0.01, 0.01});
  measure(fruit, detail);
  return detail;
}

}  // namespace

std::vector<DetailSketch> read_details(const TomlValue& value, const Template& fruit) {
  std::vector<DetailSketch> details;
  int on_face[2] = {};
  for (const TomlTable& table : value.tables(max_details)) {
    details.push_back(read_detail(table, fruit, details));
    if (++on_face[static_cast<int>(details.back().face)] != max_details_of_a_face + 1) continue;
    table.error("is one too many",
                "at most " + std::to_string(max_details_of_a_face) + " may be on cut faces, and as many on the skin");
  }
  return details;
}

}  // namespace pomona
