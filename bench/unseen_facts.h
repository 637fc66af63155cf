// Measurements of one unseen fruit: whether its halves show the parts that the drawing's halves show, and whether its
// seeds, colours and section are sound.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generator/base/random.h"
#include "generator/compose/grow.h"
#include "generator/template/template.h"

namespace pomona::bench {

/// The faces of one knife.
struct FaceFacts {
  /// Per part: shares of the section on the left and on the right of the axis.
  std::map<std::string, std::pair<double, double>> sides;
  double area = 0;  ///< square metres
  int specks = 0;   ///< loose bits and patches of one part that look like crumbs
};

/// Two parts that are one tissue, and how much the difference of their colours differs from the drawn one, in 255ths of
/// sRGB.
struct TissueDrift {
  std::string first, second;
  double drift = 0;
};

struct UnseenFacts {
  int folds = 1;
  double diagonal = 0;  ///< of the box around it, metres
  FaceFacts half, across;
  int grains = 0;           ///< those that grow on a surface in folds
  int crossings = 0;        ///< those of them that a membrane crosses
  int chambers = 0;         ///< folds in which grains may grow
  int empty_chambers = 0;   ///< those of them that bear none
  TissueDrift worst_drift;  ///< empty names if no two parts are one tissue
};

/// One template, to be measured with many seeds.
class UnseenFruit {
 public:
  explicit UnseenFruit(Template fruit);

  /// Seed 0 is the drawing.
  UnseenFacts facts(int seed) const;

  /// The parts that a half should show: those on surfaces in folds, on grains, and on surfaces between them.
  const std::vector<std::string>& inner_parts() const { return inner_parts_; }

  /// Those of them that folds alone hold, which a half may miss on one side of the axis.
  const std::set<std::string>& parts_in_folds() const { return parts_in_folds_; }

 private:
  Template fruit_;
  Variation variation_;
  std::vector<std::string> inner_parts_;
  std::set<std::string> parts_in_folds_;
};

}  // namespace pomona::bench
