#include "bench/baselines/cube_maps.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "generator/diffusion/nearest_side.h"
#include "generator/diffusion/pmvc/cube_directions.h"
#include "generator/diffusion/resolved_colors.h"
#include "render/gl/objects.h"
#include "render/gl/program.h"

namespace pomona::bench {

namespace {

// A face is a camera's view; q is the corner relative to the point. Depth is the usual one; distance and colours are
// interpolated with perspective. The radial distance is written as a number, because depth has too few digits.
constexpr const char* vertex_shader = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 front;
layout(location = 2) in vec3 back;
uniform vec3 eye;
uniform mat4 face;  // rows: right, up, forward
uniform vec2 planes;  // near, far
out vec3 q;
out vec3 front_color;
out vec3 back_color;

void main() {
  q = position - eye;
  front_color = front;
  back_color = back;
  vec3 seen = mat3(face) * q;
  float depth = (seen.z * (planes.y + planes.x) - 2.0 * planes.y * planes.x) / (planes.y - planes.x);
  gl_Position = vec4(seen.xy, depth, seen.z);
}
)";

constexpr const char* fragment_shader = R"(
in vec3 q;
in vec3 front_color;
in vec3 back_color;
out vec4 weighted;

void main() {
  float weight = 1.0 / length(q);
  weighted = vec4((gl_FrontFacing ? front_color : back_color) * weight, weight);
}
)";

/// Number of points that are drawn before the picture is read back. Faces lie side by side in it, points one above the
/// other.
constexpr int points_at_once = 16;

/// Right, up and forward of the six cameras, right-handed with the viewer: fronts stay fronts.
std::array<glm::mat4, 6> face_views() {
  std::array<glm::mat4, 6> views{};
  for (int i = 0; i < 6; ++i) {
    glm::vec3 forward(0), up(0);
    forward[i / 2] = i % 2 == 0 ? 1.0f : -1.0f;
    up[(i / 2 + 1) % 3] = 1;
    const glm::vec3 right = glm::cross(forward, up);
    for (int k = 0; k < 3; ++k) views[i][k] = glm::vec4(right[k], up[k], forward[k], 0);
  }
  return views;
}

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The point around which a cube map is drawn, and the planes between which everything lies.
struct View {
  std::size_t point = 0;
  glm::vec3 eye{0};  ///< the middle of the surfaces is 0
  float nearest = 0, farthest = 0;
};

/// Surfaces, programs and a picture for some cube maps.
class CubeMaps {
 public:
  CubeMaps(const CurrentGl& gl, const DiffusionSurfaces& surfaces, const glm::dvec3& middle, int texels)
      : gl_(gl),
        texels_(texels),
        face_(make_cube_face(texels)),
        program_(Program::from_sources(gl, resolved_includes(vertex_shader), resolved_includes(fragment_shader))),
        vertices_(gl),
        position_(gl, GL_ARRAY_BUFFER, around(surfaces.position, middle)),
        front_(gl, GL_ARRAY_BUFFER, surfaces.front_color),
        back_(gl, GL_ARRAY_BUFFER, surfaces.back_color),
        corners_(gl, GL_ARRAY_BUFFER, surfaces.triangle),
        corner_count_(static_cast<GLsizei>(3 * surfaces.triangle_count())),
        picture_(gl, GL_RGBA32F, 6 * texels, points_at_once * texels),
        depth_(gl, GL_DEPTH_COMPONENT32F, 6 * texels, points_at_once * texels),
        target_(gl, std::array<const GlTexture*, 1>{&picture_}, &depth_) {
    vertices_.attach(0, 3, position_);
    vertices_.attach(1, 3, front_);
    vertices_.attach(2, 3, back_);
    gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, corners_.id());
    gl_.check("uploading surfaces");
  }

  /// Sums of c / d and of 1 / d, times solid angles, over all directions, for each of up to points_at_once views.
  std::vector<glm::dvec4> sums(std::span<const View> views) const {
    draw(views);
    const std::size_t row = 6 * static_cast<std::size_t>(texels_);
    std::vector<glm::vec4> pixels(row * texels_ * views.size());
    gl_->ReadPixels(0, 0, 6 * texels_, texels_ * static_cast<int>(views.size()), GL_RGBA, GL_FLOAT, pixels.data());
    gl_.check("reading cube maps");

    std::vector<glm::dvec4> sums;
    const auto width = static_cast<std::size_t>(texels_);
    for (std::size_t v = 0; v < views.size(); ++v) {
      glm::dvec4 sum(0);
      for (std::size_t y = 0; y < width; ++y) {
        for (std::size_t x = 0; x < row; ++x) {
          sum += face_.solid_angle[y * width + x % width] * glm::dvec4(pixels[(v * width + y) * row + x]);
        }
      }
      sums.push_back(sum);
    }
    return sums;
  }

 private:
  static std::vector<glm::vec3> around(std::vector<glm::vec3> positions, const glm::dvec3& middle) {
    for (glm::vec3& position : positions) position = glm::vec3(glm::dvec3(position) - middle);
    return positions;
  }

  void draw(std::span<const View> views) const {
    target_.bind(6 * texels_, points_at_once * texels_);
    constexpr std::array<float, 4> nothing{0, 0, 0, 0};
    constexpr float far_away = 1;
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_LESS);
    gl_->ClearBufferfv(GL_COLOR, 0, nothing.data());
    gl_->ClearBufferfv(GL_DEPTH, 0, &far_away);

    program_.use();
    vertices_.bind();
    const std::array<glm::mat4, 6> faces = face_views();
    for (std::size_t v = 0; v < views.size(); ++v) {
      program_.set("eye", views[v].eye);
      program_.set("planes", glm::vec2(views[v].nearest, views[v].farthest));
      for (int f = 0; f < 6; ++f) {
        program_.set("face", faces[static_cast<std::size_t>(f)]);
        gl_->Viewport(f * texels_, static_cast<int>(v) * texels_, texels_, texels_);
        gl_->DrawElementsBaseVertex(GL_TRIANGLES, corner_count_, GL_UNSIGNED_INT, nullptr, 0);
      }
    }
    gl_.check("drawing cube maps");
  }

  const CurrentGl& gl_;
  int texels_;
  CubeFace face_;
  Program program_;
  GlVertexArray vertices_;
  GlBuffer position_, front_, back_, corners_;
  GLsizei corner_count_;
  GlTexture picture_, depth_;
  GlFramebuffer target_;
};

/// Colours that need no cube map, and views for all others.
struct Plan {
  std::vector<Color> color;
  std::vector<View> views;
};

Plan planned(const DiffusionSurfaces& surfaces, const SurfaceTree& tree, const glm::dvec3& middle,
             std::span<const glm::vec3> points) {
  Plan plan;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 point(points[i]);
    const SurfaceSide side = *nearest_side(surfaces, tree, point);
    plan.color.emplace_back(color_of(surfaces, side));
    if (side.distance < 1e-5 * tree.size) continue;

    // Nothing is nearer than `distance`; towards the corner of a face its depth is smaller by the root of 3.
    const double farthest = 1.01 * (tree.size + side.distance);
    plan.views.push_back({i, glm::vec3(point - middle), static_cast<float>(0.5 * side.distance / std::sqrt(3.0)),
                          static_cast<float>(farthest)});
  }
  return plan;
}

}  // namespace

CubeMapColors cube_map_pmvc(const DiffusionSurfaces& surfaces, std::span<const glm::vec3> points,
                            const CubeMapOptions& options) {
  require_finite(points);
  const SurfaceTree tree = make_surface_tree(surfaces);
  const Box<double>& all = tree.levels.back().front();
  const glm::dvec3 middle = 0.5 * (all.low + all.high);
  const Plan plan = planned(surfaces, tree, middle, points);

  GlContext context = options.route ? GlContext(*options.route) : GlContext();
  const CurrentGl gl(context);
  CubeMapColors result{plan.color, 0, 0, context.renderer()};
  if (plan.views.empty()) return result;

  // The first drawing makes the driver compile the shaders, so it counts as setup.
  const std::span<const View> views(plan.views);
  auto start = std::chrono::steady_clock::now();
  const CubeMaps maps(gl, surfaces, middle, options.texels);
  maps.sums(views.first(1));
  result.setup = milliseconds_since(start);

  start = std::chrono::steady_clock::now();
  for (std::size_t first = 0; first < views.size(); first += points_at_once) {
    const auto some = views.subspan(first, std::min<std::size_t>(points_at_once, views.size() - first));
    const std::vector<glm::dvec4> sums = maps.sums(some);
    for (std::size_t v = 0; v < some.size(); ++v) {
      if (sums[v].w > 0) result.color[some[v].point] = Color(glm::dvec3(sums[v]) / sums[v].w);
    }
  }
  result.per_point = milliseconds_since(start) / static_cast<double>(views.size());
  return result;
}

}  // namespace pomona::bench
