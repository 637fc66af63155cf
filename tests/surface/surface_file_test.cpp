#include "generator/surface/file/surface_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include "generator/base/error.h"
#include "generator/surface/bodies.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using namespace shapes;

/// A fruit with all attributes that a file can hold.
DiffusionSurfaces rich_fruit() {
  Paint core;
  core.name = "the core";
  core.front_part = "gel";
  core.blur = 0.002f;
  DiffusionSurfaces fruit = tilted(joined(hollow_ball(0.05, 0.03, 4), sphere(0.04, 3, core)));
  for (std::size_t v = 0; v < fruit.vertex_count(); ++v) fruit.front_color[v].r = 1.0f / static_cast<float>(v + 3);
  return fruit;
}

void expect_equal(const DiffusionSurfaces& a, const DiffusionSurfaces& b) {
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.front_color, b.front_color);
  EXPECT_EQ(a.back_color, b.back_color);
  EXPECT_EQ(a.blur, b.blur);
  EXPECT_EQ(a.front_hidden, b.front_hidden);
  EXPECT_EQ(a.back_hidden, b.back_hidden);
  EXPECT_EQ(a.triangle, b.triangle);
  EXPECT_EQ(a.surface, b.surface);
  EXPECT_EQ(a.front_part, b.front_part);
  EXPECT_EQ(a.back_part, b.back_part);
  EXPECT_EQ(a.surface_names, b.surface_names);
  EXPECT_EQ(a.part_names, b.part_names);
}

TEST(SurfaceFile, KeepsEveryBit) {
  const DiffusionSurfaces fruit = rich_fruit();
  const std::string bytes = write_surfaces(fruit);
  expect_equal(parse_surfaces(bytes, "fruit.ply"), fruit);
  EXPECT_EQ(write_surfaces(parse_surfaces(bytes, "fruit.ply")), bytes);
}

TEST(SurfaceFile, KeepsInstancesAndHasNoneWhereNothingIsPlaced) {
  DiffusionSurfaces fruit = rich_fruit();
  EXPECT_EQ(write_surfaces(fruit).find("instance"), std::string::npos);
  fruit.instance.assign(fruit.triangle_count(), 0);
  fruit.instance.back() = 7;
  const DiffusionSurfaces read = parse_surfaces(write_surfaces(fruit), "fruit.ply");
  expect_equal(read, fruit);
  EXPECT_EQ(read.instance, fruit.instance);
  fruit.instance.back() = 0;
  EXPECT_TRUE(parse_surfaces(write_surfaces(fruit), "fruit.ply").instance.empty());
}

TEST(JoinedSurfaces, keep_the_numbers_of_instances) {
  DiffusionSurfaces placed = sphere(0.01, 2);
  placed.instance.assign(placed.triangle_count(), 3);
  const DiffusionSurfaces plain = sphere(0.02, 2), both = joined(plain, placed);
  ASSERT_EQ(both.instance.size(), both.triangle_count());
  EXPECT_EQ(both.instance.front(), 0);
  EXPECT_EQ(both.instance.back(), 3);
  EXPECT_EQ(joined(placed, plain).instance.back(), 0);
  EXPECT_TRUE(joined(plain, plain).instance.empty());
}

std::string text(float value) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

/// A ball in a given format, quadrilaterals and strange properties included.
std::string foreign_file(const std::string& format, const std::string& line_end) {
  const bool ascii = format == "ascii", big = format == "binary_big_endian";
  std::string bytes = "ply\nformat " + format + " 1.0\ncomment made elsewhere\ncomment surface finish: glossy\n" +
                      "obj_info nothing\nelement vertex 8\nproperty float x\nproperty float y\nproperty double z\n" +
                      "property short quality\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n" +
                      "element face 6\nproperty list uchar float uv\nproperty list int uint vertex_index\nend_header\n";
  const auto put = [&](auto value) {
    if (ascii) {
      bytes += text(static_cast<float>(value)) + " ";
      return;
    }
    std::array<char, sizeof(value)> raw{};
    std::memcpy(raw.data(), &value, sizeof(value));
    if (big) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
  };
  for (int v = 0; v < 8; ++v) {
    put((v & 1) != 0 ? 0.1f : 0.0f);
    put((v & 2) != 0 ? 0.1f : 0.0f);
    put((v & 4) != 0 ? 0.125 : 0.0);
    put(static_cast<std::int16_t>(-v));
    for (int k = 0; k < 3; ++k) put(static_cast<std::uint8_t>(40 * k + v));
    if (ascii) bytes += "\n";
  }
  constexpr std::array<std::array<std::uint32_t, 4>, 6> faces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& face : faces) {
    put(std::uint8_t{1});
    put(0.5f);
    put(std::int32_t{4});
    for (const std::uint32_t corner : face) put(corner);
    if (ascii) bytes += "\n";
  }
  if (line_end != "\n") {
    for (std::size_t at = 0; (at = bytes.find('\n', at)) != std::string::npos; at += line_end.size()) {
      bytes.replace(at, 1, line_end);
    }
  }
  return bytes;
}

TEST(SurfaceFile, AllEncodingsAgree) {
  const DiffusionSurfaces ascii = parse_surfaces(foreign_file("ascii", "\n"), "a.ply");
  EXPECT_EQ(ascii.triangle_count(), 12u);
  EXPECT_EQ(ascii.front_color[3], from_srgb8({3, 43, 83}));
  EXPECT_EQ(ascii.back_color, ascii.front_color);
  expect_equal(parse_surfaces(foreign_file("ascii", "\r\n"), "a.ply"), ascii);
  expect_equal(parse_surfaces(foreign_file("binary_little_endian", "\n"), "a.ply"), ascii);
  expect_equal(parse_surfaces(foreign_file("binary_big_endian", "\n"), "a.ply"), ascii);
}

/// A tetrahedron whose corners are the last of so many vertices; its faces name them in the scalar type `Index`.
template <typename Index>
std::string tetrahedron_at_the_end(const std::string& type, std::uint32_t vertices) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(vertices) +
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face 4\nproperty list " + type +
                      " " + type + " vertex_indices\nend_header\n";
  const auto put = [&](auto value) {
    char raw[sizeof(value)];
    std::memcpy(raw, &value, sizeof(value));
    bytes.append(raw, sizeof(value));
  };
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const std::uint32_t corner = v + 4 >= vertices ? v + 4 - vertices : 0;
    for (std::uint32_t axis = 1; axis <= 3; ++axis) put(corner == axis ? 0.1f : 0.0f);
  }
  constexpr std::array<std::array<std::uint32_t, 3>, 4> faces{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  for (const auto& face : faces) {
    put(static_cast<Index>(3));
    for (const std::uint32_t corner : face) put(static_cast<Index>(vertices - 4 + corner));
  }
  return bytes;
}

/// The largest index of a type must not be read as a negative number.
template <typename Index>
void expect_tetrahedron(const std::vector<std::string>& types) {
  const auto highest = static_cast<std::uint64_t>(std::numeric_limits<Index>::max());
  const auto vertices = static_cast<std::uint32_t>(std::min<std::uint64_t>(highest + 1, 70'000));
  for (const std::string& type : types) {
    const DiffusionSurfaces read = parse_surfaces(tetrahedron_at_the_end<Index>(type, vertices), "a.ply");
    ASSERT_EQ(read.triangle_count(), 4u) << type;
    EXPECT_NEAR(find_bodies(read).bodies.at(0).volume, 1e-3 / 6, 1e-9) << type;
  }
}

TEST(SurfaceFile, EveryWholeScalarTypeCountsToItsEnd) {
  expect_tetrahedron<std::int8_t>({"char", "int8"});
  expect_tetrahedron<std::uint8_t>({"uchar", "uint8"});
  expect_tetrahedron<std::int16_t>({"short", "int16"});
  expect_tetrahedron<std::uint16_t>({"ushort", "uint16"});
  expect_tetrahedron<std::int32_t>({"int", "int32"});
  expect_tetrahedron<std::uint32_t>({"uint", "uint32"});
}

TEST(SurfaceFile, WithoutFlagsTheOutermostShellIsSkin) {
  const DiffusionSurfaces box = parse_surfaces(foreign_file("ascii", "\n"), "a.ply");
  EXPECT_TRUE(box.is_hidden(0, SideOf::front));
  EXPECT_NEAR(find_bodies(box).bodies.at(0).volume, 0.1 * 0.1 * 0.125, 1e-9);

  const DiffusionSurfaces nested = joined(turned_inside_out(sphere(1, 4)), joined(sphere(0.5, 4), open_sheet(1, 0)));
  const DiffusionSurfaces read = parse_surfaces(write_surfaces(nested), "a.ply");
  const Bodies found = find_bodies(read);
  ASSERT_EQ(found.bodies.size(), 1u);
  EXPECT_NEAR(found.bodies[0].volume, signed_volume(sphere(1, 4)), 1e-6);
  EXPECT_TRUE(read.is_hidden(0, SideOf::back));
  EXPECT_EQ(found.of_triangle.back(), Bodies::none);
}

TEST(SurfaceFile, AShellWhoseHiddenSideFacesInwardsIsRefusedByItsName) {
  Paint wall;
  wall.back_hidden = true;
  const auto told = [](const DiffusionSurfaces& surfaces) -> std::string {
    try {
      parse_surfaces(write_surfaces(surfaces), "a.ply");
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  const DiffusionSurfaces skin = sphere(1, 4, skin_paint()), alone = sphere(1, 4, wall),
                          beside = moved(sphere(0.5, 4, wall), {3, 0, 0});
  EXPECT_THAT(told(alone), testing::ContainsRegex("a.ply:[0-9]+:1: error: surface \"surface\" is inside out"));
  EXPECT_THAT(told(joined(skin, beside)), testing::HasSubstr("is inside out: the side of its shell at 3"));
  EXPECT_THAT(told(joined(alone, sphere(0.5, 4, wall))), testing::HasSubstr("is inside out"));
  EXPECT_EQ(told(joined(skin, sphere(0.5, 4, wall))), "no error") << "the wall of a hollow";
  EXPECT_EQ(told(joined(skin, sphere(0.5, 4, skin_paint()))), "no error") << "a seed in the flesh";
  EXPECT_EQ(told(turned_inside_out(skin)), "no error") << "both its faces and its flags are turned";
}

TEST(SurfaceFile, ASheetOnTheSkinsOwnVerticesStaysInner) {
  // A triangle inside a ball that uses three of the skin's vertices.
  DiffusionSurfaces ball = sphere(1, 4);
  ball.triangle.emplace_back(ball.triangle[0].x, ball.triangle[30].y, ball.triangle[60].z);
  ball.surface.push_back(0);
  ball.front_part.push_back(0);
  ball.back_part.push_back(0);
  const DiffusionSurfaces read = parse_surfaces(write_surfaces(ball), "a.ply");
  EXPECT_EQ(read.vertex_count(), ball.vertex_count() + 3);
  EXPECT_FALSE(read.is_boundary(read.triangle_count() - 1));
  EXPECT_EQ(find_bodies(read).bodies.size(), 1u);
  for (std::size_t t = 0; t < ball.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(read.position.at(read.triangle[t][k]), ball.position[ball.triangle[t][k]])
          << "what is doubled stays there";
  }
}

TEST(SurfaceFile, NothingIsDoubledWhereSkinAndInnerSurfacesShareNoVertex) {
  for (const bool inner_first : {false, true}) {
    const DiffusionSurfaces skin = sphere(1, 4), inner = sphere(0.5, 4);
    const DiffusionSurfaces both = inner_first ? joined(inner, skin) : joined(skin, inner);
    EXPECT_EQ(parse_surfaces(write_surfaces(both), "a.ply").vertex_count(), both.vertex_count()) << inner_first;
  }
}

TEST(SurfaceFile, TrianglesMayHaveVerticesOfTheirOwn) {
  const DiffusionSurfaces ball = sphere(1, 20);
  DiffusionSurfaces loose = ball;
  loose.position.clear();
  const auto unshared = [&](auto& loose_values, const auto& values) {
    loose_values.clear();
    for (const glm::uvec3& t : ball.triangle)
      for (int k = 0; k < 3; ++k) loose_values.push_back(values[t[k]]);
  };
  unshared(loose.position, ball.position);
  unshared(loose.front_color, ball.front_color);
  unshared(loose.back_color, ball.back_color);
  unshared(loose.blur, ball.blur);
  unshared(loose.front_hidden, ball.front_hidden);
  unshared(loose.back_hidden, ball.back_hidden);
  for (std::uint32_t t = 0; t < loose.triangle_count(); ++t) loose.triangle[t] = {3 * t, 3 * t + 1, 3 * t + 2};
  ASSERT_GT(loose.vertex_count(), 2000u);
  EXPECT_EQ(parse_surfaces(write_surfaces(loose), "a.ply").position, loose.position);
}

TEST(SurfaceFile, WhatIsTooLargeIsRefusedUnreadAndByName) {
  const std::size_t size = (std::size_t{512} << 20) + 1;
  const auto bytes = std::make_unique_for_overwrite<char[]>(size);  // nobody reads them, so they take no memory
  try {
    parse_surfaces({bytes.get(), size}, "huge.ply");
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    EXPECT_THAT(error.what(), testing::StartsWith("huge.ply: error: the file is larger than 512 MiB"));
  }
}

TEST(SurfaceFile, AMissingFileIsMissingInput) {
  try {
    read_surfaces("/nowhere/at/all.ply");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::input_missing);
  }
}

struct BadFile {
  const char* name;
  const char* message;  ///< the message, beginning with its place
};

class BadSurfaceFile : public testing::TestWithParam<BadFile> {};

constexpr BadFile bad_files[] = {
    {"binary_ends_in_face", ":face 0, byte 299: error: the file ends early"},
    {"binary_long_list", ":face 0, byte 289: error: the file is too short for this list"},
    {"binary_nan", ":vertex 1, byte 256: error: this number is not finite"},
    {"binary_negative_blur", ":vertex 1, byte 267: error: blur is below 0"},
    {"binary_surface_number", ":face 0, byte 302: error: surfaces, parts and instances are numbered from 0 to 65535"},
    {"binary_truncated", ":3:1: error: the file is too short for 3 of \"vertex\""},
    {"both_hidden", ":15:7: error: this face hides both its sides"},
    {"corner_out_of_range", ":13:7: error: there is no such vertex"},
    {"count_not_a_number", ":3:16: error: \"three\" is not a number of elements"},
    {"element_twice", ":7:9: error: element \"vertex\" is declared twice"},
    {"empty", ":1:1: error: the header does not end"},
    {"ends_early", ":14:1: error: the file ends early"},
    {"far_away", ":11:1: error: this number is too large"},
    {"float_list_length", ":8:15: error: a list's length must have an integer type"},
    {"future_version", ":2:14: error: only version 1.0 of PLY is known"},
    {"header_without_end", ":9:1: error: the header does not end"},
    {"huge_count", ":3:1: error: the file is too short for 4000000000 of \"vertex\""},
    {"infinite", ":11:5: error: this number is not finite"},
    {"negative_corner", ":13:5: error: there is no such vertex"},
    {"negative_count", ":3:16: error: \"-3\" is not a number of elements"},
    {"no_corners", ":7:1: error: faces need the list vertex_indices"},
    {"no_faces", ":1:1: error: the file has no faces"},
    {"no_format", ":8:1: error: the header has no format line"},
    {"no_height", ":3:1: error: vertices need the properties x, y and z"},
    {"no_size", ":3:1: error: the surfaces have no size"},
    {"not_a_number", ":11:5: error: this is not a number"},
    {"not_ply", ":1:1: error: this is no PLY file"},
    {"property_before_element", ":3:1: error: a property before the first element"},
    {"too_large", ":3:1: error: the mesh is larger than 1000 km"},
    {"two_corners", ":7:1: error: the file has no faces"},
    {"unknown_format", ":2:8: error: format \"ascii_utf16\" is not known"},
    {"unknown_keyword", ":7:1: error: \"elephant\" has no meaning in a PLY header"},
    {"unknown_type", ":5:10: error: \"quaternion\" is not a type"},
    {"zero_faces", ":7:1: error: the file has no faces"},
};

const std::filesystem::path bad_folder = std::filesystem::path(POMONA_SOURCE_DIR) / "tests/surface/bad";

TEST_P(BadSurfaceFile, IsRefusedWithItsPlace) {
  const std::filesystem::path file = bad_folder / (std::string(GetParam().name) + ".ply");
  try {
    read_surfaces(file);
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    EXPECT_THAT(error.what(), testing::StartsWith(file.string() + GetParam().message));
  }
}

INSTANTIATE_TEST_SUITE_P(Files, BadSurfaceFile, testing::ValuesIn(bad_files),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(SurfaceFile, FacesOfTwoCornersAreLeftOutAndTold) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 3\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n0.1 0 0\n0 0.1 0\n"
      "2 0 1\n3 0 1 2\n0\n";
  const DiffusionSurfaces surfaces = parse_surfaces(text, "x.ply");
  EXPECT_EQ(surfaces.triangle_count(), 1u);
  EXPECT_THAT(surfaces.notes, testing::ElementsAre("2 faces of less than three corners are left out"));
  EXPECT_EQ(parse_plain_surfaces(text, "x.ply", {}).notes, surfaces.notes);
}

TEST(SurfaceFile, EveryBadFileIsInTheTable) {
  std::set<std::string> listed, present;
  for (const BadFile& bad : bad_files) listed.insert(bad.name);
  for (const auto& entry : std::filesystem::directory_iterator(bad_folder))
    present.insert(entry.path().stem().string());
  EXPECT_EQ(listed, present);
}

TEST(SurfaceFile, CutShortOrScrambledItNeverCrashes) {
  const std::string whole = write_surfaces(joined(sphere(1, 2, skin_paint()), sphere(0.5, 1)));
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    EXPECT_THROW(parse_surfaces(std::string_view(whole).substr(0, size), "a.ply"), Error);
  }
  for (std::size_t at = 0; at < whole.size(); at += 3) {
    std::string scrambled = whole;
    scrambled[at] = static_cast<char>(scrambled[at] ^ 0x91);
    try {
      find_bodies(parse_surfaces(scrambled, "a.ply"));
    } catch (const Error&) {
    }
  }
}

}  // namespace
}  // namespace pomona
