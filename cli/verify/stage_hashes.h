// Makes one variant, from its template to files, with a hash of each stage.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cli/verify/verified_cut.h"
#include "generator/base/parallel.h"
#include "generator/template/template.h"

namespace pomona {

/// For each knife, of the template's variant of that seed, coarsely swept and coloured as a draft, because only
/// equality matters. If the knife does not fit this fruit, the hashes from the cut on are empty.
/// \param one_done called for each knife.
/// \throws Error as parse_knife() and slice() do.
std::vector<StageHashes> stage_hashes(const Template& drawn, std::uint64_t seed, std::span<const std::string> knives,
                                      Threads threads, const std::function<void()>& one_done = {});

}  // namespace pomona
