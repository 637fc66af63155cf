#include "render/page/cuttable_glb.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "generator/base/little_endian.h"

namespace pomona {

namespace {

using nlohmann::ordered_json;

// A .glb: twelve bytes of header, then a chunk of JSON and one of bytes, each with its length and kind before it
// (glTF 2.0, 4.4).
constexpr std::string_view glb_magic = "glTF", json_chunk = "JSON", binary_chunk{"BIN\0", 4};
constexpr std::size_t glb_header = 12, chunk_header = 8;

[[noreturn]] void refuse_glb(const std::string& why) { throw Error(ExitStatus::bad_data, "a cuttable .glb: " + why); }

/// The chunk of this kind that begins at `at`, without its header.
std::string_view chunk_at(std::string_view glb, std::size_t at, std::string_view kind) {
  if (glb.size() < at + chunk_header || glb.substr(at + 4, 4) != kind) refuse_glb("it has not the chunks of a .glb");
  const std::size_t length = word_at(glb, at);
  if (length > glb.size() - at - chunk_header) refuse_glb("it is cut off");
  return glb.substr(at + chunk_header, length);
}

std::string padded(std::string bytes, char with) {
  bytes.append((4 - bytes.size() % 4) % 4, with);
  return bytes;
}

}  // namespace

std::string with_asset(std::string_view glb, std::string_view asset) {
  if (glb.size() < glb_header || glb.substr(0, 4) != glb_magic) refuse_glb("it is none");
  const std::string_view text = chunk_at(glb, glb_header, json_chunk);
  ordered_json file = ordered_json::parse(text, nullptr, false);
  if (file.is_discarded() || !file.contains("buffers") || !file.contains("bufferViews"))
    refuse_glb("its JSON is none, or it has no buffer");
  std::string binary = padded(std::string(chunk_at(glb, glb_header + chunk_header + text.size(), binary_chunk)), '\0');

  file["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", asset.size()}});
  file["extensionsUsed"].push_back("POMONA_cuttable");
  file["extensions"]["POMONA_cuttable"] = {{"bufferView", file["bufferViews"].size() - 1}};
  binary += asset;
  file["buffers"][0]["byteLength"] = binary.size();

  const std::string json = padded(json_text(file), ' ');
  binary = padded(std::move(binary), '\0');
  const std::size_t length = glb_header + 2 * chunk_header + json.size() + binary.size();
  if (length > std::numeric_limits<std::uint32_t>::max()) refuse_glb("it would be larger than 4 GB");
  std::string bytes = std::string(glb_magic) + word_bytes(2) + word_bytes(length);
  bytes += word_bytes(json.size()) + std::string(json_chunk) + json;
  return bytes + word_bytes(binary.size()) + std::string(binary_chunk) + binary;
}

}  // namespace pomona
