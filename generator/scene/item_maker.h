// The items of an entry: which of its pieces a scene places, and how often each.
#pragma once

#include <cstddef>
#include <vector>

#include "generator/scene/scene_file.h"
#include "generator/scene/scene_parts.h"

namespace pomona {

/// The number of pieces that each entry places: by its share of the scene's total (largest remainders first), or its
/// own total; 0 if it has neither.
std::vector<int> totals_of(const SceneDescription& scene);

/// Makes the items of one entry: its pieces, each as often as asked for. First all are counted, then all added.
class ItemMaker {
 public:
  ItemMaker(const SceneDescription& scene, std::size_t entry, int total, SceneParts& parts);

  void count(const Solid&) { ++solids_; }
  void add(Solid solid, int fruit);

 private:
  static constexpr int max_fruits = 1 << 16;  // more than a scene has variants
  const PiecesDescription& pieces_;
  SceneParts& parts_;
  std::size_t total_, solids_ = 0, next_ = 0;
  int dish_ = -1, arrangement_ = -1;
};

}  // namespace pomona
