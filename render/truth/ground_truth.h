// The ground truth of a picture: its contents, pixel by pixel, as files.
#pragma once

#include <string>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/order/export_choices.h"
#include "generator/scene/scene.h"

namespace pomona {

struct TruthOptions {
  int width = 800, height = 600;  ///< width and height of the picture
  std::string file_name;          ///< file name of the picture, without folder
  std::string made_by;            ///< version of the program
  std::uint64_t seed = 0;         ///< seed of the fruit or the scene
  TruthFormat format = TruthFormat::png;
  bool layers = true;  ///< else annotations.json alone
  int samples = 4;     ///< per pixel, as of the picture, for Cryptomatte's coverage
  Threads threads{};
};

struct TruthFile {
  std::string name;
  std::string bytes;
};

/// \throws Error (usage) for what one sees through: behind glass no one surface is what a pixel shows.
void check_opaque(const Scene& scene);

/// Layers of the scene as its view sees it, and annotations.json: docs/reference/formats.md, "Ground truth".
/// Threads change nothing.
/// \throws Error (usage) for more instances than numbers have bits for, and as check_opaque().
std::vector<TruthFile> ground_truth(const Scene& scene, const TruthOptions& options);

}  // namespace pomona
