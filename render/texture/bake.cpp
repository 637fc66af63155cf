#include "render/texture/bake.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "generator/piece/section_colors.h"
#include "render/texture/atlas_gaps.h"
#include "render/texture/baked_ink.h"
#include "render/texture/chart_canvas.h"
#include "render/texture/look_texels.h"
#include "render/texture/sample_colors.h"
#include "render/texture/sample_maps.h"
#include "render/texture/tangents.h"
#include "render/texture/uv_charts.h"

namespace pomona {

namespace {

PackedCharts packed_charts(const Solid& solid, const BakeOptions& options) {
  const std::vector<Chart> charts = charts_of(solid, options.threads);
  return options.texel > 0 ? packed_at_texel(charts, options.texel, options.mip_levels)
                           : packed_to_side(charts, options.texels, options.mip_levels);
}

class Baker {
 public:
  Baker(const Solid& solid, const Style& style, const BakeOptions& options)
      : solid_(solid), style_(style), options_(options), packed_(packed_charts(solid, options)) {}

  double texel() const { return 1 / atlas_.texels_per_metre; }

  BakedSolid bake(const SampleColors::OfCutFaces& of_cut_faces) {
    colors_.emplace(solid_, style_, of_cut_faces, texel(), options_.threads);
    Image& image = result_.texture;
    image = image_of({0, 0, 0});
    add_mesh();
    if (options_.maps == Maps::all) start_maps();
    if (options_.maps == Maps::all && options_.looks) start_looks();
    // The number of charts that together have a million texels or two.
    for (std::size_t first = 0; first < charts_.size();) {
      std::size_t end = first, texels = 0;
      while (end < charts_.size() && (end == first || texels + texels_of(end) < SampleColors::at_once))
        texels += texels_of(end++);
      paint(first, end);
      first = end;
    }
    fill_gaps(image, atlas_);
    measure();
    return std::move(result_);
  }

 private:
  std::size_t texels_of(std::size_t chart) const {
    const glm::dvec2 size = charts_[chart].size * atlas_.texels_per_metre + 4.0;
    return static_cast<std::size_t>(size.x * size.y);
  }

  Image image_of(const glm::u8vec3& value) const {
    return {atlas_.size.x, atlas_.size.y,
            std::vector<glm::u8vec3>(static_cast<std::size_t>(atlas_.size.x) * atlas_.size.y, value)};
  }

  /// Outside of charts, maps are level, open, dull, thick and wet.
  void start_maps() {
    const Solid& mesh = result_.solid;
    SurfaceMaps& maps = result_.maps;
    maps.normal = image_of({128, 128, 255});
    maps.orm = image_of({255, 153, 0});
    maps.thickness = image_of({255, 255, 0});
    maps.part = image_of({255, 255, 255});
    maps.tangent = tangents(mesh.mesh.position, mesh.mesh.normal, result_.uv, mesh.mesh.triangle);
    tangent_mesh_ = {mesh.mesh.triangle, maps.tangent, std::vector<std::uint32_t>(solid_.mesh.triangle.size(), 0)};
    std::uint32_t next = 0;
    for (const Chart& chart : charts_)
      for (const std::uint32_t t : chart.triangles) tangent_mesh_.number[t] = next++;
    sample_maps_.emplace(solid_, colors_->look(), tangent_mesh_, texel(), options_.threads);
  }

  /// Outside of charts, nothing has a coat, a sheen or light behind it.
  void start_looks() {
    SurfaceMaps& maps = result_.maps;
    maps.tell_looks = true;
    looks_.emplace(solid_);
    const auto filled = [&](const glm::u8vec3& value, std::uint8_t opacity) {
      const std::size_t texels = static_cast<std::size_t>(atlas_.size.x) * atlas_.size.y;
      return TransparentImage{image_of(value), std::vector<std::uint8_t>(texels, opacity)};
    };
    if (looks_->any_coat()) maps.coat = filled({0, 0, 0}, 255);
    if (looks_->any_sheen()) maps.sheen = filled({0, 0, 0}, 255);
    if (looks_->any_light()) maps.light = filled({255, 255, 255}, 0);
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
    std::vector<Color> colors = colors_->plain(samples);
    std::vector<MapSample> shading;
    if (sample_maps_) shading = sample_maps_->of(samples, colors);
    colors = colors_->styled(samples, std::move(colors));
    parallel_for(of_chart.size(), options_.threads, [&](std::size_t i) {
      ChartCanvas canvas(atlas_, first + i, boxes_[first + i]);
      draw(canvas, of_chart[i], [&](std::size_t k) { return colors[begin[i] + k]; });
      if (of_chart[i].empty()) canvas.fill_with(colors_->mean_of(charts_[first + i]));
      if (style_.ink && charts_[first + i].cut_face >= 0 && !of_chart[i].empty()) ink(canvas, first + i);
      canvas.fill();
      canvas.write(result_.texture);
      if (sample_maps_) draw_maps(first + i, of_chart[i], shading.data() + begin[i]);
      if (looks_) draw_looks(first + i, of_chart[i], shading.data() + begin[i]);
    });
  }

  /// A chart's place on each map.
  void draw_maps(std::size_t chart, const std::vector<TexelSample>& samples, const MapSample* shading) {
    const MapSample speck = samples.empty() ? sample_maps_->speck(charts_[chart].triangles.front()) : MapSample{};
    const auto drawn = [&](auto value) {
      return filled(
          chart, samples, [&](std::size_t k) { return value(shading[k]); }, value(speck));
    };
    drawn([](const MapSample& s) { return s.normal; }).write_directions(result_.maps.normal);
    drawn([](const MapSample& s) { return s.orm; }).write_shares(result_.maps.orm);
    drawn([](const MapSample& s) { return s.thickness; }).write_shares(result_.maps.thickness);
    draw_parts(chart, samples);
  }

  /// A chart's place on the maps of looks. A coat is as thick as the film of juice is there.
  void draw_looks(std::size_t chart, const std::vector<TexelSample>& samples, const MapSample* shading) {
    const std::uint32_t first = charts_[chart].triangles.front();
    const float film = samples.empty() ? sample_maps_->speck(first).thickness.x : 1;
    const auto drawn = [&](auto value) {
      const auto of_sample = [&](std::size_t k) {
        return Color(value(looks_->of(samples[k].triangle), shading[k].thickness.x));
      };
      return filled(chart, samples, of_sample, Color(value(looks_->of(first), film)));
    };
    SurfaceMaps& maps = result_.maps;
    if (looks_->any_coat()) {
      drawn([](const LookTexel& look, float share) {
        return look.coat * Color(share, 1, 1);
      }).write_shares(maps.coat.image);
      drawn([](const LookTexel& look, float) { return look.specular; }).write_opacity(maps.coat);
    }
    if (looks_->any_sheen()) {
      drawn([](const LookTexel& look, float) { return look.sheen; }).write(maps.sheen.image);
      drawn([](const LookTexel& look, float) { return look.sheen_roughness; }).write_opacity(maps.sheen);
    }
    if (looks_->any_light()) {
      drawn([](const LookTexel& look, float) { return look.light; }).write(maps.light.image);
      drawn([](const LookTexel& look, float) { return look.light_share; }).write_opacity(maps.light);
    }
  }

  /// A chart's canvas with the mean of each texel's samples, drawn out to its edges. \param speck where it has none.
  template <typename ValueOf>
  ChartCanvas filled(std::size_t chart, const std::vector<TexelSample>& samples, const ValueOf& value_of,
                     const Color& speck) const {
    ChartCanvas canvas(atlas_, chart, boxes_[chart]);
    draw(canvas, samples, value_of);
    if (samples.empty()) canvas.fill_with(speck);
    canvas.fill();
    return canvas;
  }

  /// Parts have no mean: uses the part of each texel's first sample, and none around the chart.
  void draw_parts(std::size_t chart, const std::vector<TexelSample>& samples) {
    ChartCanvas canvas(atlas_, chart, boxes_[chart]);
    const auto color_of = [](std::int32_t part) { return Color(static_cast<float>(std::min(part, 254)) / 255.0f); };
    for (const TexelSample& sample : samples) {
      const glm::ivec2 at = sample.texel;
      if (canvas.owns(at.x, at.y) && !canvas.has(at.x, at.y))
        canvas.set(at.x, at.y, color_of(sample_maps_->part(sample)));
    }
    if (samples.empty()) {
      const glm::uvec3& speck = solid_.mesh.triangle[charts_[chart].triangles.front()];
      canvas.fill_with(color_of(solid_.mesh.part[speck.x]));
    }
    canvas.write_shares(result_.maps.part);
  }

  /// The mean of each texel's samples, which follow one another.
  template <typename ColorOf>
  static void draw(ChartCanvas& canvas, const std::vector<TexelSample>& samples, const ColorOf& color_of) {
    for (std::size_t i = 0; i < samples.size();) {
      const glm::ivec2 texel = samples[i].texel;
      glm::dvec3 sum(0);
      std::size_t end = i;
      for (; end < samples.size() && samples[end].texel == texel; ++end) sum += glm::dvec3(color_of(end));
      if (canvas.owns(texel.x, texel.y)) canvas.set(texel.x, texel.y, Color(sum / static_cast<double>(end - i)));
      i = end;
    }
  }

  void ink(ChartCanvas& canvas, std::size_t chart) const {
    const BakedInk lines = baked_ink(solid_, charts_, chart, atlas_, style_);
    for (int y = canvas.low().y; y < canvas.high().y; ++y) {
      for (int x = canvas.low().x; x < canvas.high().x; ++x) {
        if (canvas.has(x, y)) canvas.color(x, y) = lines.over(canvas.color(x, y), x, y);
      }
    }
  }

  void add_mesh() {
    Solid& out = result_.solid;
    out = solid_;
    out.mesh.position.clear(), out.mesh.normal.clear(), out.mesh.color.clear(), out.mesh.part.clear(),
        out.mesh.guide.clear();
    out.mesh.triangle.clear(), out.mesh.cut_face.clear(), out.mesh.surface.clear(), out.mesh.instance.clear();
    for (std::size_t c = 0; c < charts_.size(); ++c) add_chart(c);
  }

  void add_chart(std::size_t c) {
    // A vertex is copied for each chart it is in, since every chart has its own place in the texture.
    Solid& out = result_.solid;
    const Chart& chart = charts_[c];
    std::map<std::uint32_t, std::uint32_t> known;
    for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
      const std::uint32_t t = chart.triangles[i];
      glm::uvec3 copied(0);
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t original = solid_.mesh.triangle[t][k];
        const auto [vertex, added] = known.try_emplace(original, static_cast<std::uint32_t>(out.mesh.position.size()));
        copied[k] = vertex->second;
        if (!added) continue;
        out.mesh.position.push_back(solid_.mesh.position[original]);
        out.mesh.normal.push_back(solid_.mesh.normal[original]);
        out.mesh.color.push_back(solid_.mesh.color[original]);
        out.mesh.part.push_back(solid_.mesh.part[original]);
        if (!solid_.mesh.guide.empty()) out.mesh.guide.push_back(solid_.mesh.guide[original]);
        const glm::dvec2 texel = atlas_.texel(charts_, c, chart.corners[i][k]);
        result_.uv.emplace_back(texel / glm::dvec2(atlas_.size));
      }

      // Triangles keep their attributes.
      out.mesh.triangle.push_back(copied);
      out.mesh.cut_face.push_back(solid_.mesh.cut_face[t]);
      out.mesh.surface.push_back(solid_.mesh.surface[t]);
      if (!solid_.mesh.instance.empty()) out.mesh.instance.push_back(solid_.mesh.instance[t]);
    }
  }

  void measure() {
    result_.mip_levels = atlas_.mip_levels;
    result_.texel = 1 / atlas_.texels_per_metre;
    result_.charts = static_cast<int>(charts_.size());
    result_.filled = filled_share(charts_, atlas_);
    result_.diffused = colors_->diffused();
    double area = 0, sum = 0;
    for (const Chart& chart : charts_) {
      if (chart.cut_face >= 0) continue;
      area += chart.stretch.area, sum += chart.stretch.area * chart.stretch.mean;
      result_.worst_stretch = std::max(result_.worst_stretch, chart.stretch.worst);
    }
    if (area > 0) result_.mean_stretch = sum / area;
  }

  const Solid& solid_;
  const Style& style_;
  const BakeOptions& options_;
  const PackedCharts packed_;
  const std::vector<Chart>& charts_ = packed_.charts;
  const Atlas& atlas_ = packed_.atlas;
  const std::vector<OwnedBox> boxes_ = owned_boxes(packed_.atlas);  // per chart
  std::optional<SampleColors> colors_;
  TangentMesh tangent_mesh_;
  std::optional<SampleMaps> sample_maps_;
  std::optional<LookTexels> looks_;
  BakedSolid result_;
};

bool has_cut_face(const Solid& solid) {
  return std::any_of(solid.mesh.cut_face.begin(), solid.mesh.cut_face.end(), [](auto face) { return face >= 0; });
}

/// The field that diffuses its texels; null if nothing is diffused.
const SectionColors* section_colors_of(const Solid& solid) {
  return has_cut_face(solid) ? solid.section_colors.get() : nullptr;
}

/// Solids whose cut faces the same surfaces have coloured.
std::vector<BakedSolid> baked_together(std::span<const Solid> solids, const SectionColors* colors, const Style& style,
                                       const BakeOptions& options) {
  // The layout of each solid.
  std::vector<std::optional<Baker>> bakers(solids.size());
  std::vector<FaceColorTask> tasks;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (solids[i].mesh.triangle.empty()) continue;
    bakers[i].emplace(solids[i], style, options);
    tasks.push_back({&solids[i], bakers[i]->texel()});
  }

  // The colours that all of them diffuse.
  const std::unique_ptr<ColorField> field = colors != nullptr ? colors->field() : nullptr;
  DiffusedFaces faces;
  if (field && !options.every_texel) faces = diffused_faces(tasks, *field);

  // Bakes one by one.
  std::vector<BakedSolid> result(solids.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (!bakers[i]) {
      result[i].solid = solids[i];
      continue;
    }
    SampleColors::OfCutFaces of_cut_faces{.field = options.every_texel ? field.get() : nullptr};
    if (!faces.of_solid.empty()) of_cut_faces.faces = &faces.of_solid[next++];
    result[i] = bakers[i]->bake(of_cut_faces);
    bakers[i].reset();
  }
  if (!faces.of_solid.empty()) result.front().diffused = faces.points;
  return result;
}

}  // namespace

BakedSolid baked(const Solid& solid, const Style& style, const BakeOptions& options) {
  return std::move(all_baked({&solid, 1}, style, options).front());
}

std::vector<BakedSolid> all_baked(std::span<const Solid> solids, const Style& style, const BakeOptions& options) {
  std::vector<BakedSolid> result;
  for (std::size_t first = 0; first < solids.size();) {
    // Pieces of one fruit follow each other.
    const SectionColors* const own = section_colors_of(solids[first]);
    std::size_t end = first + 1;
    while (end < solids.size() && own != nullptr && section_colors_of(solids[end]) == own) ++end;
    for (BakedSolid& baked_solid : baked_together(solids.subspan(first, end - first), own, style, options))
      result.push_back(std::move(baked_solid));
    first = end;
  }
  return result;
}

}  // namespace pomona
