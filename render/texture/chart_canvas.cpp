#include "render/texture/chart_canvas.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pomona {

namespace {

template <typename Visit>
void around(const glm::ivec2& p, const Visit& visit) {
  for (int y = p.y - 1; y <= p.y + 1; ++y) {
    for (int x = p.x - 1; x <= p.x + 1; ++x) {
      if (x != p.x || y != p.y) visit(x, y);
    }
  }
}

/// Rounds to nearest: integers of what is not negative are rounded down.
glm::u8vec3 eight_bits_of(const glm::vec3& share) { return {glm::clamp(share, 0.0f, 1.0f) * 255.0f + 0.5f}; }

}  // namespace

std::vector<OwnedBox> owned_boxes(const Atlas& atlas) {
  std::vector<OwnedBox> boxes(atlas.corner.size(), {atlas.size, glm::ivec2(0)});
  const glm::ivec2 blocks = atlas.blocks();
  for (int y = 0; y < blocks.y; ++y) {
    for (int x = 0; x < blocks.x; ++x) {
      const std::int32_t chart = atlas.owner[static_cast<std::size_t>(y) * blocks.x + x];
      if (chart < 0) continue;
      OwnedBox& box = boxes[static_cast<std::size_t>(chart)];
      box.low = glm::min(box.low, glm::ivec2(x, y) * atlas.block());
      box.high = glm::max(box.high, glm::ivec2(x + 1, y + 1) * atlas.block());
    }
  }
  return boxes;
}

ChartCanvas::ChartCanvas(const Atlas& atlas, std::size_t chart, const OwnedBox& box) : low_(box.low), high_(box.high) {
  const glm::ivec2 size = high_ - low_;
  color_.assign(static_cast<std::size_t>(size.x) * size.y, Color(0));
  state_.assign(color_.size(), State::foreign);

  // The box begins and ends with whole blocks.
  const int block = atlas.block();
  for (int y = low_.y; y < high_.y; ++y) {
    const std::int32_t* const owner = &atlas.owner[static_cast<std::size_t>(y / block) * atlas.blocks().x];
    for (int x = low_.x; x < high_.x; x += block) {
      if (owner[x / block] != static_cast<std::int32_t>(chart)) continue;
      std::fill_n(&state_[at(x, y)], std::min(block, high_.x - x), State::empty);
    }
  }
}

void ChartCanvas::fill_with(const Color& color) {
  for (int y = low_.y; y < high_.y; ++y) {
    for (int x = low_.x; x < high_.x; ++x) set(x, y, color);
  }
}

void ChartCanvas::fill() {
  std::vector<glm::ivec2> ring = border();
  while (!ring.empty()) {
    std::vector<Color> means;
    for (const glm::ivec2& p : ring) means.push_back(mean_beside(p));
    for (std::size_t i = 0; i < ring.size(); ++i) set(ring[i].x, ring[i].y, means[i]);
    ring = beside(ring);
  }
}

void ChartCanvas::write(Image& image) const {
  write_as(image, [](const Color& color) { return to_srgb8(color); });
}

void ChartCanvas::write_shares(Image& image) const { write_as(image, eight_bits_of); }

void ChartCanvas::write_directions(Image& image) const {
  write_as(image, [](const Color& direction) {
    const float length = std::sqrt(glm::dot(direction, direction));
    return eight_bits_of(0.5f + 0.5f * direction / std::max(length, 1e-6f));
  });
}

void ChartCanvas::write_opacity(TransparentImage& image) const {
  for (int y = low_.y; y < high_.y; ++y) {
    for (int x = low_.x; x < high_.x; ++x) {
      if (!has(x, y)) continue;
      image.opacity[static_cast<std::size_t>(y) * image.image.width + x] = eight_bits_of(color_[at(x, y)]).r;
    }
  }
}

std::vector<glm::ivec2> ChartCanvas::border() const {
  std::vector<glm::ivec2> ring;
  for (int y = low_.y; y < high_.y; ++y) {
    for (int x = low_.x; x < high_.x; ++x) {
      if (state_[at(x, y)] != State::empty) continue;
      bool is_beside = false;
      around({x, y}, [&](int u, int v) { is_beside = is_beside || has(u, v); });
      if (is_beside) ring.emplace_back(x, y);
    }
  }
  return ring;
}

std::vector<glm::ivec2> ChartCanvas::beside(const std::vector<glm::ivec2>& ring) {
  std::vector<glm::ivec2> next;
  for (const glm::ivec2& p : ring) {
    around(p, [&](int x, int y) {
      if (!is_within(x, y) || state_[at(x, y)] != State::empty) return;
      state_[at(x, y)] = State::next;
      next.emplace_back(x, y);
    });
  }
  for (const glm::ivec2& p : next) state_[at(p.x, p.y)] = State::empty;
  return next;
}

Color ChartCanvas::mean_beside(const glm::ivec2& p) const {
  Color sum(0);
  int count = 0;
  around(p, [&](int x, int y) {
    if (!has(x, y)) return;
    sum += color_[at(x, y)];
    ++count;
  });
  return sum / static_cast<float>(count);
}

}  // namespace pomona
