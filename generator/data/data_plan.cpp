#include "generator/data/data_plan.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "generator/base/beside.h"
#include "generator/base/file_bytes.h"
#include "generator/base/json_text.h"
#include "generator/base/random.h"
#include "generator/base/sha256.h"
#include "generator/knife/knife_kinds.h"
#include "generator/surface/sweep/sweep.h"

namespace pomona {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t max_file = std::size_t{256} << 20;  // bytes

/// The box around a template as drawn, swept coarsely.
Box<double> extent_of(const Template& fruit) {
  constexpr double coarse = 0.25;
  Box<double> box;
  for (const glm::vec3& place : sweep(fruit, {.detail = coarse}).position) box.add(glm::dvec3(place));
  return box;
}

/// Files beside templates that pictures depend on: styles, pictures, drawings of knives, meshes of dishes.
std::map<std::string, std::string> hashes_of(const DataDescription& data) {
  const fs::path folder = fs::path(data.file).parent_path();
  std::vector<std::pair<std::string, fs::path>> files;
  for (const std::string& style : data.styles)
    if (is_style_path(style)) files.emplace_back("style " + fs::path(style).filename().string(), folder / style);
  for (const DataBackground& picture : data.ground.pictures) {
    const char* kind = picture.is_environment ? "environment " : "picture ";
    files.emplace_back(kind + picture.file.filename().string(), picture.file);
  }
  for (const DataDish& one : data.dishes)
    if (!one.dish.mesh.empty()) files.emplace_back("mesh " + one.dish.mesh, folder / one.dish.mesh);
  for (const DataFruit& kind : data.kinds) {
    for (const std::vector<KnifeLaw>& cut : kind.cuts) {
      for (const KnifeLaw& knife : cut) {
        const auto drawing = knife.knife ? drawing_of_knife(knife.knife->text) : std::nullopt;
        if (drawing) files.emplace_back("drawing " + *drawing, folder / *drawing);
      }
    }
  }
  std::map<std::string, std::string> hashes;
  for (const auto& [name, file] : files) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) continue;
    const std::string hash = sha256(file_bytes(file, max_file));
    std::string key = name;  // two folders may have pictures of one name
    for (int next = 2; hashes.contains(key) && hashes[key] != hash; ++next) key = name + " " + std::to_string(next);
    hashes[key] = hash;
  }
  return hashes;
}

/// The texts of a cut's knives; a random plane is a plane.
std::vector<std::string> texts_of(const std::vector<KnifeLaw>& cut) {
  std::vector<std::string> texts;
  for (const KnifeLaw& knife : cut) texts.push_back(knife.knife ? knife.knife->text : std::string("plane"));
  return texts;
}

std::vector<std::string> classes_of(const DataPlan& plan) {
  std::vector<std::string> classes;
  for (std::size_t fruit = 0; fruit < plan.templates.size(); ++fruit) {
    for (std::size_t k = 0; k < plan.kinds.size(); ++k) {
      const std::vector<std::size_t>& own = plan.kinds[k].templates;
      if (std::find(own.begin(), own.end(), fruit) == own.end()) continue;
      for (const std::vector<KnifeLaw>& cut : plan.data.kinds[k].cuts) {
        for (const CutState state : states_by(texts_of(cut))) {
          std::string name = class_of(plan.data.classes, plan.templates[fruit].name, name_of(state));
          if (std::find(classes.begin(), classes.end(), name) == classes.end()) classes.push_back(std::move(name));
        }
      }
    }
  }
  return classes;
}

Json record_without_count(const DataPlan& plan, const std::string& program) {
  Json json = {{"format", 1}, {"kind", "data"}, {"program", program}, {"seed", plan.data.seed}};
  json["templates"] = Json::array();
  for (const PlannedTemplate& fruit : plan.templates)
    json["templates"].push_back({{"name", fruit.name}, {"sha256", fruit.sha256}});
  json["files"] = Json::array();
  for (const auto& [file, hash] : plan.files) json["files"].push_back({{"file", file}, {"sha256", hash}});
  json["laws"] = Json::parse(plan.data.laws);
  return json;
}

}  // namespace

DataPlan planned(DataDescription data, const TemplateSource& source) {
  DataPlan plan;
  TemplateShelf shelf;
  double sum = 0;
  for (const DataFruit& kind : data.kinds) {
    PlannedKind found;
    for (const fs::path& file : template_files(kind.all_templates, kind.templates, source)) {
      found.words.push_back(kind.all_templates ? file.stem().string() : kind.templates[found.words.size()].name);
      found.templates.push_back(shelf.index_of(file));
    }
    // Shares are of pieces: a kind that gives many of them comes rarely.
    found.chance = kind.share / kind.pieces.mean();
    sum += found.chance;
    plan.kinds.push_back(std::move(found));
  }
  for (PlannedKind& kind : plan.kinds) kind.chance /= sum;
  plan.templates = shelf.taken();
  for (const PlannedTemplate& fruit : plan.templates) plan.extents.push_back(extent_of(fruit.fruit));
  plan.files = hashes_of(data);
  plan.data = std::move(data);
  plan.classes = classes_of(plan);
  return plan;
}

std::string class_of(DataClasses classes, const std::string& species, std::string_view state) {
  switch (classes) {
    case DataClasses::species:
      return species;
    case DataClasses::state:
      return std::string(state);
    case DataClasses::species_and_state:
      return species + " " + std::string(state);
  }
  return species;
}

std::string split_of(const DataDescription& data, std::int64_t number) {
  const double at = RandomStream({data.seed, static_cast<std::uint64_t>(number)}, "data/split").uniform(0);
  double sum = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < data.split.size(); ++i) {
    if (data.split[i] <= 0) continue;
    last = i;
    sum += data.split[i];
    if (at < sum) break;
  }
  return std::string(split_names[last]);
}

std::string data_record(const DataPlan& plan, const std::string& program) {
  const DataDescription& data = plan.data;
  Json json = record_without_count(plan, program);
  json["name"] = data.name;
  json["title"] = data.title;
  json["items"] = data.count;
  json["description"] = data.description;
  json["license"] = data.license;
  json["url"] = data.url;
  json["split"] = data.split;
  json["classes"] = plan.classes;
  json["classes_are"] = data.classes == DataClasses::species ? "species"
                        : data.classes == DataClasses::state ? "state"
                                                             : "species and state";
  json["least_area"] = data.least_area;
  json["layers"] = data.layers == DataLayers::none ? "none" : data.layers == DataLayers::png ? "png" : "exr";
  json["entries"] = Json::array({{{"name", "pictures"}, {"items", data.count}}});
  return json_text(json, 1) + "\n";
}

std::string picture_recipe(const DataPlan& plan, const std::string& program, std::int64_t number) {
  Json json = record_without_count(plan, program);
  json["number"] = number;
  return sha256(json_text(json));
}

}  // namespace pomona
