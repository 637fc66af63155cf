// Grows a fruit to order, and cuts it.
#pragma once

#include <span>
#include <string>

#include "generator/base/stage_clock.h"
#include "generator/compose/grow.h"
#include "generator/order/order.h"
#include "generator/piece/piece_origin.h"
#include "generator/piece/slice.h"
#include "generator/variation/variation.h"

namespace pomona {

struct OrderedFruit {
  Template fruit;  ///< the variant; for a surface file only a name
  GrownFruit grown;
  PieceOrigin origin;
  std::string name;  ///< name of the template or file, without folder and ending
  std::string file;  ///< the template or file
  StageClock times;  ///< read, vary, sweep
};

/// Varies and sweeps a template.
/// \param name as for OrderedFruit.
/// \param word the text that named the template, for PieceOrigin::source.
OrderedFruit ordered_fruit(const Template& drawn, const std::string& name, const std::string& word, const Order& order);

/// The same of a template that was made ready for many variants.
OrderedFruit ordered_fruit(const Variation& variation, const std::string& name, const std::string& word,
                           const Order& order);

/// The fruit of a surface file.
/// \throws Error (usage) if the order asks for folds, ripeness or browning, which it does not have.
OrderedFruit fruit_of_surfaces(const std::filesystem::path& file, const Order& order);

/// The fruit, whose cut faces have lain in air for so long.
OrderedFruit browned(OrderedFruit fruit, double browning);

/// Whether pieces tell the volumes and masses of their organs (organs.h).
enum class OrganFacts { as_ordered, always };

/// Cuts the fruit as ordered; without knives its whole bodies come out. The solids keep what coloured their cut faces
/// where the order wants textures. Errors name the fruit's file.
/// \param diffuser null if cut faces are not visible: they keep the colours of their rims.
/// \throws Error as slice(), and (usage) if there is no piece of the number that was ordered.
Slices cut_to_order(const OrderedFruit& fruit, const Order& order, const Diffuser* diffuser,
                    OrganFacts organs = OrganFacts::as_ordered);

/// Whether the order asks for volumes and masses of organs: in a list of pieces, or in ground truth.
bool wants_organs(const Order& order);

/// The order that makes a piece again: as it grew, its knives, and its number among the pieces.
Order order_of(const PieceOrigin& origin);

/// "pomona cut tomato --seed 3 --knife half --piece 2 -o FILE": makes this piece again, alone, where the paths in it
/// start: in the folder of the scene or batch file, or where the command was given. Whole fruit is grown instead.
/// Empty where nobody has said of which template, or which piece it is.
/// \param further piece_words() of what colours it, and as what it is written; they come before -o.
std::string command_for(const PieceOrigin& origin, const std::string& file, const std::string& further = {});

}  // namespace pomona
