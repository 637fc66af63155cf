// The part of a texture that one chart owns, while it is drawn, in linear colours.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "generator/base/color.h"
#include "render/image/image.h"
#include "render/texture/uv_atlas.h"

namespace pomona {

/// The box of the texels that a chart owns; high lies outside.
struct OwnedBox {
  glm::ivec2 low{0}, high{0};
};

/// The boxes of all charts, in one pass over the blocks.
std::vector<OwnedBox> owned_boxes(const Atlas& atlas);

class ChartCanvas {
 public:
  /// \param box of this chart, out of owned_boxes().
  ChartCanvas(const Atlas& atlas, std::size_t chart, const OwnedBox& box);

  // Whether a texel of the atlas belongs to the chart, and whether it already has a colour.
  bool owns(int x, int y) const { return is_within(x, y) && state_[at(x, y)] != State::foreign; }
  bool has(int x, int y) const { return is_within(x, y) && state_[at(x, y)] == State::filled; }
  Color& color(int x, int y) { return color_[at(x, y)]; }
  void set(int x, int y, const Color& color) {
    color_[at(x, y)] = color;
    if (state_[at(x, y)] != State::foreign) state_[at(x, y)] = State::filled;
  }

  /// The box of what it owns; high lies outside.
  glm::ivec2 low() const { return low_; }
  glm::ivec2 high() const { return high_; }

  void fill_with(const Color& color);

  /// Fills all owned texels from the chart's edges outwards, ring by ring, with the mean of their neighbours.
  void fill();

  /// Copies the filled texels, as sRGB.
  void write(Image& image) const;

  /// The same for values that are not colours: shares, as shares of 255; or directions, normalised, as (n + 1) / 2.
  void write_shares(Image& image) const;
  void write_directions(Image& image) const;

  /// Copies the reds of the filled texels, shares.
  void write_opacity(TransparentImage& image) const;

 private:
  enum class State : std::uint8_t { foreign, empty, filled, next };  // foreign: another chart's, or nobody's

  bool is_within(int x, int y) const { return x >= low_.x && y >= low_.y && x < high_.x && y < high_.y; }

  template <typename Encode>
  void write_as(Image& image, const Encode& encode) const {
    for (int y = low_.y; y < high_.y; ++y) {
      for (int x = low_.x; x < high_.x; ++x) {
        if (has(x, y)) image.pixels[static_cast<std::size_t>(y) * image.width + x] = encode(color_[at(x, y)]);
      }
    }
  }

  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y - low_.y) * (high_.x - low_.x) + x - low_.x; }

  /// The owned, empty texels next to a filled one, row by row.
  std::vector<glm::ivec2> border() const;

  /// The empty texels next to those of a ring, each once, in their order.
  std::vector<glm::ivec2> beside(const std::vector<glm::ivec2>& ring);

  Color mean_beside(const glm::ivec2& p) const;

  glm::ivec2 low_, high_;
  std::vector<Color> color_;
  std::vector<State> state_;
};

}  // namespace pomona
