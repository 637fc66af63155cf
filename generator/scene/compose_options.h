// How a scene is composed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "generator/base/parallel.h"
#include "generator/cut/section/cut_options.h"
#include "generator/piece/solid.h"
#include "generator/template/template.h"
#include "generator/variation/variation.h"

namespace pomona {

/// A template that is ready for variants.
struct ReadyTemplate {
  const Template* fruit = nullptr;             ///< never null
  std::shared_ptr<const Variation> variation;  ///< null where only the drawn fruit is wanted
};

struct ComposeOptions {
  /// The file behind a template's name. Paths are tried beside the scene file first.
  std::function<std::filesystem::path(const std::string& name)> find_template;
  /// For those who compose many scenes: in place of `find_template`, templates that have been made ready once.
  std::function<ReadyTemplate(const std::string& name)> ready_template{};
  double variation = 1;      ///< factor of the variation of every entry
  bool curves_only = false;  ///< see VariationOptions
  double detail = 1;         ///< see SweepOptions
  CutOptions cut = coarse_cut;
  bool keep_section_colors = false;  ///< for textures: every solid keeps its SectionColors
  bool organs = false;               ///< see SliceOptions
  Threads threads{};
  /// For outputs that do not need the whole scene at once: takes the solids of some variants at a time, in the scene's
  /// order, the dishes last. The scene then keeps only the triangles of their meshes. Another thread calls it while the
  /// next are made, one call at a time.
  std::function<void(std::span<const Solid> solids)> take{};
  /// Called from any thread, one call at a time, with a stage and how many of its items are done.
  std::function<void(const std::string& stage, std::size_t done, std::size_t total)> progress;
};

}  // namespace pomona
