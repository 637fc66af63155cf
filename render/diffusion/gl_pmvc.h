// Positive mean values by OpenGL, for many fruits at once.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "generator/diffusion/pmvc_value.h"
#include "render/diffusion/gl_ray_caster.h"

namespace pomona {

/// The number of lines through each point, used in both directions.
struct LineSampling {
  int lines = 0;
  int fine_lines = 0;      ///< instead, where colours scatter by more than `max_scatter`; 0 = nowhere
  double max_scatter = 0;  ///< linear; see Sight
};

/// Points in one fruit.
struct SightTask {
  std::uint64_t fruit = 0;  ///< a number that no other fruit has
  const RayFrame* frame = nullptr;
  std::function<std::shared_ptr<const RaySurfaces>()> surfaces;  ///< called if the card does not have them
  std::vector<glm::vec3> eye;                                    ///< normalised; near points should follow each other
};

struct PointSight {
  PmvcValue value;
  bool near_surface = false;  ///< see Sight
};

/// Tasks that the card works on while the next ones are made ready.
class GlPmvc {
 public:
  /// The arguments must outlive this object.
  /// \param fruits on the card; new ones are added
  GlPmvc(const CurrentGl& gl, const GlRayCaster& caster, GlFruits& fruits, const LineSampling& sampling);

  /// Starts with some tasks, which must outlive this object.
  /// \throws Error (helper_missing) if a fruit is too large for this OpenGL, or memory does not suffice.
  void start(std::span<const SightTask* const> tasks);

  /// An entry for every point of every task, in the order in which they were started. It does not depend on the other
  /// tasks.
  std::vector<std::vector<PointSight>> finish();

 private:
  /// Tasks whose rays are cast together.
  struct UnderWay {
    std::size_t first = 0;  ///< of the tasks
    std::size_t count = 0;
    CastRays rays;
  };

  /// Points of a task where colours scatter.
  struct Rough {
    std::size_t task = 0;
    std::vector<std::size_t> point;
    std::vector<glm::vec3> eye;
  };

  void cast(std::size_t first);
  void settle();
  std::vector<Rough> read(const UnderWay& started);
  std::vector<PointGroup> groups_of(const SightTask& task, std::span<const glm::vec3> eyes) const;

  const CurrentGl& gl_;
  const GlRayCaster& caster_;
  GlFruits& fruits_;
  LineSampling sampling_;
  GlLines lines_;
  std::vector<const SightTask*> tasks_;
  std::vector<std::vector<PointSight>> sights_;
  std::vector<UnderWay> under_way_;
};

}  // namespace pomona
