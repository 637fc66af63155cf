// Light within a part, from its template's values or from its name.
#include "render/style/tissue_light.h"

#include <gtest/gtest.h>

namespace pomona {
namespace {

TEST(TissueLight, GoesByThePartsNameWhereNothingIsSaid) {
  EXPECT_EQ(usual_tissue("gel"), Tissue::gel);
  EXPECT_EQ(usual_tissue("calyx"), Tissue::leaf);
  EXPECT_EQ(usual_tissue("flavedo"), Tissue::skin);
  EXPECT_EQ(usual_tissue("glaze"), Tissue::mineral) << "of a bowl";
  EXPECT_EQ(usual_tissue("layer"), Tissue::flesh);
  const TissueLight flesh = tissue_light({}, "flesh"), seed = tissue_light({}, "seed");
  EXPECT_GT(flesh.weight, seed.weight);
  EXPECT_GT(flesh.radius[0], flesh.radius[2]) << "of an apple, red goes farther than blue";
  EXPECT_NEAR(flesh.radius[0], 0.00696, 1e-9);
  EXPECT_EQ(tissue_light({}, "lava"), TissueLight{});
}

TEST(TissueLight, TranslucencyIsSaidOfLightAlready) {
  MaterialSketch material;
  material.translucency = {.depth = 0.003, .color = {1, 0.5f, 0}};
  const TissueLight light = tissue_light(material, "pulp");
  EXPECT_EQ(light.weight, 1);
  EXPECT_NEAR(light.radius[0], 0.003, 1e-9);
  EXPECT_NEAR(light.radius[1], 0.0015, 1e-9);
  EXPECT_EQ(light.radius[2], 0);
}

TEST(TissueLight, WhatIsSaidGoesBeforeAllElse) {
  MaterialSketch material;
  material.translucency.depth = 0.003;
  material.subsurface = Subsurface{.radius = 0.001, .tint = Color(1), .weight = 0.4};
  EXPECT_NEAR(tissue_light(material, "lava").radius[2], 0.001, 1e-9);
  EXPECT_EQ(tissue_light(material, "lava").weight, 0.4);
  material.subsurface->radius = 0;
  EXPECT_EQ(tissue_light(material, "flesh"), TissueLight{}) << "light does not go in";
  material = {};
  material.tissue = Tissue::seed;
  EXPECT_EQ(tissue_light(material, "flesh"), tissue_light({}, "seed"));
}

}  // namespace
}  // namespace pomona
