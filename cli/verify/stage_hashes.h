// The road of one variant, from its template to files, with a hash at each stage.
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

/// For each knife, of the template's variant of that seed, coarsely swept and coloured as a draft: what is compared is
/// whether the numbers are the same, not whether they are good ones.
/// Where the knife is not for this fruit, the stages from the cut on have empty ones.
/// \param one_done called for each knife. \throws Error as parse_knife() and slice() do.
std::vector<StageHashes> stage_hashes(const Template& drawn, std::uint64_t seed, std::span<const std::string> knives,
                                      Threads threads, const std::function<void()>& one_done = {});

}  // namespace pomona
