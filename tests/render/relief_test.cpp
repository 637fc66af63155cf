// Relief: heights, normal maps, and seams that must not show.
#include "render/style/relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/style/face_relief.h"
#include "render/style/skin_pits.h"
#include "render/style/style_file.h"
#include "render/texture/bake.h"
#include "tests/render/half_ball.h"

namespace pomona {
namespace {

constexpr double relief_height = 5e-4;  // metres

/// A plate of flesh at y = 0, 20 mm wide, seen from above; in its middle a square seed, 8 mm wide.
Solid plate_with_seed(double relief) {
  Solid plate;
  plate.own_look().part_names = {"flesh", "seed"};
  plate.own_look().materials.resize(2);
  plate.own_look().materials[1].relief = relief;
  constexpr int squares = 40;
  constexpr float step = 0.02f / squares;
  std::map<std::tuple<int, int, int>, std::uint32_t> known;
  const auto vertex = [&](int x, int z, int part) {
    const auto [entry, is_new] =
        known.try_emplace({x, z, part}, static_cast<std::uint32_t>(plate.mesh.position.size()));
    if (is_new) {
      plate.mesh.position.emplace_back(step * static_cast<float>(x) - 0.01f, 0.0f,
                                       step * static_cast<float>(z) - 0.01f);
      plate.mesh.normal.emplace_back(0, 1, 0);
      plate.mesh.color.emplace_back(0.5f);
      plate.mesh.part.push_back(part);
    }
    return entry->second;
  };
  for (int x = 0; x < squares; ++x) {
    for (int z = 0; z < squares; ++z) {
      const bool in_seed = x >= 12 && x < 28 && z >= 12 && z < 28;
      const int part = in_seed ? 1 : 0;
      const std::uint32_t a = vertex(x, z, part), b = vertex(x, z + 1, part), c = vertex(x + 1, z + 1, part),
                          d = vertex(x + 1, z, part);
      for (const glm::uvec3& t : {glm::uvec3(a, b, c), glm::uvec3(a, c, d)}) {
        plate.mesh.triangle.push_back(t);
        plate.mesh.cut_face.push_back(0);
        plate.mesh.surface.push_back(-1);
      }
    }
  }
  return plate;
}

/// The triangle of the plate that contains a place.
std::uint32_t triangle_at(const Solid& plate, const glm::dvec3& place) {
  for (std::uint32_t t = 0; t < plate.mesh.triangle.size(); ++t) {
    const glm::uvec3& v = plate.mesh.triangle[t];
    const glm::vec3 low =
        glm::min(plate.mesh.position[v.x], glm::min(plate.mesh.position[v.y], plate.mesh.position[v.z]));
    const glm::vec3 high =
        glm::max(plate.mesh.position[v.x], glm::max(plate.mesh.position[v.y], plate.mesh.position[v.z]));
    const glm::vec3 p(place);
    if (p.x >= low.x && p.x <= high.x && p.z >= low.z && p.z <= high.z) return t;
  }
  ADD_FAILURE() << "no triangle there";
  return 0;
}

class PlateWithSeed : public testing::TestWithParam<double> {};

TEST_P(PlateWithSeed, StandsProudOrIsSunkAndItsSlopeIntegratesToItsHeight) {
  const Solid plate = plate_with_seed(GetParam());
  const FaceRelief relief(plate);
  const auto at = [&](double x) {
    const glm::dvec3 place(x, 0, 1.3e-4);
    return relief.at(triangle_at(plate, place), place);
  };
  EXPECT_EQ(at(-0.007).height, 0.0);
  EXPECT_EQ(at(-0.007).slope, glm::dvec3(0));
  EXPECT_DOUBLE_EQ(at(0).height, GetParam());
  EXPECT_NEAR(at(-0.0035).rim, 5e-4, 1e-9);
  constexpr double step = 1e-5;
  double height = 0, steepest = 0;
  for (double x = -0.004 + 0.5 * step; x < 0; x += step) {
    height += at(x).slope.x * step;
    steepest = std::max(steepest, std::fabs(at(x).slope.x));
    EXPECT_NEAR(at(x + 0.5 * step).height, height, 0.01 * relief_height) << x;
  }
  EXPECT_NEAR(height, GetParam(), 1e-3 * relief_height);
  EXPECT_LE(steepest, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Relief, PlateWithSeed, testing::Values(relief_height, -relief_height));

TEST(FaceReliefOf, NothingWhereNoPartHasAny) {
  EXPECT_TRUE(FaceRelief(plate_with_seed(0)).empty());
  for (const RimPlace& place : FaceRelief(plate_with_seed(0)).at_vertices()) EXPECT_EQ(place.slope, glm::dvec3(0));
}

TEST(FaceReliefOf, VerticesLeanOutwardsAtASeedsRim) {
  const Solid plate = plate_with_seed(relief_height);
  const std::vector<RimPlace> places = FaceRelief(plate).at_vertices();
  for (std::size_t v = 0; v < places.size(); ++v) {
    const glm::dvec3 p(plate.mesh.position[v]);
    if (plate.mesh.part[v] == 0) {
      EXPECT_EQ(places[v].slope, glm::dvec3(0));
    } else if (std::fabs(p.x + 0.004) < 1e-6 && std::fabs(p.z) < 0.003) {
      EXPECT_GT(places[v].slope.x, 0.8);  // rises inwards, so that the normal leans outwards
      EXPECT_NEAR(places[v].slope.z, 0.0, 1e-6);
    }
  }
}

/// A skin in the plane y = 0 with two grains on it, each a small triangle.
Solid skin_with_grains(double pit) {
  Solid skin;
  skin.own_look().part_names = {"skin", "achene"};
  skin.own_look().materials.resize(2);
  skin.own_look().materials[1].pit = pit;
  for (const float x : {0.0f, 0.01f}) {
    const auto first = static_cast<std::uint32_t>(skin.mesh.position.size());
    for (const glm::vec3& p : {glm::vec3(x - 0.001f, 0, -0.001f), {x + 0.001f, 0, -0.001f}, {x, 0, 0.001f}}) {
      skin.mesh.position.push_back(p);
      skin.mesh.normal.emplace_back(0, 1, 0);
      skin.mesh.color.emplace_back(0.5f);
      skin.mesh.part.push_back(1);
    }
    skin.mesh.triangle.emplace_back(first, first + 1, first + 2);
    skin.mesh.cut_face.push_back(-1);
    skin.mesh.surface.push_back(0);
  }
  return skin;
}

TEST(Pits, LieAroundEachGrainAndTheirSlopeIntegratesToTheirDepth) {
  const SkinPits pits(skin_with_grains(relief_height));
  EXPECT_EQ(pits.count(), 2u);
  EXPECT_NEAR(pits.at({0.01, 0, 0}, {0, 1, 0}).height, -relief_height, 1e-6);
  EXPECT_EQ(pits.at({0.005, 0, 0}, {0, 1, 0}).height, 0);
  EXPECT_EQ(pits.at({1, 2, 3}, {0, 1, 0}).inside, 0);
  constexpr double step = 1e-6;
  double height = 0;
  for (double x = -0.004 + 0.5 * step; x < 0; x += step) height += pits.at({x, 0, 0}, {0, 1, 0}).slope.x * step;
  EXPECT_NEAR(height, -relief_height, 1e-4 * relief_height);
  EXPECT_TRUE(SkinPits(skin_with_grains(0)).empty());
}

TEST(Pits, ShadersHaveAllOfThem) {
  const SkinPits pits(skin_with_grains(relief_height));
  const std::vector<glm::vec4> texels = pits.texels();
  ASSERT_GT(texels.size(), 2u);
  std::size_t listed = 0;
  const auto cells = static_cast<std::size_t>(texels[1].x * texels[1].y * texels[1].z);
  for (std::size_t c = 0; c < cells; ++c) {
    const glm::vec4& list = texels[2 + c];
    ASSERT_LE(static_cast<std::size_t>(list.x) + 2 * static_cast<std::size_t>(list.y), texels.size());
    listed += static_cast<std::size_t>(list.y);
  }
  EXPECT_GE(listed, 2u);
}

/// A wart, 6 mm wide and twice as long, with a wandering outline, on the upper side of the plane y = 0.
Spot wart(double relief) {
  Spot spot;
  spot.radius = 0.003;
  spot.stretch = 2;
  spot.softness = 0.6;
  spot.waves = {glm::dvec2(0.1, 0.05), {0, 0.06}, {-0.03, 0}, {0.02, 0.01}};
  spot.relief = relief;
  return spot;
}

Solid skin_with_spots(const std::vector<Spot>& spots) {
  Solid skin = skin_with_grains(0);
  skin.raised = spots;
  return skin;
}

class WartOrPock : public testing::TestWithParam<double> {};

TEST_P(WartOrPock, ItsSlopeIntegratesToItsHeight) {
  const SkinPits pits(skin_with_spots({wart(GetParam())}));
  const glm::dvec3 up(0, 1, 0), way = glm::normalize(glm::dvec3(2, 0, 1));
  constexpr double step = 1e-6;
  double height = 0;
  for (double x = -0.012 + 0.5 * step; x < 0.012; x += step) {
    const PitPlace here = pits.at(x * way, up);
    EXPECT_NEAR(here.height, height, 0.015 * relief_height) << x;
    EXPECT_NEAR(glm::dot(here.slope, up), 0, 1e-12);
    EXPECT_EQ(here.inside > 0, here.height < 0) << "only what is sunk is in the dark";
    height += glm::dot(here.slope, way) * step;
  }
  EXPECT_NEAR(height, 0, 0.015 * relief_height);
  EXPECT_DOUBLE_EQ(pits.at(glm::dvec3(0), up).height, GetParam());
  EXPECT_LT(std::fabs(pits.at({0, -0.001, 0}, -up).height), 1e-12) << "the other side of a thin wall is level";
}

INSTANTIATE_TEST_SUITE_P(Relief, WartOrPock, testing::Values(relief_height, -relief_height));

TEST(Warts, ShadersHaveAllOfThemBesideThePits) {
  Solid skin = skin_with_grains(relief_height);
  skin.raised = {wart(relief_height), wart(-relief_height)};
  skin.raised[1].center = {0.3, 0.2, -0.1};
  const std::vector<glm::vec4> texels = SkinPits(skin).texels();
  const auto cells = static_cast<std::size_t>(texels[1].x * texels[1].y * texels[1].z);
  std::size_t listed = 0, sunk = 0;
  for (std::size_t c = 0; c < cells; ++c) {
    const auto begin = static_cast<std::size_t>(texels[2 + c].x), pits = static_cast<std::size_t>(texels[2 + c].y),
               spots = static_cast<std::size_t>(texels[2 + c].z);
    ASSERT_LE(begin + 2 * pits + 6 * spots, texels.size());
    for (std::size_t i = 0; i < spots; ++i) {
      const glm::vec4& middle = texels[begin + 2 * pits + 6 * i];
      const float relief = texels[begin + 2 * pits + 6 * i + 5].x;
      EXPECT_FLOAT_EQ(middle.w, 0.003f);
      EXPECT_FLOAT_EQ(middle.x, relief > 0 ? 0.0f : 0.3f);
      sunk += relief < 0 ? 1 : 0;
    }
    listed += spots;
  }
  EXPECT_GE(listed, 2u);
  EXPECT_GE(sunk, 1u);
}

/// Pits or knobs of 0.3 m on solids of a metre.
DetailSketch knobs(double relief) {
  DetailSketch detail;
  detail.kind = DetailKind::speckles;
  detail.face = DetailFace::skin;
  detail.size = detail.smallest = detail.length = 0.3;
  detail.density = 0.9;
  detail.softness = 1;
  detail.amount = 0;
  detail.relief = relief;
  return detail;
}

TEST(ReliefOfDetails, SlopeIntegratesToHeight) {
  const Look look(NoiseStyle{}, {knobs(0.05)});
  const glm::dvec3 up(0, 1, 0), along = glm::normalize(glm::dvec3(2, 0, 1));
  constexpr double step = 5e-4;
  const auto at = [&](double way) {
    return relief_at(
        look, Color(0.5f),
        {.position = way * along, .footprint = step, .face = DetailFace::skin, .guide = {.share = glm::vec4(1)}}, up);
  };
  const double start = at(0).height;
  double height = start, highest = 0, min_open = 1;
  for (int i = 0; i < 4000; ++i) {
    const Relief here = at(i * step);
    EXPECT_NEAR(glm::dot(here.slope, up), 0.0, 1e-12);
    EXPECT_NEAR(height, here.height, 1e-3) << i;
    height += glm::dot(here.slope, along) * step;
    highest = std::max(highest, here.height);
    min_open = std::min(min_open, here.open);
  }
  EXPECT_GT(highest, 0.025);
  EXPECT_LE(highest, 0.05 + 1e-12);
  EXPECT_LT(min_open, 1.0);
}

TEST(ReliefOfDetails, OverATexelNeighboursPassIntoEachOther) {
  // Walls a tenth of a texel wide: point samples hit or miss them, so that single texels stand out.
  DetailSketch walls = knobs(0.05);
  walls.kind = DetailKind::cells;
  walls.softness = 0;
  walls.width = 0.05;
  const Look look(NoiseStyle{}, {walls});
  constexpr double texel = 0.03;
  double jumps_at_places = 0, jumps_over_texels = 0, steepest = 0;
  glm::dvec3 place_before(0), texel_before(0);
  for (int i = 0; i < 2000; ++i) {
    const LookPlace place{.position = glm::dvec3(i * texel, 0.1, 0.37 * i * texel),
                          .footprint = texel,
                          .face = DetailFace::skin,
                          .guide = {.share = glm::vec4(1)}};
    const glm::dvec3 at_place = relief_at(look, Color(0.5f), place, {0, 1, 0}).slope;
    const glm::dvec3 over_texel = relief_over_texel(look, Color(0.5f), place, {0, 1, 0}).slope;
    EXPECT_NEAR(over_texel.y, 0.0, 1e-12);
    steepest = std::max(steepest, glm::length(over_texel));
    jumps_at_places += glm::length(at_place - place_before),
        jumps_over_texels += glm::length(over_texel - texel_before);
    place_before = at_place, texel_before = over_texel;
  }
  EXPECT_GT(jumps_over_texels, 0);
  EXPECT_LT(jumps_over_texels, 0.6 * jumps_at_places);
  EXPECT_LT(steepest, 0.8);
}

TEST(ReliefOfDetails, LevelWhereNothingStandsOut) {
  const LookPlace place{
      .position = glm::dvec3(0.1, 0.2, 0.3), .face = DetailFace::skin, .guide = {.share = glm::vec4(1)}};
  const Relief flat = relief_at(Look(NoiseStyle{}, {knobs(0)}), Color(0.5f), place, {0, 1, 0});
  EXPECT_EQ(flat.slope, glm::dvec3(0));
  EXPECT_EQ(flat.open, 1.0);
  LookPlace far = place;
  far.footprint = 1;  // much larger than a knob
  EXPECT_EQ(relief_at(Look(NoiseStyle{}, {knobs(0.05)}), Color(0.5f), far, {0, 1, 0}).slope, glm::dvec3(0));
}

BakedSolid baked_half_ball(double relief, Maps maps = Maps::all) {
  Solid solid = named::half_ball(48, 12);
  solid.own_look().details = {knobs(relief)};
  solid.mesh.guide.assign(solid.mesh.position.size(), {.share = glm::vec4(1)});
  return baked(solid, style_named("ink"), {.texels = 256, .maps = maps});
}

glm::dvec3 decoded(const glm::dvec3& value) { return value / 255.0 * 2.0 - 1.0; }

TEST(Maps, ColorsAreTheSameWithAndWithout) {
  const BakedSolid all = baked_half_ball(0.05), color = baked_half_ball(0.05, Maps::color);
  EXPECT_EQ(all.texture.pixels, color.texture.pixels);
  EXPECT_EQ(all.uv, color.uv);
  EXPECT_TRUE(color.maps.empty());
  EXPECT_TRUE(color.maps.normal.pixels.empty());
}

TEST(Maps, NormalsAreUnitAndLevelWhereThereIsNoRelief) {
  for (const glm::u8vec3& pixel : baked_half_ball(0).maps.normal.pixels) ASSERT_EQ(pixel, glm::u8vec3(128, 128, 255));
  const BakedSolid rough = baked_half_ball(0.05);
  std::size_t tilted_texels = 0;
  for (const glm::u8vec3& pixel : rough.maps.normal.pixels) {
    ASSERT_NEAR(glm::length(decoded(pixel)), 1.0, 0.012);
    if (pixel != glm::u8vec3(128, 128, 255)) ++tilted_texels;
  }
  EXPECT_GT(tilted_texels, rough.maps.normal.pixels.size() / 20);
}

TEST(Maps, TangentsAreUnitAcrossNormalsAndAlongU) {
  const BakedSolid solid = baked_half_ball(0.05);
  ASSERT_EQ(solid.maps.tangent.size(), solid.solid.mesh.position.size());
  for (std::size_t v = 0; v < solid.maps.tangent.size(); ++v) {
    const glm::dvec3 along{glm::vec3(solid.maps.tangent[v])};
    EXPECT_NEAR(glm::length(along), 1.0, 1e-5);
    EXPECT_NEAR(glm::dot(along, glm::normalize(glm::dvec3(solid.solid.mesh.normal[v]))), 0.0, 1e-4);
    EXPECT_EQ(solid.maps.tangent[v].w, 1.0f);
  }
  for (const glm::uvec3& t : solid.solid.mesh.triangle) {
    // v runs down: against normal x tangent.
    const glm::dvec3 e(solid.solid.mesh.position[t.y] - solid.solid.mesh.position[t.x]);
    const glm::dvec2 d(solid.uv[t.y] - solid.uv[t.x]);
    const glm::dvec3 along{glm::vec3(solid.maps.tangent[t.x])};
    const glm::dvec3 up = glm::cross(glm::dvec3(solid.solid.mesh.normal[t.x]), along);
    if (std::fabs(d.x) > 3 * std::fabs(d.y)) {
      EXPECT_GT(glm::dot(e, along) * d.x, 0);
    } else if (std::fabs(d.y) > 3 * std::fabs(d.x)) {
      EXPECT_LT(glm::dot(e, up) * d.y, 0);
    }
  }
}

/// The normal that a renderer computes from the map at a place of an edge.
glm::dvec3 seen_normal(const BakedSolid& solid, std::uint32_t a, std::uint32_t b) {
  const Image& map = solid.maps.normal;
  const glm::dvec2 at = 0.5 * glm::dvec2(solid.uv[a] + solid.uv[b]) * glm::dvec2(map.width, map.height) - 0.5;
  const glm::dvec2 low = glm::floor(at), t = at - low;
  const auto texel = [&](int x, int y) {
    return decoded(map.at(std::clamp(static_cast<int>(low.x) + x, 0, map.width - 1),
                          std::clamp(static_cast<int>(low.y) + y, 0, map.height - 1)));
  };
  const glm::dvec3 n = glm::mix(glm::mix(texel(0, 0), texel(1, 0), t.x), glm::mix(texel(0, 1), texel(1, 1), t.x), t.y);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(solid.solid.mesh.normal[a] + solid.solid.mesh.normal[b]));
  const glm::dvec3 along = glm::normalize(glm::dvec3(glm::vec3(solid.maps.tangent[a] + solid.maps.tangent[b])));
  return glm::normalize(n.x * along + n.y * glm::cross(normal, along) + n.z * normal);
}

TEST(Maps, ChartsAgreeWhereTheyMeet) {
  const BakedSolid solid = baked_half_ball(0.05);
  using Place = std::tuple<float, float, float>;
  const auto place = [&](std::uint32_t v) {
    const glm::vec3& p = solid.solid.mesh.position[v];
    return Place(p.x, p.y, p.z);
  };
  std::map<std::pair<Place, Place>, std::pair<std::uint32_t, std::uint32_t>> known;
  int seams = 0;
  for (std::size_t t = 0; t < solid.solid.mesh.triangle.size(); ++t) {
    for (int k = 0; solid.solid.mesh.cut_face[t] < 0 && k < 3; ++k) {
      const std::uint32_t a = solid.solid.mesh.triangle[t][k], b = solid.solid.mesh.triangle[t][(k + 1) % 3];
      const auto other = known.find({place(b), place(a)});
      known[{place(a), place(b)}] = {a, b};
      if (other == known.end() || (other->second.second == a && other->second.first == b)) continue;
      ++seams;
      const double agreement =
          glm::dot(seen_normal(solid, a, b), seen_normal(solid, other->second.first, other->second.second));
      EXPECT_GT(agreement, std::cos(6 * 3.14159265 / 180)) << "more than 6 degrees apart";
    }
  }
  EXPECT_GT(seams, 10);
}

TEST(Maps, SpotsAreInThem) {
  Solid solid = named::half_ball(48, 12);
  Spot spot;
  spot.center = spot.normal = glm::normalize(glm::dvec3(0.3, 0.8, 0.5));
  spot.tangent = glm::normalize(glm::cross(spot.normal, glm::dvec3(0, 1, 0)));
  spot.radius = 0.3;
  spot.softness = 1;
  spot.relief = 0.1;
  const auto tilted_texels = [&] {
    const BakedSolid made = baked(solid, style_named("ink"), {.texels = 256, .maps = Maps::all});
    const std::vector<glm::u8vec3>& pixels = made.maps.normal.pixels;
    return static_cast<double>(pixels.size() - static_cast<std::size_t>(std::count(pixels.begin(), pixels.end(),
                                                                                   glm::u8vec3(128, 128, 255)))) /
           static_cast<double>(pixels.size());
  };
  EXPECT_EQ(tilted_texels(), 0);
  solid.raised = {spot};
  const double share = tilted_texels();
  // Of the half ball's skin and cut face, 2 pi and pi, a spot of 0.3 has 0.09 pi.
  EXPECT_GT(share, 0.008);
  EXPECT_LT(share, 0.05);
}

TEST(Maps, PartsHaveTheirNumbers) {
  const BakedSolid solid =
      baked(plate_with_seed(relief_height), style_named("plain"), {.texels = 128, .maps = Maps::all});
  std::array<int, 256> count{};
  for (const glm::u8vec3& pixel : solid.maps.part.pixels) ++count[pixel.r];
  // The seed has 16 % of the plate.
  EXPECT_NEAR(count[1] / static_cast<double>(count[0] + count[1]), 0.16, 0.03);
  EXPECT_EQ(count[0] + count[1] + count[255], 128 * 128);
}

}  // namespace
}  // namespace pomona
