#include "generator/compose/collected_surfaces.h"

#include <utility>

#include "generator/surface/merged_names.h"

namespace pomona {

namespace {

template <typename T>
void append_all(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

void CollectedSurfaces::add(const DiffusionSurfaces& own, const InstancePose& pose, const std::string& place,
                            const std::vector<std::string>& part_names, std::int32_t number) {
  all_.instance.resize(all_.triangle_count(), 0);
  const auto first = static_cast<std::uint32_t>(all_.vertex_count());
  for (const glm::vec3& p : own.position) all_.position.emplace_back(pose(glm::dvec3(p)));
  for (const float blur : own.blur) all_.blur.push_back(static_cast<float>(pose.scale * static_cast<double>(blur)));
  append_all(all_.front_color, own.front_color);
  append_all(all_.back_color, own.back_color);
  append_all(all_.front_hidden, own.front_hidden);
  append_all(all_.back_hidden, own.back_hidden);

  std::vector<std::string> surfaces, parts;
  for (const std::string& name : own.surface_names) surfaces.push_back(place + "." + name);
  for (std::size_t i = 0; i < own.part_names.size(); ++i)
    parts.push_back(i < part_names.size() ? part_names[i] : place + "." + own.part_names[i]);
  const std::vector<std::int32_t> surface = merge_names(all_.surface_names, surfaces);
  const std::vector<std::int32_t> part = merge_names(all_.part_names, parts);
  for (std::size_t t = 0; t < own.triangle_count(); ++t) {
    all_.triangle.push_back(own.triangle[t] + glm::uvec3(first));
    all_.surface.push_back(surface[static_cast<std::size_t>(own.surface[t])]);
    all_.front_part.push_back(part[static_cast<std::size_t>(own.front_part[t])]);
    all_.back_part.push_back(part[static_cast<std::size_t>(own.back_part[t])]);
    all_.instance.push_back(number + own.instance_of(t));
  }
  append_all(all_.notes, own.notes);
}

DiffusionSurfaces CollectedSurfaces::take() { return std::exchange(all_, {}); }

}  // namespace pomona
