#include "generator/diffusion/diffuser.h"

#include <utility>

namespace pomona {

namespace {

/// The vertices that diffusion colours, and where they lie.
struct Interior {
  std::vector<std::size_t> vertex;
  std::vector<glm::vec3> position;
};

Interior interior_of(const CrossSection& section) {
  Interior interior;
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    if (!section.interior[v]) continue;
    interior.vertex.push_back(v);
    interior.position.push_back(section.position[v]);
  }
  return interior;
}

}  // namespace

std::vector<DiffusedColors> Diffuser::diffuse_all(std::span<const DiffusionTask> tasks) const {
  std::vector<DiffusedColors> colors;
  for (const DiffusionTask& task : tasks) colors.push_back(diffuse(*task.surfaces, task.points));
  return colors;
}

DiffusedColors Diffuser::diffuse(const DiffusionSurfaces& surfaces, std::span<const glm::vec3> points) const {
  return field(surfaces)->at(points);
}

CrossSection colored(CrossSection section, const DiffusionSurfaces& surfaces, const Diffuser& diffuser) {
  std::vector<CrossSection> sections;
  sections.push_back(std::move(section));
  const DiffusionSurfaces* const only = &surfaces;
  return std::move(colored(std::move(sections), {&only, 1}, diffuser).front());
}

std::vector<CrossSection> colored(std::vector<CrossSection> sections,
                                  std::span<const DiffusionSurfaces* const> surfaces, const Diffuser& diffuser) {
  // Gather the interior vertices; a section without any is no task.
  std::vector<Interior> interiors;
  std::vector<DiffusionTask> tasks;
  std::vector<std::size_t> section_of_task;
  for (const CrossSection& section : sections) interiors.push_back(interior_of(section));
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (interiors[i].vertex.empty()) continue;
    tasks.push_back({surfaces[i], interiors[i].position});
    section_of_task.push_back(i);
  }

  // Diffuse at them, and put the colours back.
  const std::vector<DiffusedColors> diffused = diffuser.diffuse_all(tasks);
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    CrossSection& section = sections[section_of_task[t]];
    const std::vector<std::size_t>& vertex = interiors[section_of_task[t]].vertex;
    for (std::size_t i = 0; i < vertex.size(); ++i) {
      section.color[vertex[i]] = diffused[t].color[i];
      section.part[vertex[i]] = diffused[t].part[i];
    }
  }
  return sections;
}

}  // namespace pomona
