#include "render/page/asset_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include <nlohmann/json.hpp>

#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "generator/base/little_endian.h"
#include "generator/cut/spared.h"
#include "render/page/byte_planes.h"
#include "render/page/deflate.h"
#include "render/page/node_coding.h"
#include "render/page/windings.h"

namespace pomona {

namespace {

using nlohmann::ordered_json;

// The file's first eight bytes, and the limit of its unpacked size.
constexpr std::string_view magic("pomona\0\1", 8);
constexpr std::size_t max_bytes = std::size_t{1} << 28;
constexpr std::size_t max_header = std::size_t{1} << 20;
// Limit of rows of nodes that its triangles cross: a fruit of 100 000 triangles has some millions.
constexpr std::int64_t max_rows = 300'000'000;

// The rounding of nodes: the finest with which the asset's page, with five characters for four bytes and 0.16 MB of
// code, stays below 1.5 MB.
constexpr std::array<int, 3> rounding = {all_thirds, 8, 3};
constexpr std::size_t large_asset = 1'060'000;

/// The oldest format that says all of it.
int format_of(const Asset& asset) {
  if (!asset.tiles.empty()) return 4;
  return asset.shell.empty() ? 2 : 3;
}

ordered_json header_of(const Asset& a, int thirds, const std::string& made_by) {
  ordered_json header = {{"format", format_of(a)},
                         {"made_by", made_by},
                         {"name", a.name},
                         {"title", a.title},
                         {"latin", a.latin},
                         {"seed", a.seed},
                         {"diffuser", a.diffuser},
                         {"origin", {a.origin.x, a.origin.y, a.origin.z}},
                         {"spacing", a.spacing},
                         {"count", a.count},
                         {"units", a.units},
                         {"thirds", thirds},
                         {"vertices", a.position.size()},
                         {"triangles", a.triangle.size()},
                         {"parts", a.parts},
                         {"ink", to_hex(a.ink)},
                         {"ink_width", a.ink_width},
                         {"texels", {a.noise.size(), a.details.size(), a.materials.size()}},
                         {"skin_shares", a.skin_share.size()}};
  if (!a.spared.empty()) header["spared"] = a.spared;
  if (!a.shell.empty()) {
    const std::uint16_t count = *std::max_element(a.shell.begin(), a.shell.end());
    header["shells"] = {{"count", count}, {"nearly_as_much", nearly_as_much}};
  }
  for (const AssetTile& tile : a.tiles)
    header["tiles"].push_back({{"side", tile.side}, {"colors", tile.palette.size()}});
  if (a.guide) {
    header["guide"] = {
        {"stride", a.guide->stride}, {"unit", a.guide->unit}, {"count", a.guide->count}, {"deepest", a.guide->deepest}};
  }
  return header;
}

std::string arrays_of(const Asset& a, int thirds) {
  std::string bytes;
  const std::size_t vertices = a.position.size(), triangles = a.triangle.size();
  for (int k = 0; k < 3; ++k) bytes += planes_of(vertices, 1, 2, [&](std::size_t v) { return a.position[v][k]; });
  for (int k = 0; k < 3; ++k) bytes += planes_of(vertices, 1, 1, [&](std::size_t v) { return a.front_color[v][k]; });
  for (int k = 0; k < 3; ++k)
    bytes += planes_of(vertices, vertices + 1, 1, [&](std::size_t v) {
      return static_cast<std::uint8_t>(a.back_color[v][k] - a.front_color[v][k]);
    });
  for (int k = 0; k < 3; ++k) bytes += planes_of(triangles, 2, 3, [&](std::size_t t) { return a.triangle[t][k]; });
  bytes += planes_of(triangles, 1, 1, [&](std::size_t t) { return a.hidden[t]; });
  bytes += planes_of(triangles, 1, 2, [&](std::size_t t) { return a.front_part[t]; });
  bytes += planes_of(triangles, 1, 2, [&](std::size_t t) { return a.back_part[t]; });
  const std::vector<std::uint8_t> coded = coded_nodes(a, thirds);
  bytes.append(coded.begin(), coded.end());

  // Writes the paint.
  bytes += texel_bytes(a.noise) + texel_bytes(a.details) + texel_bytes(a.materials);
  for (const glm::u8vec4& share : a.skin_share)
    for (int k = 0; k < 4; ++k) bytes += static_cast<char>(share[k]);
  if (a.guide) {
    for (int k = 0; k < 4; ++k)
      bytes += planes_of(a.guide->value.size(), 1, 2,
                         [&](std::size_t i) { return static_cast<std::uint16_t>(a.guide->value[i][k]); });
    for (const glm::u8vec4& share : a.guide->share)
      for (int k = 0; k < 4; ++k) bytes += static_cast<char>(share[k]);
  }
  bytes += planes_of(a.shell.size(), 1, 2, [&](std::size_t t) { return a.shell[t]; });
  for (const AssetTile& tile : a.tiles) {
    for (const glm::u8vec3& color : tile.palette)
      for (int k = 0; k < 3; ++k) bytes += static_cast<char>(color[k]);
    bytes.append(tile.texel.begin(), tile.texel.end());
  }
  return bytes;
}

/// Reads an unpacked asset from the front.
class AssetReader {
 public:
  AssetReader(std::string_view bytes, const std::filesystem::path& file) : rest_(bytes), file_(file.string()) {}

  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(ExitStatus::bad_data, {{{file_, 0, 0, {}}, why, "make it anew: pomona grow TEMPLATE -o FILE.pomona"}});
  }
  void require(bool good, const std::string& otherwise) const {
    if (!good) refuse(otherwise);
  }

  std::string_view take(std::size_t bytes, const char* what) {
    require(bytes <= rest_.size(), std::string("it ends within its ") + what);
    const std::string_view taken = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    return taken;
  }
  std::vector<std::uint32_t> numbers(std::size_t elements, std::size_t back, std::size_t width, const char* what) {
    return from_planes(take(elements * width, what), back, width);
  }
  std::vector<glm::vec4> texels(std::size_t count) {
    const std::string_view bytes = take(16 * count, "texels");
    std::vector<glm::vec4> texels(count);
    for (std::size_t i = 0; i < 4 * count; ++i)
      texels[i / 4][static_cast<int>(i % 4)] = std::bit_cast<float>(word_at(bytes, 4 * i));
    return texels;
  }
  std::vector<glm::u8vec4> shares(std::size_t count) {
    const std::string_view bytes = take(4 * count, "shares");
    std::vector<glm::u8vec4> shares(count);
    for (std::size_t i = 0; i < 4 * count; ++i)
      shares[i / 4][static_cast<int>(i % 4)] = static_cast<std::uint8_t>(bytes[i]);
    return shares;
  }
  bool is_empty() const { return rest_.empty(); }

 private:
  std::string_view rest_;
  std::string file_;
};

/// Of the header: the counts of the arrays.
struct TileCounts {
  int side = 0;
  std::size_t colors = 0;
};

struct Counts {
  int thirds = thirds_of_first_format;
  std::size_t vertices = 0, triangles = 0, shells = 0, noise = 0, details = 0, materials = 0, skin_shares = 0;
  std::vector<TileCounts> tiles;
};

void check_header(const Asset& asset, const Counts& counts, const AssetReader& reader) {
  // Reads counts first, because they determine all sizes.
  for (const int count : asset.count)
    reader.require(count >= 2 && count <= max_asset_nodes_along, "it has no nodes, or too many along an axis");
  reader.require(asset.node_count() <= max_asset_nodes && counts.vertices <= max_asset_vertices &&
                     counts.triangles <= max_asset_triangles && asset.parts.size() <= max_asset_parts,
                 "it has more nodes, vertices, triangles or parts than an asset holds");
  reader.require(counts.noise <= 1024 && counts.details <= 1024 && counts.materials <= 5 * max_asset_parts &&
                     (counts.skin_shares == 0 || counts.skin_shares == asset.parts.size()),
                 "it has more texels than an asset holds");
  reader.require(counts.tiles.size() <= max_asset_tiles, "it has more tiles than an asset holds");
  for (const TileCounts& tile : counts.tiles)
    reader.require(tile.side >= 1 && tile.side <= max_asset_tile_side && tile.colors >= 1 && tile.colors <= 256,
                   "a tile of its details is none");
  reader.require(counts.thirds >= 1 && counts.thirds <= 128, "its nodes are rounded in no known way");
  for (const int part : asset.spared)
    reader.require(part >= 0 && part < static_cast<int>(asset.parts.size()), "it spares a part that it does not have");
  reader.require(asset.units >= 1 && asset.units <= 65536, "its units are none");
  reader.require(std::isfinite(asset.spacing) && asset.spacing > 0, "its nodes lie nowhere");
  for (int k = 0; k < 3; ++k) reader.require(std::isfinite(asset.origin[k]), "its nodes lie nowhere");
  if (!asset.guide) return;
  const AssetGuide& guide = *asset.guide;
  bool fits = guide.stride >= 1 && guide.stride <= 64 && std::isfinite(guide.unit) && std::isfinite(guide.deepest);
  for (std::size_t k = 0; k < 3 && fits; ++k)
    fits = guide.count[k] == (asset.count[k] + guide.stride - 2) / guide.stride + 1;
  reader.require(fits, "its guide fits no lattice");
}

Counts read_header(std::string_view text, Asset& asset, const AssetReader& reader) {
  Counts counts;
  try {
    const ordered_json header = ordered_json::parse(text);
    const int format = header.at("format");
    reader.require(format >= 1 && format <= 4, "it is of a format that this version does not read");
    if (format >= 2) counts.thirds = header.at("thirds");
    if (format == 3 || header.contains("shells")) {
      counts.shells = header.at("shells").at("count");
      reader.require(counts.shells >= 1 && counts.shells <= max_asset_shells, "it has no shells, or too many");
    }
    asset.name = header.at("name"), asset.title = header.at("title"), asset.latin = header.at("latin");
    asset.seed = header.at("seed"), asset.diffuser = header.at("diffuser");
    for (int k = 0; k < 3; ++k) asset.origin[k] = header.at("origin").at(static_cast<std::size_t>(k));
    asset.spacing = header.at("spacing"), asset.count = header.at("count"), asset.units = header.at("units");
    counts.vertices = header.at("vertices"), counts.triangles = header.at("triangles");
    asset.parts = header.at("parts");
    asset.ink = parse_color(header.at("ink").get<std::string>()).value_or(Color(0));
    asset.ink_width = header.at("ink_width");
    const ordered_json& texels = header.at("texels");
    counts.noise = texels.at(0), counts.details = texels.at(1), counts.materials = texels.at(2);
    counts.skin_shares = header.at("skin_shares");
    if (header.contains("spared")) asset.spared = header["spared"].get<std::vector<int>>();
    if (format == 4) {
      for (const ordered_json& tile : header.at("tiles"))
        counts.tiles.push_back({.side = tile.at("side"), .colors = tile.at("colors")});
    }
    if (header.contains("guide")) {
      const ordered_json& guide = header["guide"];
      asset.guide = AssetGuide{.stride = guide.at("stride"),
                               .unit = guide.at("unit"),
                               .count = guide.at("count"),
                               .value = {},
                               .share = {},
                               .deepest = guide.at("deepest")};
    }
  } catch (const nlohmann::json::exception& wrong) {
    reader.refuse(std::string("its header is none: ") + wrong.what());
  }
  check_header(asset, counts, reader);
  return counts;
}

void read_surfaces(const Counts& counts, AssetReader& reader, Asset& a) {
  a.position.resize(counts.vertices), a.front_color.resize(counts.vertices), a.back_color.resize(counts.vertices);
  for (int k = 0; k < 3; ++k) {
    const auto column = reader.numbers(counts.vertices, 1, 2, "positions");
    for (std::size_t v = 0; v < column.size(); ++v) a.position[v][k] = static_cast<std::uint16_t>(column[v]);
  }
  for (int k = 0; k < 3; ++k) {
    const auto column = reader.numbers(counts.vertices, 1, 1, "colours");
    for (std::size_t v = 0; v < column.size(); ++v) a.front_color[v][k] = static_cast<std::uint8_t>(column[v]);
  }
  for (int k = 0; k < 3; ++k) {
    const auto column = reader.numbers(counts.vertices, counts.vertices + 1, 1, "colours");
    for (std::size_t v = 0; v < column.size(); ++v)
      a.back_color[v][k] = static_cast<std::uint8_t>(a.front_color[v][k] + column[v]);
  }
  a.triangle.resize(counts.triangles);
  for (int k = 0; k < 3; ++k) {
    const auto column = reader.numbers(counts.triangles, 2, 3, "triangles");
    for (std::size_t t = 0; t < column.size(); ++t) {
      reader.require(column[t] < counts.vertices, "triangle " + std::to_string(t) + " has a corner that is no vertex");
      a.triangle[t][k] = column[t];
    }
  }
  for (const std::uint32_t hidden : reader.numbers(counts.triangles, 1, 1, "triangles")) {
    reader.require(hidden <= 2, "a triangle has more than two sides");
    a.hidden.push_back(static_cast<std::uint8_t>(hidden));
  }
  for (std::vector<std::uint16_t>* of_side : {&a.front_part, &a.back_part}) {
    for (const std::uint32_t part : reader.numbers(counts.triangles, 1, 2, "parts")) {
      reader.require(part < std::max<std::size_t>(a.parts.size(), 1), "a triangle has a part that is none");
      of_side->push_back(static_cast<std::uint16_t>(part));
    }
  }
}

void read_look(const Counts& counts, AssetReader& reader, Asset& a) {
  a.noise = reader.texels(counts.noise), a.details = reader.texels(counts.details);
  a.materials = reader.texels(counts.materials);
  a.skin_share = reader.shares(counts.skin_shares);
  if (!a.guide) return;
  AssetGuide& guide = *a.guide;
  const std::size_t size = static_cast<std::size_t>(guide.count[0]) * static_cast<std::size_t>(guide.count[1]) *
                           static_cast<std::size_t>(guide.count[2]);
  std::vector<std::vector<std::uint32_t>> columns;
  for (int k = 0; k < 4; ++k) columns.push_back(reader.numbers(size, 1, 2, "guide"));
  guide.value.resize(size);
  for (std::size_t i = 0; i < size; ++i)
    for (int k = 0; k < 4; ++k) guide.value[i][k] = static_cast<std::int16_t>(columns[static_cast<std::size_t>(k)][i]);
  guide.share = reader.shares(a.parts.size() * static_cast<std::size_t>(depth_steps));
}

void read_shells(const Counts& counts, AssetReader& reader, Asset& a) {
  if (counts.shells == 0) return;
  for (const std::uint32_t shell : reader.numbers(counts.triangles, 1, 2, "shells")) {
    reader.require(shell <= counts.shells, "a triangle is of a shell that is none");
    a.shell.push_back(static_cast<std::uint16_t>(shell));
  }
}

void read_tiles(const Counts& counts, AssetReader& reader, Asset& a) {
  for (const TileCounts& count : counts.tiles) {
    AssetTile tile{.side = count.side, .palette = {}, .texel = {}};
    const std::string_view colors = reader.take(3 * count.colors, "tiles");
    for (std::size_t i = 0; i < colors.size(); i += 3)
      tile.palette.emplace_back(static_cast<std::uint8_t>(colors[i]), static_cast<std::uint8_t>(colors[i + 1]),
                                static_cast<std::uint8_t>(colors[i + 2]));
    const auto side = static_cast<std::size_t>(count.side);
    for (const char number : reader.take(side * side * side, "tiles")) {
      tile.texel.push_back(static_cast<std::uint8_t>(number));
      reader.require(tile.texel.back() < count.colors, "a texel of a tile has a colour that is none");
    }
    a.tiles.push_back(std::move(tile));
  }
}

}  // namespace

std::string write_asset(const Asset& asset, const std::string& made_by, int effort) {
  std::string packed;
  for (const int thirds : rounding) {
    const std::string header = json_text(header_of(asset, thirds, made_by));
    packed = std::string(magic) + deflated(word_bytes(header.size()) + header + arrays_of(asset, thirds), effort);
    if (packed.size() <= large_asset) break;
  }
  return packed;
}

Asset read_asset(std::string_view bytes, const std::filesystem::path& file) {
  const AssetReader outside(bytes, file);
  outside.require(bytes.substr(0, magic.size()) == magic, "it is no asset of Pomona's");
  const std::optional<std::string> unpacked = inflated(bytes.substr(magic.size()), max_bytes);
  outside.require(unpacked.has_value(), "it is cut off, damaged, or larger than an asset may be");

  AssetReader reader(*unpacked, file);
  const std::size_t length = word_at(reader.take(4, "header"), 0);
  reader.require(length <= max_header, "its header is longer than one may be");
  Asset asset;
  const Counts counts = read_header(reader.take(length, "header"), asset, reader);
  read_surfaces(counts, reader, asset);
  reader.require(rows_to_ask(asset) <= max_rows, "its triangles are larger than a fruit's");
  asset.winding = windings(asset);
  const auto inside = static_cast<std::size_t>(
      std::count_if(asset.winding.begin(), asset.winding.end(), [](std::int8_t w) { return w != 0; }));
  const std::string_view coded = reader.take(node_lengths + 3 * inside, "nodes");
  auto colors =
      decoded_nodes(asset, {reinterpret_cast<const std::uint8_t*>(coded.data()), coded.size()}, counts.thirds);
  reader.require(colors.has_value(), "its nodes do not fit together");
  asset.node_color = std::move(*colors);
  read_look(counts, reader, asset);
  read_shells(counts, reader, asset);
  read_tiles(counts, reader, asset);
  reader.require(reader.is_empty(), "something follows its end");
  return asset;
}

}  // namespace pomona
