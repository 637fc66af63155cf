#include "cli/data/make_picture.h"

#include <algorithm>
#include <optional>

#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "cli/data/label_files.h"
#include "cli/data/picture_scene.h"
#include "generator/base/error.h"
#include "generator/base/file_bytes.h"
#include "generator/base/json_text.h"
#include "generator/base/sha256.h"
#include "generator/batch/batch_plan.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "render/image/backdrop.h"
#include "render/image/environment.h"
#include "render/image/linear_pixels.h"
#include "render/image/png.h"
#include "render/image/sensor.h"
#include "render/picture/view_frame.h"
#include "render/truth/ground_truth.h"
#include "render/truth/layers.h"

namespace pomona {

namespace {

using Json = nlohmann::ordered_json;

constexpr Threads alone{1};  ///< a picture is made by one thread; a set makes many
constexpr int attempts = 4;

struct ComposedPicture {
  DrawnPicture drawn;
  PictureScene made;
};

/// Things that do not come to rest are drawn with another seed.
ComposedPicture composed(const PictureTools& tools, std::int64_t number, const ComposeOptions& composing) {
  const std::unique_ptr<Diffuser> diffuser = make_pmvc_diffuser({.quality = tools.plan.data.quality, .threads = alone});
  for (int attempt = 0;; ++attempt) {
    DrawnPicture drawn = drawn_picture(tools.plan, number, attempt);
    try {
      PictureScene made = picture_scene(tools.plan.data, drawn, diffuser.get(), composing);
      return {std::move(drawn), std::move(made)};
    } catch (const Error& error) {
      if (attempt + 1 == attempts) throw;
    }
  }
}

/// What stands behind.
struct Behind {
  Image picture = {};                          ///< as the camera sees it
  std::optional<EnvironmentLight> light = {};  ///< of an environment
};

/// Nothing if paper does.
std::optional<Behind> behind(const DataDescription& data, const DrawnPicture& drawn, const View& view) {
  if (!drawn.background) return {};
  constexpr std::size_t max_picture = std::size_t{256} << 20;  // bytes
  const auto& [file, is_environment] = data.ground.pictures[*drawn.background];
  const std::string bytes = file_bytes(file, max_picture), name = file.string();
  if (!is_environment)
    return Behind{cropped(read_png(bytes, name), data.width, data.height, drawn.crop, drawn.crop_size)};
  const LinearImage whole = read_environment(bytes, name);
  const ViewFrame frame = view_frame(view);
  const CameraAxes camera{frame.right, frame.up, frame.back};
  return Behind{seen_around(whole, camera, view.vertical_field, data.width, data.height), light_of(whole)};
}

/// The style with the light that was drawn; what no law says is as in the environment.
Style lit(Style style, const DrawnPicture& drawn, const std::optional<Behind>& behind) {
  LightStyle& light = style.light;
  if (behind && behind->light) {
    const EnvironmentLight& around = *behind->light;
    light.azimuth = around.azimuth - drawn.azimuth;  // a style's light turns with the viewer
    light.elevation = around.elevation;
    light.softness = around.softness;
    light.strength = around.strength;
    light.ambient = around.ambient;
  }
  light.azimuth = drawn.light_azimuth.value_or(light.azimuth);
  light.elevation = drawn.light_elevation.value_or(light.elevation);
  light.strength = drawn.light_strength.value_or(light.strength);
  light.ambient = drawn.light_ambient.value_or(light.ambient);
  light.softness = drawn.light_softness.value_or(light.softness);
  return style;
}

/// The share of four places in each pixel that show things.
CoveredShares coverage_of(const Scene& scene, const DataDescription& data) {
  const TruthLayers fine = truth_layers(scene, truth_naming(scene), 2 * data.width, 2 * data.height, alone);
  CoveredShares covered;
  covered.reserve(static_cast<std::size_t>(data.width) * data.height);
  for (int y = 0; y < data.height; ++y) {
    for (int x = 0; x < data.width; ++x) {
      int count = 0;
      for (int k = 0; k < 4; ++k) count += fine.instance[fine.pixel(2 * x + k % 2, 2 * y + k / 2)] != 0 ? 1 : 0;
      covered.push_back(0.25f * static_cast<float>(count));
    }
  }
  return covered;
}

/// Things in coloured light; the paper, which a picture replaces, stays white.
Image tinted_things(const Image& image, const CoveredShares& covered, const Color& tint) {
  std::vector<Color> pixels = linear_pixels(image);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] *= glm::mix(Color(1), tint, covered[i]);
  return image_of(pixels, image.width, image.height);
}

/// picture.png.
std::string drawn_png(const PictureTools& tools, std::int64_t number, const DrawnPicture& drawn, Scene& scene) {
  const DataDescription& data = tools.plan.data;
  const std::optional<Behind> back = behind(data, drawn, scene.view);
  Style style = lit(tools.styles.at(drawn.style), drawn, back);
  const bool on_white = data.ground.transparent || back;
  if (!drawn.scene.paper) scene.paper = style.paper;
  if (on_white) {
    scene.paper = Color(1);
    style.grain = style.vignette = 0;
  }
  Image image = tools.draw(scene, style, {.width = data.width, .height = data.height, .threads = alone});
  if (data.ground.transparent) return write_png(before_nothing(image, coverage_of(scene, data)));
  if (back) {
    const CoveredShares covered = coverage_of(scene, data);
    if (back->light) image = tinted_things(image, covered, back->light->tint);
    image = before(image, covered, back->picture);
  }
  const VariantKey key{data.seed, static_cast<std::uint64_t>(number)};
  return write_png(sensed(image, {.exposure = drawn.exposure, .blur = drawn.blur, .noise = drawn.noise, .key = key}),
                   PngPacking::fast);
}

/// What was drawn, for the picture's entry in `images`.
Json told(const PictureTools& tools, std::int64_t number, const DrawnPicture& drawn) {
  const DataDescription& data = tools.plan.data;
  constexpr double degrees = 57.29577951308232;
  Json json = {{"command", "pomona data " + tools.words + " --picture " + std::to_string(number) + " -o again"},
               {"style", drawn.style},
               {"arrangement", drawn.arrangement == DataArrangement::rows ? "rows" : "heap"},
               {"azimuth", degrees * drawn.azimuth},
               {"elevation", degrees * drawn.elevation},
               {"field", degrees * drawn.field}};
  if (drawn.background) {
    const auto& [file, is_environment] = data.ground.pictures[*drawn.background];
    json[is_environment ? "environment" : "background"] = file.filename().string();
  }
  for (const auto& [key, value] : {std::pair("exposure", drawn.exposure), {"blur", drawn.blur}, {"noise", drawn.noise}})
    if (value != 0) json[key] = value;
  return json;
}

std::vector<NamedFile> truth_files(const PictureTools& tools, std::int64_t number, const DrawnPicture& drawn,
                                   const Scene& scene) {
  const DataDescription& data = tools.plan.data;
  const TruthOptions options{.width = data.width,
                             .height = data.height,
                             .file_name = "picture.png",
                             .made_by = tools.program,
                             .seed = drawn.scene.seed,
                             .format = data.layers == DataLayers::exr ? TruthFormat::exr : TruthFormat::png,
                             .layers = data.layers != DataLayers::none,
                             .threads = alone};
  std::vector<NamedFile> files;
  for (TruthFile& file : ground_truth(scene, options)) files.push_back({file.name, std::move(file.bytes)});
  Json annotations = Json::parse(files.back().bytes);
  annotations["images"][0].update(told(tools, number, drawn));
  files.back().bytes = json_text(annotations) + "\n";
  for (NamedFile& file : label_files(annotations, tools.plan)) files.push_back(std::move(file));
  if (data.models)
    for (NamedFile& file : model_files(scene, annotations)) files.push_back(std::move(file));
  return files;
}

/// What all records begin with.
Json record_of(const PictureTools& tools, std::int64_t number) {
  const DrawnPicture drawn = drawn_picture(tools.plan, number);
  Json json = {
      {"item", item_path("pictures", tools.plan.data.count, number)}, {"entry", "pictures"}, {"number", number}};
  json["recipe"] = picture_recipe(tools.plan, tools.program, number);
  std::string species, knives;
  for (const PiecesDescription& pieces : drawn.scene.pieces) {
    species += (species.empty() ? "" : " ") + pieces.name.substr(0, pieces.name.rfind('-'));
    for (const Knife& knife : pieces.knives) knives += (knives.empty() ? "" : " ") + knife.text;
  }
  json["template"] = species;
  json["seed"] = drawn.scene.seed;
  json["knives"] = knives.empty() ? Json::array() : Json::array({knives});
  json["style"] = drawn.style;
  return json;
}

}  // namespace

std::vector<NamedFile> picture_files(const PictureTools& tools, std::int64_t number, const ComposeOptions& composing) {
  auto [drawn, made] = composed(tools, number, composing);
  std::vector<NamedFile> files{{"picture.png", drawn_png(tools, number, drawn, made.scene)}};
  for (NamedFile& file : truth_files(tools, number, drawn, made.scene)) files.push_back(std::move(file));

  Json record = record_of(tools, number);
  record["pieces"] = Json::array();
  for (const Instance& instance : made.scene.instances) {
    const Solid& solid = made.scene.solids[static_cast<std::size_t>(instance.solid)];
    if (!solid.origin.fruit.empty()) record["pieces"].push_back({{"name", instance.name}, {"volume", solid.volume}});
  }
  record["warnings"] = made.warnings;
  record["files"] = Json::array();
  for (const NamedFile& file : files)
    record["files"].push_back({{"name", file.name}, {"bytes", file.bytes.size()}, {"sha256", sha256(file.bytes)}});
  files.push_back({"item.json", json_text(record) + "\n"});
  return files;
}

NamedFile failed_picture(const PictureTools& tools, std::int64_t number, const std::string& error) {
  Json record = record_of(tools, number);
  record["error"] = error;
  for (const char* nothing : {"pieces", "warnings", "files"}) record[nothing] = Json::array();
  return {"item.json", json_text(record) + "\n"};
}

}  // namespace pomona
