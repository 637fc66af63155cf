// The parts of a scene: the solids of many cut variants, and dishes, before they are placed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "generator/base/random.h"
#include "generator/diffusion/diffuser.h"
#include "generator/piece/pose.h"
#include "generator/scene/scene_file.h"
#include "generator/scene/settle/settle.h"

namespace pomona {

struct ComposeOptions {
  /// The file behind a template's name. Paths are tried beside the scene file first.
  std::function<std::filesystem::path(const std::string& name)> find_template;
  double variation = 1;      ///< factor of the variation of every entry
  bool curves_only = false;  ///< see VariationOptions
  double detail = 1;         ///< see SweepOptions
  CutOptions cut = coarse_cut;
  bool keep_section_colors = false;  ///< for textures: every solid keeps its SectionColors
  Threads threads{};
  /// If set, it receives the solids while they are made, those of some variants at a time, in the scene's order, dishes
  /// last. The scene then keeps only without_looks() of them, which needs less memory. Called from another thread while
  /// the next solids are made, one call at a time.
  std::function<void(std::span<const Solid> solids)> take{};
  /// Called from any thread, one call at a time, with a stage and how many of its items are done.
  std::function<void(const std::string& stage, std::size_t done, std::size_t total)> progress;
};

/// Measurements for --stats.
struct ComposeReport {
  std::vector<std::pair<std::string, double>> stages;  ///< milliseconds, summed over threads, in the road's order
  std::map<std::string, std::int64_t> counts;
  std::vector<std::string> warnings;
  std::vector<Fit> fits;  ///< of every piece; empty for a layout from a file
};

/// A dish in its place.
struct ScenePlacedDish {
  std::string name;
  int solid = 0;        ///< index; dishes that are made alike share one
  Pose pose{};          ///< turned about the vertical alone
  int part_of = -1;     ///< index of the dish in or on which it stands; -1 = none
  bool turned = true;   ///< it is a solid of revolution
  SourcePlace place{};  ///< where it is described
};

/// Everything a scene consists of, not yet placed. Equal pieces share one solid.
struct SceneParts {
  std::vector<Solid> solids;            ///< of the pieces, then of the dishes
  std::vector<SettleItem> items;        ///< what is to be placed, named; solids and arrangements by index
  std::vector<int> dish_of;             ///< of each item, an index; -1 = the ground
  std::vector<ScenePlacedDish> dishes;  ///< the bowl is the first, where there is one
  std::vector<PieceArrangement> arrangements;
  ComposeReport report;
};

/// The key of an entry's n-th variant: the scene's seed, and an index drawn from the entry's name and n. So no
/// entry's variants depend on what else the scene holds, in which order, or how many it takes.
VariantKey variant_key(const SceneDescription& scene, const PiecesDescription& pieces, int n);

/// Reads everything that the scene names (templates, meshes, the layout), and tests its knives (check_cuts.h).
/// \throws Error at the place in the scene that names what is missing or wrong.
void check_sources(const SceneDescription& scene, const ComposeOptions& options);

/// Grows, cuts and colours all variants, in parallel, and picks their pieces. Without a diffuser the cut faces
/// keep the colours of their rims: for layouts and tests.
SceneParts make_parts(const SceneDescription& scene, const Diffuser* diffuser, const ComposeOptions& options);

}  // namespace pomona
