// Fruits as assets and pages, and squares of their sections as the harmonic field colours them in C++: what browsers
// and Node are held to.
//   write_sections FOLDER SIZE TEMPLATE[:SEED]...    makes FOLDER/NAME.pomona, NAME.html, NAME.json and NAME.sections;
// NAME is TEMPLATE, or TEMPLATE-SEED for a variant. NAME.looks has the same squares with noise and details, by example
// and others, as the processor paints them where no lattice comes between: each point has its own guide.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "generator/base/error.h"
#include "generator/compose/grow.h"
#include "generator/diffusion/harmonic/harmonic_diffuser.h"
#include "generator/mesh/enclosures.h"
#include "generator/piece/guided.h"
#include "generator/surface/bodies.h"
#include "generator/surface/body_walls.h"
#include "generator/surface/skin_depth.h"
#include "generator/template/read/read_template.h"
#include "render/page/asset_file.h"
#include "render/page/make_asset.h"
#include "render/page/page.h"
#include "render/style/look.h"
#include "render/style/style_file.h"

namespace {

using namespace pomona;
namespace fs = std::filesystem;

/// A square in a plane, seen from where its normal points.
struct Square {
  std::string name;
  glm::dvec3 origin, u, v, n;  ///< metres; unit directions
  double reach = 0;            ///< half its side, metres
};

std::vector<Square> squares_of(const Box<double>& bounds) {
  std::vector<Square> squares;
  const glm::dvec3 size = bounds.size();
  const double reach = 0.52 * std::max({size.x, size.y, size.z});
  const std::vector<std::pair<std::string, glm::dvec3>> normals = {
      {"half", {0, 0, 1}}, {"across", {0, 1, 0}}, {"slanted", glm::normalize(glm::dvec3(0.3, 1, 0.2))}};
  for (const auto& [name, n] : normals) {
    const glm::dvec3 u = name == "half" ? glm::dvec3(1, 0, 0) : glm::normalize(glm::cross(n, glm::dvec3(0, 0, 1)));
    // `half` is the plane z = 0, the others go through the middle.
    glm::dvec3 origin = bounds.center();
    if (name == "half") origin.z = 0;
    squares.push_back({name, origin, u, glm::cross(n, u), n, reach});
  }
  return squares;
}

std::vector<glm::vec3> points_of(const Square& square, int size) {
  std::vector<glm::vec3> points;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double s = 2 * (x + 0.5) / size - 1, t = 2 * (y + 0.5) / size - 1;
      points.emplace_back(square.origin + square.reach * (s * square.u + t * square.v));
    }
  }
  return points;
}

nlohmann::json list_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

void write(const fs::path& file, const std::string& bytes) {
  std::ofstream out(file, std::ios::binary);
  out << bytes;
  if (!out) throw Error(ExitStatus::io_error, file.string() + " cannot be written");
}

/// Per point: red, green, blue (linear floats), and 1 inside, 0 in air.
std::string bytes_of(const std::vector<glm::vec3>& points, const std::vector<Color>& color, const Enclosures& bodies) {
  std::string bytes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec4 value(color[i], bodies.around(glm::dvec3(points[i])).empty() ? 0.0f : 1.0f);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  return bytes;
}

/// The colours with the fruit's noise and details. \param footprint of a point, metres
std::vector<Color> painted(const std::vector<glm::vec3>& points, const DiffusedColors& bare, const GrownFruit& grown,
                           const Template& fruit, double footprint) {
  const Look look(fruit.noise, fruit.details);
  const SkinDepth skin(grown.swept);
  const std::vector<DetailGuide> guides = layer_guides(points, grown.swept, fruit, skin);
  std::vector<Color> color(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    LookPlace place{.position = glm::dvec3(points[i]), .footprint = footprint, .guide = guides[i]};
    place.guide.share = detail_shares(fruit, DetailFace::cut, bare.part[i], skin.depth(place.position));
    color[i] = look(bare.color[i], place);
  }
  return color;
}

/// A template, as drawn or as a seed varies it.
struct Wanted {
  std::string name;
  std::uint64_t seed = 0;  ///< 0: as drawn
};

Wanted wanted_of(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return {text, 0};
  return {text.substr(0, colon), std::stoull(text.substr(colon + 1))};
}

void write_fruit(const Wanted& wanted, int size, const fs::path& folder) {
  const VariantKey key{wanted.seed, 0};
  const GrowOptions how{.as_drawn = wanted.seed == 0};
  const fs::path file = fs::path(POMONA_SOURCE_DIR) / "templates" / (wanted.name + ".toml");
  const Template fruit = variant_of(read_template(file), key, how);
  const GrownFruit grown = grow(fruit, key, how);
  const Asset asset = make_asset({grown, fruit, wanted.name, wanted.seed});
  std::string name = wanted.name;
  if (wanted.seed != 0) name += "-" + std::to_string(wanted.seed);
  write(folder / (name + ".pomona"), write_asset(asset, "a test"));
  write(folder / (name + ".html"),
        write_page(asset, {.style = style_named("ink"), .cuts = {{.plane = {{0, 0, 1}, 0}}}, .made_by = "a test"}));

  // Squares in cells of the asset's grid, and their true colours.
  const auto field = make_harmonic_diffuser()->field(grown.sheets);
  const Enclosures bodies = body_walls(grown.sheets, find_bodies(grown.sheets));
  nlohmann::json squares = nlohmann::json::array();
  std::string bytes, looks;
  for (const Square& square : squares_of(bounds_of(grown.sheets))) {
    squares.push_back({{"name", square.name},
                       {"origin", list_of((square.origin - asset.origin) / asset.spacing)},
                       {"u", list_of(square.u)},
                       {"v", list_of(square.v)},
                       {"n", list_of(square.n)},
                       {"reach", square.reach / asset.spacing}});
    const std::vector<glm::vec3> points = points_of(square, size);
    const DiffusedColors bare = field->at(points);
    bytes += bytes_of(points, bare.color, bodies);
    looks += bytes_of(points, painted(points, bare, grown, fruit, 2 * square.reach / size), bodies);
  }
  write(folder / (name + ".json"), nlohmann::json({{"size", size}, {"squares", squares}}).dump());
  write(folder / (name + ".sections"), bytes);
  write(folder / (name + ".looks"), looks);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 4) return 64;
  fs::create_directories(argv[1]);
  for (int i = 3; i < argc; ++i) write_fruit(wanted_of(argv[i]), std::stoi(argv[2]), argv[1]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
