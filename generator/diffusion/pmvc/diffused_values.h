// Diffuses other smooth values of surfaces like colours, four at a time.
#pragma once

#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "generator/base/parallel.h"
#include "generator/diffusion/diffuser.h"

namespace pomona {

/// Values at `points` (metres), diffused from those of the vertices, which both sides of a surface share, by positive
/// mean values at draft quality: each channel is what make_pmvc_diffuser() would give it as a channel of a colour, to
/// the bit, unless points lie in one plane: here, a value depends on its point alone, whatever others are asked with
/// it. Colours and parts of the surfaces do not matter. \param value one per vertex. \throws Error (bad_data) as
/// Diffuser::field() and ColorField::at() do.
std::vector<glm::vec4> diffused_values(DiffusionSurfaces surfaces, std::span<const glm::vec4> value,
                                       std::span<const glm::vec3> points, Threads threads = {});

}  // namespace pomona
