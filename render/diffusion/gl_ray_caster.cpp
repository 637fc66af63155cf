#include "render/diffusion/gl_ray_caster.h"

#include <algorithm>
#include <string>
#include <utility>

#include "generator/base/error.h"
#include "generator/diffusion/pmvc/line_directions.h"
#include "render/gl/objects.h"

namespace pomona {

namespace {

constexpr std::size_t lines_per_block = 8;  // as in pmvc_rays.comp.glsl

/// Number of blocks whose sums are stored at a time. It must be constant, because it determines the order of additions
/// in single precision.
constexpr std::size_t blocks_per_chunk = 32;

/// Rays in one dispatch, 16 per invocation: enough to fill a large card, and a tenth of a second on a slow one, far
/// below the time after which drivers stop a shader.
constexpr std::size_t rays_per_dispatch = std::size_t{1} << 22;

/// Number of groups in one pass: more than any card processes at once.
constexpr std::size_t max_groups = 4096;

std::size_t storage_limit(const CurrentGl& gl) {
  GLint bytes = 0;
  gl->GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  gl.check("asking how much a storage buffer holds");
  return static_cast<std::size_t>(std::max(bytes, 0));
}

const CurrentGl& require_compute_shaders(const CurrentGl& gl, const GlContext& context) {
  if (context.version() >= 45) return gl;
  const std::string version = std::to_string(context.version() / 10) + "." + std::to_string(context.version() % 10);
  throw Error(ExitStatus::helper_missing,
              "diffusion by OpenGL needs version 4.5; " + context.renderer() + " has " + version, "use --diffuser cpu");
}

/// Three vectors per line. Lines are dealt to the blocks in turn, so that each block covers all directions.
std::vector<glm::vec4> shuffled_lines(int count) {
  const std::vector<Line> lines = line_directions(count);
  const std::size_t blocks = (lines.size() + lines_per_block - 1) / lines_per_block;
  std::vector<glm::vec4> shuffled;
  for (std::size_t block = 0; block < blocks; ++block) {
    for (std::size_t i = block; i < lines.size(); i += blocks) {
      for (const glm::vec3& axis : {lines[i].across_u, lines[i].across_v, lines[i].along})
        shuffled.emplace_back(axis, 0);
    }
  }
  return shuffled;
}

/// Floats of one group and block: colour and weight, and the weight of each part.
std::size_t sums_of(const PointGroup& group) { return PointGroup::size * (4 + group.parts); }

/// A group as the shaders know it.
struct GroupRecord {
  std::uint32_t points = 0, parts = 0, first_sum = 0, unused = 0;
  std::uint32_t first_node = 0, first_triangle = 0, first_vertex = 0, first_total = 0;
};

/// A sight as the shaders write it.
struct SightRecord {
  glm::vec4 mean_and_weight{0};
  glm::vec4 rest{0};  ///< heaviest part, scatter, whether a surface is near
};

}  // namespace

/// One pass: some groups with all lines.
class GlRayCaster::Pass {
 public:
  Pass(const CurrentGl& gl, const GlRayCaster& caster, const GlLines& lines)
      : gl_(gl), caster_(caster), lines_(lines) {}

  std::size_t blocks_in_chunk() const { return std::min(blocks_per_chunk, blocks_from(0)); }

  /// The buffer into which the card writes what it sees.
  GlBuffer start(const GlFruits& fruits, std::span<const PointGroup> groups) const {
    // Place the groups' sums and totals one behind the other.
    std::vector<GroupRecord> records;
    std::vector<glm::vec4> eyes;
    std::size_t totals = 0;
    for (const PointGroup& group : groups) {
      records.push_back({static_cast<std::uint32_t>(group.eye.size()), group.parts,
                         static_cast<std::uint32_t>(totals * blocks_in_chunk()), 0, group.fruit.node,
                         group.fruit.triangle, group.fruit.vertex, static_cast<std::uint32_t>(totals)});
      for (const glm::vec3& eye : group.eye) eyes.emplace_back(eye, 1);
      eyes.resize(records.size() * PointGroup::size);
      totals += sums_of(group);
    }

    const GlBuffer points(gl_, GL_SHADER_STORAGE_BUFFER, eyes);
    const GlBuffer places(gl_, GL_SHADER_STORAGE_BUFFER, records);
    const GlBuffer sums = room(totals * blocks_in_chunk() * sizeof(float)), total = room(totals * sizeof(float));
    GlBuffer seen = room(eyes.size() * sizeof(SightRecord));
    gl_.check("making room for sums");
    const auto [nodes, triangles, sides, colors] = fruits.buffers();
    for (std::size_t block = 0; blocks_from(block) > 0; block += blocks_in_chunk()) {
      bind({nodes, triangles, sides, colors, &points, &places, &lines_.axes, &sums});
      cast_rays(block, groups.size());
      bind({&total, &seen});
      add_up(block, groups.size());
    }
    bind({nodes, triangles, &seen});
    look_near(groups.size());
    return seen;
  }

 private:
  std::size_t blocks_from(std::size_t first) const {
    const std::size_t all = (lines_.count + lines_per_block - 1) / lines_per_block;
    return first < all ? all - first : 0;
  }

  GlBuffer room(std::size_t bytes) const { return {gl_, GL_SHADER_STORAGE_BUFFER, nullptr, bytes}; }

  void bind(std::initializer_list<const GlBuffer*> buffers) const {
    GLuint binding = 0;
    for (const GlBuffer* buffer : buffers) gl_->BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding++, buffer->id());
  }

  /// Casts a chunk, in dispatches that are short enough.
  void cast_rays(std::size_t first_block, std::size_t groups) const {
    caster_.rays_.use();
    caster_.rays_.set("first_line", static_cast<unsigned>(first_block * lines_per_block));
    caster_.rays_.set("line_count", static_cast<unsigned>(lines_.count));
    const std::size_t blocks = std::min(blocks_in_chunk(), blocks_from(first_block));
    const std::size_t rays_per_row = groups * PointGroup::size * lines_per_block * 2;
    const std::size_t at_once = std::max<std::size_t>(1, rays_per_dispatch / rays_per_row);
    for (std::size_t block = 0; block < blocks; block += at_once) {
      caster_.rays_.set("first_block", static_cast<unsigned>(block));
      gl_->DispatchCompute(static_cast<GLuint>(groups), static_cast<GLuint>(std::min(at_once, blocks - block)), 1);
      gl_->Flush();
    }
    gl_->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    gl_.check("looking along lines");
  }

  void add_up(std::size_t first_block, std::size_t groups) const {
    caster_.sums_.use();
    caster_.sums_.set("blocks", static_cast<unsigned>(std::min(blocks_in_chunk(), blocks_from(first_block))));
    caster_.sums_.set("is_first", first_block == 0 ? 1 : 0);
    gl_->DispatchCompute(static_cast<GLuint>(groups), 1, 1);
    gl_->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    gl_.check("adding up");
  }

  void look_near(std::size_t groups) const {
    caster_.near_.use();
    gl_->DispatchCompute(static_cast<GLuint>(groups), 1, 1);
    gl_->MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gl_->Flush();
    gl_.check("looking for surfaces nearby");
  }

  const CurrentGl& gl_;
  const GlRayCaster& caster_;
  const GlLines& lines_;
};

GlRayCaster::GlRayCaster(const CurrentGl& gl, const GlContext& context, std::size_t max_bytes)
    : rays_(Program::compute(require_compute_shaders(gl, context), "pmvc_rays.comp.glsl")),
      sums_(Program::compute(gl, "pmvc_sums.comp.glsl")),
      near_(Program::compute(gl, "pmvc_near.comp.glsl")),
      max_bytes_(std::min(storage_limit(gl), max_bytes)) {}

GlLines GlRayCaster::lines(const CurrentGl& gl, int count) {
  return {static_cast<std::size_t>(count), {gl, GL_SHADER_STORAGE_BUFFER, shuffled_lines(count)}};
}

CastRays GlRayCaster::cast(const CurrentGl& gl, const GlFruits& fruits, std::span<const PointGroup> groups,
                           const GlLines& lines) const {
  CastRays rays;
  for (const PointGroup& group : groups) rays.points.push_back(group.eye.size());
  const Pass pass(gl, *this, lines);
  const std::size_t max_sums = max_bytes_ / sizeof(float) / pass.blocks_in_chunk();

  // Take as many groups at a time as there is room for their sums.
  for (std::size_t first = 0; first < groups.size();) {
    std::size_t end = first, sums = 0;
    while (end < groups.size() && end - first < max_groups && sums + sums_of(groups[end]) <= max_sums) {
      sums += sums_of(groups[end++]);
    }
    if (end == first) throw Error(ExitStatus::helper_missing, "this OpenGL's storage buffers are too small");
    rays.seen.push_back(pass.start(fruits, groups.subspan(first, end - first)));
    rays.groups.push_back(end - first);
    first = end;
  }
  return rays;
}

std::vector<Sight> GlRayCaster::read(const CurrentGl& gl, const CastRays& rays) {
  std::vector<SightRecord> records(rays.points.size() * PointGroup::size);
  SightRecord* next = records.data();
  for (std::size_t pass = 0; pass < rays.seen.size(); ++pass) {
    const std::size_t count = rays.groups[pass] * PointGroup::size;
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, rays.seen[pass].id());
    gl->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(count * sizeof(SightRecord)), next);
    next += count;
  }
  gl.check("reading what was seen");

  std::vector<Sight> sights;
  for (std::size_t g = 0; g < rays.points.size(); ++g) {
    for (std::size_t i = 0; i < rays.points[g]; ++i) {
      const SightRecord& record = records[g * PointGroup::size + i];
      sights.push_back({glm::vec3(record.mean_and_weight), record.mean_and_weight.w,
                        static_cast<std::uint32_t>(record.rest.x), record.rest.y, record.rest.z > 0});
    }
  }
  return sights;
}

}  // namespace pomona
