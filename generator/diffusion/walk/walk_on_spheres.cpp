#include "generator/diffusion/walk/walk_on_spheres.h"

#include <atomic>
#include <cmath>

#include "generator/base/error.h"
#include "generator/diffusion/walk/walks_from_point.h"

namespace pomona {

WalkOnSpheres::WalkOnSpheres(const DiffusionSurfaces& surfaces, const WalkOptions& options)
    : ground_(std::make_unique<WalkGround>(surfaces, options.threads)), options_(options) {
  if (!(options.standard_error > 0)) {
    throw Error(ExitStatus::usage, "walk on spheres: the standard error to reach must be above 0");
  }
}

WalkOnSpheres::~WalkOnSpheres() = default;

WalkResult WalkOnSpheres::at(std::span<const glm::vec3> points) const {
  require_finite(points);
  const std::size_t count = points.size();
  WalkResult result{std::vector<Color>(count), std::vector<std::int32_t>(count), std::vector<float>(count),
                    std::vector<std::uint32_t>(count), std::vector<std::uint32_t>(count)};
  std::atomic<std::size_t> done = 0;
  parallel_for(count, options_.threads, [&](std::size_t i) {
    const WalkedColor walked = walks_from_point(*ground_, points[i], options_);
    result.color[i] = walked.color;
    result.part[i] = walked.part;
    result.standard_error[i] = static_cast<float>(walked.standard_error);
    result.walks[i] = walked.walks;
    result.misses[i] = walked.misses;
    const std::size_t finished = ++done;
    if (options_.progress) options_.progress(finished, count);
  });
  return result;
}

}  // namespace pomona
