// The mass of pieces from the parts inside them.
#include "generator/piece/weigh.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/base/units.h"
#include "generator/knife/parse_knife.h"
#include "generator/mesh/enclosures.h"
#include "generator/piece/piece_facts.h"
#include "generator/piece/region_rays.h"
#include "generator/piece/slice.h"
#include "generator/surface/part_regions.h"
#include "generator/template/read/read_template.h"
#include "tests/shapes/shapes.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

/// Flesh with a denser core.
Template cored_fruit(double core) {
  Template fruit;
  fruit.name = "cored";
  fruit.parts = {"skin", "flesh", "core"};
  fruit.density = 1000;
  fruit.densities = {1000, 1000, core};
  return fruit;
}

DiffusionSurfaces cored_ball(double outer, double inner) {
  shapes::Paint core;
  core.name = "core";
  core.front_part = "flesh";
  core.back_part = "core";
  return shapes::nested_spheres(outer, inner, 24, shapes::skin_paint(), core);
}

TEST(PartRegions, AreWhatClosedSurfacesEncloseTheSmallestFirst) {
  const DiffusionSurfaces ball = cored_ball(0.04, 0.02);
  const PartRegions regions = part_regions(ball);
  ASSERT_EQ(regions.region.size(), 2u);
  EXPECT_EQ(regions.part_names[static_cast<std::size_t>(regions.region[0].part)], "core");
  EXPECT_EQ(regions.part_names[static_cast<std::size_t>(regions.region[1].part)], "flesh");
  EXPECT_NEAR(regions.region[0].volume, 4. / 3 * pi * 8e-6, 0.01 * regions.region[0].volume);
}

TEST(PartRegions, DoNotDependOnWhichSideIsTheFront) {
  const PartRegions one = part_regions(cored_ball(0.04, 0.02)),
                    other = part_regions(shapes::turned_inside_out(cored_ball(0.04, 0.02)));
  ASSERT_EQ(one.region.size(), other.region.size());
  for (std::size_t r = 0; r < one.region.size(); ++r) {
    EXPECT_EQ(one.part_names[static_cast<std::size_t>(one.region[r].part)],
              other.part_names[static_cast<std::size_t>(other.region[r].part)]);
    EXPECT_NEAR(one.region[r].volume, other.region[r].volume, 1e-15);
  }
}

TEST(PartRegions, OfOpenSheetsAndOfHollowsAreNone) {
  EXPECT_TRUE(part_regions(shapes::open_sheet(0.1, 0)).region.empty());
  EXPECT_EQ(part_regions(shapes::hollow_ball(0.04, 0.02, 8)).region.size(), 1u) << "the skin's, not the hollow's";
}

/// Mass, centre and inertia of two nested balls of known density, to the tolerance of the rays.
TEST(Weighed, IsABallWithADenserCore) {
  const DiffusionSurfaces ball = cored_ball(0.04, 0.02);
  const std::vector<Solid> pieces = shapes::sliced(ball, {}, cored_fruit(1500)).pieces;
  ASSERT_EQ(pieces.size(), 1u);
  const PieceFacts facts = facts_of(pieces[0]);
  const double core = part_regions(ball).region[0].volume;
  const double mass = 1000 * facts.volume + 500 * core;
  EXPECT_NEAR(facts.mass, mass, 1e-3 * mass);
  EXPECT_LT(glm::length(facts.center), 1e-3 * 0.04);
  const double inertia = 0.4 * (1000 * facts.volume * 0.04 * 0.04 + 500 * core * 0.02 * 0.02);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(facts.inertia[i][i], inertia, 0.01 * inertia) << "of balls with facets";
  EXPECT_NEAR(facts.density, facts.mass / facts.volume, 1e-9);
}

TEST(Weighed, IsExactWherePartsAreAsDenseAsTheFruit) {
  const DiffusionSurfaces ball = cored_ball(0.04, 0.02);
  const std::vector<Knife> knives{parse_knife("wedges:3")};
  const std::vector<Solid> plain = shapes::sliced(ball, knives, {}).pieces;
  const std::vector<Solid> same = shapes::sliced(ball, knives, cored_fruit(1000)).pieces;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_FALSE(plain[i].weighed);
    ASSERT_TRUE(same[i].weighed);
    EXPECT_NEAR(facts_of(same[i]).mass, facts_of(plain[i]).mass, 1e-9 * facts_of(plain[i]).mass);
    EXPECT_LT(glm::distance(facts_of(same[i]).center, facts_of(plain[i]).center), 1e-9);
  }
}

/// If no place has a density that the template gives, the template is wrong. Parts of placed fruit ("berry.skin") have
/// the densities of their own template, which is looked at by itself.
TEST(Weighed, PartsThatShippedTemplatesGiveADensityFillSomething) {
  for (const auto& entry : std::filesystem::directory_iterator(std::string(POMONA_SOURCE_DIR) + "/templates")) {
    if (entry.path().extension() != ".toml") continue;
    const Template fruit = read_template(entry.path());
    const GrownFruit grown = grow(fruit, {0, 0}, {.as_drawn = true, .detail = 0.25});
    std::set<std::string> filled;
    const PartRegions regions = part_regions(joined(grown.swept, grown.grains));
    for (const PartRegions::Region& region : regions.region)
      filled.insert(regions.part_names[static_cast<std::size_t>(region.part)]);
    EXPECT_FALSE(fruit.densities.empty()) << fruit.name;
    for (std::size_t p = 0; p < fruit.densities.size(); ++p)
      EXPECT_TRUE(fruit.densities[p] == fruit.density || filled.contains(fruit.parts[p]) ||
                  fruit.parts[p].find('.') != std::string::npos)
          << fruit.name << ": " << fruit.parts[p];
  }
}

/// One of the program's templates, cut, and the weights of its parts, summed point by point.
struct CutOf {
  const char* fruit;
  const char* knife;
};

std::ostream& operator<<(std::ostream& out, const CutOf& cut) { return out << cut.fruit << " " << cut.knife; }

class WeighedFruit : public ::testing::TestWithParam<CutOf> {
 protected:
  WeighedFruit()
      : fruit_(read_template(std::string(POMONA_SOURCE_DIR) + "/templates/" + GetParam().fruit + ".toml")),
        grown_(grow(fruit_, {0, 0}, {.as_drawn = true, .detail = 0.5})) {
    // Differences of density are five times the natural ones, so that errors of a part show in the mass of the fruit.
    for (double& density : fruit_.densities) density = std::max(50.0, fruit_.density + 5 * (density - fruit_.density));
  }

  std::vector<Solid> pieces(const std::vector<Knife>& knives) const {
    return slice({grown_, fruit_, knives, "fruit"}, nullptr, {}).pieces;
  }

  Template fruit_;
  GrownFruit grown_;
};

/// Sums over a grid of points; for each, the piece and the regions around it are found.
std::vector<Moments> summed_points(const std::vector<Solid>& pieces, const PartRegions& regions, const Template& fruit,
                                   int along) {
  std::vector<Enclosures::Triangle> triangles;
  const auto add = [&](const auto& position, const glm::uvec3& t, std::size_t mesh) {
    triangles.push_back({{glm::dvec3(position[t.x]), glm::dvec3(position[t.y]), glm::dvec3(position[t.z])},
                         static_cast<std::uint32_t>(mesh)});
  };
  for (std::size_t r = 0; r < regions.region.size(); ++r) {
    const PartRegions::Region& region = regions.region[r];
    for (std::size_t t = region.first; t < region.first + region.count; ++t)
      add(regions.position, regions.triangle[t], r);
  }
  Box<double> box;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const glm::uvec3& t : pieces[i].mesh.triangle) add(pieces[i].mesh.position, t, regions.region.size() + i);
    for (const glm::vec3& p : pieces[i].mesh.position) box.add(glm::dvec3(p));
  }
  const Enclosures enclosures(std::move(triangles));
  const glm::dvec3 size = box.size();
  const double step = std::cbrt(size.x * size.y * size.z / along / along / along);

  std::vector<Moments> sums(pieces.size());
  const RandomStream draw({3, 0}, "points");
  std::uint64_t n = 0;
  for (double x = box.low.x; x < box.high.x; x += step) {
    for (double y = box.low.y; y < box.high.y; y += step) {
      for (double z = box.low.z; z < box.high.z; z += step, n += 3) {
        // Each point lies at random in its cell, so that no layer of the fruit coincides with a layer of the grid.
        const glm::dvec3 p =
            glm::dvec3(x, y, z) + step * glm::dvec3(draw.uniform(n), draw.uniform(n + 1), draw.uniform(n + 2));
        double density = fruit.density;
        bool first = true;
        for (const auto& [mesh, times] : enclosures.around(p)) {
          if (mesh < regions.region.size()) {
            if (!first) continue;  // the smallest region comes first
            first = false;
            const std::string& part = regions.part_names[static_cast<std::size_t>(regions.region[mesh].part)];
            const auto at = std::find(fruit.parts.begin(), fruit.parts.end(), part) - fruit.parts.begin();
            density = fruit.densities[static_cast<std::size_t>(at)];
          } else {
            const double mass = times * density * step * step * step;
            sums[mesh - regions.region.size()].add({mass, mass * p, mass * glm::outerProduct(p, p)});
          }
        }
      }
    }
  }
  return sums;
}

double box_volume(const std::vector<Solid>& pieces) {
  Box<double> box;
  for (const Solid& piece : pieces) {
    for (const glm::vec3& p : piece.mesh.position) box.add(glm::dvec3(p));
  }
  return box.size().x * box.size().y * box.size().z;
}

TEST_P(WeighedFruit, AgreesWithSumsOverAFineGridOfPoints) {
  const std::vector<Solid> all = pieces({parse_knife(GetParam().knife)});
  const PartRegions regions = part_regions(joined(grown_.swept, grown_.grains));
  std::set<std::int32_t> parts;
  for (const PartRegions::Region& region : regions.region) parts.insert(region.part);
  EXPECT_GE(parts.size(), 2u);

  // The tolerance includes the noise of the 80^3 points in the box, which comes from cells through which surfaces pass.
  const std::vector<Moments> points = summed_points(all, regions, fruit_, 80);
  double whole = 0;
  for (const Solid& piece : all) whole += facts_of(piece).mass;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const PieceFacts facts = facts_of(all[i]);
    if (facts.mass < 0.02 * whole) continue;
    const RigidMass expected = rigid_mass(points[i], glm::dvec3(0));
    const double size = glm::length(facts.high - facts.low);
    const double count = facts.volume * 80 * 80 * 80 / box_volume(all);
    EXPECT_NEAR(facts.mass, expected.mass, 5 / std::cbrt(count * count) * expected.mass) << i;
    EXPECT_LT(glm::distance(facts.center, expected.center), 0.002 * size) << i;
    for (int k = 0; k < 3; ++k)
      EXPECT_LT(glm::distance(facts.inertia[k], expected.inertia[k]), 0.001 * expected.mass * size * size) << i;
  }
}

TEST_P(WeighedFruit, PiecesAddUpToTheFruit) {
  const std::vector<Solid> whole = pieces({}), cut = pieces({parse_knife(GetParam().knife)});
  Moments parts, all;
  const auto moments = [](const Solid& piece) {
    const PieceFacts f = facts_of(piece);
    return Moments{f.mass, f.mass * f.center, glm::dmat3(0)};
  };
  for (const Solid& piece : cut) parts.add(moments(piece));
  for (const Solid& piece : whole) all.add(moments(piece));
  EXPECT_NEAR(parts.mass, all.mass, 1e-6 * all.mass);
  EXPECT_LT(glm::distance(parts.first, all.first), 1e-6 * all.mass * glm::length(bounds_of(grown_.swept).size()));
}

/// Eighty times as many rays give the same.
TEST_P(WeighedFruit, RaysAreManyEnough) {
  const std::vector<Solid> all = pieces({parse_knife(GetParam().knife)});
  const PartRegions regions = part_regions(joined(grown_.swept, grown_.grains));
  std::vector<double> excess;
  for (const PartRegions::Region& region : regions.region) {
    const std::string& part = regions.part_names[static_cast<std::size_t>(region.part)];
    excess.push_back(fruit_.densities[static_cast<std::size_t>(
                         std::find(fruit_.parts.begin(), fruit_.parts.end(), part) - fruit_.parts.begin())] -
                     fruit_.density);
  }
  const std::vector<Moments> usual = excess_moments(all, regions, excess, glm::dvec3(0)),
                             fine = excess_moments(all, regions, excess, glm::dvec3(0), {.rays = 320000});
  double whole = 0;
  for (const Solid& piece : all) whole += facts_of(piece).mass;
  double worst = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double mass = facts_of(all[i]).mass;
    if (mass < 0.02 * whole) continue;
    worst = std::max(worst, std::fabs(usual[i].mass - fine[i].mass) / mass);
  }
  EXPECT_LT(worst, 5e-3) << "five times a thousandth of the mass";
}

INSTANTIATE_TEST_SUITE_P(Shipped, WeighedFruit,
                         ::testing::Values(CutOf{"cherry", "half"}, CutOf{"tomato", "wedges:5"},
                                           CutOf{"lemon", "slices:9mm"}, CutOf{"avocado", "ball:40mm"},
                                           CutOf{"kiwi", "sticks:2"}),
                         [](const auto& test) { return std::string(test.param.fruit); });

}  // namespace
}  // namespace pomona
