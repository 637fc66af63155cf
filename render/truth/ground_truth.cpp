#include "render/truth/ground_truth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "generator/piece/piece_facts.h"
#include "render/strokes/lens.h"
#include "render/truth/amodal_masks.h"
#include "render/truth/cryptomatte.h"
#include "render/truth/layers.h"
#include "render/truth/mask.h"
#include "render/truth/piece_labels.h"
#include "render/truth/run_lengths.h"
#include "render/truth/truth_exr.h"
#include "render/truth/truth_pictures.h"

namespace pomona {

namespace {

struct AnnotatedPicture {
  std::string file_name;                 ///< name of the picture in `images`
  std::string made_by;                   ///< version of the program, for `info`
  std::uint64_t seed = 0;                ///< seed of the fruit or the scene
  std::vector<std::string> layer_files;  ///< files of layers beside the annotations
};

using Json = nlohmann::ordered_json;

Json numbers(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

Json box(const PixelBox& b) { return Json::array({b.left, b.top, b.width(), b.height()}); }

Json encoded(const Mask& mask, int width, int height) {
  return {{"size", Json::array({height, width})}, {"counts", packed(run_lengths(mask, width, height))}};
}

class AnnotationWriter {
 public:
  AnnotationWriter(const Scene& scene, const TruthNaming& names, const TruthLayers& layers,
                   const std::vector<Mask>& amodal, const AnnotatedPicture& picture)
      : scene_(scene),
        names_(names),
        layers_(layers),
        amodal_(amodal),
        picture_(picture),
        visible_(visible_masks(layers.instance, layers.width, scene.instances.size())) {
    for (const Solid& solid : scene.solids) facts_.push_back(facts_of(solid));
  }

  std::string write() const {
    // COCO's tools expect pixels in every annotation, so pieces that are hidden altogether have a list of their own.
    Json seen = Json::array(), hidden = Json::array();
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) {
      if (amodal_[i].area() > 0) (visible_[i].area() > 0 ? seen : hidden).push_back(annotation(i));
    }
    const Json all = {{"info", {{"description", "ground truth of one picture"}, {"made_by", picture_.made_by}}},
                      {"licenses", Json::array()},
                      {"images", Json::array({image()})},
                      {"categories", categories()},
                      {"parts", parts()},
                      {"fruits", fruits()},
                      {"annotations", seen},
                      {"hidden", hidden},
                      {"part_annotations", part_annotations()}};
    return json_text(all, 1) + "\n";
  }

 private:
  Json image() const {
    const Lens lens(scene_.view, layers_.width, layers_.height);
    const ViewFrame& frame = lens.frame();
    const double focal = 1 / lens.pixel_size(1);
    Json files = Json::array();
    for (const std::string& file : picture_.layer_files) files.push_back(file);
    return {{"id", 1},
            {"file_name", picture_.file_name},
            {"width", layers_.width},
            {"height", layers_.height},
            {"seed", picture_.seed},
            {"layers", files},
            {"metres_per_depth_step", depth_step(layers_)},
            {"camera",
             {{"focal_length", focal},
              {"principal_point", {0.5 * layers_.width, 0.5 * layers_.height}},
              {"eye", numbers(lens.eye())},
              {"right", numbers(frame.right)},
              {"down", numbers(-frame.up)},
              {"forward", numbers(-frame.back)}}}};
  }

  Json categories() const {
    Json list = Json::array();
    for (const TruthNaming::Species& s : names_.species)
      list.push_back({{"id", list.size() + 1}, {"name", s.name}, {"supercategory", "object"}});
    return list;
  }

  Json parts() const {
    Json list = Json::array();
    for (const TruthNaming::Part& p : names_.parts)
      list.push_back({{"id", list.size() + 1}, {"name", p.name}, {"category_id", p.species}});
    return list;
  }

  Json fruits() const {
    Json list = Json::array();
    for (const TruthNaming::Fruit& f : names_.fruits)
      list.push_back({{"id", list.size() + 1}, {"name", f.name}, {"category_id", f.species}});
    return list;
  }

  /// What each part of each piece shows: the pixels of both layers.
  Json part_annotations() const {
    Json list = Json::array();
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) {
      for (const auto& [part, mask] : masks_in(i, layers_.part)) {
        if (part == 0) continue;
        list.push_back({{"id", list.size() + 1},
                        {"image_id", 1},
                        {"annotation_id", i + 1},
                        {"part_id", part},
                        {"bbox", box(mask.box)},
                        {"area", mask.area()},
                        {"segmentation", encoded(mask, layers_.width, layers_.height)}});
      }
    }
    return list;
  }

  /// Per number that the pixels of an instance have in a layer, these pixels.
  std::map<std::uint16_t, Mask> masks_in(std::size_t i, const std::vector<std::uint16_t>& layer) const {
    const Mask& visible = visible_[i];
    std::map<std::uint16_t, Mask> masks;
    std::size_t at = 0;
    for (int y = visible.box.top; y <= visible.box.bottom; ++y) {
      for (int x = visible.box.left; x <= visible.box.right; ++x, ++at) {
        if (visible.covered[at] == 0) continue;
        Mask& mask = masks.try_emplace(layer[layers_.pixel(x, y)], Mask{visible.box, {}}).first->second;
        mask.covered.resize(visible.covered.size());
        mask.covered[at] = 1;
      }
    }
    for (auto& [number, mask] : masks) mask = trimmed(mask);
    return masks;
  }

  /// What a piece has of each instance of a placed template; pixels only of those that show.
  Json organs(std::size_t i) const {
    const std::map<std::uint16_t, Mask> masks = masks_in(i, layers_.organ);
    Json list = Json::array();
    for (const Organ& organ : scene_.solids[static_cast<std::size_t>(scene_.instances[i].solid)].organs) {
      Json json = {{"instance", organ.instance}, {"name", organ.name}, {"volume", organ.volume}, {"mass", organ.mass}};
      const auto mask = masks.find(static_cast<std::uint16_t>(organ.instance));
      json["area"] = mask == masks.end() ? 0 : mask->second.area();
      if (mask != masks.end()) {
        json["bbox"] = box(mask->second.box);
        json["segmentation"] = encoded(mask->second, layers_.width, layers_.height);
      }
      list.push_back(std::move(json));
    }
    return list;
  }

  Json annotation(std::size_t i) const {
    const Instance& instance = scene_.instances[i];
    const auto number = static_cast<std::size_t>(instance.solid);
    const Mask &visible = visible_[i], &whole = amodal_[i];
    const auto area = static_cast<double>(visible.area()), amodal_area = static_cast<double>(whole.area());
    const std::uint16_t fruit = names_.fruit_of_solid[number];
    const glm::dquat& turn = instance.pose.rotation;
    Json json = {{"id", i + 1},
                 {"image_id", 1},
                 {"category_id", names_.fruit(fruit).species},
                 {"bbox", box(visible.box)},
                 {"area", visible.area()},
                 {"segmentation", encoded(visible, layers_.width, layers_.height)},
                 {"iscrowd", 0},
                 {"amodal_bbox", box(whole.box)},
                 {"amodal_area", whole.area()},
                 {"amodal_segmentation", encoded(whole, layers_.width, layers_.height)},
                 {"occlusion", 1 - area / amodal_area},
                 {"name", instance.name},
                 {"fruit_id", fruit},
                 {"volume", facts_[number].volume},
                 {"mass", facts_[number].mass},
                 {"center_of_mass", numbers(turn * facts_[number].center + instance.pose.translation)},
                 {"rotation", {turn.w, turn.x, turn.y, turn.z}},
                 {"translation", numbers(instance.pose.translation)}};
    const Solid& solid = scene_.solids[number];
    if (!solid.instances.empty()) json["instances"] = solid.instances;
    if (!solid.organs.empty()) json["organs"] = organs(i);
    json.update(state_labels(solid));
    json.update(camera_pose(instance, solid, Lens(scene_.view, layers_.width, layers_.height)));
    return json;
  }

  const Scene& scene_;
  const TruthNaming& names_;
  const TruthLayers& layers_;
  const std::vector<Mask>& amodal_;
  const AnnotatedPicture& picture_;
  std::vector<Mask> visible_;      // per instance
  std::vector<PieceFacts> facts_;  // per solid
};

/// docs/reference/formats.md, "Ground truth".
/// \param amodal per instance.
std::string annotations(const Scene& scene, const TruthNaming& names, const TruthLayers& layers,
                        const std::vector<Mask>& amodal, const AnnotatedPicture& picture) {
  return AnnotationWriter(scene, names, layers, amodal, picture).write();
}

std::vector<TruthFile> png_files(const TruthLayers& layers, const std::vector<Mask>& amodal, Threads threads) {
  // Draws, packs and frees whole masks one by one, because a large heap has hundreds of pictures of them.
  const std::vector<TruthPicture> pictures = pictures_of(layers);
  std::vector<TruthFile> files(pictures.size() + amodal_pictures(amodal.size()));
  const auto packed = [](const TruthPicture& picture) {
    return TruthFile{picture.name + ".png", write_png(picture.image)};
  };
  parallel_for(files.size(), threads, [&](std::size_t i) {
    const bool is_mask = i >= pictures.size();
    files[i] = is_mask ? packed(amodal_picture(amodal, i - pictures.size(), layers.width, layers.height))
                       : packed(pictures[i]);
  });
  return files;
}

/// Organs by numbers of their own: those that show, as "bunch.piece-1.berry-17"; of the fruit itself "bunch.piece-1".
Cryptomatte organ_matte(const Scene& scene, const TruthLayers& fine, const TruthOptions& options, int side) {
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint16_t> number;
  for (std::size_t p = 0; p < fine.organ.size(); ++p)
    if (fine.instance[p] != 0) number.try_emplace({fine.instance[p], fine.organ[p]}, std::uint16_t{0});
  if (number.size() > 65535)
    throw Error(ExitStatus::usage, "--aov: the picture shows " + std::to_string(number.size()) + " organs",
                "ids have 16 bits: at most 65535");
  std::vector<std::string> names;
  for (auto& [of, own] : number) {
    const Instance& instance = scene.instances[of.first - 1u];
    std::string name = instance.name;
    for (const Organ& organ : scene.solids[static_cast<std::size_t>(instance.solid)].organs)
      if (of.second != 0 && organ.instance == of.second) name += "." + organ.name + "-" + std::to_string(of.second);
    names.push_back(std::move(name));
    own = static_cast<std::uint16_t>(names.size());
  }
  std::vector<std::uint16_t> numbers(fine.organ.size(), 0);
  for (std::size_t p = 0; p < numbers.size(); ++p)
    if (fine.instance[p] != 0) numbers[p] = number.at({fine.instance[p], fine.organ[p]});
  return cryptomatte("CryptoOrgan", std::move(names), numbers, options.width, options.height, side);
}

/// The coverage, by the samples of the picture.
std::vector<Cryptomatte> mattes_of(const Scene& scene, const TruthNaming& names, const TruthOptions& options) {
  std::vector<std::string> instances, fruits, parts;
  for (const Instance& instance : scene.instances) instances.push_back(instance.name);
  for (const TruthNaming::Fruit& fruit : names.fruits) fruits.push_back(fruit.name);
  for (const TruthNaming::Part& part : names.parts) parts.push_back(names.kind(part.species).name + "." + part.name);
  const int side = static_cast<int>(std::lround(std::sqrt(options.samples)));
  const TruthLayers fine = truth_layers(scene, names, options.width * side, options.height * side, options.threads);
  const auto matte = [&](const char* name, std::vector<std::string> of, const std::vector<std::uint16_t>& numbers) {
    return cryptomatte(name, std::move(of), numbers, options.width, options.height, side);
  };
  std::vector<Cryptomatte> all{matte("CryptoObject", std::move(instances), fine.instance),
                               matte("CryptoAsset", std::move(fruits), fine.fruit),
                               matte("CryptoMaterial", std::move(parts), fine.part)};
  if (shows_organs(fine)) all.push_back(organ_matte(scene, fine, options, side));
  return all;
}

TruthFile exr_file(const Scene& scene, const TruthNaming& names, const TruthLayers& layers,
                   const std::vector<Mask>& amodal, const TruthOptions& options) {
  return {"truth.exr", write_truth_exr(layers, amodal, mattes_of(scene, names, options), options.made_by)};
}

}  // namespace

void check_opaque(const Scene& scene) {
  if (std::any_of(scene.solids.begin(), scene.solids.end(), [](const Solid& s) { return s.opacity < 1; }))
    throw Error(ExitStatus::usage, "--aov: what one sees through has no one surface at a pixel");
}

std::vector<TruthFile> ground_truth(const Scene& scene, const TruthOptions& options) {
  check_opaque(scene);
  const TruthNaming names = truth_naming(scene);
  const TruthLayers layers = truth_layers(scene, names, options.width, options.height, options.threads);
  const std::vector<Mask> amodal = amodal_masks(scene, options.width, options.height, options.threads);
  std::vector<TruthFile> files;
  if (options.layers && options.format == TruthFormat::png)
    files = png_files(layers, amodal, options.threads);
  else if (options.layers)
    files.push_back(exr_file(scene, names, layers, amodal, options));

  AnnotatedPicture picture{options.file_name, options.made_by, options.seed, {}};
  for (const TruthFile& file : files) picture.layer_files.push_back(file.name);
  files.push_back({"annotations.json", annotations(scene, names, layers, amodal, picture)});
  return files;
}

}  // namespace pomona
