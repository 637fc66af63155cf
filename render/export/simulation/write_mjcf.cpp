#include "render/export/simulation/write_mjcf.h"

#include <cmath>
#include <set>
#include <span>

#include "generator/base/units.h"
#include "generator/mesh/principal_axes.h"
#include "render/export/decimal_text.h"
#include "render/export/simulation/simulated_body.h"
#include "render/export/up_axis.h"
#include "render/picture/view_frame.h"

namespace pomona {

namespace {

constexpr double of_points = 1e-7;  // metres

/// How contacts are felt. They are stiff: with MuJoCo's usual 20 ms a fruit sinks into the ground by millimetres, and
/// rocks from one of its few contacts to the next without end. The time constant is the least that the step permits.
constexpr const char* contact = "condim=\"6\" friction=\"0.6 0.02 0.02\" solref=\"0.002 1\"";
constexpr const char* time_step = "0.001";  // seconds

std::string points_text(std::span<const glm::vec3> points, double step) {
  std::string text;
  for (const glm::vec3& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!text.empty()) text += ' ';
      append_number(text, static_cast<double>(p[axis]), step);
    }
  }
  return text;
}

std::string corners_text(std::span<const glm::uvec3> triangles) {
  std::string text;
  for (const glm::uvec3& t : triangles)
    for (int k = 0; k < 3; ++k) text += (text.empty() ? "" : " ") + std::to_string(t[k]);
  return text;
}

std::string wxyz(const glm::dquat& q) { return exact(q.w) + " " + exact(q.x) + " " + exact(q.y) + " " + exact(q.z); }

std::string rgba(const VisualMesh& visual) {
  std::string text;
  for (int channel = 0; channel < 3; ++channel) {
    append_number(text, visual.color[channel] / 255.0, 1e-3);
    text += ' ';
  }
  append_number(text, static_cast<double>(visual.opacity), 1e-3);
  return text;
}

/// What one sees is as thin as a shell: it has no inside, and its mass counts nothing.
void append_visuals(std::string& text, const SimulatedKind& kind) {
  for (VisualMesh visual : kind.visuals) {
    // MuJoCo takes no mesh of fewer vertices than a tetrahedron has.
    while (visual.position.size() < 4) {
      visual.position.push_back(visual.position.back());
      visual.normal.push_back(visual.normal.back());
    }
    text += "    <mesh name=\"" + visual.name + "\" inertia=\"shell\" vertex=\"" +
            points_text(visual.position, of_points) + "\" normal=\"" + points_text(visual.normal, 1e-3) + "\" face=\"" +
            corners_text(visual.triangle) + "\"/>\n";
  }
}

void append_hulls(std::string& text, const std::vector<HullMesh>& hulls) {
  for (const HullMesh& part : hulls)
    text += "    <mesh name=\"" + part.name + "\" vertex=\"" + points_text(part.hull.position, of_points) +
            "\" face=\"" + corners_text(part.hull.triangle) + "\"/>\n";
}

/// The meshes of each kind once, then those of single bodies.
void append_assets(std::string& text, const SimulatedScene& made) {
  std::set<int> felt, used;
  for (const SimulatedBody& body : made.bodies)
    if (body.own_hulls.empty()) felt.insert(body.kind);
  for (const SimulatedBody& body : made.bodies) {
    if (!used.insert(body.kind).second) continue;
    const SimulatedKind& kind = made.kinds[static_cast<std::size_t>(body.kind)];
    append_visuals(text, kind);
    if (felt.count(body.kind)) append_hulls(text, kind.hulls);
  }
  for (const SimulatedBody& body : made.bodies) append_hulls(text, body.own_hulls);
}

void append_body(std::string& text, const SimulatedScene& made, const SimulatedBody& body) {
  const SimulatedKind& kind = made.kinds[static_cast<std::size_t>(body.kind)];
  text += "    <body name=\"" + body.name + "\" pos=\"" + exact_words(body.place) + "\" quat=\"" + wxyz(body.rotation) +
          "\">\n";
  if (kind.moves) {
    text += "      <freejoint name=\"" + body.name + "_free\"/>\n";
    const PrincipalAxes axes = principal_axes(kind.inertia);
    text += "      <inertial pos=\"" + exact_words(kind.center) + "\" quat=\"" + wxyz(axes.rotation) + "\" mass=\"" +
            exact(kind.mass) + "\" diaginertia=\"" + exact_words(axes.moments) + "\"/>\n";
  }
  for (const VisualMesh& visual : kind.visuals)
    text += "      <geom class=\"seen\" mesh=\"" + visual.name + "\" rgba=\"" + rgba(visual) + "\"/>\n";
  for (const HullMesh& part : hulls_of(made, body)) text += "      <geom class=\"felt\" mesh=\"" + part.name + "\"/>\n";
  text += "    </body>\n";
}

std::string camera_text(const View& view) {
  const ViewFrame frame = view_frame(view);
  const auto turned = [](const glm::dvec3& v) { return exact_words(place_with_up(UpAxis::z, v)); };
  return "    <camera name=\"view\" pos=\"" + turned(view.eye) + "\" xyaxes=\"" + turned(frame.right) + " " +
         turned(frame.up) + "\" fovy=\"" + exact(view.vertical_field * 180 / pi) + "\"/>\n";
}

void append_exclusions(std::string& text, const SimulatedScene& made, Threads threads) {
  const std::vector<std::array<std::size_t, 2>> pairs = bodies_that_overlap(made, threads);
  if (pairs.empty()) return;
  text += "  <contact>\n";
  for (const auto& [first, second] : pairs)
    text += "    <exclude body1=\"" + made.bodies[first].name + "\" body2=\"" + made.bodies[second].name + "\"/>\n";
  text += "  </contact>\n";
}

/// Welds are as stiff as MuJoCo allows (solimp up to 0.9999), because what gives way is in proportion to what hangs on
/// a body: a splinter of a stalk between two halves of a berry bears two thousand times its own mass. MuJoCo's welds
/// never break: who runs the model compares the force of each with its strength, which stands beside it as a number,
/// and lets it go.
void append_welds(std::string& text, const SimulatedScene& made) {
  if (made.welds.empty()) return;
  const auto body = [&](int number) { return made.bodies[static_cast<std::size_t>(number)].name; };
  text += "  <equality>\n";
  for (const SimulatedWeld& weld : made.welds) {
    text += "    <weld name=\"" + weld.name + "\" body1=\"" + body(weld.first) + "\" body2=\"" + body(weld.second) +
            "\" solref=\"0.005 1\" solimp=\"0.99 0.9999 0.0001\"/>\n";
  }
  text += "  </equality>\n  <custom>\n";
  for (const SimulatedWeld& weld : made.welds) {
    text += "    <numeric name=\"" + weld.name + "_newtons\" data=\"" + exact(weld.strength) + "\"/>\n";
    text += "    <numeric name=\"" + weld.name + "_square_metres\" data=\"" + exact(weld.area) + "\"/>\n";
  }
  text += "  </custom>\n";
}

}  // namespace

std::string write_mjcf(const Scene& scene, const ExportOptions& options) {
  const SimulatedScene made = simulated_scene(scene, options);
  std::string text = "<mujoco model=\"pomona\">\n  <custom>\n    <text name=\"provenance\" data=\"Made by Pomona. " +
                     xml_text(options.provenance) + "\"/>\n  </custom>\n";
  // Bits of a milligram turn too easily for MuJoCo's steps: it takes them for somewhat larger.
  text += "  <compiler angle=\"degree\" boundinertia=\"1e-11\" balanceinertia=\"true\"/>\n  <option timestep=\"" +
          std::string(time_step) + "\" cone=\"elliptic\" impratio=\"10\"/>\n";
  text +=
      "  <default>\n    <default class=\"seen\">\n"
      "      <geom type=\"mesh\" group=\"2\" contype=\"0\" conaffinity=\"0\" mass=\"0\"/>\n    </default>\n"
      "    <default class=\"felt\">\n"
      "      <geom type=\"mesh\" group=\"3\" " +
      std::string(contact) +
      "/>\n    </default>\n"
      "  </default>\n  <asset>\n";
  append_assets(text, made);
  text += "  </asset>\n  <worldbody>\n    <light pos=\"0.5 -1 2\" dir=\"-0.2 0.4 -0.9\" directional=\"true\"/>\n";
  text += camera_text(scene.view);
  text += "    <geom name=\"ground\" type=\"plane\" size=\"0 0 0.1\" pos=\"0 0 " + exact(made.ground) +
          "\" rgba=\"0.93 0.90 0.83 1\" " + contact + "/>\n";
  for (const SimulatedBody& body : made.bodies) append_body(text, made, body);
  text += "  </worldbody>\n";
  if (options.welded) append_exclusions(text, made, options.threads);
  append_welds(text, made);
  return text + "</mujoco>\n";
}

}  // namespace pomona
