#include "render/style/style_file.h"

#include <sstream>

#include "generator/base/error.h"
#include "generator/base/file_bytes.h"
#include "generator/base/nearest_name.h"
#include "generator/base/small_ending.h"
#include "generator/base/units.h"
#include "generator/text/read_name.h"
#include "generator/text/toml_document.h"
#include "render/style/shipped_styles.h"

namespace pomona {

namespace {

constexpr std::size_t max_bytes = 65536;  // limit of a style file

void read_ink(const TomlTable& table, Style& style) {
  style.ink = table.get("lines").boolean(style.ink);
  if (table.has("color")) style.ink_color = table.get("color").color();
  style.outline_width = table.get("outline").number(style.outline_width, {0, 0.05});
  style.inner_width = table.get("inner").number(style.inner_width, {0, 0.05});
  style.inner_opacity = table.get("inner_opacity").number(style.inner_opacity, {0, 1});
}

void read_paper(const TomlTable& table, Style& style) {
  style.paper = table.get("color").color(style.paper);
  style.grain = table.get("grain").number(style.grain, {0, 0.1});
  style.vignette = table.get("vignette").number(style.vignette, {0, 0.5});
}

void read_paint(const TomlTable& table, Style& style) {
  style.noise = table.get("noise").boolean(style.noise);
  style.saturation = table.get("saturation").number(style.saturation, {0, 2});
  style.lightness = table.get("lightness").number(style.lightness, {-0.5, 0.5});
  style.granulation = table.get("granulation").number(style.granulation, {0, 10});
  style.gloss = table.get("gloss").number(style.gloss, {0, 4});
  style.juice = table.get("juice").number(style.juice, {0, 1});
}

LightStyle light_from(const TomlTable& table) {
  LightStyle light;
  light.azimuth = table.get("azimuth").angle(light.azimuth, {-180, 180});
  light.elevation = table.get("elevation").angle(light.elevation, {10, 90});
  light.softness = table.get("softness").number(light.softness, {0, 1});
  light.strength = table.get("strength").number(light.strength, {0, 3});
  light.ambient = table.get("ambient").number(light.ambient, {0, 3});
  light.occlusion = table.get("occlusion").number(light.occlusion, {0, 2});
  light.window = table.get("window").boolean(light.window);
  return light;
}

ShadowStyle shadow_from(const TomlTable& table) {
  ShadowStyle shadow;
  shadow.color = table.get("color").color(shadow.color);
  shadow.strength = table.get("strength").number(shadow.strength, {0, 1});
  return shadow;
}

MarkStyle marks_from(const TomlTable& table) {
  MarkStyle marks;
  marks.kind = static_cast<MarkKind>(table.need("kind").choice({"hatching", "stipple"}));
  if (marks.kind == MarkKind::stipple) marks.width = 0.0032;
  marks.spacing = table.get("spacing").number(marks.spacing, {0.002, 0.05});
  marks.width = table.get("width").number(marks.width, {0.001, 0.05});
  marks.wash = table.get("wash").number(marks.wash, {0, 1});
  return marks;
}

PlateStyle plate_from(const TomlTable& table) {
  PlateStyle plate;
  plate.margin = table.get("margin").number(plate.margin, {0, 0.3});
  plate.letter_size = table.get("letter_size").number(plate.letter_size, {0.01, 0.1});
  plate.letter_color = table.get("letter_color").color(plate.letter_color);
  plate.leader_width = table.get("leader_width").number(plate.leader_width, {0, 0.01});
  plate.title = table.get("title").boolean(plate.title);
  plate.labels = table.get("labels").boolean(plate.labels);
  plate.scale_bar = table.get("scale_bar").boolean(plate.scale_bar);
  return plate;
}

}  // namespace

Style parse_style(std::string_view toml, const std::string& file) {
  TomlDocument document(toml, file);
  const TomlTable root = document.root();
  Style style;
  root.need("format").integer(1, 1, 1);
  root.need("kind").choice({"style"});
  style.name = read_name(root.need("name"), {});
  style.title = root.get("title").text(style.name);
  read_ink(root.get("ink").table(), style);
  read_paper(root.get("paper").table(), style);
  read_paint(root.get("paint").table(), style);
  style.light = light_from(root.get("light").table());
  style.shadow = shadow_from(root.get("shadow").table());
  if (root.has("marks")) style.marks = marks_from(root.get("marks").table());
  if (root.has("plate")) style.plate = plate_from(root.get("plate").table());
  document.throw_if_any();
  return style;
}

Style read_style(const std::filesystem::path& file) {
  return parse_style(file_bytes(file, max_bytes, "no style is that long"), file.string());
}

bool is_style_file(const std::filesystem::path& file) {
  if (small_ending(file) != ".toml") return false;
  std::istringstream text(readable_bytes(file, max_bytes));
  for (std::string line; std::getline(text, line);) {
    std::erase_if(line, [](char c) { return c == ' ' || c == '\t' || c == '\'' || c == '"'; });
    if (line.starts_with("kind=style")) return true;
    if (line.starts_with("[")) return false;
  }
  return false;
}

namespace {

Style read_shipped(const EmbeddedFile& shipped) {
  return parse_style(shipped.text, "styles/" + std::string(shipped.name));
}

}  // namespace

std::vector<Style> all_styles() {
  std::vector<Style> styles;
  for (const EmbeddedFile& shipped : shipped_styles()) styles.push_back(read_shipped(shipped));
  return styles;
}

Style style_named(std::string_view name) {
  std::vector<std::string> known;
  std::string names;
  for (const EmbeddedFile& shipped : shipped_styles()) {
    if (shipped.stem() == name) return read_shipped(shipped);
    known.emplace_back(shipped.stem());
    names += (names.empty() ? "" : ", ") + known.back();
  }
  const auto near = nearest_name(std::string(name), known);
  throw Error(ExitStatus::usage, "there is no style \"" + std::string(name) + "\"",
              (near ? "did you mean " + *near + "? " : "") + "styles are: " + names + "; a path to a .toml works too");
}

}  // namespace pomona
