// A scene in a page: its pieces as they lie, and their fruits, to cut them further.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/scene/scene.h"
#include "render/page/asset.h"
#include "render/page/page.h"

namespace pomona {

struct PageScene {
  Scene scene;
  std::string name, title;
  std::vector<Asset> fruits;  ///< each once
  std::vector<int> fruit_of;  ///< index of `fruits` for each solid; -1 without a fruit, as for a dish

  /// For each solid the command that makes it again; empty if there is none.
  std::vector<std::string> command;
};

/// Limits of a scene's page. Browsers take more, but it would take too long to open.
constexpr std::size_t max_page_fruits = 64;
constexpr std::size_t max_page_instances = 4000;
constexpr std::size_t max_scene_triangles = 3'000'000;
constexpr std::size_t max_scene_page_bytes = 48'000'000;

/// \throws Error (usage) for too many fruits, pieces or triangles.
void check_fits_a_page(const Scene& scene, std::size_t fruits);

/// Solids, their places and facts as bytes: a magic number of eight bytes, then zlib.
std::string packed_scene(const PageScene& page);

/// One file of HTML: the pile is turned and pulled apart, pieces are picked, and those of a known fruit are cut.
/// \throws Error (usage) if it would be larger than max_scene_page_bytes.
std::string write_scene_page(const PageScene& page, const PageOptions& options);

}  // namespace pomona
