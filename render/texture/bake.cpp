#include "render/texture/bake.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/scene/section_colors.h"
#include "render/style/look.h"
#include "render/style/paint.h"
#include "render/texture/atlas.h"
#include "render/texture/baked_ink.h"
#include "render/texture/charts.h"
#include "render/texture/texels.h"

namespace pomona {

namespace {

/// Samples that are coloured at once: enough that what a diffuser does once per call does not count.
constexpr std::size_t samples_at_once = 2'000'000;

/// The colour of every sample, in the style's noise and paint.
class SampleColors {
 public:
  SampleColors(const Solid& solid, const Style& style, const ColorField* field, double texel, Threads threads)
      : solid_(solid),
        field_(field),
        look_(style.noise ? Look(solid.noise, solid.details) : Look()),
        paint_(style),
        texel_(texel),
        threads_(threads) {}

  std::vector<Color> of(const std::vector<TexelSample>& samples) {
    std::vector<Color> colors(samples.size());
    std::vector<glm::vec3> points(samples.size());
    parallel_for(chunks(samples.size()), threads_, [&](std::size_t chunk) {
      for_chunk(chunk, samples.size(), [&](std::size_t i) {
        points[i] = glm::vec3(place(samples[i]));
        colors[i] = interpolated(samples[i]);
      });
    });
    diffuse(samples, points, colors);
    if (look_.is_plain() && paint_.is_plain()) return colors;
    parallel_for(chunks(samples.size()), threads_, [&](std::size_t chunk) {
      for_chunk(chunk, samples.size(),
                [&](std::size_t i) { colors[i] = paint_(look_(colors[i], look_place(samples[i]))); });
    });
    return colors;
  }

  /// The mean of a chart that is smaller than a texel.
  Color mean_of(const Chart& chart) const {
    glm::dvec3 sum(0), place(0);
    double area = 0;
    for (const std::uint32_t t : chart.triangles) {
      const glm::uvec3& v = solid_.triangle[t];
      const glm::dvec3 a(solid_.position[v.x]), b(solid_.position[v.y]), c(solid_.position[v.z]);
      const glm::dvec3 n = glm::cross(b - a, c - a);
      const double weight = std::sqrt(glm::dot(n, n)) + 1e-30;
      sum += weight * glm::dvec3(solid_.color[v.x] + solid_.color[v.y] + solid_.color[v.z]) / 3.0;
      place += weight * (a + b + c) / 3.0;
      area += weight;
    }
    const std::uint32_t first = chart.triangles.front();
    LookPlace seen = look_place({.texel = {}, .triangle = first, .weight = glm::dvec3(1 / 3.), .outside = false});
    seen.position = place / area;
    return paint_(look_(Color(sum / area), seen));
  }

  std::size_t diffused() const { return diffused_; }

 private:
  static constexpr std::size_t chunk_size = 4096;
  static std::size_t chunks(std::size_t count) { return (count + chunk_size - 1) / chunk_size; }
  template <typename Visit>
  static void for_chunk(std::size_t chunk, std::size_t count, const Visit& visit) {
    for (std::size_t i = chunk * chunk_size; i < std::min(count, (chunk + 1) * chunk_size); ++i) visit(i);
  }

  glm::dvec3 place(const TexelSample& sample) const {
    const glm::uvec3& v = solid_.triangle[sample.triangle];
    return sample.weight.x * glm::dvec3(solid_.position[v.x]) + sample.weight.y * glm::dvec3(solid_.position[v.y]) +
           sample.weight.z * glm::dvec3(solid_.position[v.z]);
  }

  LookPlace look_place(const TexelSample& sample) const {
    const glm::uvec3& v = solid_.triangle[sample.triangle];
    LookPlace seen{.position = place(sample), .footprint = texel_};
    if (solid_.cut_face[sample.triangle] < 0) seen.face = DetailFace::skin;
    if (!solid_.guide.empty()) seen.guide = interpolated_guide(v, sample.weight);
    return seen;
  }

  DetailGuide interpolated_guide(const glm::uvec3& v, const glm::dvec3& weight) const {
    return pomona::interpolated(solid_.guide[v.x], solid_.guide[v.y], solid_.guide[v.z], static_cast<float>(weight.y),
                                static_cast<float>(weight.z));
  }

  /// Right on skin, and on the rim of a cut face, whose vertices have the colours of the surfaces they lie on.
  Color interpolated(const TexelSample& sample) const {
    const glm::uvec3& v = solid_.triangle[sample.triangle];
    return Color(sample.weight.x * glm::dvec3(solid_.color[v.x]) + sample.weight.y * glm::dvec3(solid_.color[v.y]) +
                 sample.weight.z * glm::dvec3(solid_.color[v.z]));
  }

  void diffuse(const std::vector<TexelSample>& samples, const std::vector<glm::vec3>& points,
               std::vector<Color>& colors) {
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; field_ != nullptr && i < samples.size(); ++i) {
      if (!samples[i].outside && solid_.cut_face[samples[i].triangle] >= 0) wanted.push_back(i);
    }
    for (std::size_t first = 0; first < wanted.size(); first += samples_at_once) {
      std::vector<glm::vec3> at;
      const std::size_t end = std::min(wanted.size(), first + samples_at_once);
      for (std::size_t i = first; i < end; ++i) at.push_back(points[wanted[i]]);
      const DiffusedColors found = field_->at(at);
      for (std::size_t i = first; i < end; ++i) colors[wanted[i]] = found.color[i - first];
    }
    diffused_ += wanted.size();
  }

  const Solid& solid_;
  const ColorField* field_;
  Look look_;
  Paint paint_;
  double texel_;
  Threads threads_;
  std::size_t diffused_ = 0;
};

/// The part of the texture that one chart owns, in linear colours, while it is made.
class Canvas {
 public:
  Canvas(const Atlas& atlas, std::size_t chart) : atlas_(atlas), chart_(static_cast<std::int32_t>(chart)) {
    low_ = atlas.size, high_ = glm::ivec2(0);
    const glm::ivec2 blocks = atlas.blocks();
    for (int y = 0; y < blocks.y; ++y) {
      for (int x = 0; x < blocks.x; ++x) {
        if (atlas.owner[static_cast<std::size_t>(y) * blocks.x + x] != chart_) continue;
        low_ = glm::min(low_, glm::ivec2(x, y) * atlas.block());
        high_ = glm::max(high_, glm::ivec2(x + 1, y + 1) * atlas.block());
      }
    }
    const glm::ivec2 size = high_ - low_;
    color_.assign(static_cast<std::size_t>(size.x) * size.y, Color(0));
    filled_.assign(color_.size(), 0);
  }

  bool owns(int x, int y) const {
    if (x < low_.x || y < low_.y || x >= high_.x || y >= high_.y) return false;
    const int block = atlas_.block();
    return atlas_.owner[static_cast<std::size_t>(y / block) * atlas_.blocks().x + x / block] == chart_;
  }
  bool has(int x, int y) const { return owns(x, y) && filled_[at(x, y)] != 0; }
  Color& color(int x, int y) { return color_[at(x, y)]; }
  void set(int x, int y, const Color& color) {
    color_[at(x, y)] = color;
    filled_[at(x, y)] = 1;
  }
  glm::ivec2 low() const { return low_; }
  glm::ivec2 high() const { return high_; }

  void fill_with(const Color& color) {
    for (int y = low_.y; y < high_.y; ++y) {
      for (int x = low_.x; x < high_.x; ++x) set(x, y, color);
    }
  }

  /// From the chart's edges outwards, ring by ring, all that it owns takes the mean of what lies beside it.
  void fill() {
    std::vector<glm::ivec2> ring = border();
    while (!ring.empty()) {
      std::vector<Color> means;
      for (const glm::ivec2& p : ring) means.push_back(mean_beside(p));
      for (std::size_t i = 0; i < ring.size(); ++i) set(ring[i].x, ring[i].y, means[i]);
      ring = beside(ring);
    }
  }

  void write(Image& image) const {
    for (int y = low_.y; y < high_.y; ++y) {
      for (int x = low_.x; x < high_.x; ++x) {
        if (has(x, y)) image.pixels[static_cast<std::size_t>(y) * image.width + x] = to_srgb8(color_[at(x, y)]);
      }
    }
  }

 private:
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y - low_.y) * (high_.x - low_.x) + x - low_.x; }

  template <typename Visit>
  static void around(const glm::ivec2& p, const Visit& visit) {
    for (int y = p.y - 1; y <= p.y + 1; ++y) {
      for (int x = p.x - 1; x <= p.x + 1; ++x) {
        if (x != p.x || y != p.y) visit(x, y);
      }
    }
  }

  /// Owned and empty beside something filled; row by row.
  std::vector<glm::ivec2> border() const {
    std::vector<glm::ivec2> ring;
    for (int y = low_.y; y < high_.y; ++y) {
      for (int x = low_.x; x < high_.x; ++x) {
        if (!owns(x, y) || filled_[at(x, y)] != 0) continue;
        bool is_beside = false;
        around({x, y}, [&](int u, int v) { is_beside = is_beside || has(u, v); });
        if (is_beside) ring.emplace_back(x, y);
      }
    }
    return ring;
  }

  /// Empty ones beside those just filled, each once, in their order.
  std::vector<glm::ivec2> beside(const std::vector<glm::ivec2>& ring) {
    std::vector<glm::ivec2> next;
    for (const glm::ivec2& p : ring) {
      around(p, [&](int x, int y) {
        if (!owns(x, y) || filled_[at(x, y)] != 0) return;
        filled_[at(x, y)] = 2;
        next.emplace_back(x, y);
      });
    }
    for (const glm::ivec2& p : next) filled_[at(p.x, p.y)] = 0;
    return next;
  }

  Color mean_beside(const glm::ivec2& p) const {
    Color sum(0);
    int count = 0;
    around(p, [&](int x, int y) {
      if (!has(x, y)) return;
      sum += color_[at(x, y)];
      ++count;
    });
    return sum / static_cast<float>(count);
  }

  const Atlas& atlas_;
  std::int32_t chart_;
  glm::ivec2 low_{0}, high_{0};
  std::vector<Color> color_;
  std::vector<std::uint8_t> filled_;
};

class Baker {
 public:
  Baker(const Solid& solid, const Style& style, const BakeOptions& options, const ColorField* field)
      : solid_(solid),
        style_(style),
        options_(options),
        charts_(charts_of(solid, options.threads)),
        atlas_(options.texel > 0 ? atlas_of_texel(charts_, options.texel, options.mip_levels)
                                 : atlas_of_side(charts_, options.texels, options.mip_levels)),
        colors_(solid, style, field, 1 / atlas_.texels_per_metre, options.threads) {}

  BakedSolid bake() {
    Image& image = result_.texture;
    image = {atlas_.size.x, atlas_.size.y,
             std::vector<glm::u8vec3>(static_cast<std::size_t>(atlas_.size.x) * atlas_.size.y)};
    // Charts by the handful, as many as have a million texels or two.
    for (std::size_t first = 0; first < charts_.size();) {
      std::size_t end = first, texels = 0;
      while (end < charts_.size() && (end == first || texels + texels_of(end) < samples_at_once))
        texels += texels_of(end++);
      paint(first, end);
      first = end;
    }
    fill_gaps(image);
    add_mesh();
    measure();
    return std::move(result_);
  }

 private:
  std::size_t texels_of(std::size_t chart) const {
    const glm::dvec2 size = charts_[chart].size * atlas_.texels_per_metre + 4.0;
    return static_cast<std::size_t>(size.x * size.y);
  }

  /// Colours the charts from `first` to before `end`.
  void paint(std::size_t first, std::size_t end) {
    std::vector<std::vector<TexelSample>> of_chart(end - first);
    parallel_for(of_chart.size(), options_.threads,
                 [&](std::size_t i) { of_chart[i] = texel_samples(solid_, charts_, first + i, atlas_); });
    std::vector<TexelSample> samples;
    std::vector<std::size_t> begin{0};
    for (const auto& own : of_chart) {
      samples.insert(samples.end(), own.begin(), own.end());
      begin.push_back(samples.size());
    }
    const std::vector<Color> colors = colors_.of(samples);
    parallel_for(of_chart.size(), options_.threads, [&](std::size_t i) {
      Canvas canvas(atlas_, first + i);
      draw(canvas, of_chart[i], colors.data() + begin[i]);
      if (of_chart[i].empty()) canvas.fill_with(colors_.mean_of(charts_[first + i]));
      if (style_.ink && charts_[first + i].cut_face >= 0 && !of_chart[i].empty()) ink(canvas, first + i);
      canvas.fill();
      canvas.write(result_.texture);
    });
  }

  /// The mean of each texel's samples, which follow one another.
  static void draw(Canvas& canvas, const std::vector<TexelSample>& samples, const Color* colors) {
    for (std::size_t i = 0; i < samples.size();) {
      const glm::ivec2 texel = samples[i].texel;
      glm::dvec3 sum(0);
      std::size_t end = i;
      for (; end < samples.size() && samples[end].texel == texel; ++end) sum += glm::dvec3(colors[end]);
      if (canvas.owns(texel.x, texel.y)) canvas.set(texel.x, texel.y, Color(sum / static_cast<double>(end - i)));
      i = end;
    }
  }

  void ink(Canvas& canvas, std::size_t chart) const {
    const BakedInk lines = baked_ink(solid_, charts_, chart, atlas_, style_);
    for (int y = canvas.low().y; y < canvas.high().y; ++y) {
      for (int x = canvas.low().x; x < canvas.high().x; ++x) {
        if (canvas.has(x, y)) canvas.color(x, y) = lines.over(canvas.color(x, y), x, y);
      }
    }
  }

  /// What nobody owns takes the mean of the atlas around it, so that the coarsest mip levels look like the whole.
  void fill_gaps(Image& image) const;

  void add_mesh() {
    Solid& out = result_.solid;
    out = solid_;
    out.position.clear(), out.normal.clear(), out.color.clear(), out.part.clear(), out.guide.clear();
    out.triangle.clear(), out.cut_face.clear(), out.surface.clear();
    for (std::size_t c = 0; c < charts_.size(); ++c) add_chart(c);
  }

  void add_chart(std::size_t c) {
    Solid& out = result_.solid;
    const Chart& chart = charts_[c];
    std::map<std::uint32_t, std::uint32_t> known;
    for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
      const std::uint32_t t = chart.triangles[i];
      glm::uvec3 copied(0);
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t original = solid_.triangle[t][k];
        const auto [vertex, added] = known.try_emplace(original, static_cast<std::uint32_t>(out.position.size()));
        copied[k] = vertex->second;
        if (!added) continue;
        out.position.push_back(solid_.position[original]);
        out.normal.push_back(solid_.normal[original]);
        out.color.push_back(solid_.color[original]);
        out.part.push_back(solid_.part[original]);
        if (!solid_.guide.empty()) out.guide.push_back(solid_.guide[original]);
        const glm::dvec2 texel = atlas_.texel(charts_, c, chart.corners[i][k]);
        result_.uv.emplace_back(texel / glm::dvec2(atlas_.size));
      }
      out.triangle.push_back(copied);
      out.cut_face.push_back(solid_.cut_face[t]);
      out.surface.push_back(solid_.surface[t]);
    }
  }

  void measure() {
    result_.mip_levels = atlas_.mip_levels;
    result_.texel = 1 / atlas_.texels_per_metre;
    result_.charts = static_cast<int>(charts_.size());
    result_.filled = filled_share(charts_, atlas_);
    result_.diffused = colors_.diffused();
    double area = 0, sum = 0;
    for (const Chart& chart : charts_) {
      if (chart.cut_face >= 0) continue;
      const double own = chart.size.x * chart.size.y;
      area += own, sum += own * chart.stretch.mean;
      result_.worst_stretch = std::max(result_.worst_stretch, chart.stretch.worst);
    }
    if (area > 0) result_.mean_stretch = sum / area;
  }

  const Solid& solid_;
  const Style& style_;
  const BakeOptions& options_;
  std::vector<Chart> charts_;
  Atlas atlas_;
  SampleColors colors_;
  BakedSolid result_;
};

/// Linear colours of squares of texels, and whether anything is known of them.
struct Level {
  glm::ivec2 size{0};
  std::vector<Color> sum;
  std::vector<float> weight;

  explicit Level(const glm::ivec2& of)
      : size(of), sum(static_cast<std::size_t>(of.x) * of.y, Color(0)), weight(sum.size(), 0) {}
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y) * size.x + x; }
};

Level half_of(const Level& fine) {
  Level half((fine.size + 1) / 2);
  for (int y = 0; y < fine.size.y; ++y) {
    for (int x = 0; x < fine.size.x; ++x) {
      half.sum[half.at(x / 2, y / 2)] += fine.sum[fine.at(x, y)];
      half.weight[half.at(x / 2, y / 2)] += fine.weight[fine.at(x, y)];
    }
  }
  return half;
}

/// One entry per block of the atlas: the mean of what is in it.
Level blocks_of(const Atlas& atlas, const Image& image) {
  Level level(atlas.blocks());
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::size_t block = level.at(x / atlas.block(), y / atlas.block());
      if (atlas.owner[block] < 0) continue;
      level.sum[block] += from_srgb8(image.at(x, y));
      level.weight[block] += 1;
    }
  }
  return level;
}

void Baker::fill_gaps(Image& image) const {
  std::vector<Level> levels{blocks_of(atlas_, image)};
  while (std::max(levels.back().size.x, levels.back().size.y) > 1) levels.push_back(half_of(levels.back()));
  for (int y = 0; y < levels[0].size.y; ++y) {
    for (int x = 0; x < levels[0].size.x; ++x) {
      if (atlas_.owner[levels[0].at(x, y)] >= 0) continue;
      glm::u8vec3 pixel(0);
      for (std::size_t l = 1; l < levels.size(); ++l) {
        const std::size_t i = levels[l].at(x >> l, y >> l);
        if (levels[l].weight[i] == 0) continue;
        pixel = to_srgb8(levels[l].sum[i] / levels[l].weight[i]);
        break;
      }
      for (int v = 0; v < atlas_.block(); ++v) {
        const auto row = image.pixels.begin() + static_cast<std::ptrdiff_t>(y * atlas_.block() + v) * image.width;
        std::fill_n(row + static_cast<std::ptrdiff_t>(x) * atlas_.block(), atlas_.block(), pixel);
      }
    }
  }
}

BakedSolid baked_with(const Solid& solid, const Style& style, const BakeOptions& options, const ColorField* field) {
  if (solid.triangle.empty()) {
    BakedSolid nothing;
    nothing.solid = solid;
    return nothing;
  }
  return Baker(solid, style, options, field).bake();
}

bool has_cut_face(const Solid& solid) {
  return std::any_of(solid.cut_face.begin(), solid.cut_face.end(), [](auto face) { return face >= 0; });
}

}  // namespace

BakedSolid baked(const Solid& solid, const Style& style, const BakeOptions& options) {
  return std::move(all_baked({&solid, 1}, style, options).front());
}

std::vector<BakedSolid> all_baked(std::span<const Solid> solids, const Style& style, const BakeOptions& options) {
  std::vector<BakedSolid> result;
  const SectionColors* last = nullptr;
  std::unique_ptr<ColorField> field;
  for (const Solid& solid : solids) {
    // Pieces of one fruit follow one another.
    const SectionColors* const own = has_cut_face(solid) ? solid.section_colors.get() : nullptr;
    if (own != last) field = own ? own->field() : nullptr;
    last = own;
    result.push_back(baked_with(solid, style, options, field.get()));
  }
  return result;
}

}  // namespace pomona
