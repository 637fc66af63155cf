// Pieces that fall, touch, slide and come to rest: the physics of settling.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/scene/settle/contact.h"
#include "generator/scene/settle/near_bodies.h"
#include "generator/scene/settle/rigid_body.h"

namespace pomona {

/// A wall that keeps falling bodies over their dish: a round one, or four.
struct Funnel {
  double radius = 0;          ///< metres about the axis; 0 = no round one
  double low = 0;             ///< its lower end, metres above the ground
  glm::dvec2 from{0}, to{0};  ///< of four walls, x and z; equal: there are none
};

/// Lengths in units, which are the pieces' mean size; times in steps.
struct HeapOptions {
  double friction = 0.6;     ///< of every two surfaces, at rest;
  double slippery = 0.2;     ///< while they fall: heaps become compact and firm, where friction would leave arches
  double gravity = 0.002;    ///< a step a step; more jams wedges
  double fastest = 0.06;     ///< a step: less than the thinnest piece is thick
  double margin = 0.02;      ///< contacts are known when they are so near
  double slop = 0.002;       ///< an overlap that is left alone
  double push = 0.03;        ///< at most so much of an overlap is taken out in a step,
  double push_share = 0.25;  ///< or this share of it
  double pressed = 0.01;     ///< of a piece's size: what overlaps more may not rest
  double still = 0.0015;     ///< a step: slower bodies count as still,
  int still_steps = 10;      ///< and fall asleep after so many steps
  double slack = 0.1;        ///< bodies move so far before neighbours are looked for anew
  int sweeps = 20;           ///< over all contacts, a step,
  int relaxing_sweeps = 3;   ///< and after the move
  int most_steps = 400;      ///< for one wave
};

/// Rigid bodies over a dish. The same bits for any number of threads: contacts are found in parallel, each pair's for
/// itself; impulses in one order. Nothing but arithmetic and square roots is in it.
class Heap {
 public:
  /// \param bodies so many places, all empty.
  /// \param widest radius of any body, metres.
  Heap(const Dish& dish, std::size_t bodies, double unit, double widest, const HeapOptions& options, Threads threads);

  const std::vector<RigidBody>& bodies() const { return bodies_; }
  double unit() const { return unit_; }

  /// Puts a body into its place; it may have been there before.
  void put(std::size_t place, const RigidBody& body);

  /// Out of the heap; those around it wake up.
  void take_out(std::size_t place);

  /// Nothing moves it any more, unless one beside it is taken out.
  void freeze(std::size_t place);

  /// Nothing moves it ever.
  void fix(std::size_t place);

  /// All that is asleep moves again.
  void wake();

  void set_funnel(const Funnel& funnel) { funnel_ = funnel; }

  /// Lets bodies fall until all are still, or the wave's steps are used up. Returns the number of steps.
  int settle(const std::function<void()>& after_step = {});

  /// The distance to all other bodies and to the dish, metres, if it is below `within`; else `within`. For a body in
  /// the heap, or one that is to be put into the empty place.
  double clearance(std::size_t place, const RigidBody& body, double within) const;

  /// So many bodies are asleep or frozen.
  std::size_t resting() const;

 private:
  static constexpr std::size_t dish_place = static_cast<std::size_t>(-1);
  struct Pair {
    std::size_t first = 0, second = 0;  ///< places; the dish has one of its own
    std::vector<Contact> contact;
    double clear = 0;                      ///< metres that the two may move before they can touch
    double first_way = 0, second_way = 0;  ///< of the bodies, when that was known
  };
  using Places = std::vector<std::size_t>;

  int run(int most, double keep_velocity, double keep_spin, double still, const std::function<void()>& after_step);
  void step(double keep_velocity, double keep_spin);
  void find_pairs();
  std::vector<std::size_t> partners_of(std::size_t place) const;
  void find_contacts(Pair& pair) const;
  void let_act(const Places& active, const Places& touching);
  void move(const Places& active);
  void rest(const Places& active, const Places& touching);
  void keep_in_funnel(RigidBody& body) const;
  bool is_active(std::size_t place) const;
  double deepest(const Pair& pair) const;
  double smaller_size(const Pair& pair) const;
  void find_frozen();
  double reach() const { return 2 * widest_ + (2 * options_.slack + 0.05) * unit_; }

  const Dish& dish_;
  double unit_, widest_;
  HeapOptions options_;
  Threads threads_;
  Funnel funnel_;
  double friction_ = 0;
  std::vector<RigidBody> bodies_;
  std::vector<Pair> pairs_;
  bool pairs_known_ = false;
  double moved_ = 0;   ///< since the pairs were found, at most, metres
  int pressed_ = 0;    ///< pairs that overlap by more than may rest
  NearBodies frozen_;  ///< where these lie,
  bool frozen_known_ = true;
  NearBodies loose_;  ///< and all others, when the pairs were found or they were put in
};

}  // namespace pomona
