#include "generator/template/read/read_template.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "generator/base/units.h"
#include "generator/template/read/read_axis.h"
#include "generator/template/read/read_detail.h"
#include "generator/template/read/read_grains.h"
#include "generator/template/read/read_law.h"
#include "generator/template/read/read_material.h"
#include "generator/template/read/read_mesh.h"
#include "generator/template/read/read_part_cuts.h"
#include "generator/template/read/read_place.h"
#include "generator/template/read/read_ripeness.h"
#include "generator/template/read/read_sheets.h"
#include "generator/template/read/read_style.h"
#include "generator/template/read/read_surface.h"
#include "generator/template/read/read_variation.h"
#include "generator/template/read/sketch.h"
#include "generator/template/read/surface_names.h"
#include "generator/text/read_name.h"
#include "generator/text/toml_document.h"
#include "generator/text/toml_text.h"

namespace pomona {

namespace {

std::vector<double> even_angles(int count) {
  std::vector<double> angles;
  for (int k = 0; k < count; ++k) angles.push_back(2 * pi * k / count);
  return angles;
}

std::vector<double> read_fold_angles(const TomlValue& value, int count) {
  if (!value.given()) return even_angles(count);
  const std::vector<TomlValue> listed = value.values();
  if (listed.size() != static_cast<std::size_t>(count)) {
    value.error("has " + std::to_string(listed.size()) + " angles for " + std::to_string(count) + " folds");
    return even_angles(count);
  }
  std::vector<double> angles;
  for (const TomlValue& angle : listed) {
    angles.push_back(angle.angle(0, {0, 360}));
    const std::size_t n = angles.size();
    if (n > 1 && angles[n - 1] - angles[n - 2] < radians(0.5)) {
      angle.error("does not ascend", "write where each fold begins, in degrees, one after another");
    }
  }
  if (angles.back() - angles.front() > radians(359.5)) value.error("span more than a full turn");
  return angles;
}

/// The fold lines of the sketch, or none.
std::vector<double> drawn_fold_angles(const TomlValue& folds, int count, const Sketch* sketch) {
  try {
    return sketch ? sketch->fold_angles(count) : std::vector<double>();
  } catch (const BadSketch& bad) {
    folds.error(bad.what(), bad.hint);
    return {};
  }
}

/// Where folds begin, from the file, else from the sketch (may be null), else even.
Symmetry read_symmetry(const TomlTable& table, const Sketch* sketch) {
  const int kind = table.need("kind").choice({"cylindrical", "folds", "none"});
  if (kind == 0) return CylindricalSymmetry{};
  if (kind == 2) return NoSymmetry{};
  const TomlValue folds = table.need("folds"), angles = table.get("fold_angles");
  const int count = folds.integer(1, 1, max_folds);
  if (!angles.given()) {
    std::vector<double> drawn = drawn_fold_angles(folds, count, sketch);
    if (!drawn.empty()) return FoldSymmetry{std::move(drawn)};
  }
  return FoldSymmetry{read_fold_angles(angles, count)};
}

constexpr std::size_t max_surfaces = 64, max_meshes = 64, max_grain_kinds = 16, max_parts = 64;
constexpr double max_triangles = 2e6;  // limit of triangles of all surfaces at detail 1

/// The sketch the template names, if it names one that can be read.
std::optional<Sketch> read_sketch_of(const TomlTable& root, const std::string& file, std::optional<double> unit,
                                     std::optional<std::string_view> svg) {
  const TomlValue value = root.get("sketch");
  if (!value.is(TomlNode::Kind::string)) {
    value.text();  // notes a fault if there is a value that is no text
    return {};
  }
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  try {
    if (svg) return read_sketch(folder, value.text(), unit, *svg);
    return read_sketch(folder, value.text(), unit);
  } catch (const BadSketch& bad) {
    value.error(bad.what(), bad.hint);
    return {};
  }
}

std::vector<std::string> read_parts(const TomlValue& value) {
  std::vector<std::string> parts;
  for (const TomlValue& part : value.values()) {
    if (parts.size() == max_parts) {
      value.error("has more than " + std::to_string(max_parts) + " names");
      break;
    }
    parts.push_back(read_name(part, parts));
  }
  if (parts.empty() && value.is(TomlNode::Kind::array)) value.error("is empty", "name what the fruit consists of");
  return parts;
}

std::vector<SurfaceSketch> read_surfaces(const TomlTable& root, SketchSurfaceReader reader) {
  std::vector<SurfaceSketch> surfaces;
  std::vector<std::string> names;
  double triangles = 0;
  const TomlValue drawn = root.has("mesh") ? root.get("surface") : root.need("surface");
  if (!drawn.given()) return surfaces;
  for (const TomlTable& table : drawn.tables(max_surfaces)) {
    const TomlTable surface = table.called("surface \"" + table.get("name").text() + "\"");
    names.push_back(read_name(surface.need("name"), names));
    surfaces.push_back(reader.read(surface));
    const SurfaceSketch& sketch = surfaces.back();
    const std::size_t grids = sketch.type == SurfaceType::in_fold ? sketch.horizontal.size() : 1;
    triangles += 2.0 * sketch.around * sketch.along * static_cast<double>(std::max<std::size_t>(1, grids));
    if (triangles > max_triangles) {
      surface.error("makes more than 2 000 000 triangles of the fruit", "lower \"around\" or \"along\"");
      break;
    }
  }
  return surfaces;
}

/// Names must also differ from those of drawn surfaces.
std::vector<MeshSketch> read_meshes(const TomlTable& root, const Template& fruit) {
  std::vector<MeshSketch> meshes;
  std::vector<std::string> names = surface_names(fruit);
  const std::filesystem::path folder = std::filesystem::path(fruit.file).parent_path();
  if (!root.has("mesh")) return meshes;
  for (const TomlTable& table : root.get("mesh").tables(max_meshes)) {
    const TomlTable mesh = table.called("mesh \"" + table.get("name").text() + "\"");
    names.push_back(read_name(mesh.need("name"), names));
    meshes.push_back(read_mesh(mesh, fruit.parts, folder, meshes));
    meshes.back().name = names.back();
  }
  return meshes;
}

/// Curves need an axis: without symmetry there is none to draw them around.
void check_symmetry(const TomlTable& root, const Template& fruit) {
  if (!std::holds_alternative<NoSymmetry>(fruit.symmetry) || fruit.surfaces.empty()) return;
  root.get("surface").error("is drawn, but the fruit has no symmetry",
                            "write kind = \"cylindrical\" under [symmetry], or bring the surface as a [[mesh]]");
}

/// Moves all vertical curves up or down so that the lowest drawn point is at y = 0.
/// \return where that was
double set_on_ground(Template& fruit) {
  const double lowest = drawn_heights(fruit).low;
  const auto lower = [&](Curve& curve) {
    for (glm::dvec2& p : curve.points) p.y -= lowest;
  };
  for (SurfaceSketch& surface : fruit.surfaces) lower(surface.vertical);
  for (SheetSketch& sheet : fruit.sheets) {
    lower(sheet.inner);
    lower(sheet.outer);
  }
  for (LawSketch& law : fruit.laws) {
    for (glm::dvec2& p : law.envelope.points) p.y -= lowest;
  }
  return lowest;
}

/// Reads densities part by part, from air to lead. Other parts are as dense as the fruit.
std::vector<double> read_densities(const TomlTable& table, const Template& fruit) {
  std::vector<double> densities;
  for (const std::string& part : fruit.parts) densities.push_back(table.get(part).number(fruit.density, {1, 20000}));
  return densities;
}

void read_head(const TomlTable& root, Template& fruit) {
  root.need("format").integer(1, 1, 1);
  fruit.name = read_name(root.need("name"), {});
  fruit.title = root.get("title").text(fruit.name);
  fruit.latin = root.get("latin").text();
  fruit.density = root.get("density").number(fruit.density, {10, 20000});
  fruit.parts = read_parts(root.need("parts"));
  if (root.has("densities")) fruit.densities = read_densities(root.get("densities").table(), fruit);
}

/// How the drawing lies; its lowest point was `lowest` metres high.
void place_views(const std::optional<Sketch>& sketch, double unit, double lowest, DrawnTemplate& drawn) {
  const SvgTransform upright{unit, 0, 0, -unit, 0, 0}, lowered = translation({0, -lowest});
  drawn.side = sketch ? sketch->to_metres(SketchView::side) : upright;
  drawn.top = sketch ? sketch->to_metres(SketchView::top) : upright;
  if (drawn.side) drawn.side = lowered * *drawn.side;
}

/// Reads a template that others may place.
DrawnTemplate parse_within(std::string_view toml, const std::string& file, std::optional<std::string_view> svg,
                           const PlacedWithin& within) {
  TomlDocument document(toml, file);
  const TomlTable root = document.root();
  DrawnTemplate drawn;
  Template& fruit = drawn.fruit;
  fruit.file = file;
  read_head(root, fruit);

  // Curves need the unit and paint needs the parts. Without them further mistakes would be misleading.
  const bool may_lack_unit = root.has("sketch") || (root.has("mesh") && !root.has("surface"));
  const TomlValue unit_value = may_lack_unit ? root.get("unit") : root.need("unit");
  const double unit = unit_value.length(1e-3, {1e-6, 1});
  const std::optional<Sketch> sketch =
      read_sketch_of(root, file, unit_value.given() ? std::optional<double>(unit) : std::nullopt, svg);
  fruit.symmetry = read_symmetry(root.need("symmetry").table(), sketch ? &*sketch : nullptr);
  CurveReader curves(unit, {.sketch = sketch ? &*sketch : nullptr, .named = root.has("sketch")});
  if (root.has("law")) fruit.laws = read_laws(root.get("law").table(), curves);
  fruit.surfaces = read_surfaces(root, SketchSurfaceReader(curves, fruit.parts, fruit.symmetry, fruit.laws));
  fruit.sheets = read_sheets(root, curves, fruit);
  place_views(sketch, unit, set_on_ground(fruit), drawn);
  fruit.meshes = read_meshes(root, fruit);
  check_symmetry(root, fruit);

  std::vector<std::string> names;
  for (const TomlTable& table : root.get("grains").tables(max_grain_kinds)) {
    const TomlTable grains = table.called("grains \"" + table.get("name").text() + "\"");
    const std::string name = read_name(grains.need("name"), names);
    names.push_back(name);
    fruit.grains.push_back(read_grains(grains, fruit));
    fruit.grains.back().name = name;
  }
  if (root.has("part")) {
    PartCuts cuts = read_part_cuts(root.get("part").table(), fruit);
    fruit.spared = std::move(cuts.spared);
    fruit.held = std::move(cuts.held);
  }
  read_axis_of(root, curves, fruit);
  if (root.has("variation")) fruit.variation = read_variation(root.get("variation").table(), fruit);
  if (root.has("material")) fruit.materials = read_materials(root.get("material").table(), fruit.parts);
  if (root.has("noise")) fruit.noise = read_noise(root.get("noise").table());
  if (root.has("detail")) fruit.details = read_details(root.get("detail"), fruit);
  if (root.has("ink")) fruit.ink = read_ink(root.get("ink").table());
  if (root.has("ripeness")) fruit.ripeness = read_ripeness(root.get("ripeness").table(), fruit);
  if (root.has("browning")) fruit.browning = read_browning(root.get("browning").table(), fruit);
  if (root.has("variation")) fruit.variation.color = read_color_variation(root.get("variation").table(), fruit);
  read_places(root, within, fruit);
  document.throw_if_any();
  return drawn;
}

constexpr int max_placed = 64;  // templates within one, at all levels

}  // namespace

DrawnTemplate parse_drawn_template(std::string_view toml, const std::string& file,
                                   std::optional<std::string_view> svg) {
  int left = max_placed;
  return parse_within(toml, file, svg, {{file}, &left});
}

Template read_placed_template(const std::filesystem::path& file, const PlacedWithin& within) {
  PlacedWithin deeper = within;
  deeper.around.push_back(file);
  return parse_within(read_toml_text(file), file.string(), {}, deeper).fruit;
}

Template parse_template(std::string_view toml, const std::string& file) {
  return parse_drawn_template(toml, file, {}).fruit;
}

Template read_template(const std::filesystem::path& file) {
  return parse_template(read_toml_text(file), file.string());
}

}  // namespace pomona
