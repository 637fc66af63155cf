#include "render/gl/scene_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "generator/base/error.h"
#include "generator/base/free_memory.h"
#include "render/gl/glass.h"
#include "render/gl/objects.h"
#include "render/gl/placed_solids.h"
#include "render/gl/program.h"
#include "render/gl/scene_camera.h"
#include "render/gl/scene_instances.h"
#include "render/marks/marks.h"
#include "render/picture/marks_on_picture.h"
#include "render/strokes/ink_on_picture.h"

namespace pomona {

namespace {

constexpr float juice_reach = 0.009f;  // metres: how far juice runs from what lies on the table
constexpr double juicy = 1.2;          // how wet a part's cut faces are, from which on juice runs out of them
constexpr int shadow_side = 2048, table_side = 1024;  // samples of the maps each way

/// The nearest surface at each sample.
struct Surfaces {
  Surfaces(const CurrentGl& gl, const glm::ivec2& samples)
      : albedo(gl, GL_RGBA16F, samples.x, samples.y),
        normal_line(gl, GL_RGBA16F, samples.x, samples.y),
        ids(gl, GL_R32UI, samples.x, samples.y),
        depth(gl, GL_DEPTH_COMPONENT32F, samples.x, samples.y) {}

  GlTexture albedo, normal_line, ids, depth;
};

/// The textures that passes exchange, with `samples` along a pixel's side unless said otherwise.
struct Targets {
  Targets(const CurrentGl& gl, const PictureOptions& options, int side)
      : samples(options.width * side, options.height * side),
        opaque(gl, samples),
        light{GlTexture(gl, GL_RGBA16F, options.width, options.height),
              GlTexture(gl, GL_RGBA16F, options.width, options.height)},
        paper(gl, GL_DEPTH_COMPONENT32F, options.width, options.height),
        shadow(gl, GL_DEPTH_COMPONENT32F, shadow_side, shadow_side),
        lowest(gl, GL_DEPTH_COMPONENT32F, table_side, table_side),
        picture(gl, GL_RGBA8, options.width, options.height) {}

  glm::ivec2 samples;
  Surfaces opaque;
  std::optional<GlTexture> glass;         // all transparent layers
  std::optional<GlTexture> guide_shares;  // of texture detail, if any
  std::array<GlTexture, 2> light;         // one per pixel: sky, light, distance
  GlTexture paper;                        // one per pixel: the far depth if it shows no piece, else the near one
  GlTexture shadow;
  GlTexture lowest;                          // the pieces on the table, seen from below
  std::optional<GlTexture> far_shadow;       // depths farthest from the light, if anything is translucent
  std::optional<GlTexture> arrives, leaves;  // one per pixel: sunlight through the fruit, likewise
  std::optional<GlTexture> hairs;            // over the ink, if any
  GlTexture picture;                         // one per pixel
};

/// Draws one scene; its passes in the order in which they run.
class ScenePainter {
 public:
  ScenePainter(const CurrentGl& gl, const Scene& scene, const Style& style, const PictureOptions& options)
      : gl_(gl),
        scene_(scene),
        style_(style),
        options_(options),
        side_(static_cast<int>(std::lround(std::sqrt(options.samples)))),
        ball_(ball_around(scene)),
        camera_(camera_of(scene, ball_, static_cast<double>(options.width) / options.height)),
        light_(light_of(camera_, ball_, style.light)),
        shade_(table_shade_of(scene, ball_)),
        targets_(gl, options, side_),
        solids_(gl, scene, style),
        texels_(instance_texels(scene, camera_, style, targets_.samples)),
        instances_(gl, GL_RGBA32F, texels_, "pieces"),
        nothing_(gl) {}

  Image painted() {
    cast_shadows(targets_.shadow, shadow_side, light_.to_clip);
    if (shade_.reach > 0) cast_shadows(targets_.lowest, table_side, shade_.to_clip);
    draw_surfaces();
    if (solids_.any(Drawn::see_through)) draw_glass();
    look_for_light();
    if (solids_.any_translucent()) look_through();
    if (solids_.any_hairs()) draw_hairs();
    compose("PAPER", GL_LESS);
    compose(detailed(), GL_GREATER);
    return read_back();
  }

 private:
  void cast_shadows(const GlTexture& map, int side, const glm::mat4& to_clip);
  void draw_surfaces();
  void draw_ground();
  void draw_glass();
  void look_for_light();
  void look_through();
  void cast_far_shadows(const GlTexture& map);
  void draw_hairs();
  void bind_materials(const Program& program) const;
  void compose(const char* definition, GLenum depth_test);
  Image read_back();

  /// The same definition, and one more where the style's light is a window's.
  std::string in_its_light(const std::string& definition) const {
    if (!style_.light.window) return definition;
    return definition.empty() ? "WINDOW" : definition + "\n#define WINDOW";
  }

  /// How much juice there is to be seen: none on what is whole or dry.
  float juice() const;

  /// The definition with which programs for texture detail are compiled.
  const char* detailed() const {
    if (!solids_.detail_styles()) return "";
    return solids_.any_example() ? "DETAILED\n#define EXAMPLES" : "DETAILED";
  }

  void fill(const GlFramebuffer& target, const glm::ivec2& size, GLenum depth_test = GL_ALWAYS);
  void set_camera(const Program& program, const Surfaces& surfaces) const;
  glm::mat4 to_unit_box(const glm::mat4& to_clip) const;

  const CurrentGl& gl_;
  const Scene& scene_;
  const Style& style_;
  const PictureOptions& options_;
  int side_;
  SceneBall ball_;
  SceneCamera camera_;
  SceneLight light_;
  TableShade shade_;
  Targets targets_;
  PlacedSolids solids_;
  std::vector<InstanceTexels> texels_;
  GlTable instances_;
  GlVertexArray nothing_;  // for passes that fill the picture
};

void ScenePainter::cast_shadows(const GlTexture& map, int side, const glm::mat4& to_clip) {
  const GlFramebuffer target(gl_, {}, &map);
  target.bind(side, side);
  const float far = 1;
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_LESS);
  gl_->DepthMask(GL_TRUE);
  gl_->Disable(GL_CULL_FACE);
  gl_->Disable(GL_BLEND);
  gl_->ClearBufferfv(GL_DEPTH, 0, &far);

  for (const Drawn which : {Drawn::opaque, Drawn::see_through}) {
    if (!solids_.any(which)) continue;
    // A shader that discards samples prevents early depth tests.
    const char* definition = which == Drawn::see_through ? "SEE_THROUGH" : "";
    const Program program(gl_, "solid.vert.glsl", "shadow.frag.glsl", definition);
    program.use();
    program.set("projection", to_clip);
    solids_.draw(program, which);
  }
  gl_.check("a shadow map");
}

void ScenePainter::draw_surfaces() {
  // Clears to no colour, no id, and the far depth. Shares of details are drawn with the rest, because drawing all
  // triangles again takes longer than storing shares of surfaces that are hidden later.
  const Surfaces& surfaces = targets_.opaque;
  std::vector<const GlTexture*> colors{&surfaces.albedo, &surfaces.normal_line, &surfaces.ids};
  if (solids_.detail_styles()) {
    colors.push_back(&targets_.guide_shares.emplace(gl_, GL_RGBA8, targets_.samples.x, targets_.samples.y));
  }
  const GlFramebuffer target(gl_, colors, &surfaces.depth);
  target.bind(targets_.samples.x, targets_.samples.y);
  const std::array<float, 4> empty{0, 0, 0, 0};
  const std::array<unsigned, 4> no_id{0, 0, 0, 0};
  const float far = 1;
  gl_->ClearBufferfv(GL_COLOR, 0, empty.data());
  gl_->ClearBufferfv(GL_COLOR, 1, empty.data());
  gl_->ClearBufferuiv(GL_COLOR, 2, no_id.data());
  if (targets_.guide_shares) gl_->ClearBufferfv(GL_COLOR, 3, empty.data());
  gl_->ClearBufferfv(GL_DEPTH, 0, &far);

  // Draws all opaque solids, then the ground.
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_LESS);
  solids_.triangle_tags().bind(0);
  const Program program(gl_, "solid.vert.glsl", "solid.frag.glsl", detailed());
  program.use();
  program.set("projection", camera_.projection * camera_.view);
  program.set("triangle_tags", 0);
  solids_.draw(program, Drawn::opaque);
  if (scene_.ground) draw_ground();
  gl_.check("the solids");
}

void ScenePainter::draw_ground() {
  const Program program(gl_, "ground.vert.glsl", "ground.frag.glsl", detailed());
  program.use();
  program.set("projection", camera_.projection * camera_.view);
  program.set("ground_center", ball_.center);
  program.set("ground_reach", 12.0f * ball_.radius);
  nothing_.bind();
  gl_->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void ScenePainter::draw_glass() {
  const GlassView view{.camera = camera_,
                       .eye = scene_.view.eye,
                       .to_light = light_.to_light,
                       .gloss = static_cast<float>(style_.gloss),
                       .light_strengths = {style_.light.strength, style_.light.ambient},
                       .inked = style_.ink,
                       .instances = &instances_.texture(),
                       .max_layers = options_.max_layers};
  targets_.glass.emplace(glass_layers(gl_, solids_, view, targets_.opaque.depth, targets_.samples));
}

/// Runs the current program on every pixel of the target, or, if it has depths, on those that pass the depth test: the
/// triangle of fullscreen.vert.glsl has a depth of one half.
void ScenePainter::fill(const GlFramebuffer& target, const glm::ivec2& size, GLenum depth_test) {
  target.bind(size.x, size.y);
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(depth_test);
  nothing_.bind();
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  gl_->DepthFunc(GL_LESS);
}

void ScenePainter::set_camera(const Program& program, const Surfaces& surfaces) const {
  program.set("depth_range", glm::vec2(camera_.near, camera_.far));
  program.set("tangent", camera_.tangent);
  program.set("view", camera_.view);
  program.set("samples_per_side", side_);
  program.set("ids", 0);
  program.set("depth", 1);
  program.set("normal_line", 2);
  program.set("instances", 3);
  surfaces.ids.bind(0);
  surfaces.depth.bind(1);
  surfaces.normal_line.bind(2);
  instances_.texture().bind(3);
}

/// The matrix from the camera to a map's box, 0..1 along each axis.
glm::mat4 ScenePainter::to_unit_box(const glm::mat4& to_clip) const {
  const glm::mat4 to_unit(glm::vec4(0.5f, 0, 0, 0), glm::vec4(0, 0.5f, 0, 0), glm::vec4(0, 0, 0.5f, 0),
                          glm::vec4(0.5f, 0.5f, 0.5f, 1));
  return to_unit * to_clip * glm::inverse(camera_.view);
}

float ScenePainter::juice() const {
  const auto is_juicy = [](const Solid& solid) {
    for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
      if (solid.mesh.cut_face[t] < 0) continue;
      if (material_of(solid, solid.mesh.part[solid.mesh.triangle[t].x]).wet >= juicy) return true;
    }
    return false;
  };
  const bool any = std::any_of(scene_.solids.begin(), scene_.solids.end(), is_juicy);
  return any ? static_cast<float>(style_.juice) : 0;
}

void ScenePainter::look_for_light() {
  const glm::ivec2 size(options_.width, options_.height);
  const Program program(gl_, "fullscreen.vert.glsl", "light.frag.glsl", in_its_light(""));
  program.use();
  if (style_.light.window) program.set("juice_reach", juice() > 0 ? juice_reach : 0.0f);
  set_camera(program, targets_.opaque);
  program.set("camera_to_light", to_unit_box(light_.to_clip));
  program.set("reach", 0.16f * ball_.radius);
  program.set("light_size", static_cast<float>(style_.light.softness));
  program.set("strengths", glm::vec2(style_.light.occlusion, style_.shadow.strength));
  program.set("shadow_bias", glm::vec2(0.004f * ball_.radius, 0.0012f));
  program.set("shadow_map", 4);
  targets_.shadow.bind(4);
  program.set("camera_to_table", to_unit_box(shade_.to_clip));
  program.set("table_reach", glm::vec2(shade_.reach, shade_.reach / shade_.side));
  program.set("lowest", 5);
  targets_.lowest.bind(5);
  const std::array<const GlTexture*, 1> raw{&targets_.light[0]}, soft{&targets_.light[1]};
  const GlFramebuffer and_paper(gl_, raw, &targets_.paper), to_raw(gl_, raw, nullptr), to_soft(gl_, soft, nullptr);
  fill(and_paper, size);

  // Across and up.
  const Program soften(gl_, "fullscreen.vert.glsl", "soften.frag.glsl");
  soften.use();
  soften.set("light_in", 0);
  soften.set("direction", glm::vec2(1, 0));
  targets_.light[0].bind(0);
  fill(to_soft, size);
  soften.set("direction", glm::vec2(0, 1));
  targets_.light[1].bind(0);
  fill(to_raw, size);
  gl_.check("light and sky");
}

/// Computes the sunlight through each place, from the surfaces nearest to the light and farthest from it.
void ScenePainter::look_through() {
  // Only this pass needs the surfaces farthest from the light.
  cast_far_shadows(targets_.far_shadow.emplace(gl_, GL_DEPTH_COMPONENT32F, shadow_side, shadow_side));
  const glm::ivec2 size(options_.width, options_.height);
  targets_.arrives.emplace(gl_, GL_RGBA16F, size.x, size.y);
  targets_.leaves.emplace(gl_, GL_RGBA16F, size.x, size.y);

  // Uses depths from both maps, with colours and materials, which decide how much passes.
  const Program program(gl_, "fullscreen.vert.glsl", "through.frag.glsl");
  program.use();
  set_camera(program, targets_.opaque);
  program.set("camera_to_light", to_unit_box(light_.to_clip));
  program.set("light_box", light_.box);
  program.set("slack", 0.004f * ball_.radius);
  program.set("shadow_map", 4);
  program.set("far_map", 5);
  program.set("albedo", 6);
  program.set("materials", 7);
  targets_.shadow.bind(4);
  targets_.far_shadow->bind(5);
  targets_.opaque.albedo.bind(6);
  solids_.materials().bind(7);

  // One pass finds how much light arrives at each place, and how much would leave beyond it.
  const std::array<const GlTexture*, 2> both{&*targets_.arrives, &*targets_.leaves};
  fill(GlFramebuffer(gl_, both, nullptr), size);
  gl_.check("light through the fruit");
  targets_.far_shadow.reset();
}

void ScenePainter::cast_far_shadows(const GlTexture& map) {
  const GlFramebuffer target(gl_, {}, &map);
  target.bind(shadow_side, shadow_side);
  const Program program(gl_, "solid.vert.glsl", "shadow.frag.glsl");
  const float near = 0;
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(GL_GREATER);
  gl_->CullFace(GL_FRONT);
  gl_->ClearBufferfv(GL_DEPTH, 0, &near);
  program.use();
  program.set("projection", light_.to_clip);
  if (solids_.any(Drawn::opaque)) solids_.draw(program, Drawn::opaque);
  gl_->CullFace(GL_BACK);
  gl_->DepthFunc(GL_LESS);
}

/// Hairs lie over the ink, on a layer of their own.
void ScenePainter::draw_hairs() {
  // Solids hide hairs; hairs hide nothing and are blended over each other.
  const GlTexture& layer = targets_.hairs.emplace(gl_, GL_RGBA16F, targets_.samples.x, targets_.samples.y);
  const std::array<const GlTexture*, 1> colors{&layer};
  const GlFramebuffer target(gl_, colors, &targets_.opaque.depth);
  target.bind(targets_.samples.x, targets_.samples.y);
  const std::array<float, 4> empty{0, 0, 0, 0};
  gl_->ClearBufferfv(GL_COLOR, 0, empty.data());
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthMask(GL_FALSE);
  gl_->Enable(GL_BLEND);
  gl_->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

  // A hair is lit as the skin there, and covers a sample by its width.
  const Program program(gl_, "hair.vert.glsl", "hair.frag.glsl");
  program.use();
  program.set("projection", camera_.projection * camera_.view);
  program.set("view", camera_.view);
  program.set("eye", glm::vec3(scene_.view.eye));
  program.set("to_light", light_.to_light);
  program.set("light_strengths", glm::vec2(style_.light.strength, style_.light.ambient));
  program.set("sample_angle", 2.0f * camera_.tangent.y / static_cast<float>(targets_.samples.y));
  program.set("light", 0);
  targets_.light[0].bind(0);
  solids_.draw_hairs(program);
  gl_->Disable(GL_BLEND);
  gl_->DepthMask(GL_TRUE);
  gl_.check("the hairs");
}

/// The results of look_through() and draw_hairs(), if they ran.
void ScenePainter::bind_materials(const Program& program) const {
  program.set("translucent", targets_.arrives ? 1 : 0);
  program.set("hairy", targets_.hairs ? 1 : 0);
  program.set("materials", 10);
  solids_.materials().bind(10);
  program.set("arrives", 6);
  program.set("leaves", 8);
  program.set("hairs", 11);
  if (targets_.arrives) targets_.arrives->bind(6);
  if (targets_.leaves) targets_.leaves->bind(8);
  if (targets_.hairs) targets_.hairs->bind(11);
}

/// Runs where the map of paper passes the depth test: software renderers run both sides of a branch, but skip blocks of
/// pixels that fail a depth test.
void ScenePainter::compose(const char* definition, GLenum depth_test) {
  // Sets the nearest surface, its colour, and the light on it.
  const std::array<const GlTexture*, 1> colors{&targets_.picture};
  const GlFramebuffer target(gl_, colors, &targets_.paper);
  const GlTexture* const details = solids_.detail_styles();
  const Program program(gl_, "fullscreen.vert.glsl", "compose.frag.glsl", in_its_light(definition));
  program.use();
  if (style_.light.window) program.set("juice", juice());
  set_camera(program, targets_.opaque);
  program.set("albedo", 4);
  program.set("light", 5);
  targets_.opaque.albedo.bind(4);
  targets_.light[0].bind(5);

  // Sets noise and detail, materials, and transparent layers, if the scene has any.
  program.set("noise_styles", 7);
  solids_.noise_styles().bind(7);
  if (details) {
    program.set("detail_styles", 13), details->bind(13);
    program.set("guide_lattices", 14), solids_.guide_lattices()->bind(14);
    program.set("guide_shares", 15), targets_.guide_shares->bind(15);
  }
  bind_materials(program);
  program.set("pits", 12);
  solids_.pits().bind(12);
  program.set("see_through", targets_.glass ? 1 : 0);
  program.set("glass", 9);
  if (targets_.glass) targets_.glass->bind(9);

  // Sets paper, paint and shadow of the style.
  program.set("pixel_angle", 2.0f * camera_.tangent.y / static_cast<float>(options_.height));
  program.set("paper", scene_.paper);
  program.set("grain", static_cast<float>(style_.grain));
  program.set("vignette", static_cast<float>(style_.vignette));
  program.set("paint", glm::vec3(style_.saturation, style_.lightness, style_.grain * style_.granulation));
  program.set("shadow_color", style_.shadow.color);
  program.set("light_strengths", glm::vec2(style_.light.strength, style_.light.ambient));

  // Sets the gloss, and the places of eye and light.
  program.set("gloss", static_cast<float>(style_.gloss));
  program.set("camera_to_scene", glm::inverse(camera_.view));
  program.set("to_light", light_.to_light);
  gl_->DepthMask(GL_FALSE);
  fill(target, {options_.width, options_.height}, depth_test);
  gl_->DepthMask(GL_TRUE);
  gl_.check("the picture");
}

Image ScenePainter::read_back() {
  const std::array<const GlTexture*, 1> colors{&targets_.picture};
  const GlFramebuffer target(gl_, colors, nullptr);
  target.bind(options_.width, options_.height);
  Image image{options_.width, options_.height, {}};
  image.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_->ReadPixels(0, 0, image.width, image.height, GL_RGB, GL_UNSIGNED_BYTE, image.pixels.data());
  gl_.check("reading the picture");
  return image;
}

void check_options(const CurrentGl& gl, const PictureOptions& options) {
  const int side = static_cast<int>(std::lround(std::sqrt(std::max(options.samples, 0))));
  if (side < 1 || side > 4 || side * side != options.samples) {
    throw Error(ExitStatus::usage, "samples per pixel must be 1, 4, 9 or 16");
  }
  GLint max = 0;
  gl->GetIntegerv(GL_MAX_TEXTURE_SIZE, &max);
  max = std::min(max, max_picture_side);
  if (options.width < 1 || options.height < 1 || std::max(options.width, options.height) > max / side) {
    throw Error(ExitStatus::usage, "a picture with " + std::to_string(options.samples) +
                                       " samples per pixel must be 1 to " + std::to_string(max / side) +
                                       " pixels each way");
  }
}

}  // namespace

Image draw_scene(GlContext& context, const Scene& scene, const Style& style, const PictureOptions& options) {
  return draw_scene(CurrentGl(context), scene, style, options);
}

Image draw_scene(const CurrentGl& gl, const Scene& scene, const Style& style, const PictureOptions& options) {
  check_options(gl, options);
  give_back_free_memory();
  Image picture = ScenePainter(gl, scene, style, options).painted();
  if (style.marks) {
    Style on_this_paper = style;
    on_this_paper.paper = scene.paper;
    const Paper paper(on_this_paper, options.width, options.height);
    picture = with_marks(picture, paper, marks_of(picture, scene.paper, *style.marks), *style.marks,
                         style.ink_color.value_or(InkStyle().color));
  }
  const StrokeOptions strokes{.width = options.width, .height = options.height, .threads = options.threads};
  return style.ink ? with_ink(std::move(picture), scene_strokes(scene, style, strokes), options.threads) : picture;
}

Image draw_scene(const Scene& scene, const Style& style, const PictureOptions& options) {
  GlContext context;
  return draw_scene(context, scene, style, options);
}

}  // namespace pomona
