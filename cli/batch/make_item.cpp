#include "cli/batch/make_item.h"

#include <algorithm>
#include <utility>

#include "cli/exhausted.h"
#include "generator/base/error.h"
#include "generator/base/sha256.h"
#include "generator/batch/item_record.h"
#include "generator/mesh/box.h"
#include "generator/scene/lay_out.h"
#include "render/deliver/deliver.h"
#include "render/deliver/export_options.h"
#include "render/deliver/live_files.h"
#include "render/deliver/ordered_diffuser.h"
#include "render/deliver/piece_files.h"
#include "render/image/png.h"
#include "render/thumbnail/thumbnail.h"

namespace pomona {

namespace {

constexpr Threads alone{1};  ///< one thread makes an item; a batch makes many items at once

/// A thumbnail shows the pieces elsewhere; their meshes are the same, but for a peel that hangs.
std::string thumbnail(const Scene& scene, const std::vector<StyledMesh>& meshes, const AssetOptions& assets,
                      const ExportOptions& options) {
  const Scene laid = laid_out(without_crumbs(scene), 1);
  const bool is_bent = !std::equal(laid.solids.begin(), laid.solids.end(), scene.solids.begin(), scene.solids.end(),
                                   [](const Solid& a, const Solid& b) { return a.mesh.position == b.mesh.position; });
  return write_png(draw_thumbnail(laid, is_bent ? styled_meshes(laid, options) : meshes, options.style,
                                  {.size = assets.thumbnail, .on_paper = assets.thumbnail_on_paper}));
}

/// The files of an item, and its pieces where they grew.
struct MadePieces {
  Scene scene;
  std::vector<NamedFile> files;
  std::vector<std::string> warnings;
};

/// What the same files show: all pieces, or one of them.
struct FileSet {
  Scene scene;
  std::vector<RipenessVariant> variants;
  Order order;
};

/// One piece alone, in files with its number: kiwi-2.glb.
FileSet set_of_piece(const Scene& all, std::size_t number, const std::vector<RipenessVariant>& variants, Order order) {
  FileSet set{gathered({all.solids[number]}), {}, std::move(order)};
  set.scene.paper = all.paper;
  for (const RipenessVariant& riper : variants) set.variants.push_back({riper.name, {riper.pieces[number]}});
  for (Output& output : set.order.outputs)
    output.file = output.file.stem().string() + "-" + std::to_string(number + 1) + output.file.extension().string();
  return set;
}

/// Moves the only piece along the ground, until the middle of its box is above the origin.
void move_to_origin(Scene& scene) {
  Instance& instance = scene.instances.front();
  Box<double> box;
  for (const glm::vec3& p : scene.solids.front().mesh.position)
    box.add(instance.pose.rotation * glm::dvec3(p) + instance.pose.translation);
  instance.pose.translation -= glm::dvec3(box.center().x, 0, box.center().z);
}

std::vector<FileSet> file_sets(const Scene& all, std::vector<RipenessVariant> variants, const Order& order,
                               const AssetOptions& assets) {
  std::vector<FileSet> sets;
  if (!assets.apart) sets.push_back({all, std::move(variants), order});
  for (std::size_t i = 0; assets.apart && i < all.solids.size(); ++i)
    sets.push_back(set_of_piece(all, i, variants, order));
  for (FileSet& set : sets) {
    if (!assets.on_table) continue;
    const Color paper = set.scene.paper;
    set.scene = laid_out(set.scene, 1);
    set.scene.paper = paper;
    if (assets.apart) move_to_origin(set.scene);
  }
  return sets;
}

MadePieces made_pieces(const OrderedFruit& fruit, const Template& drawn, const Order& order, const AssetOptions& assets,
                       const EntryStyles& styles) {
  const DeliverOptions how{
      .style = styles.drawn, .texture_style = styles.baked, .provenance = provenance_of(order.fruit)};
  const std::unique_ptr<Diffuser> diffuser = ordered_diffuser(order);
  Delivered delivered = live_files({&fruit, 1}, order, how);
  Slices slices = cut_to_order(fruit, order, diffuser.get(), OrganFacts::always);
  StageClock times;
  std::vector<RipenessVariant> variants = ripeness_variants(slices.pieces, fruit, drawn, order, diffuser.get(), times);
  MadePieces made{gathered(std::move(slices.pieces)), {}, std::move(slices.warnings)};
  made.scene.paper = styles.drawn.paper;

  // The thumbnail shows the meshes of the .glb.
  const ExportOptions options = export_options(order, how);
  const std::vector<StyledMesh> meshes =
      assets.thumbnail > 0 ? styled_meshes(made.scene, options) : std::vector<StyledMesh>();
  const bool as_grown = !assets.on_table && !assets.apart;
  for (const FileSet& set : file_sets(made.scene, std::move(variants), order, assets)) {
    delivered.add(
        piece_files({.placed = set.scene,
                     .variants = set.variants,
                     .meshes = as_grown ? std::span<const StyledMesh>(meshes) : std::span<const StyledMesh>()},
                    fruit, set.order, how));
  }
  for (DeliveredFile& one : delivered.files) made.files.push_back({one.file.path.string(), std::move(one.file.bytes)});
  if (assets.thumbnail > 0) made.files.push_back({"thumbnail.png", thumbnail(made.scene, meshes, assets, options)});
  made.warnings.insert(made.warnings.end(), delivered.warnings.begin(), delivered.warnings.end());
  return made;
}

std::vector<RecordedFile> recorded(const std::vector<NamedFile>& files) {
  std::vector<RecordedFile> records;
  for (const NamedFile& file : files) records.push_back({file.name, file.bytes.size(), sha256(file.bytes)});
  return records;
}

}  // namespace

OrderedFruit grown_variant(const BatchPlan& plan, const Variation& variation, const BatchVariant& which) {
  Order order = order_of(plan, which);
  order.threads = alone;
  OrderedFruit fruit = ordered_fruit(variation, plan.templates[which.fruit].name, source_of(plan, which), order);
  fruit.origin.growing.threads = {};
  return fruit;
}

MadeItem make_item(const BatchPlan& plan, const BatchVariant& which, const OrderedFruit* grown,
                   const std::string& growing_error, const BatchItem& item, const EntryStyles& styles) {
  const PlannedEntry& entry = plan.entries[which.entry];
  MadeItem made{.item = item_path(entry.wanted.name, entry.items(), item.number), .files = {}, .error = growing_error};

  // Cut the fruit and make the files; an error concerns only this item.
  ItemOutcome outcome;
  MadePieces pieces;
  try {
    if (grown != nullptr) {
      Order order = order_of(plan, which, item);
      order.threads = alone;
      const Template& drawn = plan.templates[which.fruit].fruit;
      const bool is_fresh = item.browning == grown->fruit.individual.browning;
      pieces = is_fresh ? made_pieces(*grown, drawn, order, entry.wanted.assets, styles)
                        : made_pieces(browned(*grown, item.browning), drawn, order, entry.wanted.assets, styles);
      made.files = std::move(pieces.files);
      outcome = {.pieces = pieces.scene.solids,
                 .files = recorded(made.files),
                 .warnings = std::move(pieces.warnings),
                 .error = {}};
    }
  } catch (const std::exception& error) {
    if (exhausted(error)) throw;
    made.error = reason_of(error);
  }

  // A failed item leaves only its record.
  if (!made.error.empty()) {
    made.files.clear();
    outcome = {.error = made.error};
  }
  made.files.push_back({"item.json", item_record(plan, which, item, outcome)});
  return made;
}

std::uint64_t memory_of_an_item(const PlannedEntry& entry) {
  constexpr std::uint64_t megabyte = 1'000'000;
  const AssetOptions& assets = entry.wanted.assets;
  const double detail = std::max(1.0, assets.order.fruit.growing.detail * assets.order.fruit.growing.detail);
  const auto surfaces = static_cast<std::uint64_t>(80 * detail) * megabyte;
  const auto side = static_cast<std::uint64_t>(assets.thumbnail);
  const auto texels = static_cast<std::uint64_t>(*std::max_element(assets.textures.begin(), assets.textures.end()));
  constexpr std::uint64_t of_a_texel = 200, of_a_pixel = 640;
  return surfaces + of_a_texel * texels * texels + of_a_pixel * side * side;
}

}  // namespace pomona
