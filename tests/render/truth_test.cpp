// Ground truth of pictures: the value of each pixel is what a ray through it hits.
#include "render/truth/ground_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "generator/base/error.h"
#include "generator/base/random.h"
#include "generator/piece/piece_facts.h"
#include "render/gl/scene_picture.h"
#include "render/image/deep_image.h"
#include "render/strokes/lens.h"
#include "render/style/style_file.h"
#include "render/truth/amodal_masks.h"
#include "render/truth/layers.h"
#include "render/truth/run_lengths.h"
#include "render/truth/truth_pictures.h"
#include "tests/render/painted_shapes.h"

namespace pomona {
namespace {

using nlohmann::json;

constexpr int width = 320, height = 240;

/// Whole and half balls that hide each other, on paper.
Scene hiding_balls() {
  Scene scene = testing::still_life();
  scene.ground = false;
  return scene;
}

TruthLayers layers_of(const Scene& scene) { return truth_layers(scene, truth_naming(scene), width, height); }

struct Hit {
  std::uint16_t instance = 0;
  double depth = 0;
  glm::dvec3 normal{0};
  bool section = false;
};

/// The first hit of a ray through a pixel's middle [Moeller and Trumbore 1997], by testing every triangle of every
/// instance.
Hit cast(const Scene& scene, int x, int y) {
  const Lens lens(scene.view, width, height);
  const glm::dvec3 from = lens.eye(), way = lens.in_scene({x + 0.5, y + 0.5}, 1) - from;  // one step is a depth of 1
  Hit nearest;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Pose& pose = scene.instances[i].pose;
    const Solid& solid = scene.solids[static_cast<std::size_t>(scene.instances[i].solid)];
    const glm::dquat back = glm::conjugate(pose.rotation);
    const glm::dvec3 o = back * (from - pose.translation), d = back * way;
    for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
      const glm::uvec3& corner = solid.mesh.triangle[t];
      const glm::dvec3 a(solid.mesh.position[corner.x]), b(solid.mesh.position[corner.y]),
          c(solid.mesh.position[corner.z]);
      const glm::dvec3 p = glm::cross(d, c - a);
      const double det = glm::dot(b - a, p);
      if (!(det > 0)) continue;  // faces away
      const double u = glm::dot(o - a, p) / det;
      const glm::dvec3 q = glm::cross(o - a, b - a);
      const double v = glm::dot(d, q) / det, depth = glm::dot(c - a, q) / det;
      if (u < 0 || v < 0 || u + v > 1 || depth <= 0) continue;
      if (nearest.instance != 0 && depth >= nearest.depth) continue;
      const glm::dvec3 n = (1 - u - v) * glm::dvec3(solid.mesh.normal[corner.x]) +
                           u * glm::dvec3(solid.mesh.normal[corner.y]) + v * glm::dvec3(solid.mesh.normal[corner.z]);
      nearest = {static_cast<std::uint16_t>(i + 1), depth, pose.rotation * glm::normalize(n),
                 solid.mesh.cut_face[t] >= 0};
    }
  }
  return nearest;
}

TEST(GroundTruth, IsWhatRaysThroughPixelsMeet) {
  const Scene scene = hiding_balls();
  const TruthLayers layers = layers_of(scene);
  const RandomStream draw({1, 0}, "pixels");
  std::set<std::uint16_t> met;
  int cut_faces = 0;
  for (std::uint64_t k = 0; k < 400; ++k) {
    const int x = static_cast<int>(draw.below(2 * k, width)), y = static_cast<int>(draw.below(2 * k + 1, height));
    const Hit hit = cast(scene, x, y);
    const std::size_t pixel = layers.pixel(x, y);
    ASSERT_EQ(layers.instance[pixel], hit.instance) << x << " " << y;
    met.insert(hit.instance);
    if (hit.instance == 0) {
      EXPECT_EQ(layers.depth[pixel], 0);
      EXPECT_EQ(layers.normal[pixel], glm::vec3(0));
      EXPECT_EQ(layers.part[pixel], 0);
      continue;
    }
    EXPECT_NEAR(static_cast<double>(layers.depth[pixel]), hit.depth, 1e-6 * hit.depth);
    EXPECT_LT(glm::distance(glm::dvec3(layers.normal[pixel]), hit.normal), 1e-6);
    EXPECT_NEAR(static_cast<double>(glm::length(layers.normal[pixel])), 1, 1e-6);
    EXPECT_EQ(layers.section[pixel] != 0, hit.section);
    cut_faces += hit.section ? 1 : 0;
  }
  EXPECT_EQ(met.size(), 5u) << "paper and all four balls";
  EXPECT_GT(cut_faces, 10);
}

TEST(GroundTruth, PartsAreThoseOfTheNearestVertex) {
  const Scene scene = hiding_balls();
  const TruthNaming names = truth_naming(scene);
  const TruthLayers layers = layers_of(scene);
  for (std::size_t i = 0; i < layers.part.size(); ++i) {
    if (layers.instance[i] == 0) continue;
    const TruthNaming::Part& part = names.parts.at(layers.part[i] - 1u);
    // The cut face of a half ball is flesh, the rest skin.
    EXPECT_EQ(part.name, layers.section[i] != 0 ? "flesh" : "skin");
    EXPECT_EQ(part.species, names.fruit(layers.fruit[i]).species);
  }
}

/// The scene with only this instance.
Scene alone(const Scene& scene, std::size_t instance) {
  Scene one = scene;
  one.instances = {scene.instances[instance]};
  return one;
}

TEST(GroundTruth, WholeMasksAreWhatShowsWithoutTheOthers) {
  const Scene scene = hiding_balls();
  const std::vector<Mask> amodal = amodal_masks(scene, width, height);
  const std::vector<Mask> visible = visible_masks(layers_of(scene).instance, width, scene.instances.size());
  bool hides = false;
  for (std::size_t i = 0; i < amodal.size(); ++i) {
    const TruthLayers own = layers_of(alone(scene, i));
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        ASSERT_EQ(amodal[i].at(x, y), own.instance[own.pixel(x, y)] != 0);
        ASSERT_TRUE(amodal[i].at(x, y) || !visible[i].at(x, y));
      }
    }
    hides = hides || visible[i].area() < amodal[i].area();
  }
  EXPECT_TRUE(hides);
}

/// The pixels of COCO's text, column by column; read as maskApi.c of pycocotools reads it (rleFrString).
std::vector<bool> unpacked(const json& segmentation) {
  const std::string text = segmentation.at("counts");
  std::vector<std::int64_t> runs;
  for (std::size_t p = 0; p < text.size();) {
    std::int64_t x = 0;
    int k = 0;
    for (bool more = true; more; ++k, ++p) {
      const int c = text.at(p) - 48;
      x |= static_cast<std::int64_t>(c & 0x1f) << 5 * k;
      more = (c & 0x20) != 0;
      if (!more && (c & 0x10) != 0) x |= -(std::int64_t{1} << 5 * (k + 1));
    }
    if (runs.size() > 2) x += runs[runs.size() - 2];
    runs.push_back(x);
  }
  std::vector<bool> pixels;
  for (std::size_t i = 0; i < runs.size(); ++i)
    pixels.insert(pixels.end(), static_cast<std::size_t>(runs[i]), i % 2 != 0);
  return pixels;
}

Mask random_mask(std::uint64_t seed, int columns, int rows) {
  const RandomStream draw({seed, 0}, "mask");
  Mask mask{{0, 0, columns - 1, rows - 1}, {}};
  for (int i = 0; i < columns * rows; ++i)
    mask.covered.push_back(draw.uniform(static_cast<std::uint64_t>(i)) < 0.6 ? 1 : 0);
  return trimmed(mask);
}

TEST(RunLengths, SayWhichPixelsAreCovered) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const int columns = 1 + static_cast<int>(seed % 7), rows = 1 + static_cast<int>(seed % 5);
    const Mask mask = random_mask(seed, columns, rows);
    // In a picture with a border of two pixels, and in one that it fills.
    for (const int border : {0, 2}) {
      const std::vector<bool> pixels =
          unpacked({{"counts", packed(run_lengths(mask, columns + border, rows + border))}});
      ASSERT_EQ(pixels.size(), static_cast<std::size_t>((columns + border) * (rows + border)));
      for (int x = 0; x < columns + border; ++x) {
        for (int y = 0; y < rows + border; ++y)
          ASSERT_EQ(pixels[static_cast<std::size_t>(x * (rows + border) + y)], mask.at(x, y)) << seed;
      }
    }
  }
}

TEST(RunLengths, OfNothingAndOfEverything) {
  EXPECT_EQ(run_lengths({}, 4, 3), (std::vector<std::uint32_t>{12}));
  const Mask full{{0, 0, 3, 2}, std::vector<std::uint8_t>(12, 1)};
  EXPECT_EQ(run_lengths(full, 4, 3), (std::vector<std::uint32_t>{0, 12}));
  EXPECT_EQ(run_lengths(full, 5, 3), (std::vector<std::uint32_t>{0, 12, 3}));
  EXPECT_EQ(packed({0, 12, 3}), "0<3");
}

std::string file(const std::vector<TruthFile>& files, const std::string& name) {
  for (const TruthFile& f : files) {
    if (f.name == name) return f.bytes;
  }
  ADD_FAILURE() << "no file " << name;
  return {};
}

TruthOptions options() {
  return {.width = width, .height = height, .file_name = "balls.png", .made_by = "pomona", .seed = 7};
}

/// All keys of COCO's format for object detection are there, and numbers agree with the masks.
TEST(Annotations, HaveCocosKeysAndAgreeWithTheMasks) {
  const Scene scene = hiding_balls();
  const std::vector<TruthFile> files = ground_truth(scene, options());
  const json all = json::parse(file(files, "annotations.json"));
  for (const char* key : {"info", "licenses", "images", "annotations", "categories"})
    ASSERT_TRUE(all.contains(key)) << key;
  const json& image = all.at("images").at(0);
  EXPECT_EQ(image.at("file_name"), "balls.png");
  EXPECT_EQ(image.at("width"), width);
  EXPECT_EQ(image.at("height"), height);
  ASSERT_EQ(all.at("annotations").size(), 4u);

  const DeepImage ids = read_deep_png(file(files, "instance.png"), "instance.png");
  for (const json& one : all.at("annotations")) {
    const int id = one.at("id");
    EXPECT_EQ(one.at("image_id"), image.at("id"));
    EXPECT_EQ(one.at("iscrowd"), 0);
    EXPECT_EQ(one.at("segmentation").at("size"), json({height, width}));

    // Area, box and segmentation are those of the pixels with this id.
    const std::vector<bool> seen = unpacked(one.at("segmentation")), whole = unpacked(one.at("amodal_segmentation"));
    int area = 0, amodal = 0, left = width, right = -1, top = height, bottom = -1;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto place = static_cast<std::size_t>(x * height + y);
        ASSERT_EQ(seen[place], ids.at(x, y) == id);
        ASSERT_TRUE(whole[place] || !seen[place]);
        amodal += whole[place] ? 1 : 0;
        if (!seen[place]) continue;
        ++area;
        left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
      }
    }
    EXPECT_EQ(one.at("area"), area);
    EXPECT_EQ(one.at("amodal_area"), amodal);
    EXPECT_EQ(one.at("bbox"), json({left, top, right - left + 1, bottom - top + 1}));
    EXPECT_DOUBLE_EQ(one.at("occlusion"), 1 - static_cast<double>(area) / amodal);

    const Solid& solid =
        scene.solids[static_cast<std::size_t>(scene.instances[static_cast<std::size_t>(id - 1)].solid)];
    EXPECT_EQ(one.at("volume"), facts_of(solid).volume);
    EXPECT_EQ(one.at("mass"), facts_of(solid).mass);
    const std::size_t category = one.at("category_id");
    EXPECT_EQ(all.at("categories").at(category - 1).at("name"), solid.name);
  }
}

/// The same balls, the first of them of three organs, one of which lies inside.
Scene balls_of_organs() {
  Scene scene = hiding_balls();
  Solid& ball = scene.solids[static_cast<std::size_t>(scene.instances[0].solid)];
  for (std::size_t t = 0; t < ball.mesh.triangle.size(); ++t)
    ball.mesh.instance.push_back(static_cast<std::int32_t>(t % 3 == 0 ? 0 : 6 + t % 3));
  ball.organs = {{0, "bunch", 1e-6, 1e-3}, {3, "seed", 1e-6, 1e-3}, {7, "berry", 2e-6, 2e-3}, {8, "berry", 2e-6, 2e-3}};
  return scene;
}

TEST(Annotations, OrgansAddUpToTheirPiece) {
  const Scene scene = balls_of_organs();
  const std::vector<TruthFile> files = ground_truth(scene, options());
  const json all = json::parse(file(files, "annotations.json"));
  const DeepImage ids = read_deep_png(file(files, "instance.png"), "instance.png"),
                  numbers = read_deep_png(file(files, "organ.png"), "organ.png");
  int with_organs = 0;
  for (const json& one : all.at("annotations")) {
    if (!one.contains("organs")) continue;
    ++with_organs;
    ASSERT_EQ(one.at("organs").size(), 4u);
    const std::vector<bool> piece = unpacked(one.at("segmentation"));
    std::vector<int> times(piece.size(), 0);
    std::size_t area = 0;
    for (const json& organ : one.at("organs")) {
      area += organ.at("area").get<std::size_t>();
      EXPECT_EQ(organ.contains("segmentation"), organ.at("area") > 0);
      EXPECT_EQ(organ.at("area") > 0, organ.at("instance") != 3) << "it lies inside";
      if (!organ.contains("segmentation")) continue;
      const std::vector<bool> mask = unpacked(organ.at("segmentation"));
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const auto place = static_cast<std::size_t>(x * height + y);
          times[place] += mask[place] ? 1 : 0;
          const bool is_here =
              ids.at(x, y) == one.at("id").get<int>() && numbers.at(x, y) == organ.at("instance").get<int>();
          ASSERT_EQ(mask[place], is_here);
        }
      }
    }
    EXPECT_EQ(area, one.at("area"));
    for (std::size_t place = 0; place < piece.size(); ++place) ASSERT_EQ(times[place], piece[place] ? 1 : 0);
  }
  EXPECT_GE(with_organs, 1);
}

TEST(Annotations, OrgansWhoseNumbersDoNotFitAreRefused) {
  Scene scene = balls_of_organs();
  Solid& ball = scene.solids[static_cast<std::size_t>(scene.instances[0].solid)];
  ball.organs.back().instance = 65535;
  EXPECT_NO_THROW(ground_truth(scene, options()));
  ball.organs.back().instance = 65536;
  EXPECT_THROW(ground_truth(scene, options()), Error);
}

TEST(Annotations, WithoutOrgansAreAsBefore) {
  const std::vector<TruthFile> files = ground_truth(hiding_balls(), options());
  for (const TruthFile& one : files) EXPECT_NE(one.name, "organ.png");
  EXPECT_EQ(file(files, "annotations.json").find("organ"), std::string::npos);
}

TEST(Annotations, ListApartWhatIsHiddenAltogether) {
  Scene scene = hiding_balls();
  scene.instances.push_back(scene.instances[0]);  // the same again, a little farther away
  scene.instances.back().pose.translation += 0.2 * (scene.instances[0].pose.translation - scene.view.eye);
  scene.instances.back().name = "behind";
  scene.instances.push_back(scene.instances[0]);  // behind the eye: not visible
  scene.instances.back().pose.translation = 2.0 * scene.view.eye;
  const json all = json::parse(file(ground_truth(scene, options()), "annotations.json"));
  EXPECT_EQ(all.at("annotations").size(), 4u);
  ASSERT_EQ(all.at("hidden").size(), 1u);
  EXPECT_EQ(all.at("hidden").at(0).at("name"), "behind");
  EXPECT_EQ(all.at("hidden").at(0).at("occlusion"), 1);
}

/// The camera in `images` projects centres of mass onto the pixels of their instances.
TEST(Annotations, CameraProjectsIntoThePicture) {
  const Scene scene = hiding_balls();
  const json all = json::parse(file(ground_truth(scene, options()), "annotations.json"));
  const json& camera = all.at("images").at(0).at("camera");
  const auto vector = [](const json& v) { return glm::dvec3(v.at(0), v.at(1), v.at(2)); };
  const double focal = camera.at("focal_length");
  for (const json& one : all.at("annotations")) {
    const glm::dvec3 p = vector(one.at("center_of_mass")) - vector(camera.at("eye"));
    const double depth = glm::dot(p, vector(camera.at("forward")));
    const double x =
        camera.at("principal_point").at(0).get<double>() + focal * glm::dot(p, vector(camera.at("right"))) / depth;
    const double y =
        camera.at("principal_point").at(1).get<double>() + focal * glm::dot(p, vector(camera.at("down"))) / depth;
    const json& box = one.at("amodal_bbox");
    EXPECT_NEAR(x, box.at(0).get<double>() + 0.5 * box.at(2).get<double>(), 0.2 * box.at(2).get<double>());
    EXPECT_NEAR(y, box.at(1).get<double>() + 0.5 * box.at(3).get<double>(), 0.2 * box.at(3).get<double>());
  }
}

TEST(TruthPictures, HoldTheLayers) {
  const Scene scene = hiding_balls();
  const TruthLayers layers = layers_of(scene);
  const std::vector<Mask> amodal = amodal_masks(scene, width, height);
  const std::vector<TruthFile> files = ground_truth(scene, options());
  const auto read = [&](const std::string& name) { return read_deep_png(file(files, name), name); };
  const DeepImage instance = read("instance.png"), fruit = read("fruit.png"), part = read("part.png"),
                  depth = read("depth.png"), normal = read("normal.png"), section = read("section.png"),
                  whole = read("amodal_1.png");
  const double step = depth_step(layers);
  EXPECT_EQ(json::parse(file(files, "annotations.json")).at("images").at(0).at("metres_per_depth_step"), step);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = layers.pixel(x, y);
      ASSERT_EQ(instance.at(x, y), layers.instance[i]);
      ASSERT_EQ(fruit.at(x, y), layers.fruit[i]);
      ASSERT_EQ(part.at(x, y), layers.part[i]);
      ASSERT_EQ(section.at(x, y), layers.section[i] != 0 ? 65535 : 0);
      ASSERT_NEAR(depth.at(x, y) * step, static_cast<double>(layers.depth[i]), 0.5001 * step);
      for (int k = 0; k < 3 && layers.instance[i] != 0; ++k)
        ASSERT_NEAR(normal.at(x, y, k) / 65535.0 * 2 - 1, static_cast<double>(layers.normal[i][k]), 1.6e-5);
      for (std::size_t k = 0; k < amodal.size(); ++k) ASSERT_EQ((whole.at(x, y) >> k & 1) != 0, amodal[k].at(x, y));
    }
  }
}

TEST(GroundTruth, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = hiding_balls();
  TruthOptions one = options(), three = options();
  one.threads = {1}, three.threads = {3};
  const std::vector<TruthFile> a = ground_truth(scene, one), b = ground_truth(scene, three);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].bytes, b[i].bytes) << a[i].name;
}

TEST(GroundTruth, OfWhatOneSeesThroughIsRefused) {
  Scene scene = hiding_balls();
  scene.solids[0].opacity = 0.5f;
  EXPECT_THROW(ground_truth(scene, options()), Error);
}

/// Away from outlines OpenGL's picture agrees with the ids: there all samples and the middle of a pixel lie in the same
/// instance.
TEST(GroundTruth, AgreesWithThePictureByOpenGl) {
  Scene scene = hiding_balls();
  scene.paper = Color(0, 0, 1);  // nothing else is blue
  Style style = style_named("plain");
  style.ink = false;
  style.grain = style.vignette = 0;
  const Image picture = draw_scene(scene, style, {.width = width, .height = height});
  const TruthLayers layers = layers_of(scene);
  int paper = 0, fruit = 0;
  for (int y = 1; y + 1 < height; ++y) {
    for (int x = 1; x + 1 < width; ++x) {
      int covered = 0;
      for (int k = 0; k < 9; ++k) covered += layers.instance[layers.pixel(x + k % 3 - 1, y + k / 3 - 1)] != 0 ? 1 : 0;
      const glm::u8vec3& color = picture.at(x, y);
      const bool is_paper = color.b > 200 && color.r < 30;
      ASSERT_TRUE(covered != 0 || is_paper) << x << " " << y;
      ASSERT_TRUE(covered != 9 || color.b < color.r) << x << " " << y;
      // On outlines, no pixel with its middle on paper has fruit at all samples, nor the reverse.
      const bool is_covered = layers.instance[layers.pixel(x, y)] != 0;
      ASSERT_TRUE(is_covered ? !is_paper : color.b > 125) << x << " " << y;
      paper += covered == 0 ? 1 : 0;
      fruit += covered == 9 ? 1 : 0;
    }
  }
  EXPECT_GT(paper, 10000);
  EXPECT_GT(fruit, 10000);
}

}  // namespace
}  // namespace pomona
