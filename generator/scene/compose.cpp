#include "generator/scene/compose.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <numeric>

#include "generator/piece/brown.h"
#include "generator/piece/grow.h"
#include "generator/piece/guided.h"
#include "generator/piece/section_colors.h"
#include "generator/scene/bowl.h"
#include "generator/template/read/read_template.h"

namespace pomona {

namespace {

/// Wall time of a thread's work on each stage.
class Clock {
 public:
  template <typename Work>
  auto time(const char* stage, Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    auto result = work();
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    add(stage, elapsed.count());
    return result;
  }

  void add(const std::string& stage, double milliseconds) {
    for (auto& [name, sum] : stages_)
      if (name == stage) return void(sum += milliseconds);
    stages_.emplace_back(stage, milliseconds);
  }

  const std::vector<std::pair<std::string, double>>& stages() const { return stages_; }

 private:
  std::vector<std::pair<std::string, double>> stages_;
};

/// Passes progress on, one call at a time.
class Teller {
 public:
  Teller(const ComposeOptions& options, std::string stage, std::size_t total)
      : options_(options), stage_(std::move(stage)), total_(total) {
    if (options_.progress) options_.progress(stage_, 0, total_);
  }
  void one_done() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (options_.progress) options_.progress(stage_, done_, total_);
  }

 private:
  const ComposeOptions& options_;
  std::string stage_;
  std::size_t total_, done_ = 0;
  std::mutex mutex_;
};

/// How many variants are held between cutting and writing: a batch that fills a graphics card, in a few hundred
/// megabytes.
constexpr std::size_t variants_at_once = 64;

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
  Clock clock;
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

/// The largest pieces that are worth keeping, in the order in which they were cut.
std::vector<CutPiece> picked(std::vector<CutPiece> cut, const PiecesDescription& pieces) {
  double whole = 0;
  for (const CutPiece& piece : cut) whole += piece.volume;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    const bool is_wanted = cut[i].volume >= pieces.smallest * whole && cut[i].volume <= pieces.largest * whole;
    if (is_wanted && !cut[i].crumb) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cut[a].volume > cut[b].volume; });
  if (pieces.take > 0 && order.size() > static_cast<std::size_t>(pieces.take))
    order.resize(static_cast<std::size_t>(pieces.take));
  std::sort(order.begin(), order.end());

  std::vector<CutPiece> kept;
  for (const std::size_t i : order) kept.push_back(std::move(cut[i]));
  return kept;
}

/// Takes the mark off interior vertices that no piece shows: nobody will see their colours.
void forget_unseen(Cut& cut) {
  std::vector<std::uint8_t> seen(cut.section.position.size(), 0);
  for (const CutPiece& piece : cut.pieces) {
    for (const CutPiece::CapTriangle& cap : piece.caps) {
      const glm::uvec3& t = cut.section.triangle[cap.triangle];
      for (int k = 0; k < 3; ++k) seen[t[k]] = 1;
    }
  }
  for (std::size_t v = 0; v < seen.size(); ++v) cut.section.interior[v] &= seen[v];
}

/// A value of the range, if there is one.
std::optional<double> drawn_between(const std::optional<Within>& range, VariantKey key, const char* purpose) {
  if (!range) return {};
  return range->low + (range->high - range->low) * RandomStream(key, purpose).uniform(0);
}

/// A variant cut, its faces still without colours.
struct CutVariant {
  Template fruit;
  GrownFruit grown;
  Cut cut;
  Clock clock;
};

/// \param variation of the template; none for pieces as drawn.
CutVariant cut_variant(const SceneDescription& scene, const PiecesDescription& pieces, int number,
                       const Template& fruit, const Variation* variation, const ComposeOptions& options) {
  CutVariant made;
  const VariantKey key = variant_key(scene, pieces, number);
  const GrowOptions how{.as_drawn = pieces.as_drawn,
                        .variation = pieces.variation * options.variation,
                        .curves_only = options.curves_only,
                        .folds = pieces.folds,
                        .detail = options.detail,
                        .ripeness = drawn_between(pieces.ripeness, key, "scene/ripeness"),
                        .browning = drawn_between(pieces.browning, key, "scene/browning").value_or(0)};
  made.fruit = made.clock.time(
      "vary", [&] { return variation ? variant_of(*variation, key, how) : variant_of(fruit, key, how); });
  made.grown = made.clock.time("sweep", [&] { return grow(made.fruit, key, how); });
  made.cut = made.clock.time("cut", [&] { return cut(made.grown.sheets, pieces.knives, options.cut); });
  made.cut.pieces = picked(std::move(made.cut.pieces), pieces);
  forget_unseen(made.cut);
  return made;
}

/// With the colours of all sections, diffused at once.
std::vector<CutVariant> diffused(std::vector<CutVariant> variants, const Diffuser& diffuser) {
  std::vector<CrossSection> sections;
  std::vector<const DiffusionSurfaces*> surfaces;
  for (CutVariant& variant : variants) {
    sections.push_back(std::move(variant.cut.section));
    surfaces.push_back(&variant.grown.sheets);
  }
  sections = colored(std::move(sections), surfaces, diffuser);
  for (std::size_t i = 0; i < variants.size(); ++i) variants[i].cut.section = std::move(sections[i]);
  return variants;
}

/// \param keep_colors_of the diffuser whose colours the solids are to remember; none if they need not.
Made finished(CutVariant variant, const PiecesDescription& pieces, int number, const Diffuser* keep_colors_of) {
  Made made;
  made.clock = variant.clock;
  const CrossSection& section = variant.cut.section;
  made.counts["surface_triangles"] += std::ssize(variant.grown.sheets.triangle);
  made.counts["section_triangles"] += std::ssize(section.triangle);
  made.counts["interior_vertices"] += std::count(section.interior.begin(), section.interior.end(), 1);

  const std::string name = pieces.name + "-" + std::to_string(number + 1);
  const CrossSection styled =
      guided(browned(section, variant.grown.sheets, variant.fruit), variant.grown.swept, variant.fruit);
  made.solids = solids(variant.cut, styled, variant.fruit, name);
  if (made.solids.empty()) made.warnings.push_back("pieces \"" + name + "\": nothing is left to take");
  for (const std::string& warning : variant.cut.warnings) {
    made.warnings.push_back("pieces \"" + name + "\": " + warning);
  }
  if (keep_colors_of) {
    made.solids = with_section_colors(std::move(made.solids),
                                      std::make_shared<const SectionColors>(std::move(variant.grown.sheets),
                                                                            std::move(variant.fruit), *keep_colors_of));
  }
  return made;
}

void add_items(const PiecesDescription& pieces, int solid, const std::string& name, std::vector<SettleItem>& items) {
  for (int copy = 0; copy < pieces.copies; ++copy) {
    SettleItem item{
        .solid = solid, .name = name, .order = pieces.order, .face_up = pieces.face_up, .beside = pieces.beside};
    if (copy > 0) item.name += ".copy-" + std::to_string(copy + 1);
    items.push_back(item);
  }
}

std::vector<Pose> settled_poses(const SceneDescription& scene, const SceneParts& parts, const ComposeOptions& options,
                                ComposeReport& report) {
  SettleOptions how;
  how.seed = scene.seed;
  how.fill = scene.fill;
  how.spread = scene.spread;
  how.around = scene.around;
  how.attempts = scene.attempts;
  how.pile.friction = scene.friction;
  how.threads = options.threads;
  const Solid* const bowl = parts.bowl ? &parts.solids[static_cast<std::size_t>(*parts.bowl)] : nullptr;
  Settled settled = settle(parts.solids, parts.items, bowl, how);
  report.fits = std::move(settled.fits);
  report.counts["settle_attempts"] = settled.attempts;
  report.counts["settle_steps"] = settled.steps;
  if (bowl) settled.poses.insert(settled.poses.begin(), Pose{});
  return std::move(settled.poses);
}

std::vector<Instance> unplaced(const SceneParts& parts) {
  std::vector<Instance> instances;
  if (parts.bowl) instances.push_back({*parts.bowl, {}, "bowl"});
  for (const SettleItem& item : parts.items) instances.push_back({item.solid, {}, item.name});
  return instances;
}

std::vector<Pose> layout_poses(const SceneDescription& scene, const SceneParts& parts) {
  const std::filesystem::path file = std::filesystem::path(scene.file).parent_path() / scene.layout;
  return poses_for(read_layout(file), parts.solids, unplaced(parts));
}

}  // namespace

VariantKey variant_key(const SceneDescription& scene, const PiecesDescription& pieces, int n) {
  const RandomStream names({0, static_cast<std::uint64_t>(n)}, "scene/pieces/" + pieces.name);
  return {scene.seed, names.bits(0) >> 32};
}

SceneParts make_parts(const SceneDescription& scene, const Diffuser* diffuser, const ComposeOptions& options) {
  Clock clock;
  const std::vector<Template> templates = clock.time("read", [&] { return read_templates(scene, options); });
  const auto ready = clock.time("vary", [&] { return made_ready(scene, templates); });
  std::vector<Task> tasks;
  for (std::size_t entry = 0; entry < scene.pieces.size(); ++entry)
    for (int number = 0; number < scene.pieces[entry].count; ++number) tasks.push_back({entry, number});

  // As many variants at a time as fit into memory: each cut by itself, all coloured at once.
  Clock diffusing;
  Teller teller(options, "pieces", tasks.size());
  std::vector<Made> made(tasks.size());
  for (std::size_t first = 0; first < tasks.size(); first += variants_at_once) {
    const std::size_t count = std::min(variants_at_once, tasks.size() - first);
    std::vector<CutVariant> variants(count);
    parallel_for(count, options.threads, [&](std::size_t i) {
      const auto& [entry, number] = tasks[first + i];
      variants[i] = cut_variant(scene, scene.pieces[entry], number, templates[entry], ready[entry].get(), options);
    });
    if (diffuser) variants = diffusing.time("diffuse", [&] { return diffused(std::move(variants), *diffuser); });
    parallel_for(count, options.threads, [&](std::size_t i) {
      const auto& [entry, number] = tasks[first + i];
      made[first + i] = finished(std::move(variants[i]), scene.pieces[entry], number,
                                 options.keep_section_colors ? diffuser : nullptr);
      teller.one_done();
    });
  }

  // Gather them in the order of the file.
  SceneParts parts;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    for (Solid& solid : made[i].solids) {
      add_items(scene.pieces[tasks[i].entry], static_cast<int>(parts.solids.size()), solid.name, parts.items);
      parts.solids.push_back(std::move(solid));
    }
    for (const std::string& warning : made[i].warnings) parts.report.warnings.push_back(warning);
    for (const auto& [what, number] : made[i].counts) parts.report.counts[what] += number;
    for (const auto& [stage, milliseconds] : made[i].clock.stages()) clock.add(stage, milliseconds);
  }
  for (const auto& [stage, milliseconds] : diffusing.stages()) clock.add(stage, milliseconds);
  if (scene.bowl) {
    parts.bowl = static_cast<int>(parts.solids.size());
    parts.solids.push_back(bowl_solid(*scene.bowl));
  }
  parts.report.counts["variants"] = std::ssize(tasks);
  parts.report.counts["pieces"] = std::ssize(parts.items);
  parts.report.stages = clock.stages();
  return parts;
}

Scene placed(const SceneDescription& scene, const SceneParts& parts, const std::vector<Pose>& poses) {
  Scene result;
  result.solids = parts.solids;
  if (scene.paper) result.paper = *scene.paper;
  result.ground = scene.ground;
  result.instances = unplaced(parts);
  for (std::size_t i = 0; i < result.instances.size(); ++i) result.instances[i].pose = poses[i];
  result.view.vertical_field = scene.vertical_field;
  result.view = scene.view ? *scene.view : fitted_view(result, scene.view_direction);
  return result;
}

Composition compose(const SceneDescription& scene, const Diffuser* diffuser, const ComposeOptions& options) {
  SceneParts parts = make_parts(scene, diffuser, options);
  Composition composition{{}, std::move(parts.report)};
  Clock clock;
  Teller teller(options, "settle", 1);
  const std::vector<Pose> poses = clock.time("settle", [&] {
    return scene.layout.empty() ? settled_poses(scene, parts, options, composition.report) : layout_poses(scene, parts);
  });
  teller.one_done();
  composition.report.stages.push_back(clock.stages().front());
  composition.scene = placed(scene, parts, poses);
  return composition;
}

}  // namespace pomona
