#include "generator/scene/make_parts.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "generator/base/background_work.h"
#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/compose/grow.h"
#include "generator/cut/cut.h"
#include "generator/piece/slice.h"
#include "generator/scene/dish_solids.h"
#include "generator/scene/item_maker.h"
#include "generator/scene/layout_file.h"
#include "generator/scene/scene_templates.h"
#include "generator/scene/scene_variants.h"

namespace pomona {

namespace {

/// An error of cut() about an entry's knives, with its place in the scene's file.
Error at_entry(const PiecesDescription& pieces, const Error& error) {
  const Diagnostic& what = error.diagnostics().front();
  return {ExitStatus::bad_data, {{pieces.place, "pieces \"" + pieces.name + "\": " + what.message, what.hint}}};
}

/// Grows each entry's fruit as drawn, coarsely, and cuts it.
/// \throws Error (bad_data) at the entry whose knives do not fit its fruit, or whose fruit cannot be grown.
void check_cuts(const SceneDescription& scene, const std::vector<Template>& templates) {
  constexpr double coarse = 0.25;
  constexpr CutOptions no_samples{.coarsest = 1, .finest = 1, .grading = 1, .contrast = 1};
  for (std::size_t entry = 0; entry < templates.size(); ++entry) {
    const PiecesDescription& pieces = scene.pieces[entry];
    const GrownFruit grown = grow(templates[entry], {}, {.as_drawn = true, .detail = coarse});
    try {
      cut(grown.sheets, pieces.knives, no_samples);
    } catch (const Error& error) {
      throw at_entry(pieces, error);
    }
  }
}

/// Passes progress on, one call at a time.
class Teller {
 public:
  /// \param steps number of steps for each item.
  Teller(const ComposeOptions& options, std::string stage, std::size_t total, std::size_t steps = 1)
      : options_(options), stage_(std::move(stage)), total_(total), steps_(steps) {
    if (options_.progress) options_.progress(stage_, 0, total_);
  }
  void step_done() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (options_.progress) options_.progress(stage_, done_ / steps_, total_);
  }

 private:
  const ComposeOptions& options_;
  std::string stage_;
  std::size_t total_, steps_, done_ = 0;
  std::mutex mutex_;
};

/// The number of variants between growing and their solids, some seven megabytes each: enough for all threads, and for
/// a graphics card to be worth it.
std::size_t variants_at_once(Threads threads) {
  constexpr std::size_t min = 16;
  return std::max(min, 2 * static_cast<std::size_t>(resolved(threads)));
}

/// A variant to make: its entry, and its number in it.
struct Task {
  std::size_t entry = 0;
  int number = 0;
};

/// The result for a variant.
struct Made {
  std::vector<Solid> solids;
  std::vector<std::string> warnings;
  std::map<std::string, std::int64_t> counts;
  StageClock clock;
};

/// The task of cutting an entry's variant, with the choice of its pieces.
SliceTask task_of(const PiecesDescription& pieces, int number, const GrownSceneVariant& made) {
  return {.grown = made.grown,
          .variant = made.variant,
          .knives = pieces.knives,
          .name = variant_name(pieces, number),
          .choice = PieceChoice{.smallest = pieces.smallest, .largest = pieces.largest, .take = pieces.take},
          .origin = made.origin};
}

/// Slices; an error names the entry that could not be cut.
std::vector<Slices> sliced(const SceneDescription& scene, std::span<const Task> tasks,
                           const std::vector<SliceTask>& to_slice, const Diffuser* diffuser, const SliceOptions& how) {
  try {
    return slice(to_slice, diffuser, how);
  } catch (const Error&) {
    for (std::size_t i = 0; i < to_slice.size(); ++i) {
      try {
        cut(to_slice[i].grown.sheets, to_slice[i].knives, how.cut);
      } catch (const Error& error) {
        throw at_entry(scene.pieces[tasks[i].entry], error);
      }
    }
    throw;
  }
}

/// The report of one variant.
Made reported(Slices slices, const GrownSceneVariant& variant, const std::string& name) {
  Made made{std::move(slices.pieces), {}, {}, variant.clock};
  made.clock.add(slices.times);
  const CrossSection& section = slices.section;
  made.counts["surface_triangles"] += std::ssize(variant.grown.sheets.triangle);
  made.counts["section_triangles"] += std::ssize(section.triangle);
  made.counts["interior_vertices"] += std::count(section.interior.begin(), section.interior.end(), 1);
  if (made.solids.empty()) made.warnings.push_back("pieces \"" + name + "\": nothing is left to take");
  for (const std::string& warning : slices.warnings) made.warnings.push_back("pieces \"" + name + "\": " + warning);
  return made;
}

std::vector<Task> tasks_of(const SceneDescription& scene) {
  std::vector<Task> tasks;
  for (std::size_t entry = 0; entry < scene.pieces.size(); ++entry)
    for (int number = 0; number < scene.pieces[entry].count; ++number) tasks.push_back({entry, number});
  return tasks;
}

/// The inputs of all variants.
struct Ingredients {
  const SceneDescription& scene;
  const std::vector<Template>& templates;                           ///< one per entry
  const std::vector<std::shared_ptr<const Variation>>& variations;  ///< likewise
};

/// Makes some variants: grows each, cuts and colours all at once, and frees the grown fruits.
void make_some(std::span<const Task> tasks, const Ingredients& from, const Diffuser* diffuser,
               const ComposeOptions& options, const SliceOptions& how, std::span<Made> made) {
  std::vector<GrownSceneVariant> variants(tasks.size());
  parallel_for(tasks.size(), options.threads, [&](std::size_t i) {
    const auto& [entry, number] = tasks[i];
    variants[i] = grown_variant(from.scene, from.scene.pieces[entry], number, from.templates[entry],
                                from.variations[entry].get(), options);
    how.one_done();
  });
  std::vector<SliceTask> to_slice;
  for (std::size_t i = 0; i < tasks.size(); ++i)
    to_slice.push_back(task_of(from.scene.pieces[tasks[i].entry], tasks[i].number, variants[i]));
  std::vector<Slices> slices = sliced(from.scene, tasks, to_slice, diffuser, how);
  for (std::size_t i = 0; i < tasks.size(); ++i)
    made[i] = reported(std::move(slices[i]), variants[i], to_slice[i].name);
}

/// The number of solids that each entry still places. An entry with a total places its first ones; the others are freed
/// at once.
class RoomLeft {
 public:
  explicit RoomLeft(const SceneDescription& scene) {
    const std::vector<int> totals = totals_of(scene);
    for (std::size_t entry = 0; entry < totals.size(); ++entry) {
      const PiecesDescription& pieces = scene.pieces[entry];
      const bool has_total = pieces.total > 0 || pieces.share > 0;
      left_.push_back(has_total ? static_cast<std::size_t>(totals[entry]) : std::numeric_limits<std::size_t>::max());
    }
  }

  std::vector<Solid> placed(std::size_t entry, std::vector<Solid> solids) {
    if (solids.size() > left_[entry]) solids.resize(left_[entry]);
    left_[entry] -= solids.size();
    return solids;
  }

 private:
  std::vector<std::size_t> left_;
};

/// Keeps enough to settle the solid and to name it in files: only the triangles of its mesh.
Solid bare(Solid solid) {
  solid.mesh.normal = {}, solid.mesh.color = {}, solid.mesh.part = {}, solid.mesh.guide = {}, solid.mesh.surface = {};
  solid.mesh.guide_lattice = nullptr;
  solid.section_colors = nullptr;
  return solid;
}

/// Passes some variants' solids on; their shapes stay.
void hand_on(std::span<Made> made, const ComposeOptions& options) {
  std::vector<Solid> solids;
  for (Made& one : made) std::move(one.solids.begin(), one.solids.end(), std::back_inserter(solids));
  options.take(solids);
  auto next = solids.begin();
  for (Made& one : made)
    for (Solid& solid : one.solids) solid = bare(std::move(*next++));
}

/// Makes as many variants at a time as fit into memory.
std::vector<Made> all_made(std::span<const Task> tasks, const Ingredients& from, const Diffuser* diffuser,
                           const ComposeOptions& options) {
  Teller teller(options, "pieces", tasks.size(), 2);
  const SliceOptions how{.cut = options.cut,
                         .keep_section_colors = options.keep_section_colors,
                         .organs = options.organs,
                         .threads = options.threads,
                         .one_done = [&] { teller.step_done(); }};
  std::vector<Made> made(tasks.size());
  RoomLeft room(from.scene);
  BackgroundWork taking(options.threads);
  const std::size_t at_once = variants_at_once(options.threads);
  for (std::size_t first = 0; first < tasks.size(); first += at_once) {
    const std::size_t count = std::min(at_once, tasks.size() - first);
    const std::span<Made> some = std::span(made).subspan(first, count);
    make_some(tasks.subspan(first, count), from, diffuser, options, how, some);
    for (std::size_t i = 0; i < count; ++i)
      some[i].solids = room.placed(tasks[first + i].entry, std::move(some[i].solids));
    if (options.take) taking.begin([some, &options] { hand_on(some, options); });
  }
  taking.finish();
  return made;
}

/// Collects the results of an entry.
/// \param first the index of its first variant among all.
void gather(std::span<Made> made, int first, ItemMaker& maker, ComposeReport& report, StageClock& clock) {
  for (const Made& one : made)
    for (const Solid& solid : one.solids) maker.count(solid);
  for (Made& one : made) {
    for (Solid& solid : one.solids) maker.add(std::move(solid), first);
    ++first;
    for (const std::string& warning : one.warnings) report.warnings.push_back(warning);
    for (const auto& [what, number] : one.counts) report.counts[what] += number;
    clock.add(one.clock);
  }
}

/// Makes the bowl, then the dishes of the file; equal ones share a solid.
void add_dishes(const SceneDescription& scene, SceneParts& parts) {
  if (scene.bowl) {
    parts.dishes.push_back({.name = "bowl", .solid = static_cast<int>(parts.solids.size()), .place = scene.bowl_place});
    parts.solids.push_back(bowl_solid(*scene.bowl));
  }
  DishSolids solids(std::filesystem::path(scene.file).parent_path());
  const std::size_t first = parts.dishes.size();
  std::vector<int> made;  // indices of the solids, by those of DishSolids
  for (const DishDescription& dish : scene.dishes) {
    ScenePlacedDish placed{.name = dish.name, .turned = dish.turned.has_value(), .place = dish.place};
    placed.pose = {glm::dquat(reproducible::cos(0.5 * dish.turn), 0, reproducible::sin(0.5 * dish.turn), 0), dish.at};
    for (std::size_t k = 0; k < scene.dishes.size(); ++k)
      if (scene.dishes[k].name == dish.part_of) placed.part_of = static_cast<int>(first + k);
    const std::size_t index = solids.index_of(dish);
    if (index == made.size()) {
      made.push_back(static_cast<int>(parts.solids.size()));
      parts.solids.push_back(solids.solid(index));
    }
    placed.solid = made[index];
    parts.dishes.push_back(std::move(placed));
  }
  for (const std::string& note : solids.notes()) parts.report.warnings.push_back(note);
}

}  // namespace

std::vector<std::string> check_sources(const SceneDescription& scene, const ComposeOptions& options) {
  const std::vector<Template> templates = scene_templates(scene, options);
  layout_of(scene);
  check_cuts(scene, templates);
  DishSolids solids(std::filesystem::path(scene.file).parent_path());
  for (const DishDescription& dish : scene.dishes) solids.index_of(dish);
  return solids.notes();
}

SceneParts make_parts(const SceneDescription& scene, const Diffuser* diffuser, const ComposeOptions& options) {
  StageClock clock;
  const std::vector<Template> templates = clock.time("read", [&] { return scene_templates(scene, options); });
  const auto ready = clock.time("vary", [&] { return variations_of(scene, templates, options); });
  const std::vector<Task> tasks = tasks_of(scene);
  std::vector<Made> made = all_made(tasks, {scene, templates, ready}, diffuser, options);

  // Gathers them in the order of the file.
  SceneParts parts;
  const std::vector<int> totals = totals_of(scene);
  for (std::size_t first = 0; first < tasks.size();) {
    const std::size_t entry = tasks[first].entry;
    const auto count = static_cast<std::size_t>(scene.pieces[entry].count);
    ItemMaker maker(scene, entry, totals[entry], parts);
    gather(std::span(made).subspan(first, count), static_cast<int>(first), maker, parts.report, clock);
    first += count;
  }
  const std::size_t pieces = parts.solids.size();
  add_dishes(scene, parts);
  if (options.take && parts.solids.size() > pieces) {
    options.take(std::span(parts.solids).subspan(pieces));
    for (std::size_t k = pieces; k < parts.solids.size(); ++k) parts.solids[k] = bare(std::move(parts.solids[k]));
  }
  parts.report.counts["variants"] = std::ssize(tasks);
  parts.report.counts["pieces"] = std::ssize(parts.items);
  parts.report.stages = clock.stages();
  return parts;
}

}  // namespace pomona
