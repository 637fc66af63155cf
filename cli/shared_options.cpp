#include "cli/shared_options.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <system_error>

#include <CLI/CLI.hpp>

#include "cli/option_checks.h"
#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/diffusion/quality.h"

namespace pomona {

namespace {

struct NamedView {
  std::string_view name;
  glm::dvec3 direction;
};
constexpr NamedView named_views[] = {
    {"front", {0, 0, 1}},
    {"back", {0, 0, -1}},
    {"left", {-1, 0, 0}},
    {"right", {1, 0, 0}},
    {"top", {0, 1, 0}},
    {"bottom", {0, -1, 0}},
    {"three-quarter", {0.5, 0.55, 1}},
};

/// As CLI11 writes a choice; the words in braces are what shells complete (cli/pages).
std::string view_names() {
  std::string names;
  for (const NamedView& view : named_views) names.append(names.empty() ? "" : ",").append(view.name);
  return "VIEW:{" + names + "}";
}

/// CLI11 would read -1, and whatever has more than 64 bits, as the largest number there is.
std::string no_count(const std::string& text) {
  std::uint64_t count = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), count);
  const bool fits = fault == std::errc() && end == text.data() + text.size();
  return fits ? "" : "\"" + text + "\" is not a whole number from 0 to 18446744073709551615";
}

/// Which variant of the fruit.
void add_variant_options(CLI::App& command, SharedOptions& options) {
  command.add_option("--seed", options.seed, "Variant to grow; 0 = as drawn")
      ->check(no_count)
      ->capture_default_str()
      ->each([&options](const std::string&) { options.seed_given = true; });
  command.add_option("--variation", options.variation, "How far variants stray: 0 = as drawn, 1 = natural, 2 = wild")
      ->check(between(0.0, 2.0))
      ->capture_default_str();
  command.add_flag("--curves-only", options.curves_only,
                   "Vary the horizontal curves alone, as in the paper, whatever the template says");
}

/// How it is computed, and how finely.
void add_computing_options(CLI::App& command, SharedOptions& options) {
  command.add_option("--threads", options.threads, "Threads to use; 0 = all. The result does not depend on it")
      ->check(whole_between(0, 1024))
      ->capture_default_str();
  command
      .add_option(
          "--diffuser", options.diffuser,
          "How colour diffuses: cpu = positive mean values, gl = the same by OpenGL, auto = gl on a graphics card")
      ->check(one_of({"cpu", "gl", "harmonic", "walk", "auto"}))
      ->capture_default_str()
      ->each([&options](const std::string&) { options.diffuser_given = true; });
  command.add_option("--quality", options.quality, "The error of the diffusion, nothing else")
      ->check(one_of(quality_names()))
      ->capture_default_str();
  command.add_option("--detail", options.detail, "Tessellation of the surfaces, relative to the template's")
      ->check(between(0.1, 4.0))
      ->capture_default_str();
}

/// \param usual the style that is taken unless one is said.
void add_style_option(CLI::App& command, SharedOptions& options, const std::string& usual) {
  command
      .add_option(
          "--style", options.style,
          "Look of pictures: a name from `pomona list --styles` or a style file (.toml); " + usual + " unless said")
      ->type_name("STYLE");
}

void add_texture_options(CLI::App& command, SharedOptions& options) {
  command.add_option("--texture", options.texture, "Bake colours into a texture of N x N texels instead of vertices")
      ->check(whole_between(64, 8192));
  command
      .add_option("--texel", options.texel,
                  "Bake colours into textures with texels of this size (0.2mm) instead of a size of their own")
      ->excludes("--texture");
  command
      .add_option("--maps", options.maps,
                  "Of textures: color = base colour alone; all = normal, occlusion, roughness and thickness, too")
      ->check(one_of({"color", "all"}))
      ->capture_default_str();
  command.add_option("--maps-dir", options.maps_dir, "The textures as .png, too, in this folder, with part numbers")
      ->type_name("FOLDER");
}

/// What files of meshes hold besides.
void add_mesh_options(CLI::App& command, SharedOptions& options) {
  command
      .add_option("--lod", options.lod,
                  ".glb: each solid at so many further levels of detail, with a half, a quarter, ... of the triangles")
      ->check(whole_between(1, 6));
  command
      .add_option("--engine", options.engine,
                  ".glb: names as this engine's importer expects them, and convex hulls to collide with")
      ->check(one_of({"godot", "unreal", "unity"}));
  command.add_flag("--instances", options.instances,
                   ".glb, .usda: pieces that repeat are one node with many places, one prim");
  command.add_flag("--feature-ids", options.feature_ids, ".glb: parts as EXT_mesh_features, too");
}

void add_size_options(CLI::App& command, SharedOptions& options) {
  command.add_option("--size", options.size,
                     "Size of pictures in pixels, WIDTHxHEIGHT; with --dpi also as in 120x90mm");
  command.add_option("--dpi", options.dpi, "Pixels per inch that .png and .svg tell programs which print them")
      ->check(between(10.0, 2400.0));
}

/// Where pictures look from, and what they show in numbers.
void add_view_options(CLI::App& command, SharedOptions& options) {
  command.add_option("--view", options.view, "Where pictures look from, or AZIMUTH,ELEVATION in degrees")
      ->check(not_empty())
      ->type_name(view_names());
  command
      .add_option("--aov", options.aov,
                  "With a .png of solids: ids, depth, normals, masks and annotations of what it shows, in this folder")
      ->type_name("FOLDER");
  command
      .add_option("--aov-format", options.aov_format, "png = a 16-bit picture a layer, exr = one file with Cryptomatte")
      ->check(one_of({"png", "exr"}))
      ->capture_default_str();
}

/// What goes to standard output, and what is told besides.
void add_telling_options(CLI::App& command, SharedOptions& options) {
  command.add_option("--format", options.format, "What -o - writes to standard output: an ending without its dot")
      ->type_name("FORMAT");
  command.add_option("--stats", options.stats, "Write times and counts to this JSON file")->type_name("FILE");
  command.add_flag("--quiet", options.quiet, "Print nothing but errors");
  command.add_flag("--json", options.json, "Print the result as JSON");
}

}  // namespace

void add_output_option(CLI::App& command, std::vector<std::string>& outputs, const std::string& what) {
  command.add_option("-o,--output", outputs, what)
      ->type_name("FILE")
      ->required()
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_shared_options(CLI::App& command, SharedOptions& options) {
  add_variant_options(command, options);
  add_computing_options(command, options);
  add_style_option(command, options, "ink");
  add_texture_options(command, options);
  add_mesh_options(command, options);
  add_size_options(command, options);
  add_view_options(command, options);
  add_telling_options(command, options);
}

void add_plate_options(CLI::App& command, SharedOptions& options) {
  add_variant_options(command, options);
  add_computing_options(command, options);
  add_style_option(command, options, "plate");
  add_size_options(command, options);
  add_telling_options(command, options);
}

void add_index_options(CLI::App& command, SharedOptions& options) {
  command
      .add_option("--index", options.index,
                  "Which of the seed's variants, as files of scenes and batches tell it; with it seed 0 is a variant")
      ->check(no_count);
  command.add_option("--scale", options.scale, "Times the size that it grows to")->check(between(0.05, 20.0));
  command.add_flag("--as-drawn", options.as_drawn, "The curves as drawn, whatever the seed; grains follow it");
}

void add_ripeness_option(CLI::App& command, SharedOptions& options) {
  command
      .add_option("--ripeness", options.ripeness,
                  "0 = unripe, 1 = as drawn, 2 = overripe, where the template says how it ripens")
      ->check(between(0.0, 2.0));
}

void add_ripeness_variants_option(CLI::App& command, SharedOptions& options) {
  command
      .add_option("--ripeness-variants", options.ripeness_variants,
                  ".glb, .usda with textures: as variants these ripenesses, too, as in 0.3,1,1.7")
      ->check(not_empty())
      ->type_name("R,R,...");
}

void add_browning_option(CLI::App& command, SharedOptions& options) {
  command
      .add_option("--browning", options.browning,
                  "How long the cut faces have lain in air: 0 = just cut, 1 = long, where the template says how")
      ->check(between(0.0, 1.0))
      ->capture_default_str();
}

void add_watch_option(CLI::App& command, SharedOptions& options) {
  command.add_flag("--watch", options.watch, "Make the outputs anew when a file that was read changes");
}

namespace {

/// How many inches a unit of paper has; nothing for what is none.
std::optional<double> inches_of(const std::string& unit) {
  if (unit == "in") return 1.0;
  if (unit == "mm") return 1 / 25.4;
  if (unit == "cm") return 1 / 2.54;
  return std::nullopt;
}

/// A side "120mm" in pixels, or "800", without a unit, as it is where `per_unit` is 1.
std::optional<double> pixels_of(std::string side, const std::string& unit, double per_unit) {
  if (side.ends_with(unit)) side.resize(side.size() - unit.size());
  const std::optional<double> number = parse_number(side);
  if (!number) return std::nullopt;
  return unit.empty() ? *number : std::floor(*number * per_unit + 0.5);
}

}  // namespace

std::optional<PictureSize> picture_size(const SharedOptions& options) {
  if (options.size.empty()) return std::nullopt;
  const std::size_t x = options.size.find('x');
  const std::string width_text = options.size.substr(0, x);
  const std::string height_text = x == std::string::npos ? std::string() : options.size.substr(x + 1);

  // Sizes on paper want to know how many pixels an inch has. The height's unit is that of both.
  const std::size_t digits = height_text.find_last_of("0123456789.");
  const std::string unit = digits == std::string::npos ? std::string() : height_text.substr(digits + 1);
  const std::optional<double> inches = inches_of(unit);
  if (inches && options.dpi == 0) {
    throw Error(ExitStatus::usage, "--size " + options.size + " is a size on paper",
                "say how many pixels an inch is to have: --dpi 300");
  }
  const double per_unit = inches.value_or(0) * options.dpi;
  const auto width = pixels_of(width_text, unit, per_unit), height = pixels_of(height_text, unit, per_unit);
  const auto fits = [](std::optional<double> side) {
    return side && *side >= 16 && *side <= 16384 && *side == static_cast<int>(*side);
  };
  if (!fits(width) || !fits(height)) {
    throw Error(ExitStatus::usage, "--size " + options.size + " is not a picture size",
                "write 800x600, or 120x90mm with --dpi 300; 16 to 16384 pixels a side");
  }
  return PictureSize{static_cast<int>(*width), static_cast<int>(*height)};
}

bool wants_textures(const SharedOptions& options) { return options.texture > 0 || !options.texel.empty(); }

double texel_size(const SharedOptions& options) {
  if (options.texel.empty()) return 0;
  const std::optional<double> size = parse_length(options.texel);
  const std::optional<double> bare = parse_number(options.texel);
  if (bare && *bare > 0)
    throw Error(ExitStatus::usage, "--texel " + options.texel + " has no unit", "write " + options.texel + "mm");
  if (!size || !(*size > 0)) {
    throw Error(ExitStatus::usage, "--texel " + options.texel + " is not the size of a texel",
                "write a length above 0: 0.2mm");
  }
  return *size;
}

std::optional<glm::dvec3> view_direction(const SharedOptions& options) {
  if (options.view.empty()) return std::nullopt;
  for (const NamedView& view : named_views) {
    if (options.view == view.name) return view.direction;
  }

  const std::size_t comma = options.view.find(',');
  const auto azimuth = parse_number(options.view.substr(0, comma));
  const auto elevation = comma == std::string::npos ? std::nullopt : parse_number(options.view.substr(comma + 1));
  if (!azimuth || !elevation || *elevation < -90 || *elevation > 90) {
    throw Error(
        ExitStatus::usage, "--view " + options.view + " is not a view",
        "front, back, left, right, top, bottom, three-quarter, or AZIMUTH,ELEVATION as in 30,20; elevations are "
        "-90 to 90");
  }
  const double a = radians(*azimuth), e = radians(*elevation);
  return glm::dvec3(reproducible::cos(e) * reproducible::sin(a), reproducible::sin(e),
                    reproducible::cos(e) * reproducible::cos(a));
}

}  // namespace pomona
