// Fruit that is cut after it has left the program: -o FILE.html and -o FILE.pomona of grow and cut.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/deliver.h"
#include "cli/fruit_source.h"
#include "cli/outputs.h"
#include "cli/shared_options.h"
#include "generator/knife/knife.h"
#include "generator/scene/scene.h"

namespace pomona {

constexpr bool is_live(Format format) { return format == Format::html || format == Format::pomona; }
bool any_live(const std::vector<Output>& outputs);
bool all_live(const std::vector<Output>& outputs);

/// Adds the outputs that are live; a page opens with the planes of these knives. The colours of the grid are those of
/// true diffusion unless --diffuser says otherwise.
/// \param beside further seeds, which a page shows side by side with the first; then the nodes of all are those of
/// drafts \throws Error (usage) for knives that are no planes, or too many; (bad_data) as make_asset().
void add_live(const std::vector<Output>& outputs, const FruitSource& source, std::span<const Knife> knives,
              const SharedOptions& options, Delivery& delivery, std::span<const FruitSource> beside = {});

/// Adds a .glb of the whole fruit that carries its asset (render/page/cuttable_glb.h). \throws Error as make_asset()
void add_cuttable(const Output& output, const Scene& scene, const FruitSource& source, const SharedOptions& options,
                  Delivery& delivery);

/// The bytes of FILE.pomona, as add_live() writes them where no diffuser is named. With `fast` they hold the same and
/// are more: for those who look at once and keep nothing.
std::string live_bytes(const FruitSource& source, const SharedOptions& options, bool fast = false);

/// What add_live() would say of the knives. \throws Error (usage)
void check_live_knives(std::span<const Knife> knives);

}  // namespace pomona
