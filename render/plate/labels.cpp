#include "render/plate/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

constexpr double closest_lines = 1.15;  // smallest distance of base lines, ems
constexpr double usual_lines = 1.7;

/// How far a word reaches above its base line and below, ems.
constexpr double ascent = 0.72, descent = 0.28;
constexpr double middle = 0.22;  // height above the base line at which the line leaves the word

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

struct LabelChoice {
  glm::dvec2 place{0};
  double cost = std::numeric_limits<double>::max();
};

/// The place of the part nearest to one side, away from places that have a line already.
LabelChoice best_place(const ShownPart& part, double side, double em, const std::vector<Label>& taken) {
  LabelChoice best;
  for (const glm::dvec2& p : part.places) {
    double here = std::fabs(p.x - side);
    for (const Label& other : taken) {
      const double apart = std::fabs(p.y - other.tip.y);
      if (apart < 2.2 * em) here += 2.5 * (2.2 * em - apart);
    }
    if (here < best.cost) best = {p, here};
  }
  return best;
}

/// Chooses tips part by part, the smallest first, because they have the least choice.
std::vector<Label> chosen_tips(const std::vector<LabelWish>& wishes, const PlateBox& figure, double em) {
  std::vector<Label> labels;
  std::size_t lefts = 0, rights = 0;
  for (const LabelWish& wish : wishes) {
    const LabelChoice left = best_place(wish.part, figure.low.x, em, labels);
    const LabelChoice right = best_place(wish.part, figure.high.x, em, labels);

    // A side with fewer words is worth a longer line.
    const double balance = 6 * em * (static_cast<double>(lefts) - static_cast<double>(rights));
    Label label;
    label.text = wish.text;
    label.part = wish.part.part;
    label.left = left.cost + balance <= right.cost;
    label.tip = label.left ? left.place : right.place;
    label.bounds.high.x = wish.width;
    ++(label.left ? lefts : rights);
    labels.push_back(label);
  }

  // Every tip on the left is left of every tip on the right, so that lines of the two sides cannot cross.
  std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) {
    return a.tip.x < b.tip.x || (a.tip.x == b.tip.x && a.tip.y < b.tip.y);
  });
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i].left = i < lefts;
  return labels;
}

/// Ascending heights between low and high, at least `apart` from each other, near the wanted ones.
std::vector<double> spread_out(std::vector<double> wished, double apart, double low, double high) {
  std::vector<double> heights;
  for (double wish : wished)
    heights.push_back(heights.empty() ? std::max(wish, low) : std::max(wish, heights.back() + apart));

  // Half of what was pushed down moves up again; then everything that is too low.
  double push = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) push += heights[i] - wished[i];
  if (!heights.empty()) push /= static_cast<double>(heights.size());
  for (double& height : heights) height -= push;
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] = std::max(heights[i], i > 0 ? heights[i - 1] + apart : low);
  double limit = high;
  for (std::size_t i = heights.size(); i-- > 0;) {
    heights[i] = std::min(heights[i], limit);
    limit = heights[i] - apart;
  }
  return heights;
}

/// One side's words, top down, without crossing lines: exchanging two whose lines cross shortens all lines together, so
/// this ends.
void untangle(std::vector<Label>& side) {
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < side.size(); ++i) {
      for (std::size_t j = i + 1; j < side.size(); ++j) {
        if (!leaders_cross(side[i], side[j])) continue;
        std::swap(side[i].leader, side[j].leader);
        again = true;
      }
    }
  }
}

void stack(std::vector<Label>& side, bool left, const PlateBox& figure, double em, double gap) {
  std::stable_sort(side.begin(), side.end(), [](const Label& a, const Label& b) { return a.tip.y < b.tip.y; });
  std::vector<double> wished;
  const double center = 0.5 * (figure.low.y + figure.high.y);
  // Lines fan out a little: words are further from the middle than their parts.
  for (const Label& label : side) wished.push_back(center + 1.25 * (label.tip.y - center));
  const double low = figure.low.y + ascent * em, high = figure.high.y - descent * em;
  const double room = side.size() > 1 ? (high - low) / static_cast<double>(side.size() - 1) : high - low;
  const std::vector<double> heights = spread_out(wished, std::min(usual_lines * em, room), low, high);
  for (std::size_t i = 0; i < side.size(); ++i)
    side[i].leader = {left ? figure.low.x - gap : figure.high.x + gap, heights[i] - middle * em};
  untangle(side);

  for (Label& label : side) {
    const double width = label.bounds.high.x;
    label.left = left;
    const double space = 0.3 * em;  // gap between the word and its line
    label.start = label.leader + glm::dvec2(left ? -width - space : space, middle * em);
    label.bounds = {label.start - glm::dvec2(0, ascent * em), label.start + glm::dvec2(width, descent * em)};
  }
}

}  // namespace

bool leaders_cross(const Label& a, const Label& b) {
  const double p = turn(a.leader, a.tip, b.leader), q = turn(a.leader, a.tip, b.tip);
  const double r = turn(b.leader, b.tip, a.leader), s = turn(b.leader, b.tip, a.tip);
  return p * q < 0 && r * s < 0;
}

std::vector<Label> placed_labels(std::vector<LabelWish> wishes, const PlateBox& figure, double em, double gap) {
  // Keeps only as many as fit.
  std::stable_sort(wishes.begin(), wishes.end(),
                   [](const LabelWish& a, const LabelWish& b) { return a.part.area > b.part.area; });
  const double room = (figure.high.y - figure.low.y - (ascent + descent) * em) / (closest_lines * em);
  const std::size_t a_side = room < 0 ? 0 : static_cast<std::size_t>(room) + 1;
  if (wishes.size() > a_side) wishes.resize(std::min(wishes.size(), 2 * a_side));
  std::reverse(wishes.begin(), wishes.end());

  std::vector<Label> labels = chosen_tips(wishes, figure, em);
  std::size_t lefts = std::count_if(labels.begin(), labels.end(), [](const Label& label) { return label.left; });
  lefts = std::clamp(lefts, labels.size() - std::min(labels.size(), a_side), a_side);
  std::vector<Label> left(labels.begin(), labels.begin() + static_cast<std::ptrdiff_t>(lefts));
  std::vector<Label> right(labels.begin() + static_cast<std::ptrdiff_t>(lefts), labels.end());
  stack(left, true, figure, em, gap);
  stack(right, false, figure, em, gap);
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

}  // namespace pomona
