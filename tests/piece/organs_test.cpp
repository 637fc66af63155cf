// What pieces have of each berry and each kernel: by the exact meshes of whole ones, and in sum.
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "generator/knife/parse_knife.h"
#include "generator/mesh/signed_volume.h"
#include "generator/piece/facts_json.h"
#include "generator/piece/organs.h"
#include "generator/piece/piece_facts.h"
#include "generator/piece/slice.h"
#include "generator/template/read/read_template.h"

namespace pomona {
namespace {

struct Fruit {
  Template drawn;
  GrownFruit grown;

  std::vector<Solid> cut(const std::string& knife) const {
    std::vector<Knife> knives;
    if (!knife.empty()) knives.push_back(parse_knife(knife));
    return slice({grown, drawn, knives, drawn.name}, nullptr, {.organs = true}).pieces;
  }
};

Fruit fruit(const std::string& file, double detail = 1) {
  Fruit made{read_template(std::string(POMONA_SOURCE_DIR) + "/" + file + ".toml"), {}};
  made.grown = grow(made.drawn, {0, 0}, {.as_drawn = true, .detail = detail});
  return made;
}

/// Of the triangles of one instance that face air, all together.
double mesh_volume(const DiffusionSurfaces& surfaces, std::int32_t instance) {
  double six = 0;
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (surfaces.instance_of(t) != instance || !surfaces.is_boundary(t)) continue;
    const glm::uvec3& v = surfaces.triangle[t];
    const bool turned = surfaces.is_hidden(t, SideOf::back);
    const auto at = [&](std::uint32_t k) { return glm::dvec3(surfaces.position[k]); };
    six += six_volumes(at(v.x), at(turned ? v.z : v.y), at(turned ? v.y : v.z));
  }
  return six / 6;
}

std::map<std::int32_t, Organ> summed(const std::vector<Solid>& pieces) {
  std::map<std::int32_t, Organ> sums;
  for (const Solid& piece : pieces) {
    for (const Organ& organ : piece.organs) {
      Organ& sum = sums[organ.instance];
      sum.name = organ.name;
      sum.volume += organ.volume;
      sum.mass += organ.mass;
    }
  }
  return sums;
}

void expect_sums(const Solid& piece) {
  double volume = 0, mass = 0;
  std::int32_t last = -1;
  for (const Organ& organ : piece.organs) {
    EXPECT_GT(organ.instance, last) << "ascending";
    last = organ.instance;
    EXPECT_GE(organ.volume, 0);
    EXPECT_GE(organ.mass, 0);
    volume += organ.volume;
    mass += organ.mass;
  }
  EXPECT_NEAR(volume, piece.volume, 1e-9 * piece.volume);
  EXPECT_NEAR(mass, facts_of(piece).mass, 1e-9 * mass);
}

TEST(Organs, OfAFruitWithoutPlacesAreNone) {
  const Fruit berry = fruit("tests/compose/placed/berry");
  for (const Solid& piece : berry.cut("half")) {
    EXPECT_TRUE(piece.organs.empty());
    EXPECT_TRUE(piece.mesh.instance.empty());
    EXPECT_FALSE(facts_with_organs_json(piece).contains("organs"));
  }
}

TEST(Organs, AWholeBerryHasTheVolumeOfItsMesh) {
  const Fruit bunch = fruit("tests/compose/placed/bunch");
  const std::map<std::int32_t, Organ> whole = summed(bunch.cut(""));
  ASSERT_GT(whole.size(), 8u);
  for (const auto& [instance, organ] : whole) {
    if (instance == 0) continue;
    const double exact = mesh_volume(bunch.grown.sheets, instance);
    EXPECT_NEAR(organ.volume, exact, 0.01 * exact) << instance << ": less its root";
  }
}

TEST(Organs, HalvesOfABerryAddUpToIt) {
  const Fruit bunch = fruit("tests/compose/placed/bunch");
  const std::vector<Solid> halves = bunch.cut("half");
  const std::map<std::int32_t, Organ> whole = summed(bunch.cut("")), both = summed(halves);
  ASSERT_EQ(whole.size(), both.size());
  std::set<std::int32_t> cut;
  for (const Solid& piece : halves) {
    for (std::size_t t = 0; t < piece.mesh.triangle.size(); ++t)
      if (piece.mesh.cut_face[t] >= 0) cut.insert(piece.mesh.instance[t]);
  }
  EXPECT_GT(cut.size(), 1u);
  for (const auto& [instance, organ] : whole) {
    if (instance == 0) continue;
    EXPECT_NEAR(both.at(instance).volume, organ.volume, (cut.contains(instance) ? 2e-3 : 1e-7) * organ.volume)
        << instance;
  }
}

/// Shipped templates whose organs are placed, or grains at the seats of a law.
struct Kind {
  const char* fruit;
  const char* organ;
  std::size_t least;  ///< so many at least
};

class OrgansOf : public ::testing::TestWithParam<Kind> {};

TEST_P(OrgansOf, AddUpToTheirPieces) {
  const Fruit made = fruit(std::string("templates/") + GetParam().fruit, 0.5);
  for (const char* knife : {"", "half"}) {
    const std::vector<Solid> pieces = made.cut(knife);
    std::set<std::int32_t> seen;
    for (const Solid& piece : pieces) {
      expect_sums(piece);
      ASSERT_EQ(piece.mesh.instance.size(), piece.mesh.triangle.size());
      for (const Organ& organ : piece.organs) {
        EXPECT_EQ(organ.name, organ.instance == 0 ? GetParam().fruit : GetParam().organ);
        if (organ.instance > 0) seen.insert(organ.instance);
      }
      for (const std::int32_t instance : piece.mesh.instance)
        EXPECT_TRUE(std::any_of(piece.organs.begin(), piece.organs.end(),
                                [&](const Organ& organ) { return organ.instance == instance; }));
    }
    EXPECT_GE(seen.size(), GetParam().least) << knife;
  }
}

TEST_P(OrgansOf, LoseNothingToTheKnife) {
  const Fruit made = fruit(std::string("templates/") + GetParam().fruit, 0.5);
  const std::map<std::int32_t, Organ> whole = summed(made.cut("")), cut = summed(made.cut("half"));
  double apart = 0, all = 0;
  for (const auto& [instance, organ] : whole) {
    all += organ.volume;
    const auto same = cut.find(instance);
    apart += std::fabs((same == cut.end() ? 0 : same->second.volume) - organ.volume);
  }
  EXPECT_LT(apart, 0.004 * all);
}

INSTANTIATE_TEST_SUITE_P(Shipped, OrgansOf,
                         ::testing::Values(Kind{"grapes", "berry", 60}, Kind{"maize", "kernels", 300},
                                           Kind{"raspberry", "drupelets", 30}, Kind{"blackberry", "drupelet", 20}),
                         [](const auto& test) { return std::string(test.param.fruit); });

TEST(Organs, AreInTheFactsOfAPiece) {
  Solid solid;
  solid.organs = {{0, "bunch", 1e-6, 1e-3}, {17, "berry", 4e-6, 4e-3}};
  EXPECT_EQ(facts_with_organs_json(solid)["organs"].dump(),
            R"([{"instance":0,"name":"bunch","volume":1e-06,"mass":0.001},)"
            R"({"instance":17,"name":"berry","volume":4e-06,"mass":0.004}])");
}

}  // namespace
}  // namespace pomona
