#include "tests/surface/mesh_files.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>

namespace pomona::mesh_files {

namespace {

constexpr std::array<std::array<float, 3>, 8> corners{
    {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}}};
constexpr std::array<std::array<std::uint16_t, 4>, 6> faces{
    {{2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}, {1, 3, 7, 5}, {0, 4, 6, 2}}};

template <typename T>
void put(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof(T));
  bytes.append(raw.data(), raw.size());
}

}  // namespace

std::string cube_obj() {
  std::string text = "# a cube\nmtllib cube.mtl\n";
  for (const auto& c : corners) {
    text += "v";
    for (const float x : c) text += x < 0 ? " -1.0" : " +1.0";
    text += "\n";
  }
  text += "vt 0 0\nvn 0 1 0\n";
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (f == 0) text += "o lid\ns off\n";
    if (f == 1) text += "o box\r\nusemtl wood\r\n";
    text += "f";
    for (const std::uint16_t v : faces[f]) {
      text += " " + (f == 2 ? std::to_string(static_cast<int>(v) - 8) : std::to_string(v + 1)) + "/1/1";
    }
    text += "\n";
  }
  return text;
}

std::string cube_bin() {
  std::string bin;
  for (const auto& c : corners) {
    for (const float x : c) put(bin, x);
  }
  for (std::size_t v = 0; v < corners.size(); ++v) {
    bin += std::string{static_cast<char>(255), 0, static_cast<char>(51), static_cast<char>(255)};
  }
  for (const auto& f : faces) {
    for (const int k : {0, 1, 2, 0, 2, 3}) put(bin, f[static_cast<std::size_t>(k)]);
  }
  return bin;
}

std::string cube_json(const Change& change) {
  std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
      R"("nodes":[{"children":[1,2],"translation":[0,1,0]},{"name":"lid","mesh":0},{"name":"box","mesh":1}],)"
      R"("meshes":[{"name":"lid_data","primitives":[{"attributes":{"POSITION":0,"COLOR_0":1},"indices":2}]},)"
      R"({"name":"box_data","primitives":[{"attributes":{"POSITION":0,"COLOR_0":1},"indices":3}]}],)"
      R"("buffers":[{"byteLength":200}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":96},)"
      R"({"buffer":0,"byteOffset":96,"byteLength":32},{"buffer":0,"byteOffset":128,"byteLength":72}],"accessors":[)"
      R"({"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},)"
      R"({"bufferView":1,"componentType":5121,"normalized":true,"count":8,"type":"VEC4"},)"
      R"({"bufferView":2,"componentType":5123,"count":6,"type":"SCALAR"},)"
      R"({"bufferView":2,"byteOffset":12,"componentType":5123,"count":30,"type":"SCALAR"}]})";
  if (const std::size_t at = json.find(change.from); !change.from.empty() && at != std::string::npos) {
    json.replace(at, change.from.size(), change.to);
  }
  return json;
}

std::string glb(std::string json, std::string bin) {
  while (json.size() % 4 != 0) json += ' ';
  while (bin.size() % 4 != 0) bin += '\0';
  std::string bytes = "glTF";
  put(bytes, std::uint32_t{2});
  put(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + bin.size()));
  put(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  put(bytes, static_cast<std::uint32_t>(bin.size()));
  bytes += std::string("BIN\0", 4) + bin;
  return bytes;
}

std::string obj_of(const DiffusionSurfaces& surfaces, const std::string& name) {
  std::string text = "o " + name + "\n";
  for (const glm::vec3& p : surfaces.position) {
    text += "v";
    for (int k = 0; k < 3; ++k) {
      std::array<char, 32> number{};
      text += " " + std::string(number.data(),
                                std::to_chars(number.data(), number.data() + 32, static_cast<double>(p[k])).ptr);
    }
    text += "\n";
  }
  for (const glm::uvec3& t : surfaces.triangle) {
    text += "f";
    for (int k = 0; k < 3; ++k) text += " " + std::to_string(t[k] + 1);
    text += "\n";
  }
  return text;
}

std::string glb_of(const DiffusionSurfaces& surfaces, const std::string& name) {
  std::string bin;
  for (const glm::vec3& p : surfaces.position) {
    for (int k = 0; k < 3; ++k) put(bin, p[k]);
  }
  const std::size_t middle = bin.size();
  for (const glm::uvec3& t : surfaces.triangle) {
    for (int k = 0; k < 3; ++k) put(bin, static_cast<std::uint32_t>(t[k]));
  }
  const auto number = [](std::size_t value) { return std::to_string(value); };
  return glb(R"({"asset":{"version":"2.0"},"nodes":[{"name":")" + name +
                 R"(","mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
                 R"("buffers":[{"byteLength":)" +
                 number(bin.size()) + R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + number(middle) +
                 R"(},{"buffer":0,"byteOffset":)" + number(middle) + R"(,"byteLength":)" + number(bin.size() - middle) +
                 R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
                 number(surfaces.vertex_count()) +
                 R"(},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" +
                 number(3 * surfaces.triangle_count()) + "}]}",
             bin);
}

}  // namespace pomona::mesh_files
