#include "render/gl/detail_texels.h"

namespace pomona {

namespace {

constexpr std::size_t texels_of_a_detail = 7;  // the same in shaders/detail.glsl
constexpr float no_detail = -1;

std::vector<glm::vec4> texels_of(const Look::Detail& detail) {
  const DetailSketch& sketch = detail.pattern.detail();
  const Pattern::Shape& shape = detail.pattern.shape();
  return {
      {static_cast<float>(sketch.kind), static_cast<float>(sketch.run), sketch.amount, sketch.color ? 1 : 0},
      {sketch.size, sketch.length, sketch.width, sketch.density},
      {sketch.softness, sketch.wander, sketch.variety, sketch.near ? sketch.near_within : 0},
      {glm::vec3(detail.target), sketch.smallest},
      {glm::vec3(detail.near), shape.pitch},
      {shape.threshold, shape.ramp, shape.mean.share, shape.mean.tone},
      {sketch.reach, sketch.middle, static_cast<float>(shape.seed), sketch.relief},
  };
}

}  // namespace

std::vector<glm::vec4> detail_texels(const Look& look) {
  std::vector<glm::vec4> texels;
  for (const DetailFace face : {DetailFace::cut, DetailFace::skin}) {
    for (const Look::Detail& detail : look.details(face)) {
      const std::vector<glm::vec4> own = texels_of(detail);
      texels.insert(texels.end(), own.begin(), own.end());
    }
    const std::size_t faces = face == DetailFace::cut ? 1 : 2;
    while (texels.size() < faces * max_details_of_a_face * texels_of_a_detail)
      texels.insert(texels.end(), {no_detail, 0, 0, 0});
  }
  return texels;
}

}  // namespace pomona
