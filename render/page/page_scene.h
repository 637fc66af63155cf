// A scene that travels in a page: its pieces as they lie, and the fruits that they are cut from, to cut them further.
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
  std::vector<int> fruit_of;  ///< of each solid: an index of `fruits`, -1 for what no fruit is known of: a dish

  /// Of each solid: the command that makes it again, empty where there is none.
  std::vector<std::string> command;
};

/// What a page of a scene holds at most. Browsers take more; who waits for it may not.
constexpr std::size_t max_page_fruits = 64;
constexpr std::size_t max_page_instances = 4000;
constexpr std::size_t max_scene_triangles = 3'000'000;
constexpr std::size_t max_scene_page_bytes = 48'000'000;

/// \throws Error (usage) for a scene with more fruits, pieces or triangles than a page takes.
void check_fits_a_page(const Scene& scene, std::size_t fruits);

/// Solids, their places and what is known of them as bytes: zlib, after eight that say what it is.
std::string packed_scene(const PageScene& page);

/// One file of HTML: the pile is turned and pulled apart, pieces are picked, and those of a known fruit are cut.
/// \throws Error (usage) where it would be larger than max_scene_page_bytes.
std::string write_scene_page(const PageScene& page, const PageOptions& options);

}  // namespace pomona
