#include "generator/scene/make_parts.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <numeric>
#include <span>

#include "generator/base/reproducible.h"
#include "generator/cut/cut.h"
#include "generator/piece/grow.h"
#include "generator/piece/slice.h"
#include "generator/scene/check_cuts.h"
#include "generator/scene/dish_solids.h"
#include "generator/scene/layout_file.h"
#include "generator/template/read/read_template.h"

namespace pomona {

namespace {

/// Passes progress on, one call at a time.
class Teller {
 public:
  /// \param steps in which each of the items is made.
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

/// How many variants are held between growing and their solids: some seven megabytes each. Enough for all threads, and
/// for a graphics card to pay.
std::size_t variants_at_once(Threads threads) {
  constexpr std::size_t least = 16;
  return std::max(least, 2 * static_cast<std::size_t>(resolved(threads)));
}

/// One variant to be made: entry and number in it.
struct Task {
  std::size_t entry = 0;
  int number = 0;
};

/// What came of it.
struct Made {
  std::vector<Solid> solids;
  std::vector<std::string> warnings;
  std::map<std::string, std::int64_t> counts;
  StageClock clock;
};

std::filesystem::path template_file(const SceneDescription& scene, const PiecesDescription& pieces,
                                    const ComposeOptions& options) {
  const std::filesystem::path beside = std::filesystem::path(scene.file).parent_path() / pieces.template_name;
  if (std::filesystem::is_regular_file(beside)) return beside;
  try {
    if (options.find_template) return options.find_template(pieces.template_name);
  } catch (const Error& error) {
    const Diagnostic& what = error.diagnostics().front();
    throw Error(error.status(), {{pieces.template_place, what.message, what.hint}});
  }
  throw Error(ExitStatus::input_missing,
              {{pieces.template_place, "there is no template \"" + pieces.template_name + "\"", {}}});
}

/// Refuses an entry that asks of its template what that does not declare.
void check_fits(const PiecesDescription& pieces, const Template& fruit) {
  const auto refuse = [&](const std::string& why) {
    throw Error(
        ExitStatus::bad_data,
        {{pieces.template_place, "pieces \"" + pieces.name + "\": \"" + pieces.template_name + "\" " + why, {}}});
  };
  if (pieces.folds && !std::holds_alternative<FoldSymmetry>(fruit.symmetry)) refuse("has no folds");
  if (pieces.ripeness && !fruit.ripeness.declared()) refuse("does not say how it ripens");
  if (pieces.browning && !fruit.browning.declared()) refuse("does not say how it turns brown");
}

/// One template per entry; the same file is read once.
std::vector<Template> read_templates(const SceneDescription& scene, const ComposeOptions& options) {
  std::vector<Template> templates;
  std::vector<std::filesystem::path> files;
  for (const PiecesDescription& pieces : scene.pieces) {
    files.push_back(template_file(scene, pieces, options));
    const auto known = std::find(files.begin(), files.end() - 1, files.back()) - files.begin();
    templates.push_back(known + 1 < std::ssize(files) ? templates[static_cast<std::size_t>(known)]
                                                      : read_template(files.back()));
    check_fits(pieces, templates.back());
  }
  return templates;
}

/// For each entry that wants variants its template made ready for them, once for all entries with the same template.
std::vector<std::shared_ptr<const Variation>> made_ready(const SceneDescription& scene,
                                                         const std::vector<Template>& templates) {
  std::vector<std::shared_ptr<const Variation>> ready(templates.size());
  for (std::size_t entry = 0; entry < ready.size(); ++entry) {
    if (scene.pieces[entry].as_drawn) continue;
    for (std::size_t known = 0; known < entry && !ready[entry]; ++known) {
      if (scene.pieces[known].template_name == scene.pieces[entry].template_name) ready[entry] = ready[known];
    }
    if (!ready[entry]) ready[entry] = std::make_shared<Variation>(templates[entry]);
  }
  return ready;
}

/// A value of the range, if there is one.
std::optional<double> drawn_between(const std::optional<Within>& range, VariantKey key, const char* purpose) {
  if (!range) return {};
  return range->low + (range->high - range->low) * RandomStream(key, purpose).uniform(0);
}

/// A variant as it has grown.
struct GrownVariant {
  Template variant;
  GrownFruit grown;
  PieceOrigin origin;
  StageClock clock;
};

/// \param variation of the template; none for pieces as drawn.
GrownVariant grown_variant(const SceneDescription& scene, const PiecesDescription& pieces, int number,
                           const Template& fruit, const Variation* variation, const ComposeOptions& options) {
  GrownVariant made;
  const VariantKey key = variant_key(scene, pieces, number);
  const GrowOptions how{.as_drawn = pieces.as_drawn,
                        .variation = pieces.variation * options.variation,
                        .curves_only = options.curves_only,
                        .folds = pieces.folds,
                        .detail = options.detail * pieces.detail,
                        .ripeness = drawn_between(pieces.ripeness, key, "scene/ripeness"),
                        .browning = drawn_between(pieces.browning, key, "scene/browning").value_or(0),
                        .scale = drawn_between(pieces.size, key, "scene/size").value_or(1)};
  made.variant = made.clock.time(
      "vary", [&] { return variation ? variant_of(*variation, key, how) : variant_of(fruit, key, how); });
  made.grown = made.clock.time("sweep", [&] { return grow(made.variant, key, how); });
  made.origin = {.source = source_word(pieces.template_name), .key = key, .growing = how, .entry = pieces.name};
  return made;
}

std::string variant_name(const PiecesDescription& pieces, int number) {
  return pieces.name + "-" + std::to_string(number + 1);
}

/// How an entry's variant is cut, and which of its pieces the scene takes.
SliceTask task_of(const PiecesDescription& pieces, int number, const GrownVariant& made) {
  return {.grown = made.grown,
          .variant = made.variant,
          .knives = pieces.knives,
          .name = variant_name(pieces, number),
          .choice = PieceChoice{.smallest = pieces.smallest, .largest = pieces.largest, .take = pieces.take},
          .origin = made.origin};
}

/// Slices, or says which entry could not be cut.
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

/// What the report tells of one variant.
Made reported(Slices slices, const GrownVariant& variant, const std::string& name) {
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

/// How many pieces each entry places: by its share of the scene's total, those with the largest rests first; else its
/// own total. 0 where it says neither.
std::vector<int> totals_of(const SceneDescription& scene) {
  double all = 0;
  for (const PiecesDescription& pieces : scene.pieces) all += pieces.share;
  std::vector<int> totals;
  std::vector<std::pair<double, std::size_t>> rests;
  int left = scene.total;
  for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
    const PiecesDescription& pieces = scene.pieces[i];
    totals.push_back(pieces.total);
    if (pieces.share <= 0) continue;
    const double wanted = scene.total * pieces.share / all;
    totals.back() = static_cast<int>(wanted);
    left -= totals.back();
    rests.emplace_back(static_cast<double>(totals.back()) - wanted, i);
  }
  std::sort(rests.begin(), rests.end());
  for (std::size_t k = 0; k < rests.size() && left > 0; ++k, --left) ++totals[rests[k].second];
  return totals;
}

/// Makes the items of one entry: its pieces, each as often as asked for.
class ItemMaker {
 public:
  ItemMaker(const SceneDescription& scene, std::size_t entry, int total, SceneParts& parts)
      : pieces_(scene.pieces[entry]), parts_(parts), total_(static_cast<std::size_t>(total)) {
    for (std::size_t k = 0; k < scene.dishes.size(); ++k)
      if (scene.dishes[k].name == pieces_.dish) dish_ = static_cast<int>(k) + (scene.bowl ? 1 : 0);
    if (pieces_.dish.empty() && scene.bowl) dish_ = 0;
    if (pieces_.where) {
      arrangement_ = static_cast<int>(parts_.arrangements.size());
      parts_.arrangements.push_back(*pieces_.where);
    }
  }

  void count(const Solid&) { ++solids_; }

  void add(Solid solid, int fruit) {
    const bool has_total = pieces_.total > 0 || pieces_.share > 0;
    const std::size_t times =
        has_total ? total_ / solids_ + (next_ < total_ % solids_ ? 1 : 0) : static_cast<std::size_t>(pieces_.copies);
    ++next_;
    if (times == 0) return;
    SettleItem item{.solid = static_cast<int>(parts_.solids.size()),
                    .name = solid.name,
                    .order = pieces_.order,
                    .face_up = pieces_.face_up,
                    .beside = pieces_.beside,
                    .upright = pieces_.upright,
                    .arrangement = arrangement_,
                    .place = pieces_.place};
    for (std::size_t copy = 0; copy < times; ++copy) {
      // Copies of a fruit are fruits of their own.
      item.fruit = fruit + static_cast<int>(copy) * most_fruits;
      if (copy > 0) item.name = solid.name + ".copy-" + std::to_string(copy + 1);
      parts_.items.push_back(item);
      parts_.dish_of.push_back(dish_);
    }
    parts_.solids.push_back(std::move(solid));
  }

 private:
  static constexpr int most_fruits = 1 << 16;  // more than a scene has variants
  const PiecesDescription& pieces_;
  SceneParts& parts_;
  std::size_t total_, solids_ = 0, next_ = 0;
  int dish_ = -1, arrangement_ = -1;
};

/// The bowl, then the dishes of the file; what is made alike is one solid.
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
}

}  // namespace

VariantKey variant_key(const SceneDescription& scene, const PiecesDescription& pieces, int n) {
  const RandomStream names({0, static_cast<std::uint64_t>(n)}, "scene/pieces/" + pieces.name);
  return {scene.seed, names.bits(0) >> 32};
}

void check_sources(const SceneDescription& scene, const ComposeOptions& options) {
  const std::vector<Template> templates = read_templates(scene, options);
  layout_of(scene);
  check_cuts(scene, templates);
  DishSolids solids(std::filesystem::path(scene.file).parent_path());
  for (const DishDescription& dish : scene.dishes) solids.index_of(dish);
}

SceneParts make_parts(const SceneDescription& scene, const Diffuser* diffuser, const ComposeOptions& options) {
  StageClock clock;
  const std::vector<Template> templates = clock.time("read", [&] { return read_templates(scene, options); });
  const auto ready = clock.time("vary", [&] { return made_ready(scene, templates); });
  std::vector<Task> tasks;
  for (std::size_t entry = 0; entry < scene.pieces.size(); ++entry)
    for (int number = 0; number < scene.pieces[entry].count; ++number) tasks.push_back({entry, number});

  // As many variants at a time as fit into memory: each grown by itself, all cut and coloured at once.
  Teller teller(options, "pieces", tasks.size(), 2);
  const SliceOptions how{.cut = options.cut,
                         .keep_section_colors = options.keep_section_colors,
                         .threads = options.threads,
                         .one_done = [&] { teller.step_done(); }};
  std::vector<Made> made(tasks.size());
  const std::size_t at_once = variants_at_once(options.threads);
  for (std::size_t first = 0; first < tasks.size(); first += at_once) {
    const std::size_t count = std::min(at_once, tasks.size() - first);
    std::vector<GrownVariant> variants(count);
    parallel_for(count, options.threads, [&](std::size_t i) {
      const auto& [entry, number] = tasks[first + i];
      variants[i] = grown_variant(scene, scene.pieces[entry], number, templates[entry], ready[entry].get(), options);
      teller.step_done();
    });
    std::vector<SliceTask> to_slice;
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [entry, number] = tasks[first + i];
      to_slice.push_back(task_of(scene.pieces[entry], number, variants[i]));
    }
    std::vector<Slices> slices = sliced(scene, std::span(tasks).subspan(first, count), to_slice, diffuser, how);
    for (std::size_t i = 0; i < count; ++i) {
      made[first + i] = reported(std::move(slices[i]), variants[i], to_slice[i].name);
    }
  }

  // Gather them in the order of the file.
  SceneParts parts;
  const std::vector<int> totals = totals_of(scene);
  for (std::size_t first = 0; first < tasks.size();) {
    const PiecesDescription& pieces = scene.pieces[tasks[first].entry];
    const auto end = first + static_cast<std::size_t>(pieces.count);
    ItemMaker maker(scene, tasks[first].entry, totals[tasks[first].entry], parts);
    for (std::size_t i = first; i < end; ++i)
      for (const Solid& solid : made[i].solids) maker.count(solid);
    for (std::size_t i = first; i < end; ++i) {
      for (Solid& solid : made[i].solids) maker.add(std::move(solid), static_cast<int>(i));
      for (const std::string& warning : made[i].warnings) parts.report.warnings.push_back(warning);
      for (const auto& [what, number] : made[i].counts) parts.report.counts[what] += number;
      clock.add(made[i].clock);
    }
    first = end;
  }
  add_dishes(scene, parts);
  parts.report.counts["variants"] = std::ssize(tasks);
  parts.report.counts["pieces"] = std::ssize(parts.items);
  parts.report.stages = clock.stages();
  return parts;
}

}  // namespace pomona
