// [material.PART]: good.toml with more at its end.
#include "generator/template/read/read_material.h"

#include <gtest/gtest.h>

#include "tests/template/plum.h"

namespace pomona {
namespace {

TEST(ReadMaterial, says_nothing_where_nothing_is_said) { EXPECT_TRUE(plum_and("").materials.empty()); }

TEST(ReadMaterial, reads_all_there_is) {
  const std::vector<MaterialSketch> materials = plum_and(R"(
[material.skin]
gloss = 1.5
roughness = 0.2
bloom = { cover = 0.6, color = "#0000ff", rubbed = 0.3, patch_size = "6mm" }
fuzz = { length = "1.2mm", density = 3, color = "#ff0000", lie = 0.7 }
[material.flesh]
wet = 2
translucency = { depth = "4mm", color = "#00ff00" }
)")
                                                    .materials;
  ASSERT_EQ(materials.size(), 3u);
  const MaterialSketch &skin = materials[0], &flesh = materials[1], &stone = materials[2];
  EXPECT_EQ(skin.gloss, 1.5);
  EXPECT_EQ(skin.roughness, 0.2);
  EXPECT_EQ(skin.bloom.cover, 0.6);
  EXPECT_EQ(skin.bloom.color, Color(0, 0, 1));
  EXPECT_EQ(skin.bloom.rubbed, 0.3);
  EXPECT_NEAR(skin.bloom.patch_size, 0.006, 1e-12);
  EXPECT_NEAR(skin.fuzz.length, 0.0012, 1e-12);
  EXPECT_EQ(skin.fuzz.density, 3);
  EXPECT_EQ(skin.fuzz.color, Color(1, 0, 0));
  EXPECT_EQ(skin.fuzz.lie, 0.7);
  EXPECT_EQ(flesh.wet, 2);
  EXPECT_NEAR(flesh.translucency.depth, 0.004, 1e-12);
  EXPECT_EQ(flesh.translucency.color, Color(0, 1, 0));
  EXPECT_EQ(stone.gloss, MaterialSketch{}.gloss);
  EXPECT_EQ(stone.fuzz.length, 0);
  EXPECT_EQ(stone.translucency.depth, 0);
}

TEST(ReadMaterial, reads_what_light_does_inside) {
  const std::vector<MaterialSketch> materials = plum_and(R"(
[material.skin]
coat = 0.4
[material.flesh]
tissue = "gel"
transmission = 0.25
subsurface = { radius = "3mm", tint = "#ff8000", weight = 0.7 }
)")
                                                    .materials;
  ASSERT_EQ(materials.size(), 3u);
  EXPECT_EQ(materials[0].coat, 0.4);
  EXPECT_FALSE(materials[0].tissue || materials[0].subsurface || materials[0].transmission);
  EXPECT_EQ(materials[1].tissue, Tissue::gel);
  EXPECT_EQ(materials[1].transmission, 0.25);
  ASSERT_TRUE(materials[1].subsurface);
  EXPECT_NEAR(materials[1].subsurface->radius, 0.003, 1e-12);
  EXPECT_EQ(materials[1].subsurface->tint.b, 0);
  EXPECT_EQ(materials[1].subsurface->weight, 0.7);
}

const Mistake mistakes[] = {
    {"[material.skin]\ntissue = \"bone\"\n", 2, 10, "bone"},
    {"[material.skin]\nsubsurface = { tint = \"#ffffff\" }\n", 2, 14, "lacks \"radius\""},
    {"[material.skin]\nsubsurface = { radius = \"1m\" }\n", 2, 25, "radius is 1m"},
    {"[material.skin]\ntransmission = 2\n", 2, 16, "transmission is 2"},
    {"[material.skin]\ncoat = -1\n", 2, 8, "coat is -1"},
    {"[material]\ngloss = 1\n", 2, 1, "unknown key \"gloss\""},
    {"[material]\nskin = 1\n", 2, 8, "must be a table"},
    {"[material.skim]\ngloss = 1\n", 1, 11, "unknown key \"skim\""},
    {"[material.skin]\nglos = 1\n", 2, 1, "unknown key \"glos\""},
    {"[material.skin]\ngloss = 5\n", 2, 9, "gloss is 5"},
    {"[material.skin]\nroughness = 0\n", 2, 13, "roughness is 0"},
    {"[material.skin]\nwet = \"much\"\n", 2, 7, "wet must be a number"},
    {"[material.skin]\nbloom = 0.5\n", 2, 9, "bloom must be a table"},
    {"[material.skin]\nbloom = { rubbed = 0.5 }\n", 2, 9, "lacks \"cover\""},
    {"[material.skin]\nbloom = { cover = 2 }\n", 2, 19, "cover is 2"},
    {"[material.skin]\nbloom = { cover = 1, patch_size = \"0mm\" }\n", 2, 35, "patch_size is 0mm"},
    {"[material.skin]\nfuzz = { density = 1 }\n", 2, 8, "lacks \"length\""},
    {"[material.skin]\nfuzz = { length = 1 }\n", 2, 19, "must be a length"},
    {"[material.skin]\nfuzz = { length = \"1mm\", density = 1e9 }\n", 2, 36, "density is 1e"},
    {"[material.flesh]\ntranslucency = { color = \"#ffffff\" }\n", 2, 16, "lacks \"depth\""},
    {"[material.flesh]\ntranslucency = { depth = \"-1mm\" }\n", 2, 26, "depth is -1mm"},
    {"[material.flesh]\ntranslucency = { depth = \"1mm\", color = \"red\" }\n", 2, 41, "is not a colour"},
};

TEST(ReadMaterial, mistakes_are_found_where_they_are) { expect_found(mistakes); }

}  // namespace
}  // namespace pomona
