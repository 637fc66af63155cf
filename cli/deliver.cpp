#include "cli/deliver.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include <nlohmann/json.hpp>

#include "cli/ending_signals.h"
#include "cli/find_style.h"
#include "cli/made_folder.h"
#include "cli/outside_parts.h"
#include "cli/version.h"
#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "generator/base/shell_words.h"
#include "generator/piece/piece_origin.h"
#include "render/export/gltf/write_glb.h"
#include "render/export/obj.h"
#include "render/export/ply.h"
#include "render/export/pov.h"
#include "render/export/stl.h"
#include "render/export/svg.h"
#include "render/export/usd/write_usda.h"
#include "render/gl/context.h"
#include "render/gl/scene_picture.h"
#include "render/image/png.h"
#include "render/marks/marks.h"
#include "render/picture/light_direction.h"
#include "render/picture/section_picture.h"
#include "render/picture/view_within.h"
#include "render/strokes/scene_parts.h"
#include "render/texture/bake.h"
#include "render/truth/ground_truth.h"

namespace pomona {

namespace {

Engine engine_called(const std::string& name) {
  if (name == "godot") return Engine::godot;
  if (name == "unreal") return Engine::unreal;
  return name == "unity" ? Engine::unity : Engine::any;
}

/// "12.3 MB"; below a tenth of that "4 kB".
std::string size_in_words(std::size_t bytes) {
  char words[32];
  const double size = static_cast<double>(bytes);
  if (bytes < 100'000)
    std::snprintf(words, sizeof words, "%.0f kB", std::max(size * 1e-3, 1.0));
  else
    std::snprintf(words, sizeof words, "%.1f MB", size * 1e-6);
  return words;
}

}  // namespace

void check_picture_size(const SharedOptions& options, const std::vector<Output>& outputs) {
  constexpr int most = max_picture_side / 2;
  const std::optional<PictureSize> size = picture_size(options);
  if (!size || std::max(size->width, size->height) <= most) return;
  for (const Output& output : outputs) {
    if (output.format == Format::png)
      throw Error(
          ExitStatus::usage,
          "--size " + options.size + ": pictures of pieces have up to " + std::to_string(most) + " pixels a side",
          "write 8192x6144 or less; pictures of --section, and .svg, may have 16384");
  }
}

void check_exports(const SharedOptions& options, const std::vector<Output>& outputs) {
  if (options.lod > 0) check_heeded("--lod", {Format::glb, Format::usda}, outputs);
  if (!options.engine.empty()) check_heeded("--engine", {Format::glb}, outputs);
  check_maps_dir(options, outputs);
  if (options.instances) check_heeded("--instances", {Format::glb, Format::usda}, outputs);
  if (options.feature_ids) check_heeded("--feature-ids", {Format::glb}, outputs);
  if (!wanted_ripenesses(options).empty()) check_heeded("--ripeness-variants", {Format::glb, Format::usda}, outputs);
  const auto is_usda_to_standard_output = [](const Output& output) {
    return output.file == "-" && output.format == Format::usda;
  };
  if (wants_textures(options) && std::any_of(outputs.begin(), outputs.end(), is_usda_to_standard_output))
    throw Error(ExitStatus::usage, "--texture with --format usda makes several files, and standard output is one",
                "write -o FILE.usda");
  if (options.lod > 0 && options.engine == "godot") {
    throw Error(ExitStatus::usage, "--lod: Godot makes levels of detail of its own, and Godot 3 shows ours all at once",
                "leave it out");
  }
  if (options.instances && (options.engine == "godot" || options.engine == "unreal")) {
    throw Error(ExitStatus::usage, "--instances: " + options.engine + " does not read EXT_mesh_gpu_instancing",
                "leave it out: the meshes of pieces that repeat are shared anyway");
  }
}

Delivery::Delivery(const SharedOptions& options)
    : progress(options.quiet),
      options_(options),
      style_(find_style(options.style.empty() ? "ink" : options.style)),
      style_word_(source_word(options.style)),
      size_(picture_size(options)),
      view_(view_direction(options)),
      texel_(texel_size(options)),
      seed_(options.seed) {}

void Delivery::set_default_style(const std::string& name_or_path) {
  if (!options_.style.empty()) return;
  style_ = find_style(name_or_path);
  style_word_ = source_word(name_or_path);
}

/// What colours pieces, and as what: the words of a command that makes one of them again.
std::string Delivery::command_words() const {
  const SharedOptions usual;
  std::string words;
  const auto add = [&](const char* option, const std::string& value, const std::string& usual_value) {
    if (value != usual_value) words += std::string(" ") + option + " " + shell_word(value);
  };
  add("--quality", options_.quality, usual.quality);
  add("--diffuser", options_.diffuser, usual.diffuser);
  add("--style", style_word_.empty() ? "ink" : style_word_, "ink");
  add("--texture", std::to_string(options_.texture), std::to_string(usual.texture));
  add("--texel", options_.texel, usual.texel);
  if (wants_textures(options_)) add("--maps", options_.maps, usual.maps);
  add("--lod", std::to_string(options_.lod), std::to_string(usual.lod));
  return words;
}

ExportOptions Delivery::export_options() const {
  return {.style = style_,
          .provenance = std::string("pomona ") + version + ", seed " + std::to_string(options_.seed),
          .command_words = command_words(),
          .threads = {options_.threads},
          .instances = options_.instances,
          .feature_ids = options_.feature_ids,
          .engine = engine_called(options_.engine)};
}

void Delivery::add(const std::filesystem::path& file, const std::function<std::string()>& make) {
  files_.push_back({file, times.time("write", make)});
}

void Delivery::add(const Output& output, const Scene& scene) {
  const ExportOptions options = export_options();
  switch (output.format) {
    case Format::ply:
      return add(output.file, [&] { return write_solids(scene, options); });
    case Format::glb:
      return add_glb(output, scene);
    case Format::obj:
      return add(output.file, [&] { return write_obj(scene, options); });
    case Format::stl:
      return add(output.file, [&] { return write_stl(scene); });
    case Format::usda:
      return add_usda(output, scene);
    case Format::pov:
      return add_pov(output, scene);
    case Format::png:
      return add_picture(output, scene);
    case Format::svg:
      return add_lines(output, scene);
    case Format::json:
    case Format::html:
    case Format::pomona:
      throw Error(ExitStatus::bug, "layouts, pages and assets are no scenes");
  }
}

std::optional<Plate> Delivery::plate_for(const Scene& scene, const PictureSize& size) const {
  if (!style_.plate || !plate_text_ || scene.solids.empty()) return {};
  return Plate(style_, *plate_text_, scene.solids[0].part_names, size.width, size.height);
}

double Delivery::picture_aspect() const {
  const PictureSize size = size_.value_or(default_size_);
  return static_cast<double>(size.width) / size.height;
}

/// The scene seen as the options say, or as it fits a picture of this shape, or the figure on a plate.
Scene Delivery::fitted(Scene scene, const PictureSize& size, const std::optional<Plate>& plate) const {
  if (!view_ && !scene.view.fitted) return scene;
  const glm::dvec3 direction = view_.value_or(scene.view.eye - scene.view.target);
  const glm::dvec2 picture(size.width, size.height);
  const glm::dvec2 room = plate ? plate->figure().high - plate->figure().low : picture;
  std::optional<glm::dvec3> light;
  if (style_.shadow.strength > 0)
    light = light_direction(View{.eye = direction, .target = glm::dvec3(0)}, style_.light);
  scene.view = fitted_view(scene, direction, room.x / room.y, light);
  if (plate) scene.view = view_within(scene.view, picture, plate->figure().low, plate->figure().high);
  return scene;
}

std::vector<PlateLayer> Delivery::plate_layers(const std::optional<Plate>& plate, const Scene& seen,
                                               const PictureSize& size) {
  if (!plate) return {};
  return plate->layers(scene_parts(seen, size.width, size.height), pixels_per_metre(seen.view, size.height));
}

void Delivery::add_picture(const Output& output, const Scene& scene) {
  const PictureSize size = size_.value_or(default_size_);
  const std::optional<Plate> plate = plate_for(scene, size);
  const Scene seen = fitted(scene, size, plate);
  Image image = times.time("style", [&] {
    GlContext context;
    return draw_scene(context, seen, style_,
                      {.width = size.width, .height = size.height, .threads = {options_.threads}});
  });
  draw(plate_layers(plate, seen, size), image);
  image.dpi = options_.dpi;
  add(output.file, [&] { return write_png(image); });
  if (!options_.aov.empty()) add_ground_truth(output, seen, size);
}

/// What the picture shows, by the same view.
void Delivery::add_ground_truth(const Output& picture, const Scene& seen, const PictureSize& size) {
  const TruthOptions how{.width = size.width,
                         .height = size.height,
                         .file_name = picture.file.filename().string(),
                         .made_by = std::string("pomona ") + version,
                         .seed = seed_,
                         .format = options_.aov_format == "exr" ? TruthFormat::exr : TruthFormat::png,
                         .threads = {options_.threads}};
  for (TruthFile& file : times.time("truth", [&] { return ground_truth(seen, how); }))
    add_counted({std::filesystem::path(options_.aov) / file.name, std::move(file.bytes)});
}

/// Hatching or stipple, where the style draws tones by marks: they follow the picture that OpenGL paints.
SvgMarks Delivery::marks_on(const Scene& seen, const PictureSize& size) const {
  if (!style_.marks) return {};
  Style paint = style_;
  paint.ink = false;
  paint.marks.reset();
  GlContext context;
  const Image painted =
      draw_scene(context, seen, paint, {.width = size.width, .height = size.height, .threads = {options_.threads}});
  return {marks_of(painted, seen.paper, *style_.marks), style_.ink_color.value_or(InkStyle().color)};
}

void Delivery::add_lines(const Output& output, const Scene& scene) {
  const PictureSize size = size_.value_or(default_size_);
  const std::optional<Plate> plate = plate_for(scene, size);
  const Scene seen = fitted(scene, size, plate);
  const StrokeOptions options{.width = size.width, .height = size.height, .threads = {options_.threads}};
  const std::vector<SceneStroke> strokes = times.time("style", [&] { return scene_strokes(seen, style_, options); });
  const SvgMarks marks = times.time("style", [&] { return marks_on(seen, size); });
  if (!style_.ink && marks.marks.empty())
    warn({"the style " + style_.name + " has no ink: " + output.file.string() + " holds no lines"});
  const std::string made_by = export_options().provenance;
  const std::vector<PlateLayer> around = plate_layers(plate, seen, size);
  add(output.file, [&] {
    return write_svg(seen, strokes, {size.width, size.height, options_.dpi}, made_by, around, marks);
  });
}

void Delivery::add_pov(const Output& output, const Scene& scene) {
  // The strokes of the camera that is in the file.
  SceneInk ink{.width = default_size_.width, .height = default_size_.height, .strokes = {}};
  const StrokeOptions options{.width = ink.width, .height = ink.height, .threads = {options_.threads}};
  ink.strokes = times.time("style", [&] { return scene_strokes(scene, style_, options); });
  const std::string stem = output.file.stem().string();
  const ExportOptions as_mesh = export_options();
  for (NamedFile& file : times.time("write", [&] { return write_pov(scene, stem, as_mesh, ink); })) {
    files_.push_back({output.file.parent_path() / file.name, std::move(file.bytes)});
  }
}

void Delivery::add_section_picture(const Output& output, const CrossSection& section, const Template& fruit) {
  const PictureSize size = size_.value_or(default_size_);
  const SectionPictureOptions options{.width = size.width,
                                      .height = size.height,
                                      .dpi = options_.dpi,
                                      .text = {fruit.title, fruit.latin},
                                      .outside = outside_parts(fruit),
                                      .threads = {options_.threads}};
  const Look look(fruit.noise, fruit.details);
  if (output.format == Format::svg) {
    const std::string made_by = export_options().provenance;
    return add(output.file, [&] { return write_section_svg(section, look, fruit.ink, style_, options, made_by); });
  }
  Image image = times.time("style", [&] { return draw_section(section, look, fruit.ink, style_, options); });
  image.dpi = options_.dpi;
  add(output.file, [&] { return write_png(image); });
}

void Delivery::warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) progress.line("warning: " + warning);
  warnings_.insert(warnings_.end(), warnings.begin(), warnings.end());
}

void Delivery::finish() {
  // The statistics tell how long it took to write all other files.
  for (const OutputFile& file : files_)
    if (!options_.stats.empty() && is_same_file(file.path, options_.stats))
      throw Error(ExitStatus::usage, "--stats " + options_.stats + " is a file of this run already",
                  "give it a name of its own");

  // Ctrl-C is heard before or after, not between two files.
  const HeldSignals held;
  MadeFolder truth(options_.aov), maps(options_.maps_dir);
  times.time("write", [&] { write_whole(files_); });
  truth.keep(), maps.keep();
  if (!options_.stats.empty()) {
    files_.push_back({options_.stats, times.json(resolved({options_.threads}))});
    write_whole(std::span(files_).last(1));
  }
  say_what_was_written();
}

void Delivery::add_counted(OutputFile file) {
  counted_.insert(file.path);
  files_.push_back(std::move(file));
}

void Delivery::say_what_was_written() {
  if (options_.json) {
    nlohmann::ordered_json result = {{"files", nlohmann::ordered_json::array()}, {"warnings", warnings_}};
    for (const OutputFile& file : files_) {
      result["files"].push_back({{"path", file.path.string()}, {"bytes", size_of(file)}});
    }
    std::printf("%s\n", json_text(result, 2).c_str());
    return;
  }
  // Maps and truth are counted, the rest is named: of many pieces they are hundreds of files.
  std::map<std::filesystem::path, std::pair<std::size_t, std::size_t>> folders;  // files and bytes
  for (const OutputFile& file : files_) {
    if (counted_.contains(file.path)) {
      auto& [files, bytes] = folders[file.path.parent_path()];
      ++files;
      bytes += size_of(file);
      continue;
    }
    const std::string where = file.path == "-" ? "to standard output" : file.path.string();
    progress.line("wrote " + where + " (" + size_in_words(size_of(file)) + ")");
  }
  for (const auto& [folder, what] : folders) {
    const auto& [files, bytes] = what;
    progress.line("wrote " + std::to_string(files) + (files == 1 ? " file in " : " files in ") + folder.string() +
                  " (" + size_in_words(bytes) + ")");
  }
  progress.line(times.summary());
}

}  // namespace pomona
