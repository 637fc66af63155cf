// The names of --diffuser, and what they stand for (docs/reference/diffusion.md).
#pragma once

#include <memory>

#include "cli/progress.h"
#include "cli/shared_options.h"
#include "generator/diffusion/diffuser.h"

namespace pomona {

/// Long work tells `progress`, which must outlive the diffuser.
/// \throws Error (usage) for a name this version does not have; (unavailable) where the machine lacks what it needs.
std::unique_ptr<Diffuser> make_diffuser(const SharedOptions& options, Progress& progress);

}  // namespace pomona
