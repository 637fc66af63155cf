#include "render/strokes/scene_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/mesh/box.h"
#include "render/image/image.h"
#include "render/strokes/long_runs.h"

namespace pomona {

namespace {

/// Lines are found on a picture of about this many pixels a side, so that a small picture has the lines of a large one.
constexpr int min_side = 900, max_side = 4096;

double magnification(const StrokeOptions& options) {
  const double shorter = std::min(options.width, options.height), longer = std::max(options.width, options.height);
  return std::min(std::max(1.0, min_side / shorter), std::max(max_side / longer, 1e-3));
}

/// Half the diagonal of the solid's box, metres.
double radius_of(const Solid& solid) {
  return solid.mesh.position.empty() ? 0.0
                                     : 0.5 * static_cast<double>(glm::length(box_around(solid.mesh.position).size()));
}

/// The properties of an instance on which its lines depend.
struct Sitter {
  PenWidths pen{};
  double fine = 1;        // 1 for objects that fill the picture, less for small ones
  double wavelength = 1;  // wavelength of the hand's tremble, metres on the fruit
};

/// The direction of the light on the picture, y down.
glm::dvec2 from_light(const LightStyle& light) {
  const glm::dvec2 way(-reproducible::sin(light.azimuth) * reproducible::cos(light.elevation),
                       reproducible::sin(light.elevation));
  const double size = glm::length(way);
  return size > 1e-6 ? way / size : glm::dvec2(0);
}

class Draughtsman {
 public:
  Draughtsman(const Scene& scene, const Style& style, const StrokeOptions& options)
      : scene_(scene),
        style_(style),
        threads_(options.threads),
        scale_(magnification(options)),
        lens_(scene.view, std::max(1, static_cast<int>(std::lround(options.width * scale_))),
              std::max(1, static_cast<int>(std::lround(options.height * scale_)))),
        side_(std::min(lens_.width(), lens_.height())),
        from_light_(from_light(style.light)) {}

  std::vector<SceneStroke> strokes();

 private:
  Sitter sitter(const Solid& solid, const SeenSolid& seen) const;
  std::vector<VisibleRun> sitters_lines(const IdentityBuffer& buffer);
  SceneStroke stroke(const VisibleRun& run, const IdentityBuffer& buffer) const;
  double before_all(const glm::dvec2& at, double radius, const IdentityBuffer& buffer) const;

  const Scene& scene_;
  const Style& style_;
  Threads threads_;
  double scale_;  // pixels of the identity buffer per pixel of the picture
  Lens lens_;
  double side_;
  glm::dvec2 from_light_;
  std::vector<Sitter> sitters_;
};

Sitter Draughtsman::sitter(const Solid& solid, const SeenSolid& seen) const {
  Sitter result;

  // By its size in the picture.
  const double radius = radius_of(solid);
  double away = 0;
  std::size_t count = 0;
  for (const glm::dvec3& v : seen.vertex) {
    if (v.z > 0) away += v.z, ++count;
  }
  if (count == 0) return result;
  const double size = 2 * radius / lens_.pixel_size(away / static_cast<double>(count));
  result.fine = std::clamp(std::sqrt(size / (0.7 * side_)), 0.3, 1.0);
  const double width = side_ * result.fine * solid.look->ink.width;
  result.pen = {width * style_.outline_width, width * style_.inner_width};
  result.wavelength = 0.3 * radius + 1e-6;
  return result;
}

/// Every visible instance, with its pens and its visible lines.
std::vector<VisibleRun> Draughtsman::sitters_lines(const IdentityBuffer& buffer) {
  std::vector<SolidEdges> edges(scene_.solids.size());
  parallel_for(edges.size(), threads_, [&](std::size_t i) { edges[i] = solid_edges(scene_.solids[i]); });
  std::vector<std::vector<VisibleRun>> by_instance(scene_.instances.size());
  sitters_.resize(by_instance.size());
  visit_seen_solids(scene_, lens_, threads_, [&](std::size_t first, std::span<const SeenSolid> seen) {
    parallel_for(seen.size(), threads_, [&](std::size_t k) {
      const std::size_t i = first + k;
      const int number = scene_.instances[i].solid;
      const Solid& solid = scene_.solids[number];
      sitters_[i] = sitter(solid, seen[k]);
      const auto lines = object_lines(solid, edges[number], seen[k], static_cast<std::uint32_t>(i), lens_);
      by_instance[i] = visible_runs(lines, buffer, lens_);
    });
  });
  std::vector<VisibleRun> all;
  for (std::vector<VisibleRun>& some : by_instance) std::move(some.begin(), some.end(), std::back_inserter(all));
  return all;
}

std::vector<SceneStroke> Draughtsman::strokes() {
  const IdentityBuffer buffer = identity_buffer(scene_, lens_, threads_);
  std::vector<VisibleRun> lines = sitters_lines(buffer);
  std::vector<PenWidths> pens;
  for (const Sitter& one : sitters_) pens.push_back(one.pen);

  // Visible lines, joined before and after those beside others are thinned; inner ones come first.
  lines = without_overlaps(joined_runs(std::move(lines), 0.004 * side_), pens, lens_.width(), lens_.height());
  lines = joined_runs(std::move(lines), 0.004 * side_);
  std::stable_sort(lines.begin(), lines.end(),
                   [](const VisibleRun& a, const VisibleRun& b) { return is_inner(a.kind) > is_inner(b.kind); });

  // Drops empty strokes.
  std::vector<SceneStroke> result(lines.size());
  parallel_for(lines.size(), threads_, [&](std::size_t i) { result[i] = stroke(lines[i], buffer); });
  std::erase_if(result, [](const SceneStroke& s) { return s.points.empty(); });
  return result;
}

double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

SceneStroke Draughtsman::stroke(const VisibleRun& run, const IdentityBuffer& buffer) const {
  const Sitter& sitter = sitters_[run.instance];
  PenLine line{.points = {}, .opacity = {}, .closed = run.closed};
  double length = 0;
  for (const RunPoint& point : run.points) {
    if (!line.points.empty()) length += glm::distance(line.points.back(), point.at);
    line.points.push_back(point.at);
    line.opacity.push_back(point.opacity * (is_inner(run.kind) ? style_.inner_opacity : 1.0));
    line.heft.push_back(point.heft);
    line.place.push_back(point.own / sitter.wavelength + glm::dvec3(0.37 * run.instance));
    line.outwards.push_back(point.outwards);
  }

  // Short lines are finer, and vanish before they become dots.
  const double share = length / side_ / sitter.fine;
  const double finer = std::clamp(std::sqrt(share / 0.15), 0.45, 1.0) *
                       (run.closed ? smoothstep(0.004, 0.012, share) : smoothstep(0.010, 0.035, share));
  const Solid& solid = scene_.solids[scene_.instances[run.instance].solid];
  SceneStroke result{.instance = run.instance,
                     .kind = run.kind,
                     .closed = run.closed,
                     .color = style_.ink_color.value_or(solid.look->ink.color),
                     .points = {},
                     .distance = {}};
  const double width = finer * (is_inner(run.kind) ? sitter.pen.inner : sitter.pen.outline);
  const double darkest = *std::max_element(line.opacity.begin(), line.opacity.end());
  if (width < 0.05 * scale_ || darkest < 0.06) return result;
  result.points = drawn(line, {.width = width,
                               .wander = is_inner(run.kind) ? 0.35 : 0.3,
                               .wavelength = 1,
                               .taper = 0.06 * side_ * sitter.fine,
                               .sway = 0.1 * width,
                               .min = std::min(width, (is_inner(run.kind) ? 0.6 : 1.25) * scale_ * finer),
                               .from_light = from_light_});
  for (StrokePoint& point : result.points) {
    result.distance.push_back(before_all(point.at, point.radius, buffer));
    point.at /= scale_;
    point.radius /= scale_;
  }
  return result;
}

/// A distance a little smaller than that of all within the radius.
double Draughtsman::before_all(const glm::dvec2& at, double radius, const IdentityBuffer& buffer) const {
  float nearest = 0;
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) {
      const glm::dvec2 place = at + glm::dvec2(x, y) * (0.5 * (radius + 2));
      nearest = std::max(nearest, buffer.nearness[buffer.pixel_at(place)]);
    }
  }
  return nearest > 0 ? 0.995 / static_cast<double>(nearest) : lens_.frame().distance;
}

}  // namespace

std::vector<SceneStroke> scene_strokes(const Scene& scene, const Style& style, const StrokeOptions& options) {
  const auto fits = [](int side) { return side >= 1 && side <= max_picture_side; };
  if (!fits(options.width) || !fits(options.height)) {
    throw Error(ExitStatus::usage, "a picture must be 1 to " + std::to_string(max_picture_side) + " pixels each way");
  }
  if (!style.ink) return {};
  return Draughtsman(scene, style, options).strokes();
}

}  // namespace pomona
