// A mesh as binary glTF. Header and chunks state their lengths, which most mutations make wrong. Seven inputs in eight
// are corrected after the mutation, so that the code behind the lengths is reached.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "generator/surface/file/glb_file.h"
#include "tests/fuzz/told.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max, unsigned seed);

namespace {

constexpr std::size_t head = 12, chunk_head = 8;  // bytes
constexpr std::string_view binary("BIN\0", 4);

std::string word(std::size_t value) {
  std::string bytes;
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> 8 * k & 255);
  return bytes;
}

/// A chunk padded to words, as glTF requires.
std::string chunk(std::string_view kind, std::string_view bytes, char padding) {
  std::string padded(bytes);
  while (padded.size() % 4 != 0) padded += padding;
  return word(padded.size()).append(kind) + padded;
}

/// Sets the lengths: JSON up to the kind BIN and its length, bytes after it.
std::string with_lengths(std::string_view bytes) {
  if (bytes.size() < head + chunk_head) return std::string(bytes);
  const std::size_t kind = bytes.find(binary, head + chunk_head + 4);
  const bool has_binary = kind != std::string_view::npos;
  const std::size_t json = has_binary ? kind - 4 : bytes.size();
  std::string chunks = chunk(bytes.substr(head + 4, 4), bytes.substr(head + chunk_head, json - head - chunk_head), ' ');
  if (has_binary) chunks += chunk(binary, bytes.substr(kind + 4), '\0');
  return std::string(bytes.substr(0, 8)) + word(head + chunks.size()) + chunks;
}

}  // namespace

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max, unsigned seed) {
  const std::size_t now = LLVMFuzzerMutate(data, size, max);
  if (seed % 8 == 0) return now;
  const std::string right = with_lengths({reinterpret_cast<const char*>(data), now});
  if (right.size() > max) return now;
  std::copy(right.begin(), right.end(), data);
  return right.size();
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  return pomona::fuzz::told([&] { pomona::parse_glb(bytes, "fuzz.glb", size % 2 == 0 ? "" : "lid"); });
}
