#include "render/gl/glass.h"

#include <array>

#include <glm/matrix.hpp>

namespace pomona {

namespace {

/// Queries whether anything has been drawn while this exists.
class DrawnQuery {
 public:
  explicit DrawnQuery(const CurrentGl& gl) : gl_(gl.functions()) {
    gl_.GenQueries(1, &id_);
    gl_.BeginQuery(GL_ANY_SAMPLES_PASSED, id_);
  }
  ~DrawnQuery() { gl_.DeleteQueries(1, &id_); }
  DrawnQuery(const DrawnQuery&) = delete;
  DrawnQuery& operator=(const DrawnQuery&) = delete;

  bool end() const {
    gl_.EndQuery(GL_ANY_SAMPLES_PASSED);
    GLuint any = 0;
    gl_.GetQueryObjectuiv(id_, GL_QUERY_RESULT, &any);
    return any != 0;
  }

 private:
  const GlFunctions& gl_;
  GLuint id_ = 0;
};

constexpr std::array<float, 4> nothing_at_all{0, 0, 0, 0};

class LayerPeeler {
 public:
  LayerPeeler(const CurrentGl& gl, const PlacedSolids& solids, const GlassView& view, const GlTexture& opaque_depth,
              const glm::ivec2& samples)
      : gl_(gl),
        solids_(solids),
        view_(view),
        opaque_depth_(opaque_depth),
        samples_(samples),
        gathered_(gl, GL_RGBA16F, samples.x, samples.y),
        color_slope_(gl, GL_RGBA16F, samples.x, samples.y),
        normal_(gl, GL_RGBA16F, samples.x, samples.y),
        ids_(gl, GL_R32UI, samples.x, samples.y),
        depth_{GlTexture(gl, GL_DEPTH_COMPONENT32F, samples.x, samples.y),
               GlTexture(gl, GL_DEPTH_COMPONENT32F, samples.x, samples.y)},
        nothing_(gl) {}

  GlTexture peeled() {
    clear({&gathered_}, nullptr);
    clear({&color_slope_}, &depth_[0]);  // the first layer lies behind the plane of the eye
    const Program start(gl_, "fullscreen.vert.glsl", "glass_start.frag.glsl");
    const Program peel(gl_, "glass.vert.glsl", "glass.frag.glsl");
    const Program light(gl_, "fullscreen.vert.glsl", "glass_layer.frag.glsl");
    int layer = 0;
    for (; layer < view_.max_layers; ++layer) {
      const GlTexture& last = depth_[layer % 2];
      const GlTexture& depth = depth_[(layer + 1) % 2];
      start_layer(start, depth);
      if (!peel_layer(peel, last, depth)) break;
      light_layer(light);
    }
    if (layer == view_.max_layers) add_the_rest(start, depth_[layer % 2], depth_[(layer + 1) % 2]);
    gl_.check("what is see-through");
    return std::move(gathered_);
  }

 private:
  using Colors = std::vector<const GlTexture*>;

  GlFramebuffer bound(const Colors& colors, const GlTexture* depth) const {
    GlFramebuffer target(gl_, colors, depth);
    target.bind(samples_.x, samples_.y);
    return target;
  }

  /// Clears to nothing, and to the nearest depth.
  void clear(const Colors& colors, const GlTexture* depth) const {
    const GlFramebuffer target = bound(colors, depth);
    for (GLint i = 0; i < static_cast<GLint>(colors.size()); ++i) {
      gl_->ClearBufferfv(GL_COLOR, i, nothing_at_all.data());
    }
    if (depth != nullptr) gl_->ClearBufferfv(GL_DEPTH, 0, nothing_at_all.data());
  }

  /// Fills `depth` with the depth before which layers must lie.
  void start_layer(const Program& program, const GlTexture& depth) const {
    const GlFramebuffer target = bound({}, &depth);
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_ALWAYS);
    gl_->DepthMask(GL_TRUE);
    gl_->Disable(GL_BLEND);
    program.use();
    program.set("opaque_depth", 0);
    program.set("gathered", 1);
    opaque_depth_.bind(0);
    gathered_.bind(1);
    nothing_.bind();
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
    gl_->DepthFunc(GL_LESS);
  }

  /// Draws the nearest surfaces behind `last` into color_slope_, normal_, ids_ and `depth`.
  /// \return whether there are any.
  bool peel_layer(const Program& program, const GlTexture& last, const GlTexture& depth) const {
    const GlFramebuffer target = bound({&color_slope_, &normal_, &ids_}, &depth);
    constexpr std::array<unsigned, 4> no_id{0, 0, 0, 0};
    gl_->ClearBufferuiv(GL_COLOR, 2, no_id.data());
    const DrawnQuery query(gl_);
    draw_behind(program, last);
    return query.end();
  }

  void draw_behind(const Program& program, const GlTexture& last) const {
    program.use();
    program.set("projection", view_.camera.projection * view_.camera.view);
    program.set("last_depth", 0);
    last.bind(0);
    set_light(program);
    solids_.draw(program, Drawn::see_through);
  }

  void set_light(const Program& program) const {
    program.set("eye", view_.eye);
    program.set("to_light", view_.to_light);
    program.set("gloss", view_.gloss);
    program.set("light_strengths", view_.light_strengths);
    program.set("inked", view_.inked ? 1 : 0);
    program.set("instances", 4);
    view_.instances->bind(4);
  }

  /// Adds the layer behind the gathered ones.
  void light_layer(const Program& program) const {
    program.use();
    set_light(program);
    program.set("tangent", view_.camera.tangent);
    program.set("camera_to_scene", glm::inverse(view_.camera.view));
    program.set("color_slope", 0);
    program.set("normal", 1);
    program.set("ids", 2);
    color_slope_.bind(0);
    normal_.bind(1);
    ids_.bind(2);
    lay_behind();
  }

  /// Adds the output of the current program behind the gathered layers; all colours are multiplied by their coverage
  /// [Porter & Duff 1984].
  void lay_behind() const {
    const GlFramebuffer target = bound({&gathered_}, nullptr);
    gl_->Disable(GL_DEPTH_TEST);
    gl_->Enable(GL_BLEND);
    gl_->BlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    nothing_.bind();
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
    gl_->Disable(GL_BLEND);
  }

  /// Adds all remaining layers, summed in any order: their mean colour, with their joint coverage.
  void add_the_rest(const Program& start, const GlTexture& last, const GlTexture& depth) const {
    start_layer(start, depth);
    const GlTexture& sums = color_slope_;
    const GlTexture& thickness = normal_;
    clear({&sums, &thickness}, nullptr);
    {
      const GlFramebuffer target = bound({&sums, &thickness}, &depth);
      gl_->DepthMask(GL_FALSE);
      gl_->Enable(GL_BLEND);
      gl_->BlendFunc(GL_ONE, GL_ONE);
      draw_behind(Program(gl_, "glass.vert.glsl", "glass.frag.glsl", "ALL_THAT_IS_LEFT"), last);
      gl_->DepthMask(GL_TRUE);
    }
    const Program mean(gl_, "fullscreen.vert.glsl", "glass_layer.frag.glsl", "ALL_THAT_IS_LEFT");
    mean.use();
    mean.set("layer", 0);
    mean.set("thickness", 1);
    sums.bind(0);
    thickness.bind(1);
    lay_behind();
  }

  const CurrentGl& gl_;
  const PlacedSolids& solids_;
  const GlassView& view_;
  const GlTexture& opaque_depth_;
  glm::ivec2 samples_;
  GlTexture gathered_;                    // all layers so far
  GlTexture color_slope_, normal_, ids_;  // colour and slope, normals and ids of this layer
  std::array<GlTexture, 2> depth_;        // depths of this layer and of the last
  GlVertexArray nothing_;
};

}  // namespace

GlTexture glass_layers(const CurrentGl& gl, const PlacedSolids& solids, const GlassView& view,
                       const GlTexture& opaque_depth, const glm::ivec2& samples) {
  return LayerPeeler(gl, solids, view, opaque_depth, samples).peeled();
}

}  // namespace pomona
