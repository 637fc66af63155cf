#include "render/gl/lattice_texels.h"

#include <cmath>
#include <cstddef>
#include <map>

#include "generator/cut/section/guide_lattice.h"

namespace pomona {

namespace {

constexpr std::size_t texels_of_solid = 3;

/// Shaders test for values above a kilometre, as comparisons with what is no number may be left out by their compilers.
constexpr float unknown = 1e9f;

/// Tables and blocks begin at whole rows of texels, whose numbers single precision can tell apart.
constexpr std::size_t row = 64;

void fill_row(std::vector<glm::vec4>& texels) { texels.resize((texels.size() + row - 1) / row * row, glm::vec4(-1)); }

/// Adds a lattice; returns the row where its table begins.
float added(const GuideLattice& lattice, std::vector<glm::vec4>& texels) {
  fill_row(texels);
  const std::size_t table = texels.size() / row, nodes = table + (lattice.blocks().size() + row - 1) / row;
  for (const std::uint32_t start : lattice.blocks())
    texels.emplace_back(start == 0 ? -1.0f : static_cast<float>(nodes + start / row), 0, 0, 0);
  fill_row(texels);
  for (const glm::vec4& value : lattice.values()) texels.push_back(std::isnan(value.w) ? glm::vec4(unknown) : value);
  return static_cast<float>(table);
}

}  // namespace

std::vector<glm::vec4> lattice_texels(const std::vector<Solid>& solids) {
  std::vector<glm::vec4> texels(texels_of_solid * solids.size(), glm::vec4(-1));
  std::map<const GuideLattice*, float> known;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const GuideLattice* const lattice = solids[i].mesh.guide_lattice.get();
    if (lattice == nullptr) continue;
    const auto [table, is_new] = known.try_emplace(lattice, 0.0f);
    if (is_new) table->second = added(*lattice, texels);
    const LatticeFrame& frame = lattice->frame();
    texels[texels_of_solid * i] = {frame.spacing, table->second, 0, 0};
    texels[texels_of_solid * i + 1] = glm::vec4(glm::vec3(frame.low), 0);
    texels[texels_of_solid * i + 2] = glm::vec4(glm::vec3(frame.count), 0);
  }
  return texels;
}

}  // namespace pomona
