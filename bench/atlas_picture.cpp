#include "bench/atlas_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

#include "render/picture/section_picture.h"
#include "render/style/style_file.h"

namespace pomona::bench {

namespace {

double worst_channel(const Color& a, const Color& b) {
  const glm::vec3 gap = glm::abs(a - b);
  return 255.0 * static_cast<double>(std::max({gap.x, gap.y, gap.z}));
}

/// White, yellow, red, black at 0, 1/3, 2/3, 1; in between by sRGB.
Color heat(double share) {
  const std::array<glm::vec3, 4> stops{{{255, 255, 255}, {255, 210, 60}, {200, 30, 30}, {20, 0, 10}}};
  const double place = std::clamp(share, 0.0, 1.0) * 3;
  const auto low = std::min<std::size_t>(static_cast<std::size_t>(place), 2);
  const glm::vec3 mixed = glm::mix(stops[low], stops[low + 1], static_cast<float>(place - static_cast<double>(low)));
  return from_srgb8(glm::u8vec3(mixed));
}

}  // namespace

CrossSection with_colors(CrossSection section, std::span<const Color> interior) {
  std::size_t next = 0;
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    if (section.interior[v]) section.color[v] = interior[next++];
  }
  return section;
}

CrossSection with_differences(CrossSection section, std::span<const Color> interior, std::span<const Color> truth,
                              double full_scale) {
  std::size_t next = 0;
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    section.color[v] = heat(0);
    if (!section.interior[v]) continue;
    section.color[v] = heat(worst_channel(interior[next], truth[next]) / full_scale);
    ++next;
  }
  return section;
}

Image side_by_side(std::span<const CrossSection> sections, int panel_width, int panel_height) {
  Style style = style_named("plain");
  style.grain = 0;
  Image row{panel_width * static_cast<int>(sections.size()), panel_height, {}};
  row.pixels.resize(static_cast<std::size_t>(row.width) * static_cast<std::size_t>(row.height));
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const Image panel = draw_section(sections[i], {}, {}, style,
                                     {.width = panel_width, .height = panel_height, .margin = 0.03, .threads = {}});
    for (int y = 0; y < panel_height; ++y) {
      const auto from = panel.pixels.begin() + static_cast<std::ptrdiff_t>(y) * panel_width;
      const auto to = static_cast<std::ptrdiff_t>(y) * row.width + static_cast<std::ptrdiff_t>(i) * panel_width;
      std::copy_n(from, panel_width, row.pixels.begin() + to);
    }
  }
  return row;
}

}  // namespace pomona::bench
