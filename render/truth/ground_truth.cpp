#include "render/truth/ground_truth.h"

#include <algorithm>

#include "generator/base/error.h"
#include "render/truth/amodal_masks.h"
#include "render/truth/annotations.h"
#include "render/truth/truth_pictures.h"

namespace pomona {

namespace {

std::vector<TruthFile> png_files(const TruthLayers& layers, const std::vector<Mask>& amodal, Threads threads) {
  std::vector<TruthPicture> pictures = pictures_of(layers);
  for (TruthPicture& picture : pictures_of(amodal, layers.width, layers.height)) pictures.push_back(std::move(picture));
  std::vector<TruthFile> files(pictures.size());
  parallel_for(files.size(), threads, [&](std::size_t i) {
    files[i] = {pictures[i].name + ".png", write_png(pictures[i].image)};
  });
  return files;
}

}  // namespace

std::vector<TruthFile> ground_truth(const Scene& scene, const TruthOptions& options) {
  if (std::any_of(scene.solids.begin(), scene.solids.end(), [](const Solid& s) { return s.opacity < 1; }))
    throw Error(ExitStatus::usage, "--aov: what one sees through has no one surface at a pixel");
  const TruthNaming names = truth_naming(scene);
  const TruthLayers layers = truth_layers(scene, names, options.width, options.height, options.threads);
  const std::vector<Mask> amodal = amodal_masks(scene, options.width, options.height, options.threads);
  std::vector<TruthFile> files = png_files(layers, amodal, options.threads);

  AnnotatedPicture picture{options.file_name, options.made_by, options.seed, {}};
  for (const TruthFile& file : files) picture.layer_files.push_back(file.name);
  files.push_back({"annotations.json", annotations(scene, names, layers, amodal, picture)});
  return files;
}

}  // namespace pomona
