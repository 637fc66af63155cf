#include "generator/piece/piece_state.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

std::string_view kind_of(std::string_view knife) { return knife.substr(0, knife.find(':')); }

/// The state that one knife alone gives.
CutState state_of_kind(std::string_view kind) {
  constexpr std::array<std::pair<std::string_view, CutState>, 7> states{{{"half", CutState::half},
                                                                         {"across", CutState::half},
                                                                         {"wedges", CutState::wedge},
                                                                         {"slices", CutState::slice},
                                                                         {"crinkle", CutState::slice},
                                                                         {"dice", CutState::dice},
                                                                         {"sticks", CutState::stick}}};
  const auto* const found = std::find_if(states.begin(), states.end(), [&](const auto& s) { return s.first == kind; });
  return found == states.end() ? CutState::piece : found->second;
}

/// The share of the surface that is the fruit's skin.
double skin_share(const Solid& solid) {
  const std::vector<std::uint8_t>& on_skin = solid.look->on_skin;
  double all = 0, skin = 0;
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    const double area = glm::length(solid.mesh.area_vector(t));
    const auto part = static_cast<std::size_t>(solid.mesh.part[solid.mesh.triangle[t].x]);
    const bool is_skin = solid.mesh.cut_face[t] < 0 && (part >= on_skin.size() || on_skin[part] != 0);
    all += area;
    if (is_skin) skin += area;
  }
  return all > 0 ? skin / all : 0;
}

}  // namespace

bool is_peeler(std::string_view knife) { return kind_of(knife) == "peel"; }

std::string_view name_of(CutState state) {
  constexpr std::array<std::string_view, 9> names{"whole", "half",  "quarter", "wedge", "slice",
                                                  "dice",  "stick", "peel",    "piece"};
  return names[static_cast<std::size_t>(state)];
}

CutState state_by(std::span<const std::string> knives) {
  CutState state = CutState::whole;
  for (const std::string& knife : knives) {
    if (is_peeler(knife)) continue;
    const CutState next = state_of_kind(kind_of(knife));
    const bool is_again = next == CutState::half && state != CutState::whole;
    if (!is_again) state = next;
    if (is_again && state == CutState::quarter) state = CutState::piece;
    if (is_again && state == CutState::half) state = CutState::quarter;
  }
  return state;
}

std::vector<CutState> states_by(std::span<const std::string> knives) {
  std::vector<CutState> states{state_by(knives)};
  if (std::any_of(knives.begin(), knives.end(), is_peeler)) states.push_back(CutState::peel);
  return states;
}

PieceState state_of(const Solid& solid) {
  const std::vector<std::string>& knives = solid.origin.knives;
  PieceState of_piece{state_by(knives), false};
  if (std::none_of(knives.begin(), knives.end(), is_peeler)) return of_piece;
  of_piece.peeled = skin_share(solid) < 0.2;
  if (!of_piece.peeled) of_piece.state = CutState::peel;
  return of_piece;
}

}  // namespace pomona
