// Models of simulators as text; tests/programs/mujoco_rest.mjs has MuJoCo load and run them.
#include "render/export/simulation/write_mjcf.h"
#include "render/export/simulation/write_urdf.h"

#include <gmock/gmock.h>
#include <cmath>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "generator/piece/piece_facts.h"
#include "render/export/piece_words.h"
#include "tests/render/export/named_solids.h"

namespace pomona {
namespace {

/// A box that is a piece of fruit, turned and moved, on a ball that is a dish.
Scene box_on_ball() {
  Scene scene = named::mixed();
  scene.solids[0].origin = {.source = "kiwi", .number = 1, .pieces = 1, .fruit = "kiwi"};
  return scene;
}

std::vector<double> numbers(const std::string& text) {
  std::istringstream words(text);
  std::vector<double> list;
  for (double number = 0; words >> number;) list.push_back(number);
  return list;
}

TEST(Mjcf, SaysMassCentreAndInertia) {
  const Scene scene = box_on_ball();
  pugi::xml_document file;
  ASSERT_TRUE(file.load_string(write_mjcf(scene).c_str()));
  const PieceFacts facts = facts_of(scene.solids[0]);
  std::size_t moving = 0, still = 0;
  for (const pugi::xml_node body : file.child("mujoco").child("worldbody").children("body")) {
    if (!body.child("freejoint")) {
      ++still;
      continue;
    }
    const pugi::xml_node inertial = body.child("inertial");
    EXPECT_EQ(numbers(inertial.attribute("mass").value()), std::vector<double>{facts.mass});
    const std::vector<double> moments = numbers(inertial.attribute("diaginertia").value());
    const std::vector<double> q = numbers(inertial.attribute("quat").value());
    ASSERT_EQ(moments.size() + q.size(), 7u);
    const glm::dmat3 turn = glm::mat3_cast(glm::dquat(q[0], q[1], q[2], q[3]));
    glm::dmat3 diagonal(0);
    for (int k = 0; k < 3; ++k) diagonal[k][k] = moments[static_cast<std::size_t>(k)];
    const glm::dmat3 inertia = turn * diagonal * glm::transpose(turn);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(inertia[i][j], facts.inertia[i][j], 1e-12 * facts.mass);
    const std::vector<double> at = numbers(inertial.attribute("pos").value());
    const glm::dvec3 center = facts.center - glm::dvec3(pivot_of(scene.solids[0]));
    EXPECT_EQ(at, (std::vector<double>{center.x, center.y, center.z}));
    ++moving;
  }
  EXPECT_EQ(moving, 2u) << "both instances of the box";
  EXPECT_EQ(still, 2u) << "leaf and ball; nothing is of the empty solid";
}

TEST(Mjcf, EveryMeshOfABodyIsThere) {
  const std::string text = write_mjcf(box_on_ball());
  pugi::xml_document file;
  ASSERT_TRUE(file.load_string(text.c_str()));
  std::set<std::string> assets, used;
  for (const pugi::xml_node mesh : file.child("mujoco").child("asset").children("mesh"))
    EXPECT_TRUE(assets.insert(mesh.attribute("name").value()).second) << "told once";
  for (const pugi::xml_node body : file.child("mujoco").child("worldbody").children("body"))
    for (const pugi::xml_node geom : body.children("geom")) used.insert(geom.attribute("mesh").value());
  EXPECT_EQ(assets, used);
}

TEST(Mjcf, UpIsZ) {
  Scene scene = named::mixed();
  scene.instances.resize(1);
  scene.solids[0].origin = {};
  scene.instances[0].pose = {.rotation = {1, 0, 0, 0}, .translation = {1, 2, 3}};
  EXPECT_THAT(write_mjcf(scene),
              testing::HasSubstr("pos=\"1 -3 2\" quat=\"0.7071067811865476 0.7071067811865476 0 0\""));
}

/// The hull of a ring is full, so that the core within would push its welds apart; so would a stone in its socket.
TEST(Mjcf, WeldedBodiesWhoseHullsOverlapDoNotCollide) {
  const auto excluded = [](bool welded) {
    pugi::xml_document file;
    EXPECT_TRUE(file.load_string(write_mjcf(named::settled_balls(), {.welded = welded}).c_str()));
    std::vector<std::string> pairs;
    for (const pugi::xml_node pair : file.child("mujoco").child("contact").children("exclude"))
      pairs.push_back(std::string(pair.attribute("body1").value()) + " " + pair.attribute("body2").value());
    return pairs;
  };
  EXPECT_EQ(excluded(true), (std::vector<std::string>{"ball_1 ball_2", "ball_3 ball_4"}));
  EXPECT_TRUE(excluded(false).empty()) << "there shapes are cut apart";
}

TEST(Urdf, NamesTheMeshesThatLieBesideIt) {
  const UrdfFiles files = write_urdf(box_on_ball(), "bowl");
  pugi::xml_document file;
  ASSERT_TRUE(file.load_string(files.text.c_str()));
  std::set<std::string> named, made;
  for (const NamedFile& mesh : files.meshes) EXPECT_TRUE(made.insert(mesh.name).second);
  for (const pugi::xpath_node mesh : file.select_nodes("//mesh"))
    named.insert(mesh.node().attribute("filename").value());
  EXPECT_EQ(named, made);
  EXPECT_EQ(file.select_nodes("//joint[@type='floating']").size(), 2u);
  EXPECT_EQ(file.select_nodes("//joint[@type='fixed']").size(), 2u);
}

TEST(Urdf, AnglesAreThoseOfTheRotation) {
  Scene scene = named::mixed();
  scene.instances.resize(1);
  scene.solids[0].origin = {};
  const glm::dquat turn = glm::normalize(glm::dquat(0.7, -0.2, 0.4, 0.55));
  scene.instances[0].pose.rotation = turn;
  pugi::xml_document file;
  ASSERT_TRUE(file.load_string(write_urdf(scene, "x").text.c_str()));
  const std::vector<double> rpy = numbers(file.select_node("//joint/origin").node().attribute("rpy").value());
  ASSERT_EQ(rpy.size(), 3u);
  const auto about = [](int axis, double angle) {
    glm::dvec3 along(0);
    along[axis] = std::sin(angle / 2);
    return glm::dquat(std::cos(angle / 2), along);
  };
  const glm::dquat again = about(2, rpy[2]) * about(1, rpy[1]) * about(0, rpy[0]);
  const glm::dquat wanted = about(0, std::acos(0.0)) * turn;
  EXPECT_NEAR(std::abs(glm::dot(again, wanted)), 1, 1e-12);
}

}  // namespace
}  // namespace pomona
