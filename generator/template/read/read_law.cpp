#include "generator/template/read/read_law.h"

#include <algorithm>
#include <cmath>

#include "generator/base/units.h"
#include "generator/template/read/read_stops.h"

namespace pomona {

namespace {

constexpr std::size_t max_laws = 16;

/// Whether so many seats later comes one beside the first: by the golden angle k seats are 161 to 170 degrees / k
/// beside whole turns where k is a Fibonacci number.
bool is_beside(int seats, double angle) { return seats * std::fabs(angle) < radians(240); }

/// Steps of both families can only be equally long if the larger number comes nearer to its whole turns.
void read_pair(const TomlTable& table, LawSketch& law) {
  const TomlValue value = table.need("pair");
  const std::vector<TomlValue> pair = value.values(2, "must be two numbers of spirals", "write [8, 13]");
  if (pair.empty()) return;
  law.low_pair = pair[0].integer(law.low_pair, 1, 377);
  law.high_pair = pair[1].integer(law.high_pair, 2, 610);
  const double low = beside_whole_turns(law.low_pair * law.divergence);
  const double high = beside_whole_turns(law.high_pair * law.divergence);
  const bool are_beside = is_beside(law.low_pair, low) && is_beside(law.high_pair, high);
  if (are_beside && law.low_pair < law.high_pair && low * low > high * high) return;
  value.error("are no spirals of this divergence",
              "write the smaller number first; 137.508 degrees make [3, 5], [5, 8], [8, 13], [13, 21], ...");
}

void read_band(const TomlValue& value, LawSketch& law) {
  const auto ends = value.values(2, "is not a band", "write its lower and upper end, as in [0.2, 0.8]");
  if (ends.empty()) return;
  law.from = ends[0].number(0, {0, 1});
  law.to = ends[1].number(1, {0, 1});
  if (!(law.to > law.from)) value.error("is empty", "write the lower end first");
}

/// The room of a cluster, which may reach beyond the fruit's own surfaces.
void read_envelope(const TomlTable& table, CurveReader& curves, LawSketch& law) {
  const TomlValue value = table.need("envelope");
  law.hollow = table.get("hollow").length(0, {0, 1});
  const std::optional<DrawnCurve> drawn = curves.read(value, SketchView::side);
  if (!drawn) return;
  law.envelope = drawn->curve;
  std::vector<glm::dvec2>& points = law.envelope.points;
  if (law.envelope.closed) return value.error("is closed", "draw it open, from its lower end to its upper one");
  for (const glm::dvec2& p : points) {
    if (p.x < 0) return value.error("goes left of the axis", "draw its right half");
  }
  if (points.front().y > points.back().y) std::reverse(points.begin(), points.end());
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].y < points[i - 1].y) return value.error("turns back down", "draw it ever upwards");
  }
}

LawSketch read_law(const TomlTable& table, CurveReader& curves) {
  LawSketch law;
  law.kind =
      static_cast<LawSketch::Kind>(table.need("kind").choice({"spiral", "parastichies", "rows", "whorls", "cluster"}));
  const bool spirals = law.kind == LawSketch::Kind::spiral || law.kind == LawSketch::Kind::parastichies;
  if (spirals) law.divergence = table.get("divergence").angle(law.divergence, {1, 359});
  if (law.kind == LawSketch::Kind::parastichies) {
    read_pair(table, law);
  } else {
    law.spacing = read_ramp<double>(table.need("spacing"), 0.005, [](const TomlValue& stop) {
      return stop.length(0.005, {1e-4, 1});
    });
  }
  if (law.kind == LawSketch::Kind::rows) {
    law.count = table.need("rows").integer(1, 1, 512);
    law.stagger = table.get("stagger").number(law.stagger, {0, 1});
    law.twist = table.get("twist").angle(0, {-3600, 3600});
  }
  if (law.kind == LawSketch::Kind::whorls) {
    law.count = table.need("count").integer(1, 1, 512);
    law.turn = table.get("turn").angle(pi / law.count, {-360, 360});
  }
  if (law.kind == LawSketch::Kind::cluster) {
    read_envelope(table, curves, law);
    law.jitter = table.get("jitter").number(0.3, {0, 1});
    return law;
  }
  law.start = table.get("start").angle(0, {-360, 360});
  read_band(table.get("band"), law);
  law.jitter = table.get("jitter").number(0, {0, 1});
  return law;
}

}  // namespace

std::vector<LawSketch> read_laws(const TomlTable& table, CurveReader& curves) {
  std::vector<LawSketch> laws;
  for (const std::string& name : table.keys()) {
    const TomlValue value = table.get(name);
    if (laws.size() == max_laws) {
      value.error("is one of more than " + std::to_string(max_laws) + " laws");
      break;
    }
    laws.push_back(read_law(value.table().called("law \"" + name + "\""), curves));
    laws.back().name = name;
  }
  return laws;
}

std::optional<int> read_law_name(const TomlValue& value, const std::vector<LawSketch>& laws) {
  if (laws.empty()) {
    if (value.given())
      value.error("is given, but the template has no laws", "write a table [law." + value.text("NAME") + "]");
    return {};
  }
  std::vector<std::string> names;
  for (const LawSketch& law : laws) names.push_back(law.name);
  return value.choice(names);
}

std::optional<int> read_law_name(const TomlTable& table, const std::vector<LawSketch>& laws, SurfaceType type) {
  const TomlValue value = table.get("law");
  if (table.has("spacing")) {
    table.get("spacing").error("is given beside a law, which says where they sit", "leave one of the two out");
  }
  if (type == SurfaceType::in_fold) {
    value.error("is for surfaces around the axis", "strew them with \"spacing\"");
    return {};
  }
  const std::optional<int> law = read_law_name(value, laws);
  if (law && laws[static_cast<std::size_t>(*law)].kind == LawSketch::Kind::cluster) {
    value.error("is a cluster, whose seats lie on no surface", "use it for a [[place]]");
    return {};
  }
  return law;
}

}  // namespace pomona
