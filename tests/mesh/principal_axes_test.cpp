#include "generator/mesh/principal_axes.h"

#include <cstdint>

#include <gtest/gtest.h>

#include "generator/base/random.h"

namespace pomona {
namespace {

glm::dmat3 rebuilt(const PrincipalAxes& axes) {
  const glm::dmat3 turn = glm::mat3_cast(axes.rotation);
  glm::dmat3 diagonal(0);
  for (int k = 0; k < 3; ++k) diagonal[k][k] = axes.moments[k];
  return turn * diagonal * glm::transpose(turn);
}

TEST(PrincipalAxes, GiveTheTensorBack) {
  const RandomStream random({7, 0}, "tensor");
  std::uint64_t draw = 0;
  for (int trial = 0; trial < 200; ++trial) {
    glm::dmat3 tensor(0);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) tensor[i][j] = tensor[j][i] = 2 * random.uniform(draw++) - 1;
    const PrincipalAxes axes = principal_axes(tensor);
    EXPECT_NEAR(glm::length(axes.rotation), 1, 1e-14);
    const glm::dmat3 again = rebuilt(axes);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(again[i][j], tensor[i][j], 1e-13);
  }
}

TEST(PrincipalAxes, OfADiagonalTensorAreItsOwn) {
  glm::dmat3 tensor(0);
  tensor[0][0] = 3, tensor[1][1] = 1, tensor[2][2] = 2;
  const PrincipalAxes axes = principal_axes(tensor);
  EXPECT_EQ(axes.moments, glm::dvec3(3, 1, 2));
  EXPECT_EQ(axes.rotation, glm::dquat(1, 0, 0, 0));
}

}  // namespace
}  // namespace pomona
