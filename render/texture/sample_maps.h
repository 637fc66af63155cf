// The values of a texture's maps at a texel: the normal, occlusion, roughness and thickness.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/piece/solid.h"
#include "render/style/face_relief.h"
#include "render/style/look.h"
#include "render/style/relief.h"
#include "render/style/skin_pits.h"
#include "render/texture/shine.h"
#include "render/texture/texels.h"

namespace pomona {

/// The values at one sample. Texels are means over their samples.
struct MapSample {
  glm::vec3 normal{0, 0, 1};     ///< in the tangent frame, unit
  glm::vec3 orm{1, 0.6f, 0};     ///< occlusion, roughness, metal
  glm::vec3 thickness{1, 1, 0};  ///< red: share of the film of juice; green: share of max_thickness
};

/// The tangent frames, per vertex of the texture's mesh.
struct TangentMesh {
  std::vector<glm::uvec3> triangle;  ///< in the order of the charts
  std::vector<glm::vec4> tangent;
  std::vector<std::uint32_t> number;  ///< per triangle of the solid: its number there
};

class SampleMaps {
 public:
  /// All must outlive this. \param texel size, metres
  SampleMaps(const Solid& solid, const Look& look, const TangentMesh& mesh, double texel, Threads threads);

  /// \param plain the samples' colours before noise and details.
  std::vector<MapSample> of(const std::vector<TexelSample>& samples, const std::vector<Color>& plain) const;

  /// The values for a chart that is smaller than a texel; its normal is flat.
  MapSample speck(std::uint32_t triangle) const;

  /// The part that a sample shows.
  std::int32_t part(const TexelSample& sample) const {
    return solid_.mesh.part[solid_.mesh.triangle[sample.triangle].x];
  }

 private:
  glm::dvec3 normal_at(const TexelSample& sample) const;
  MapSample at(const TexelSample& sample, const glm::dvec3& place, const glm::dvec3& normal,
               const Relief& relief) const;
  LookPlace look_place(const TexelSample& sample, const glm::dvec3& place) const;
  double roughness(std::uint32_t triangle, double own, const glm::dvec3& place) const;

  /// The material of a part on skins and on cut faces.
  struct OfPart {
    bool shows_rim = false;
    double wet = 0;
  };

  const Solid& solid_;
  const Look& look_;
  const TangentMesh& mesh_;
  FaceRelief faces_;
  SkinPits pits_;
  Shine shine_;
  double texel_;
  Threads threads_;
  std::vector<OfPart> of_part_;
};

}  // namespace pomona
