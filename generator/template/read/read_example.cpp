#include "generator/template/read/read_example.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generator/base/error.h"
#include "generator/base/png_rows.h"
#include "generator/template/read/file_beside.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

// Limits of a tile: 48 texels a side are 110 592 in all, some 2 MB of memory with all levels.
constexpr int side_step = 16, max_side = 48;
constexpr std::size_t max_colors = 256;  // assets and pages have a byte for each texel
constexpr PngLimits tile_limits{.side = max_side * max_side, .pixels = max_side * max_side * max_side};
constexpr const char* tile_hint =
    "scripts/example_tile.py makes one: slices of 16 x 16, 32 x 32 or 48 x 48 texels, one "
    "below the other";

std::size_t color_count(const std::vector<glm::u8vec3>& texel) {
  std::set<std::uint32_t> colors;
  for (const glm::u8vec3& t : texel) colors.insert(std::uint32_t{t.r} << 16 | std::uint32_t{t.g} << 8 | t.b);
  return colors.size();
}

std::optional<PngRows> read_rows(const TomlValue& value, const std::string& bytes, const fs::path& file) {
  try {
    return read_png_rows(bytes, file.string(), PngPixels::rgb, tile_limits);
  } catch (const Error& error) {
    value.error("is " + error.diagnostics().front().message, tile_hint);
    return {};
  }
}

}  // namespace

std::shared_ptr<const ExampleTile> read_example(const TomlValue& value, const fs::path& folder) {
  const std::string name = value.text();  // notes a fault if it is no text
  if (!value.is(TomlNode::Kind::string)) return {};
  const std::optional<fs::path> file = file_beside(value, folder);
  if (!file) return {};
  const std::optional<std::string> bytes = bytes_beside(value, *file, max_example_bytes, tile_hint);
  if (!bytes) return {};
  const std::optional<PngRows> rows = read_rows(value, *bytes, *file);
  if (!rows) return {};

  const int side = rows->width;
  if (side % side_step != 0 || side > max_side || rows->height != side * side) {
    value.error("has " + std::to_string(side) + " x " + std::to_string(rows->height) + " pixels, which are no cube",
                tile_hint);
    return {};
  }
  std::vector<glm::u8vec3> texel;
  texel.reserve(rows->bytes.size() / 3);
  for (std::size_t i = 0; i < rows->bytes.size(); i += 3)
    texel.emplace_back(rows->bytes[i], rows->bytes[i + 1], rows->bytes[i + 2]);
  if (color_count(texel) > max_colors) {
    value.error("has more than 256 colours", tile_hint);
    return {};
  }
  return std::make_shared<const ExampleTile>(example_tile(file->string(), side, std::move(texel)));
}

}  // namespace pomona
