#include "render/truth/ground_truth.h"

#include <algorithm>
#include <cmath>

#include "generator/base/error.h"
#include "render/truth/amodal_masks.h"
#include "render/truth/annotations.h"
#include "render/truth/cryptomatte.h"
#include "render/truth/truth_exr.h"
#include "render/truth/truth_pictures.h"

namespace pomona {

namespace {

std::vector<TruthFile> png_files(const TruthLayers& layers, const std::vector<Mask>& amodal, Threads threads) {
  // Whole masks are drawn, packed and let go one by one: a large heap has hundreds of pictures of them.
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

/// Who covers how much, by the samples of the picture.
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
  return {matte("CryptoObject", std::move(instances), fine.instance),
          matte("CryptoAsset", std::move(fruits), fine.fruit), matte("CryptoMaterial", std::move(parts), fine.part)};
}

TruthFile exr_file(const Scene& scene, const TruthNaming& names, const TruthLayers& layers,
                   const std::vector<Mask>& amodal, const TruthOptions& options) {
  return {"truth.exr", write_truth_exr(layers, amodal, mattes_of(scene, names, options), options.made_by)};
}

}  // namespace

std::vector<TruthFile> ground_truth(const Scene& scene, const TruthOptions& options) {
  if (std::any_of(scene.solids.begin(), scene.solids.end(), [](const Solid& s) { return s.opacity < 1; }))
    throw Error(ExitStatus::usage, "--aov: what one sees through has no one surface at a pixel");
  const TruthNaming names = truth_naming(scene);
  const TruthLayers layers = truth_layers(scene, names, options.width, options.height, options.threads);
  const std::vector<Mask> amodal = amodal_masks(scene, options.width, options.height, options.threads);
  std::vector<TruthFile> files;
  if (options.format == TruthFormat::png)
    files = png_files(layers, amodal, options.threads);
  else
    files.push_back(exr_file(scene, names, layers, amodal, options));

  AnnotatedPicture picture{options.file_name, options.made_by, options.seed, {}};
  for (const TruthFile& file : files) picture.layer_files.push_back(file.name);
  files.push_back({"annotations.json", annotations(scene, names, layers, amodal, picture)});
  return files;
}

}  // namespace pomona
