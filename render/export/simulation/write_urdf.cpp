#include "render/export/simulation/write_urdf.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "render/export/decimal_text.h"
#include "render/export/obj.h"
#include "render/export/simulation/simulated_body.h"

namespace pomona {

namespace {

/// Angles about the fixed axes X, Y and Z, one after the other, radians.
glm::dvec3 roll_pitch_yaw(const glm::dquat& q) {
  const double sine = std::clamp(2 * (q.w * q.y - q.z * q.x), -1.0, 1.0);
  return {reproducible::atan2(2 * (q.w * q.x + q.y * q.z), 1 - 2 * (q.x * q.x + q.y * q.y)),
          pi / 2 - reproducible::acos(sine),
          reproducible::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))};
}

class UrdfWriter {
 public:
  explicit UrdfWriter(const std::string& stem) : stem_(stem) {}

  UrdfFiles written(const SimulatedScene& scene, const std::string& provenance) {
    files_.text = "<?xml version=\"1.0\"?>\n<!-- Made by Pomona. " + comment(provenance) + " -->\n<robot name=\"" +
                  plain_name(stem_) + "\">\n  <link name=\"scene\"/>\n";
    for (const SimulatedBody& body : scene.bodies) {
      if (known_.insert(body.kind).second) add_visuals(scene.kinds[static_cast<std::size_t>(body.kind)]);
      add_hulls(hulls_of(scene, body));
      add_link(scene, body);
    }
    files_.text += "</robot>\n";
    return std::move(files_);
  }

 private:
  /// Two hyphens would end the comment.
  static std::string comment(const std::string& words) {
    std::string text = xml_text(words);
    for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--")) text.replace(at, 2, "- ");
    return text;
  }

  std::string file_of(const std::string& mesh) const { return stem_ + "_" + mesh + ".obj"; }

  void add_visuals(const SimulatedKind& kind) {
    for (const VisualMesh& visual : kind.visuals) {
      files_.meshes.push_back(
          {file_of(visual.name), write_obj(visual.position, visual.normal, visual.triangle, glm::vec3(0))});
    }
  }

  void add_hulls(const std::vector<HullMesh>& hulls) {
    for (const HullMesh& part : hulls) {
      if (!known_hulls_.insert(part.name).second) continue;
      files_.meshes.push_back(
          {file_of(part.name), write_obj(part.hull.position, {}, part.hull.triangle, glm::vec3(0))});
    }
  }

  std::string geometry(const std::string& mesh) const {
    return "<geometry><mesh filename=\"" + xml_text(file_of(mesh)) + "\"/></geometry>";
  }

  void add_link(const SimulatedScene& scene, const SimulatedBody& body) {
    const SimulatedKind& kind = scene.kinds[static_cast<std::size_t>(body.kind)];
    std::string& text = files_.text;
    text += "  <link name=\"" + body.name + "\">\n";
    if (kind.moves) {
      const glm::dmat3& i = kind.inertia;
      text += "    <inertial>\n      <origin xyz=\"" + exact_words(kind.center) + "\"/>\n      <mass value=\"" +
              exact(kind.mass) + "\"/>\n      <inertia ixx=\"" + exact(i[0][0]) + "\" ixy=\"" + exact(i[0][1]) +
              "\" ixz=\"" + exact(i[0][2]) + "\" iyy=\"" + exact(i[1][1]) + "\" iyz=\"" + exact(i[1][2]) + "\" izz=\"" +
              exact(i[2][2]) + "\"/>\n    </inertial>\n";
    }
    for (const VisualMesh& visual : kind.visuals) {
      text += "    <visual>" + geometry(visual.name) + "<material name=\"" + visual.name + "\"><color rgba=\"";
      for (int channel = 0; channel < 3; ++channel)
        append_number(text, visual.color[channel] / 255.0, 1e-3), text += ' ';
      append_number(text, static_cast<double>(visual.opacity), 1e-3);
      text += "\"/></material></visual>\n";
    }
    for (const HullMesh& part : hulls_of(scene, body))
      text += "    <collision>" + geometry(part.name) + "</collision>\n";
    text += "  </link>\n  <joint name=\"" + body.name + "_joint\" type=\"" + (kind.moves ? "floating" : "fixed") +
            "\">\n    <origin xyz=\"" + exact_words(body.place) + "\" rpy=\"" +
            exact_words(roll_pitch_yaw(body.rotation)) + "\"/>\n    <parent link=\"scene\"/>\n    <child link=\"" +
            body.name + "\"/>\n  </joint>\n";
  }

  const std::string& stem_;
  UrdfFiles files_;
  std::set<int> known_;
  std::set<std::string> known_hulls_;
};

}  // namespace

UrdfFiles write_urdf(const Scene& scene, const std::string& stem, const ExportOptions& options) {
  return UrdfWriter(stem).written(simulated_scene(scene, options), options.provenance);
}

}  // namespace pomona
