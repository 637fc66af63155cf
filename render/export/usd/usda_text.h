// Texts and numbers for USD's text format.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/export/decimal_text.h"

namespace pomona::usd {

/// "(1, 0.5, -2)"
std::string tuple(const glm::dvec3& v, double step);

/// Every number to the last bit.
std::string exact_tuple(const glm::dvec3& v);
std::string exact_tuple(const glm::dquat& q);  ///< w first

/// "[(0, 0, 1), ...]" of points, colours or normals.
std::string list(std::span<const glm::vec3> values, double step);
std::string list(std::span<const glm::vec2> values, double step);
std::string list(std::span<const std::int32_t> values);

/// A line of four spaces a step of indentation: "        int x = 3\n".
void append_line(std::string& text, int indent, const std::string& line);

/// A file's name as an asset path: "@./kiwi.png@".
std::string asset(const std::string& file);

/// The text in double quotes, with special characters escaped.
std::string quoted(const std::string& text);

/// Unique names of sibling prims, of letters, digits and underscores.
class PrimNames {
 public:
  std::string name_for(const std::string& wanted);

 private:
  std::set<std::string> taken_;
};

}  // namespace pomona::usd
