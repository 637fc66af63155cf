#include "generator/template/read_template.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "generator/base/units.h"
#include "generator/template/read_paint.h"
#include "generator/template/read_surface.h"
#include "generator/template/sketch.h"
#include "generator/template/toml_document.h"
#include "generator/template/toml_limits.h"

namespace pomona {

namespace {

constexpr int most_folds = 64;
constexpr std::size_t most_surfaces = 64, most_grain_kinds = 16, most_noise_keys = 64, most_parts = 64;
constexpr double most_triangles = 2e6;  // of all surfaces at detail 1

bool is_plain_name(const std::string& name) {
  const auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_'; };
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), plain);
}

/// A name for files and messages; `taken` are those it must differ from.
std::string read_name(const TomlValue& value, const std::vector<std::string>& taken) {
  const std::string name = value.text();
  if (!value.is(TomlNode::Kind::string)) return name;
  if (!is_plain_name(name)) {
    value.error("\"" + name.substr(0, 40) + "\" is not a plain name", "use a-z, 0-9, - and _, at most 64 of them");
  } else if (std::find(taken.begin(), taken.end(), name) != taken.end()) {
    value.error("\"" + name + "\" is there already", "give it a name of its own");
  }
  return name;
}

/// Tables of a kind, refusing more than `most`.
std::vector<TomlTable> limited(const TomlValue& value, std::size_t most) {
  std::vector<TomlTable> tables = value.tables();
  if (tables.size() > most) {
    value.error("is there " + std::to_string(tables.size()) + " times; the most is " + std::to_string(most));
    tables.erase(tables.begin() + static_cast<std::ptrdiff_t>(most), tables.end());
  }
  return tables;
}

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

Symmetry read_symmetry(const TomlTable& table, const Sketch* sketch) {
  if (table.need("kind").choice({"cylindrical", "folds"}) == 0) return CylindricalSymmetry{};
  const TomlValue folds = table.need("folds"), angles = table.get("fold_angles");
  const int count = folds.integer(1, 1, most_folds);
  if (!angles.given()) {
    std::vector<double> drawn = drawn_fold_angles(folds, count, sketch);
    if (!drawn.empty()) return FoldSymmetry{std::move(drawn)};
  }
  return FoldSymmetry{read_fold_angles(angles, count)};
}

/// The sketch the template names, if it names one that can be read.
std::optional<Sketch> read_sketch_of(const TomlTable& root, const std::string& file, std::optional<double> unit) {
  const TomlValue value = root.get("sketch");
  if (!value.is(TomlNode::Kind::string)) {
    value.text();  // notes that it is none, if it is there
    return {};
  }
  try {
    return read_sketch(std::filesystem::path(file).parent_path(), value.text(), unit);
  } catch (const BadSketch& bad) {
    value.error(bad.what(), bad.hint);
    return {};
  }
}

std::vector<std::string> read_parts(const TomlValue& value) {
  std::vector<std::string> parts;
  for (const TomlValue& part : value.values()) parts.push_back(read_name(part, parts));
  if (parts.empty() && value.is(TomlNode::Kind::array)) value.error("is empty", "name what the fruit consists of");
  if (parts.size() > most_parts) value.error("has more than " + std::to_string(most_parts) + " names");
  return parts;
}

std::vector<SurfaceSketch> read_surfaces(const TomlTable& root, SurfaceReader reader) {
  std::vector<SurfaceSketch> surfaces;
  std::vector<std::string> names;
  double triangles = 0;
  for (const TomlTable& table : limited(root.need("surface"), most_surfaces)) {
    const TomlTable surface = table.called("surface \"" + table.get("name").text() + "\"");
    names.push_back(read_name(surface.need("name"), names));
    surfaces.push_back(reader.read(surface));
    const SurfaceSketch& sketch = surfaces.back();
    triangles +=
        2.0 * sketch.around * sketch.along * static_cast<double>(std::max<std::size_t>(1, sketch.horizontal.size()));
    if (triangles > most_triangles) {
      surface.error("makes more than 2 000 000 triangles of the fruit", "lower \"around\" or \"along\"");
      break;
    }
  }
  return surfaces;
}

/// Moves all vertical curves up or down so that the lowest drawn point is at y = 0.
void set_on_ground(std::vector<SurfaceSketch>& surfaces) {
  bool found = false;
  double lowest = 0;
  for (const SurfaceSketch& surface : surfaces) {
    for (const glm::dvec2& p : surface.vertical.points) {
      lowest = found ? std::min(lowest, p.y) : p.y;
      found = true;
    }
  }
  for (SurfaceSketch& surface : surfaces) {
    for (glm::dvec2& p : surface.vertical.points) p.y -= lowest;
  }
}

void read_grain_shape(const TomlTable& table, GrainSketch& grain) {
  const Within size{1e-5, 0.2};
  grain.poisson_radius = table.need("spacing").length(1e-3, size);
  grain.length = table.need("length").length(1e-3, size);
  grain.width = table.need("width").length(1e-3, size);
  grain.thickness = table.need("thickness").length(1e-3, size);
  grain.sink = table.get("sink").length(0, {-0.1, 0.1});
  grain.size_jitter = table.get("size_jitter").number(0, {0, 0.9});
  grain.angle_jitter = table.get("angle_jitter").angle(0, {0, 180});
  grain.tilt = table.get("tilt").angle(0, {-90, 90});
  grain.pointedness = table.get("pointedness").number(0, {0, 1});
}

void read_band(const TomlValue& value, GrainSketch& grain) {
  if (!value.given()) return;
  const std::vector<TomlValue> ends = value.values();
  if (ends.size() != 2) return value.error("must be two places along the vertical curve, as in [0.2, 0.8]");
  grain.along_from = ends[0].number(0, {0, 1});
  grain.along_to = ends[1].number(1, {0, 1});
  if (grain.along_from >= grain.along_to) value.error("is empty", "write the lower end first");
}

GrainSketch read_grains(const TomlTable& table, const Template& fruit) {
  GrainSketch grain;
  std::vector<std::string> names;
  for (const SurfaceSketch& surface : fruit.surfaces) names.push_back(surface.name);
  grain.surface = table.need("surface").choice(names);
  grain.on_front = table.get("side").choice({"front", "back"}) == 0;
  read_grain_shape(table, grain);
  read_band(table.get("band"), grain);
  grain.front = read_side(table.need("front").table(), fruit.parts);
  grain.back = read_side(table.need("back").table(), fruit.parts);
  if (grain.front.hidden && grain.back.hidden)
    table.error("have both sides hidden", "hide only the side that faces air");
  grain.blur = table.get("blur").length(0, {0, 0.1});
  grain.around = table.get("around").integer(grain.around, 3, 64);
  grain.along = table.get("along").integer(grain.along, 2, 64);
  return grain;
}

std::vector<double> read_numbers(const TomlValue& value, std::size_t least, std::size_t most, Within within) {
  std::vector<double> numbers;
  if (!value.is(TomlNode::Kind::array)) {
    value.values();  // notes that it is none, if it is there
    return numbers;
  }
  for (const TomlValue& number : value.values()) numbers.push_back(number.number(0, within));
  if (numbers.size() >= least && numbers.size() <= most) return numbers;
  value.error("has " + std::to_string(numbers.size()) + " numbers, but must have " + std::to_string(least) +
              (least == most ? "" : " to " + std::to_string(most)));
  return {};
}

NoiseKey read_noise_key(const TomlTable& table) {
  NoiseKey key;
  key.color = table.need("color").color();
  key.weights = read_numbers(table.need("weights"), 1, 12, {-1, 1});
  const std::vector<double> axis = read_numbers(table.get("axis"), 3, 3, {-1, 1});
  if (axis.size() == 3) key.axis = {axis[0], axis[1], axis[2]};
  if (key.axis == glm::vec3(0)) table.get("axis").error("has no direction", "[1, 0, 0] is from dark to light");
  return key;
}

NoiseStyle read_noise(const TomlTable& table) {
  NoiseStyle noise;
  noise.base_frequency = table.need("base_frequency").number(0, {0, 1e5});
  const std::vector<double> stretch = read_numbers(table.get("stretch"), 3, 3, {1e-3, 1e3});
  if (stretch.size() == 3) noise.stretch = {stretch[0], stretch[1], stretch[2]};
  noise.sigma = table.get("sigma").number(noise.sigma, {1e-3, 10});
  for (const TomlTable& key : limited(table.get("key"), most_noise_keys)) noise.keys.push_back(read_noise_key(key));
  return noise;
}

InkStyle read_ink(const TomlTable& table) {
  InkStyle ink;
  ink.color = table.get("color").color(ink.color);
  ink.width = table.get("width").number(ink.width, {0, 10});
  return ink;
}

void read_head(const TomlTable& root, Template& fruit) {
  root.need("format").integer(1, 1, 1);
  fruit.name = read_name(root.need("name"), {});
  fruit.title = root.get("title").text(fruit.name);
  fruit.density = root.get("density").number(fruit.density, {10, 20000});
  fruit.parts = read_parts(root.need("parts"));
}

}  // namespace

Template parse_template(std::string_view toml, const std::string& file) {
  TomlDocument document(toml, file);
  const TomlTable root = document.root();
  Template fruit;
  fruit.file = file;
  read_head(root, fruit);

  // Curves need the unit, and paint needs the parts: without them their own mistakes cannot be told.
  const TomlValue unit_value = root.has("sketch") ? root.get("unit") : root.need("unit");
  const double unit = unit_value.length(1e-3, {1e-6, 1});
  const std::optional<Sketch> sketch =
      read_sketch_of(root, file, unit_value.given() ? std::optional<double>(unit) : std::nullopt);
  fruit.symmetry = read_symmetry(root.need("symmetry").table(), sketch ? &*sketch : nullptr);
  const CurveReader curves(unit, {.sketch = sketch ? &*sketch : nullptr, .named = root.has("sketch")});
  fruit.surfaces = read_surfaces(root, SurfaceReader(curves, fruit.parts, fruit.symmetry));
  set_on_ground(fruit.surfaces);

  std::vector<std::string> names;
  for (const TomlTable& table : limited(root.get("grains"), most_grain_kinds)) {
    const TomlTable grains = table.called("grains \"" + table.get("name").text() + "\"");
    const std::string name = read_name(grains.need("name"), names);
    names.push_back(name);
    fruit.grains.push_back(read_grains(grains, fruit));
    fruit.grains.back().name = name;
  }
  if (root.has("noise")) fruit.noise = read_noise(root.get("noise").table());
  if (root.has("ink")) fruit.ink = read_ink(root.get("ink").table());
  document.throw_if_any();
  return fruit;
}

Template read_template(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file)) {
    throw Error(ExitStatus::input_missing, {{{file.string(), 0, 0, {}}, "cannot be read", {}}});
  }
  // One byte beyond the limit is enough to know that the file goes beyond it.
  std::string text(TomlLimits{}.bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return parse_template(text, file.string());
}

}  // namespace pomona
