// Places of a template: where other templates are set, such as berries in a bunch.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/base/color.h"
#include "generator/template/ramp.h"

namespace pomona {

struct Template;

/// How neighbours flatten each other: each stays in the convex cell that planes between hearts leave.
struct PressSketch {
  int surface = 0;      ///< of the placed template: its skin
  double heart = 0.5;   ///< height of the point from which it is pressed, as a share of the placed template's
  double gap = 0.0001;  ///< metres between two that are pressed
  double soft = 0.03;   ///< how round the rims of flat faces are, as a share of the distance to the heart
  std::optional<double> root = {};  ///< the ground is a neighbour, too; each reaches so deep into it, metres
  std::vector<int> against = {};    ///< surfaces of the template that has the place, which do not give way
};

/// A stalk from a surface near the axis to the top of each instance.
struct StalkSketch {
  int from = 0;                                   ///< surface of the template that has the place
  double rise = 0.008;                            ///< how much higher its root lies than the instance, metres
  double root_width = 0.002, top_width = 0.0016;  ///< metres
  double depth = 0.001;                           ///< how deep it reaches into the instance, metres
  int around = 6;
  int part = 0;
  Color color{0.3f, 0.35f, 0.1f};
};

/// Instances of one template at the seats of a law. Each is a variant with a key of its own.
struct PlaceSketch {
  enum class Foot { bottom, middle, top };

  /// Where an instance's top looks.
  enum class Heading {
    out,  ///< away from the surface; in a cluster: from the axis
    in,
    along,  ///< up the vertical curve
    up,
    down,
    stalk,  ///< to where its stalk leaves
  };

  std::string name;
  std::shared_ptr<const Template> placed;  ///< as drawn; never null
  int law = 0;                             ///< index into Template::laws
  std::optional<int> surface;              ///< index into Template::surfaces: where the seats lie; none for clusters
  bool on_front = true;                    ///< which side they sit on
  Foot foot = Foot::bottom;                ///< which point of an instance's axis lies on the seat
  Heading heading = Heading::out;
  double tilt = 0, tilt_jitter = 0;  ///< of the top towards `along`, radians; random part, to either side
  double turn = 0, turn_jitter = 0;  ///< about the instance's own axis, radians; random part, to either side
  double sink = 0;                   ///< how deep the foot lies below the surface, metres
  Ramp<double> size = Ramp<double>::constant(1);  ///< factor of lengths by the share of the vertical curve
  double size_jitter = 0;                         ///< random part, as a share, to either side
  int individuals = 0;                            ///< so many variants are shared; 0: each instance is one of its own
  double detail = 1;                              ///< factor of the numbers of vertices around and along
  std::optional<PressSketch> press;
  std::optional<StalkSketch> stalk;
  std::vector<int> parts;  ///< for each part of the placed template, the index of what it is here in Template::parts
};

}  // namespace pomona
