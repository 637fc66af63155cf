#include "render/diffusion/gl_fruits.h"

#include <algorithm>
#include <string>
#include <utility>

#include "generator/base/error.h"

namespace pomona {

namespace {

/// Room for some ten fruits.
constexpr std::size_t first_size = std::size_t{32} << 20;

/// The arrays of a fruit, in the order of the buffers.
std::array<std::span<const std::byte>, 4> arrays_of(const RaySurfaces& fruit) {
  return {std::as_bytes(std::span(fruit.node)), std::as_bytes(std::span(fruit.triangle)),
          std::as_bytes(std::span(fruit.side)), std::as_bytes(std::span(fruit.color))};
}

}  // namespace

std::optional<FruitPlace> GlFruits::place(std::uint64_t number) const {
  const auto found = place_.find(number);
  return found == place_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<FruitPlace> GlFruits::add(const CurrentGl& gl, std::uint64_t number, const RaySurfaces& fruit) {
  const auto arrays = arrays_of(fruit);
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    if (buffer_[i].used + arrays[i].size() <= max_bytes_) continue;
    if (arrays[i].size() <= max_bytes_) return std::nullopt;
    throw Error(ExitStatus::helper_missing,
                "surfaces of " + std::to_string(fruit.triangle.size()) + " triangles need storage buffers of " +
                    std::to_string((arrays[i].size() >> 20) + 1) + " MiB; this OpenGL has " +
                    std::to_string(max_bytes_ >> 20) + " MiB",
                "use --diffuser cpu");
  }
  for (std::size_t i = 0; i < arrays.size(); ++i) buffer_[i].append(gl, arrays[i], max_bytes_);
  gl.check("uploading surfaces");

  const FruitPlace place = next_;
  next_.node += static_cast<std::uint32_t>(fruit.node.size());
  next_.triangle += static_cast<std::uint32_t>(fruit.triangle.size());
  next_.vertex += static_cast<std::uint32_t>(fruit.color.size() / 2);
  place_.emplace(number, place);
  return place;
}

void GlFruits::clear() {
  for (Growing& growing : buffer_) growing.used = 0;
  next_ = {};
  place_.clear();
}

std::array<const GlBuffer*, 4> GlFruits::buffers() const {
  std::array<const GlBuffer*, 4> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = &*buffer_[i].buffer;
  return all;
}

void GlFruits::Growing::append(const CurrentGl& gl, std::span<const std::byte> bytes, std::size_t max_bytes) {
  if (!buffer || used + bytes.size() > size) {
    // Grow a lot, so that data are seldom copied: a card takes a millisecond for a new buffer.
    size = std::min(std::max({2 * size, first_size, used + bytes.size()}), max_bytes);
    GlBuffer larger(gl, GL_SHADER_STORAGE_BUFFER, nullptr, size);
    if (buffer && used > 0) larger.copy(*buffer, used);
    buffer.emplace(std::move(larger));
  }
  buffer->write(used, bytes);
  used += bytes.size();
}

}  // namespace pomona
