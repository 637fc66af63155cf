// Many instances joined into one fruit's surfaces.
#pragma once

#include <string>
#include <vector>

#include "generator/compose/instance_pose.h"

namespace pomona {

/// Appends one instance after another in time in proportion to what they hold.
class CollectedSurfaces {
 public:
  explicit CollectedSurfaces(DiffusionSurfaces own) : all_(std::move(own)) {}

  /// Lays an instance's surfaces in the fruit. Their names become "PLACE.SURFACE", the same for all instances, their
  /// parts those that `part_names` says in their order, and what they call instance n becomes `number` + n.
  void add(const DiffusionSurfaces& own, const InstancePose& pose, const std::string& place,
           const std::vector<std::string>& part_names, std::int32_t number);

  DiffusionSurfaces take();

 private:
  DiffusionSurfaces all_;
};

}  // namespace pomona
