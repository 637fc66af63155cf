// Texels are diffused by the diffuser of the cut face; all diffusers give nearly the same colours.
#include <gtest/gtest.h>
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "generator/diffusion/harmonic/harmonic_diffuser.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "render/diffusion/gl_diffuser.h"
#include "render/style/style_file.h"
#include "render/texture/bake.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

BakedSolid half_baked_by(const Diffuser& diffuser) {
  const DiffusionSurfaces surfaces = shapes::seeded_fruit();
  Template fruit;
  fruit.parts = surfaces.part_names;
  const std::vector<Knife> knives{parse_knife("half")};
  const Slices slices = shapes::sliced(surfaces, knives, fruit, &diffuser, {.keep_section_colors = true});
  return baked(slices.pieces.front(), style_named("plain"), {.texels = 96});
}

struct Difference {
  double rms = 0, largest = 0;  ///< of 255
};

Difference difference_between(const Image& a, const Image& b) {
  Difference found;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const glm::dvec3 d = glm::abs(glm::dvec3(a.pixels[i]) - glm::dvec3(b.pixels[i]));
    found.rms += glm::dot(d, d) / 3;
    found.largest = std::max({found.largest, d.r, d.g, d.b});
  }
  found.rms = std::sqrt(found.rms / static_cast<double>(a.pixels.size()));
  return found;
}

const BakedSolid& by_processor() {
  static const BakedSolid solid = half_baked_by(*make_pmvc_diffuser({.quality = Quality::final, .threads = {}}));
  return solid;
}

TEST(BakedByOpenGl, IsWhatTheProcessorBakes) {
  const BakedSolid other = half_baked_by(*make_gl_diffuser({.quality = Quality::final}));
  EXPECT_NEAR(static_cast<double>(other.diffused), static_cast<double>(by_processor().diffused), 50)
      << "a unit more or less decides whether a triangle is parted";
  EXPECT_GT(other.diffused, 300u);
  const Difference found = difference_between(other.texture, by_processor().texture);
  EXPECT_LE(found.rms, 0.5);
  EXPECT_LE(found.largest, 2);
}

TEST(BakedHarmonically, DiffersAsItsEquationDoes) {
  const BakedSolid other = half_baked_by(*make_harmonic_diffuser({.quality = Quality::final}));
  EXPECT_GT(other.diffused, 300u);
  const Difference found = difference_between(other.texture, by_processor().texture);
  EXPECT_LE(found.rms, 6);
  EXPECT_GT(found.rms, 0) << "it was not asked";
}

}  // namespace
}  // namespace pomona
