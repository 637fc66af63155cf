// Textures of real fruit against every texel diffused by itself.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <string>

#include "generator/compose/grow.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/slice.h"
#include "generator/template/read/read_template.h"
#include "render/style/style_file.h"
#include "render/texture/bake.h"

namespace pomona {
namespace {

struct Cut {
  const char* fruit = "";
  const char* knife = "";
};

void PrintTo(const Cut& cut, std::ostream* out) { *out << cut.fruit << ", " << cut.knife; }

class BakedFruit : public ::testing::TestWithParam<Cut> {
 protected:
  BakedFruit() {
    const Template fruit = read_template(std::string(POMONA_SOURCE_DIR "/templates/") + GetParam().fruit + ".toml");
    GrowOptions how;
    how.as_drawn = true;
    const GrownFruit grown = grow(fruit, {}, how);
    const std::vector<Knife> knives{parse_knife(GetParam().knife)};
    pieces_ = slice({grown, fruit, knives, "fruit", {}}, diffuser_.get(), {.keep_section_colors = true}).pieces;
    pieces_.resize(2);
  }

  std::vector<BakedSolid> baked(bool every_texel, int threads) const {
    return all_baked(pieces_, style_named("plain"), {.texels = 384, .every_texel = every_texel, .threads = {threads}});
  }

 private:
  std::unique_ptr<Diffuser> diffuser_ = make_pmvc_diffuser({.quality = Quality::final, .threads = {}});
  std::vector<Solid> pieces_;
};

TEST_P(BakedFruit, LooksAsIfEveryTexelHadBeenDiffusedByItselfOnAnyNumberOfThreads) {
  const std::vector<BakedSolid> found = baked(false, 1), truth = baked(true, 0);
  double squares = 0;
  std::size_t texels = 0, far_off = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].texture.pixels.size(), truth[i].texture.pixels.size());
    for (std::size_t p = 0; p < found[i].texture.pixels.size(); ++p) {
      const glm::ivec3 d = glm::abs(glm::ivec3(found[i].texture.pixels[p]) - glm::ivec3(truth[i].texture.pixels[p]));
      squares += d.x * d.x + d.y * d.y + d.z * d.z;
      far_off += std::max({d.x, d.y, d.z}) > 4 ? 1 : 0;
    }
    texels += found[i].texture.pixels.size();
  }
  EXPECT_LE(std::sqrt(squares / (3.0 * static_cast<double>(texels))), 0.5) << "of 255, RMS";
  EXPECT_LE(far_off, texels / 500) << "texels by more than 4 of 255";
  EXPECT_LT(found[0].diffused, truth[0].diffused + truth[1].diffused);

  const std::vector<BakedSolid> five = baked(false, 5);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_TRUE(found[i].texture.pixels == five[i].texture.pixels) << i;
    EXPECT_EQ(found[i].uv, five[i].uv);
  }
}

INSTANTIATE_TEST_SUITE_P(Templates, BakedFruit,
                         ::testing::Values(Cut{"tomato", "wedges:6"}, Cut{"kiwi", "across"}, Cut{"onion", "half"},
                                           Cut{"strawberry", "half"}, Cut{"avocado", "ball:30mm"},
                                           Cut{"pepper", "crinkle:13mm"}));

}  // namespace
}  // namespace pomona
