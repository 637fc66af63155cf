#include "render/picture/section_layout.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

namespace pomona {

glm::dvec2 PlacedFace::to_paper(const glm::dvec3& p) const {
  return corner + glm::dvec2(glm::dot(p, right) + shift - low.x, high.y - glm::dot(p, up)) * scale;
}

glm::dvec3 PlacedFace::to_fruit(const glm::dvec2& pixel) const {
  const glm::dvec2 q = (pixel - corner) / scale;
  return right * (low.x + q.x - shift) + up * (high.y - q.y) + depth;
}

namespace {

/// +Y is up on the paper; on nearly level faces, -Z.
PlacedFace turned_upright(const CutFace& face) {
  const glm::dvec3 n = face.normal;
  const glm::dvec3 wish = std::fabs(n.y) < 0.95 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
  PlacedFace placed;
  placed.depth = n * glm::dot(face.origin, n);
  if (face.stroke >= 0) {
    placed.up = -face.v;
    placed.right = -face.u;
    placed.shift = glm::dot(face.origin, face.u) - face.along;
    return placed;
  }
  placed.up = glm::normalize(wish - n * glm::dot(wish, n));
  placed.right = glm::cross(placed.up, n);
  return placed;
}

void measure(const CrossSection& section, std::vector<PlacedFace>& faces) {
  for (std::size_t t = 0; t < section.triangle.size(); ++t) {
    PlacedFace& face = faces[section.cut[t]];
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 p = section.position[section.triangle[t][i]];
      const glm::dvec2 q(glm::dot(p, face.right) + face.shift, glm::dot(p, face.up));
      face.low = face.shown ? glm::min(face.low, q) : q;
      face.high = face.shown ? glm::max(face.high, q) : q;
      face.shown = true;
    }
  }
}

/// For each face itself, or the first shown facet of its stroke; that one gets the bounds of all.
std::vector<std::size_t> join_facets(const CrossSection& section, std::vector<PlacedFace>& faces) {
  std::vector<std::size_t> first_of;
  std::map<int, std::size_t> first_of_stroke;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    first_of.push_back(f);
    if (section.faces[f].stroke < 0 || !faces[f].shown) continue;
    first_of[f] = first_of_stroke.try_emplace(section.faces[f].stroke, f).first->second;
    PlacedFace& first = faces[first_of[f]];
    first.low = glm::min(first.low, faces[f].low);
    first.high = glm::max(first.high, faces[f].high);
  }
  return first_of;
}

struct Row {
  std::vector<std::size_t> faces;
  double width = 0, height = 0;  // metres, without gaps
};

/// The shown faces in `count` rows, as evenly filled as their number allows.
std::vector<Row> in_rows(const std::vector<PlacedFace>& faces, const std::vector<std::size_t>& shown,
                         std::size_t count) {
  std::vector<Row> rows(count);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const glm::dvec2 size = faces[shown[i]].high - faces[shown[i]].low;
    Row& row = rows[i * count / shown.size()];
    row.faces.push_back(shown[i]);
    row.width += size.x;
    row.height = std::max(row.height, size.y);
  }
  return rows;
}

/// The scale, pixels per metre, at which the rows just fit.
double fitting_scale(const std::vector<Row>& rows, const glm::dvec2& picture, double gap) {
  double height = 0;
  double scale = 1e300;
  for (const Row& row : rows) {
    height += row.height;
    const double room = picture.x - gap * static_cast<double>(row.faces.size() + 1);
    scale = std::min(scale, room / std::max(row.width, 1e-12));
  }
  const double room = picture.y - gap * static_cast<double>(rows.size() + 1);
  return std::min(scale, room / std::max(height, 1e-12));
}

void place(const std::vector<Row>& rows, double scale, const glm::dvec2& picture, double gap,
           std::vector<PlacedFace>& faces) {
  double height = gap * static_cast<double>(rows.size() - 1);
  for (const Row& row : rows) height += row.height * scale;
  double y = 0.5 * (picture.y - height);
  for (const Row& row : rows) {
    double x = 0.5 * (picture.x - row.width * scale - gap * static_cast<double>(row.faces.size() - 1));
    for (const std::size_t f : row.faces) {
      PlacedFace& face = faces[f];
      const glm::dvec2 size = (face.high - face.low) * scale;
      face.scale = scale;
      face.corner = {x, y + 0.5 * (row.height * scale - size.y)};
      x += size.x + gap;
    }
    y += row.height * scale + gap;
  }
}

}  // namespace

std::vector<PlacedFace> lay_out(const CrossSection& section, const glm::dvec2& picture, double gap) {
  std::vector<PlacedFace> faces;
  for (const CutFace& face : section.faces) faces.push_back(turned_upright(face));
  measure(section, faces);
  const std::vector<std::size_t> first_of = join_facets(section, faces);
  std::vector<std::size_t> shown;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f].shown && first_of[f] == f) shown.push_back(f);
  }
  if (shown.empty()) return faces;

  // Gaps are smaller for very many faces.
  gap = std::min(gap, 0.3 * std::min(picture.x, picture.y) / std::sqrt(static_cast<double>(shown.size())));
  std::vector<Row> best;
  double best_scale = 0;
  for (std::size_t count = 1; count <= std::min<std::size_t>(shown.size(), 128); ++count) {
    std::vector<Row> rows = in_rows(faces, shown, count);
    const double scale = fitting_scale(rows, picture, gap);
    if (scale <= best_scale) continue;
    best_scale = scale;
    best = std::move(rows);
  }
  if (best.empty()) {
    for (PlacedFace& face : faces) face.shown = false;
    return faces;
  }
  place(best, best_scale, picture, gap, faces);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const PlacedFace& first = faces[first_of[f]];
    faces[f].low = first.low;
    faces[f].high = first.high;
    faces[f].corner = first.corner;
    faces[f].scale = first.scale;
  }
  return faces;
}

}  // namespace pomona
