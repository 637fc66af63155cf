#include "generator/template/read/read_place.h"

#include <algorithm>
#include <string>
#include <utility>

#include "generator/base/nearest_name.h"
#include "generator/base/path_within.h"
#include "generator/base/small_ending.h"
#include "generator/template/read/file_beside.h"
#include "generator/template/read/placed_parts.h"
#include "generator/template/read/read_law.h"
#include "generator/template/read/read_stops.h"
#include "generator/template/read/surface_names.h"
#include "generator/text/read_name.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

constexpr std::size_t max_places = 8, max_levels = 4, max_parts = 64;

/// The template that a place names. Faults are noted at the value.
std::shared_ptr<const Template> read_placed(const TomlValue& value, const PlacedWithin& within) {
  const std::string name = value.text();
  if (name.empty()) return {};
  const fs::path folder = within.around.back().parent_path(), file = folder / name;
  if (small_ending(file) != ".toml") {
    value.error("is no template", "write the name of a file .toml beside this one, or in a folder below");
    return {};
  }
  if (fs::path(name).is_absolute() || !path_within(folder, file)) {
    value.error("leads out of the template's folder", "put the file beside the template");
    return {};
  }
  std::error_code ignored;
  for (const fs::path& around : within.around) {
    if (fs::weakly_canonical(around, ignored) != fs::weakly_canonical(file, ignored)) continue;
    value.error("places a template within itself", "place another template");
    return {};
  }
  if (within.around.size() > max_levels) {
    value.error("is more than " + std::to_string(max_levels) + " templates deep", "place it further out");
    return {};
  }
  if (--*within.left < 0) {
    value.error("is one of more than 64 templates within one", "leave some out");
    return {};
  }
  try {
    return std::make_shared<const Template>(read_placed_template(file, within));
  } catch (const Error& error) {
    if (error.status() != ExitStatus::input_missing) throw;
    value.error("cannot be read: " + error.diagnostics().front().message, hint_for_missing(file));
    return {};
  }
}

PressSketch read_press(const TomlTable& table, const Template& placed, const Template& fruit) {
  PressSketch press;
  press.surface = table.need("surface").choice(surface_names(placed));
  press.heart = table.get("heart").number(press.heart, {0.05, 0.95});
  press.gap = table.get("gap").length(press.gap, {0, 0.1});
  press.soft = table.get("soft").number(press.soft, {0.005, 0.2});
  if (table.has("against")) {
    for (const TomlValue& surface : table.get("against").values()) {
      if (press.against.size() == fruit.surfaces.size()) break;
      press.against.push_back(surface.choice(surface_names(fruit)));
    }
  }
  if (table.has("root")) press.root = table.get("root").length(0, {0, 0.1});
  return press;
}

StalkSketch read_stalk(const TomlTable& table, const Template& fruit) {
  StalkSketch stalk;
  stalk.from = table.need("from").choice(surface_names(fruit));
  stalk.rise = table.get("rise").length(stalk.rise, {-1, 1});
  const TomlValue width = table.get("width");
  const Within thick{1e-4, 0.1};
  if (width.is(TomlNode::Kind::array)) {
    const auto widths = width.values(2, "must be one length, or two: at the root and at the top");
    if (!widths.empty()) {
      stalk.root_width = widths[0].length(stalk.root_width, thick);
      stalk.top_width = widths[1].length(stalk.top_width, thick);
    }
  } else if (width.given()) {
    stalk.root_width = stalk.top_width = width.length(stalk.root_width, thick);
  }
  stalk.depth = table.get("depth").length(stalk.depth, {0, 0.1});
  stalk.around = table.get("around").integer(stalk.around, 3, 64);
  stalk.part = table.need("part").choice(fruit.parts);
  stalk.color = table.need("color").color();
  return stalk;
}

void read_stance(const TomlTable& table, PlaceSketch& place) {
  place.foot = static_cast<PlaceSketch::Foot>(table.get("seat").choice({"bottom", "middle", "top"}));
  place.heading =
      static_cast<PlaceSketch::Heading>(table.get("heading").choice({"out", "in", "along", "up", "down", "stalk"}));
  place.tilt = table.get("tilt").angle(0, {-90, 90});
  place.tilt_jitter = table.get("tilt_jitter").angle(0, {0, 90});
  place.turn = table.get("turn").angle(0, {-360, 360});
  place.turn_jitter = table.get("turn_jitter").angle(0, {0, 180});
  place.sink = table.get("sink").length(0, {-0.1, 0.1});
  place.size = read_ramp<double>(table.get("size"), 1.0, [](const TomlValue& stop) {
    return stop.number(1, {0.05, 4});
  });
  place.size_jitter = table.get("size_jitter").number(0, {0, 0.9});
}

/// Seats of a cluster lie in space, all others on a surface around the axis.
void read_ground(const TomlTable& table, const Template& fruit, PlaceSketch& place) {
  const std::optional<int> law = read_law_name(table.need("law"), fruit.laws);
  place.law = law.value_or(0);
  const bool is_cluster = law && fruit.laws[static_cast<std::size_t>(*law)].kind == LawSketch::Kind::cluster;
  const TomlValue surface = is_cluster ? table.get("surface") : table.need("surface");
  place.on_front = table.get("side").choice({"front", "back"}) == 0;
  if (!surface.given()) return;
  if (is_cluster) return surface.error("is given beside a cluster, whose seats lie on none", "leave it out");
  place.surface = surface.choice(surface_names(fruit));
  const auto at = static_cast<std::size_t>(*place.surface);
  if (at < fruit.surfaces.size() && fruit.surfaces[at].type == SurfaceType::in_fold)
    surface.error("lies in folds", "seats of laws lie on surfaces around the axis");
}

MergedParts read_merged(const TomlTable& table, const Template& fruit, const Template& placed) {
  MergedParts merged;
  for (const std::string& part : table.keys()) {
    const TomlValue value = table.get(part);
    if (std::find(placed.parts.begin(), placed.parts.end(), part) == placed.parts.end())
      value.error("is no part of what is placed", name_hint(part, placed.parts));
    const int as = value.choice(fruit.parts);
    merged[part] = fruit.parts[static_cast<std::size_t>(as)];
  }
  return merged;
}

/// What is placed brings its materials: [material.kernel.hull] would change no part.
void refuse_materials(const TomlTable& root, const TomlTable& place, const Template& fruit) {
  if (!root.has("material")) return;
  const TomlTable materials = root.get("material").table();
  const std::string name = place.get("name").text(), prefix = name + ".";
  for (const std::string& key : materials.keys()) {
    const bool is_own = std::find(fruit.parts.begin(), fruit.parts.end(), key) != fruit.parts.end();
    if (is_own || (key != name && key.compare(0, prefix.size(), prefix) != 0)) continue;
    materials.get(key).error("belongs to what place \"" + name + "\" sets here",
                             "write it as [material.PART] into " + place.get("template").text());
  }
}

/// What is brought along counts against the same limits.
void check_brought(const TomlTable& table, const Template& fruit) {
  if (fruit.parts.size() > max_parts)
    table.error("makes more than " + std::to_string(max_parts) + " parts of the fruit", "merge some of them");
  for (const DetailFace face : {DetailFace::cut, DetailFace::skin}) {
    const auto count = std::count_if(fruit.details.begin(), fruit.details.end(),
                                     [&](const DetailSketch& detail) { return detail.face == face; });
    if (count > max_details_of_a_face)
      table.error("brings more than " + std::to_string(max_details_of_a_face) + " details together",
                  "leave some out of what is placed");
  }
}

std::optional<PlaceSketch> read_place(const TomlTable& table, const PlacedWithin& within, const Template& fruit,
                                      MergedParts& merged) {
  PlaceSketch place;
  place.placed = read_placed(table.need("template"), within);
  read_ground(table, fruit, place);
  read_stance(table, place);
  place.individuals = table.get("individuals").integer(0, 0, 4096);
  place.detail = table.get("detail").number(1, {0.1, 4});
  if (table.has("stalk")) place.stalk = read_stalk(table.get("stalk").table(), fruit);
  if (place.heading == PlaceSketch::Heading::stalk && !place.stalk)
    table.get("heading").error("looks to a stalk, but there is none", "write stalk = { from = ... }");
  const TomlValue press = table.get("press"), merge = table.get("merge");
  if (!place.placed) return {};  // noted; faults of the press and of parts would be misleading
  if (press.given()) place.press = read_press(press.table(), *place.placed, fruit);
  if (place.press && place.press->root && !place.surface)
    press.table().get("root").error("needs a ground", "seats of a cluster lie on no surface");
  if (merge.given()) merged = read_merged(merge.table(), fruit, *place.placed);
  return place;
}

}  // namespace

void read_places(const TomlTable& root, const PlacedWithin& within, Template& fruit) {
  if (!root.has("place")) return;
  std::vector<std::string> names = surface_names(fruit);
  std::vector<MergedParts> merged;
  std::vector<TomlTable> tables;
  for (const TomlTable& entry : root.get("place").tables(max_places)) {
    const TomlTable table = entry.called("place \"" + entry.get("name").text() + "\"");
    names.push_back(read_name(table.need("name"), names));
    refuse_materials(root, table, fruit);
    MergedParts own;
    std::optional<PlaceSketch> place = read_place(table, within, fruit, own);
    if (!place) continue;
    place->name = names.back();
    fruit.places.push_back(std::move(*place));
    merged.push_back(std::move(own));
    tables.push_back(table);
  }
  for (std::size_t i = 0; i < fruit.places.size(); ++i) {
    PlaceSketch& place = fruit.places[i];
    place.parts = bring_parts(fruit, *place.placed, place.name, merged[i]);
    check_brought(tables[i], fruit);
  }
}

}  // namespace pomona
