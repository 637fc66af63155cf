// Meshes of programs that deviate from the formats are read as intended, or reported.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/surface/file/obj_file.h"
#include "generator/surface/file/plain_mesh_file.h"
#include "generator/surface/file/surface_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/surface/mesh_files.h"

namespace pomona {
namespace {

using namespace mesh_files;
using ::testing::HasSubstr;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string message_of(const std::function<void()>& run) {
  try {
    run();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    return error.what();
  }
  return "no error";
}

void expect_same(const PlainMesh& mesh, const PlainMesh& as) {
  EXPECT_EQ(mesh.position, as.position);
  EXPECT_EQ(mesh.triangle, as.triangle);
  EXPECT_EQ(mesh.color, as.color);
}

const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

// ---- OBJ ----

TEST(ObjDialect, AMarkIsNoPartOfTheFirstKeyword) {
  const PlainMesh plain = parse_obj(tetrahedron, "x", "");
  expect_same(parse_obj("\xEF\xBB\xBF" + tetrahedron, "x", ""), plain);
  EXPECT_THAT(message_of([] { parse_obj(std::string("\xFF\xFEv\0 \0", 6), "x.obj", ""); }), HasSubstr("UTF-16"));
}

TEST(ObjDialect, AnyLineEndEndsALine) {
  const PlainMesh plain = parse_obj(cube_obj(), "x", "box");
  const std::string with_lf = replaced(cube_obj(), "\r\n", "\n");
  for (const char* end : {"\n", "\r", "\r\n"}) {
    expect_same(parse_obj(replaced(with_lf, "\n", end), "x", "box"), plain);
    EXPECT_THAT(message_of([&] { parse_obj(replaced("v 0 0 0\nv 1 0 0\nv 0 1\n", "\n", end), "x.obj", ""); }),
                HasSubstr("x.obj:3:6: error: a vertex needs three numbers"));
  }
}

TEST(ObjDialect, ABackslashJoinsLines) {
  const PlainMesh plain = parse_obj(tetrahedron, "x", "");
  for (const char* joint : {" \\\n ", "\\\n", " \\\r\n\t", " \\ \n", " \\\n\\\n "}) {
    std::string broken =
        replaced(tetrahedron, "v 0 1 0", "v 0" + std::string(joint == std::string("\\\n") ? " " : "") + joint + "1 0");
    broken = replaced(broken, "f 2 3 4", "f 2 3 " + std::string(joint) + "4");
    expect_same(parse_obj(broken, "x", ""), plain);
  }
  EXPECT_THAT(message_of([] { parse_obj("v 0 0 \\\n  x\n", "x.obj", ""); }),
              HasSubstr("x.obj:2:3: error: this is not"));
  EXPECT_THAT(message_of([] { parse_obj("v 0 0 \\\n 0\nv 1 \\\n\\\n y\n", "x.obj", ""); }), HasSubstr("x.obj:5:2"));
  // Neither a comment nor the name of a file continues on the next line.
  expect_same(parse_obj("# from C:\\meshes\\\nmtllib C:\\looks\\\n" + tetrahedron, "x", ""), plain);
}

TEST(ObjDialect, ACommentMayStandBehindNumbers) {
  const PlainMesh plain = parse_obj(tetrahedron, "x", "");
  expect_same(parse_obj(replaced(tetrahedron, "v 1 0 0", "v 1 0 0 # the tip \\"), "x", ""), plain);
  expect_same(parse_obj(replaced(tetrahedron, "f 2 3 4", "f 2 3 4# front"), "x", ""), plain);
  EXPECT_EQ(parse_obj("o skin # outside\n" + tetrahedron, "x", "skin").triangle.size(), 4u);
  EXPECT_EQ(parse_obj("o plum #2\n" + tetrahedron, "x", "plum #2").triangle.size(), 4u);
  EXPECT_THAT(message_of([] { parse_obj("v 0 1.#IND 0\n", "x.obj", ""); }), HasSubstr("x.obj:1:5: error: this is not"));
}

TEST(ObjDialect, FacesMayStandBeforeTheirVertices) {
  const std::string vertices = tetrahedron.substr(0, tetrahedron.find('f')),
                    faces = tetrahedron.substr(vertices.size());
  expect_same(parse_obj(faces + vertices, "x", ""), parse_obj(tetrahedron, "x", ""));
  EXPECT_THAT(message_of([&] { parse_obj("f 1 2 3\nf 1 5 6\n" + vertices, "x.obj", ""); }),
              HasSubstr("x.obj:2:5: error: there is no such vertex"));
}

TEST(ObjDialect, WhatIsNotReadIsTold) {
  EXPECT_THAT(message_of([] { parse_obj("v 0 0 0\ncstype bezier\nsurf 0 1 0 1 1\n", "x.obj", ""); }),
              HasSubstr("x.obj:3:1: error: \"surf\" makes a curved surface"));
  EXPECT_THAT(message_of([] { parse_obj("call more.obj\n", "x.obj", ""); }), HasSubstr("leads to another file"));
  EXPECT_THAT(message_of([] { parse_obj("V 0 0 0\n", "x.obj", ""); }), HasSubstr("small letters"));
  EXPECT_THAT(message_of([] { parse_obj("v 0 0 0\n1 2 3\n", "x.obj", ""); }), HasSubstr("x.obj:2:1: error: a line"));
}

TEST(ObjDialect, ObjectsComeBeforeGroups) {
  const std::string faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no skin\nf 1 2 3\no other\ng skin\nf 1 2 4\n";
  EXPECT_EQ(parse_obj(faces, "x", "skin").triangle.size(), 1u);
  EXPECT_EQ(parse_obj(replaced(faces, "o skin", "o first"), "x", "skin").triangle.size(), 1u);
  EXPECT_EQ(parse_obj(replaced(faces, "g skin", "g left skin"), "x", "left").triangle.size(), 1u);
}

TEST(ObjDialect, AVertexHasThreeNumbersAWeightOrAColour) {
  for (const char* numbers : {"", " 1", " 1 0 0", " 1 0 0 1"})
    EXPECT_EQ(parse_obj(replaced(tetrahedron, "v 1 0 0", "v 1 0 0" + std::string(numbers)), "x", "").triangle.size(),
              4u);
  for (const char* numbers : {" 1 0", " 1 0 0 1 0", " 1 0 0 1 0 0"}) {
    const std::string text = replaced(tetrahedron, "v 1 0 0", "v 1 0 0" + std::string(numbers));
    EXPECT_THAT(message_of([&] { parse_obj(text, "x.obj", ""); }), HasSubstr("error: a vertex has 3 numbers"));
  }
}

TEST(ObjDialect, ACornerTwiceInARowIsOne) {
  expect_same(parse_obj(replaced(tetrahedron, "f 2 3 4", "f 2 2 3 4 4 2"), "x", ""), parse_obj(tetrahedron, "x", ""));
}

TEST(ObjDialect, ColoursMayBeBytes) {
  const std::string bytes = "v 0 0 0 255 0 128\nv 1 0 0 255 0 128\nv 0 1 0 255 0 128\nf 1 2 3\n";
  const PlainMesh mesh = parse_obj(bytes, "x", "");
  EXPECT_FLOAT_EQ(mesh.color[0].r, 1.0f);
  EXPECT_FLOAT_EQ(mesh.color[0].b, static_cast<float>(linear_from_srgb(128 / 255.0)));
}

TEST(ObjDialect, AConcaveFaceStaysWithinItself) {
  const std::string c = "v 4 1 0\nv 1 1 0\nv 1 3 0\nv 4 3 0\nv 4 4 0\nv 0 4 0\nv 0 0 0\nv 4 0 0\nf 1 2 3 4 5 6 7 8\n";
  const PlainMesh mesh = parse_obj(c, "x", "");
  double area = 0;
  for (const glm::uvec3& t : mesh.triangle)
    area += glm::length(glm::cross(mesh.position[t.y] - mesh.position[t.x], mesh.position[t.z] - mesh.position[t.x]));
  EXPECT_DOUBLE_EQ(area / 2, 10.0);
  EXPECT_THAT(message_of([] { parse_obj("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n", "x.obj", ""); }),
              HasSubstr("x.obj:5:1: error: this face crosses or touches itself"));
}

// ---- PLY ----

std::string ply(const std::string& vertices, const std::string& faces, const std::string& vertex = "",
                const std::string& face = "", const std::string& type = "float") {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type +
         " z\n" + vertex + "element face 4\nproperty list uchar int vertex_indices\n" + face + "end_header\n" +
         vertices + faces;
}
const std::string ply_vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string ply_faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

std::string written(const std::string& bytes) { return write_surfaces(parse_surfaces(bytes, "x.ply")); }

TEST(PlyDialect, AMarkAndAnyLineEndAreRead) {
  const std::string plain = ply(ply_vertices, ply_faces), as = written(plain);
  EXPECT_TRUE(written("\xEF\xBB\xBF" + plain) == as);
  for (const char* end : {"\r", "\r\n"}) EXPECT_TRUE(written(replaced(plain, "\n", end)) == as);
  EXPECT_THAT(message_of([&] { written(replaced(replaced(plain, "0 0 1", "0 0 x"), "\n", "\r")); }),
              HasSubstr("x.ply:13:5: error"));
}

TEST(PlyDialect, BinaryValuesBeginBehindTheHeadersOwnLineEnd) {
  // The first byte of the first number is a line feed.
  std::string binary = write_surfaces(parse_surfaces(ply(replaced(ply_vertices, "0 0 0", "0 0 0.25"), ply_faces), "x"));
  const std::size_t header = binary.find("end_header\n") + 11;
  binary[header] = '\n';
  const std::string lf = written(binary);
  for (const char* end : {"\r", "\r\n"})
    EXPECT_TRUE(written(replaced(binary.substr(0, header), "\n", end) + binary.substr(header)) == lf);
}

TEST(PlyDialect, StripsAreTriangles) {
  const std::string strips =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
      ply_vertices + "10 0 2 1 3 -1 0 3 2 -1 0 1 \n";
  // 0 2 1, 2 3 1 turned, then 0 3 2; the last strips are too short.
  const PlainMesh mesh = parse_plain_surfaces(strips, "x", "");
  EXPECT_EQ(mesh.triangle.size(), 3u);
  const DiffusionSurfaces surfaces = parse_surfaces(strips, "x");
  EXPECT_EQ(surfaces.triangle, (std::vector<glm::uvec3>{{0, 2, 1}, {2, 3, 1}, {0, 3, 2}}));
}

TEST(PlyDialect, RangeGridsAreNamed) {
  EXPECT_THAT(message_of([] {
                written(
                    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                    "element range_grid 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0\n");
              }),
              HasSubstr("range_grid"));
}

std::string colored(const std::string& type, const std::string& names, const std::string& values) {
  std::string properties;
  for (const char channel : std::string("012")) {
    std::string name = names;
    name = replaced(name, "*", std::string(1, channel));
    for (const auto& [digit, word] : {std::pair("0", "red"), std::pair("1", "green"), std::pair("2", "blue")})
      name = replaced(name, digit, names.size() > 1 ? word : std::string(word).substr(0, 1));
    properties += "property " + type + " " + name + "\n";
  }
  return ply(replaced(ply_vertices, "\n", " " + values + "\n"), ply_faces, properties);
}

TEST(PlyDialect, ColoursHaveManyNamesAndScales) {
  const std::string as = written(colored("uchar", "_*", "128 64 32"));
  const auto has_color = [&](const std::string& bytes) {
    const DiffusionSurfaces surfaces = parse_surfaces(bytes, "x");
    for (const Color& color : surfaces.front_color) {
      EXPECT_FLOAT_EQ(color.r, static_cast<float>(linear_from_srgb(128 / 255.0)));
      EXPECT_FLOAT_EQ(color.b, static_cast<float>(linear_from_srgb(32 / 255.0)));
    }
  };
  has_color(replaced(colored("uchar", "_*", "128 64 32"), " _", " "));
  has_color(colored("uchar", "diffuse_*", "128 64 32"));
  has_color(colored("uchar", "*", "128 64 32"));
  has_color(colored("float", "diffuse_*", "128 64 32"));
  has_color(colored("float", "diffuse_*", "0.50196078 0.25098039 0.12549020"));
  has_color(replaced(colored("uchar", "diffuse_*", "128 64 32"), "diffuse_red", "Diffuse_Red"));
}

TEST(PlyDialect, ColoursAtFacesGoToTheirCorners) {
  const std::string face = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const std::string faces = "3 0 2 1 255 0 0\n3 0 1 3 255 0 0\n3 0 3 2 0 255 0\n3 1 2 3 0 255 0\n";
  const DiffusionSurfaces surfaces = parse_surfaces(ply(ply_vertices, faces, "", face), "x");
  EXPECT_EQ(surfaces.triangle_count(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(surfaces.front_color[surfaces.triangle[i][k]], i < 2 ? Color(1, 0, 0) : Color(0, 1, 0));
      EXPECT_EQ(surfaces.back_color[surfaces.triangle[i][k]], i < 2 ? Color(1, 0, 0) : Color(0, 1, 0));
    }
  }
}

TEST(PlyDialect, ColoursInAPictureAreTold) {
  const std::string bytes =
      replaced(ply(ply_vertices, ply_faces), "ascii 1.0\n", "ascii 1.0\ncomment TextureFile skin.png\n");
  const DiffusionSurfaces surfaces = parse_surfaces(bytes, "x");
  ASSERT_EQ(surfaces.notes.size(), 1u);
  EXPECT_THAT(surfaces.notes[0], HasSubstr("skin.png"));
  EXPECT_EQ(parse_plain_surfaces(bytes, "x", "").notes, surfaces.notes);
}

TEST(PlyDialect, ColoursByOtherNamesAreTold) {
  const auto notes_with = [](const std::string& property) {
    const std::string values = replaced(ply_vertices, "\n", " 9\n");
    return parse_surfaces(ply(values, ply_faces, "property " + property + "\n"), "x").notes;
  };
  for (const char* property : {"float ambient_red", "uint rgb", "float f_dc_0", "uchar Intensity", "uchar red"}) {
    const std::vector<std::string> notes = notes_with(property);
    ASSERT_EQ(notes.size(), 1u) << property;
    EXPECT_THAT(notes[0], HasSubstr("a name that is not read"));
  }
  for (const char* property : {"float quality", "float blur", "uchar scattered"})
    EXPECT_TRUE(notes_with(property).empty()) << property;
}

TEST(PlyDialect, AConcaveFaceStaysWithinItselfAlsoBeforeItsVertices) {
  const std::string c = "4 1 0\n1 1 0\n1 3 0\n4 3 0\n4 4 0\n0 4 0\n0 0 0\n4 0 0\n";
  const std::string vertex = "element vertex 8\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string head = "ply\nformat ascii 1.0\n", corners = "8 0 1 2 3 4 5 6 7\n";
  for (const std::string& bytes :
       {head + vertex + face + "end_header\n" + c + corners, head + face + vertex + "end_header\n" + corners + c}) {
    const DiffusionSurfaces surfaces = parse_surfaces(bytes, "x");
    double area = 0;
    for (const glm::uvec3& t : surfaces.triangle) {
      const glm::dvec3 a(surfaces.position[t.x]), b(surfaces.position[t.y]), d(surfaces.position[t.z]);
      area += glm::length(glm::cross(b - a, d - a)) / 2;
    }
    EXPECT_DOUBLE_EQ(area, 10.0);
  }
}

// ---- Far away ----

TEST(FarAway, WhatRoundingWouldSpoilIsRefusedAndPlacedInDoubles) {
  const std::string near = ply(ply_vertices, ply_faces, "", "", "double");
  std::string far = near;
  far = replaced(far, "0 0 0\n", "448262.25 0 -5000000\n");
  far = replaced(far, "1 0 0\n", "448262.35 0 -5000000\n");
  far = replaced(far, "0 1 0\n", "448262.25 0.1 -5000000\n");
  far = replaced(far, "0 0 1\n", "448262.25 0 -4999999.9\n");
  EXPECT_THAT(message_of([&] { parse_surfaces(far, "x.ply"); }), HasSubstr("km from the origin"));
  const DiffusionSurfaces moved = parse_surfaces(far, "x.ply", {.unit = 1, .at = {-448262.25, 0, 5000000}});
  EXPECT_NEAR(glm::length(bounds_of(moved).size()), std::sqrt(0.03), 1e-7);
  EXPECT_NEAR(parse_plain_surfaces(far, "x.ply", "").position[1].x, 448262.25, 0.2);
}

// ---- Endings ----

TEST(Endings, MayBeInCapitals) {
  const TemporaryFolder folder;
  std::ofstream(folder / "A.OBJ") << tetrahedron;
  std::ofstream(folder / "A.Ply") << ply(ply_vertices, ply_faces);
  std::ofstream(folder / "A.GLB") << cube_glb();
  EXPECT_EQ(read_plain_mesh(folder / "A.OBJ").triangle.size(), 4u);
  EXPECT_EQ(read_plain_mesh(folder / "A.Ply").triangle.size(), 4u);
  EXPECT_EQ(read_plain_mesh(folder / "A.GLB").triangle.size(), 12u);
}

/// Line ends of old Macs: the end of the previous line does not count as an empty line.
TEST(PlyDialect, EmptyLinesBetweenBareCarriageReturnsAreTold) {
  for (const char* text : {"ply\r\r\r\r", "ply\r\rformat ascii 1.0\rend_header\r", "ply\r\n\r\n\r\n"})
    EXPECT_THROW(parse_surfaces(text, "x.ply"), Error) << text;
}

}  // namespace
}  // namespace pomona
