// The rigid-body world: pieces that fall, touch, slide and come to rest.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/scene/settle/broad_phase.h"
#include "generator/scene/settle/contact.h"
#include "generator/scene/settle/rigid_body.h"

namespace pomona {

/// A wall that keeps falling bodies above their dish: a round one, or four straight ones.
struct Funnel {
  double radius = 0;   ///< metres from the axis; 0 = no round wall
  double low = 0;      ///< height of the wall's lower end, metres above the ground
  glm::dvec2 from{0};  ///< x and z, metres: the lower corner of the four walls
  glm::dvec2 to{0};    ///< x and z, metres: the upper corner; equal to `from` = no straight walls
};

/// Lengths are in units; one unit is the mean size of the pieces. Times are in steps.
struct WorldOptions {
  double friction = 0.6;            ///< coefficient of friction at rest, for every two surfaces
  double falling_friction = 0.2;    ///< the same while bodies fall; low, because friction would build loose arches
  double gravity = 0.002;           ///< units a step, each step; stronger gravity jams wedges
  double max_speed = 0.06;          ///< units a step; must be less than the thickness of the thinnest piece
  double contact_margin = 0.02;     ///< two surfaces nearer than this form a contact
  double penetration_slop = 0.002;  ///< a penetration up to this depth is not corrected
  double max_correction = 0.03;     ///< a step reduces a penetration by at most this length
  double correction_share = 0.25;   ///< a step reduces a penetration by at most this share of it
  double max_resting_penetration = 0.01;  ///< share of a piece's size; a body that penetrates deeper does not sleep
  double sleep_speed = 0.0015;            ///< sleep threshold, units a step: a slower body counts as still
  int sleep_steps = 10;                   ///< a body that is still for so many steps falls asleep
  double pair_slack = 0.1;                ///< the broad phase runs again when a body may have moved this far
  int sweeps = 20;                        ///< sweeps of the contact solver over all contacts, each step
  int relax_sweeps = 3;                   ///< sweeps of the contact solver after the bodies have moved, each step
  int max_steps = 400;                    ///< steps for one wave of bodies
};

/// Rigid bodies over a dish. The result has the same bits for any number of threads: contacts are found in parallel,
/// each pair by itself; impulses are computed in one fixed order. It uses only arithmetic and square roots.
class RigidBodyWorld {
 public:
  /// \param bodies number of slots; all are empty at first.
  /// \param unit the length that options are given in, metres.
  /// \param widest the largest radius of a body, metres.
  RigidBodyWorld(const Dish& dish, std::size_t bodies, double unit, double widest, const WorldOptions& options,
                 Threads threads);

  const std::vector<RigidBody>& bodies() const { return bodies_; }
  double unit() const { return unit_; }

  /// Puts a body into a slot. The slot may have held a body before.
  void put(std::size_t slot, const RigidBody& body);

  /// Removes a body. The bodies around it wake up.
  void remove(std::size_t slot);

  /// Stops a body for good. It can move again only if a body beside it is removed.
  void freeze(std::size_t slot);

  /// Stops a body for good, whatever is removed beside it.
  void fix(std::size_t slot);

  /// Wakes all bodies that are asleep.
  void wake_all();

  void set_funnel(const Funnel& funnel) { funnel_ = funnel; }

  /// Steps until all bodies are at rest, or `max_steps` steps are done. Returns the number of steps.
  int run_until_rest(const std::function<void()>& after_step = {});

  /// The distance from `body` to all other bodies and to the dish, metres, if it is below `within`; else `within`. The
  /// body is the one in the slot, or one that is to be put there.
  double clearance(std::size_t slot, const RigidBody& body, double within) const;

  /// The number of bodies that are asleep or frozen.
  std::size_t resting_count() const;

 private:
  static constexpr std::size_t dish_slot = static_cast<std::size_t>(-1);
  /// Two bodies that may touch, or a body and the dish.
  struct Pair {
    std::size_t first = 0, second = 0;  ///< slots; `dish_slot` for the dish
    std::vector<Contact> contacts;
    double clearance = 0;         ///< metres that the two may move before they can touch
    double first_travelled = 0;   ///< RigidBody::travelled of the first when `clearance` was measured
    double second_travelled = 0;  ///< the same of the second
  };
  using Indices = std::vector<std::size_t>;

  int run_phase(int max_steps, double keep_velocity, double keep_spin, double rest_speed,
                const std::function<void()>& after_step);
  void step(double keep_velocity, double keep_spin);
  void find_pairs();
  std::vector<std::size_t> bodies_near(std::size_t slot) const;
  void update_contacts(Pair& pair) const;
  void solve_contacts(const Indices& active, const Indices& touching);
  void integrate(const Indices& active);
  void update_sleep(const Indices& active, const Indices& touching);
  void apply_funnel(RigidBody& body) const;
  bool is_active(std::size_t slot) const;
  double penetration_of(const Pair& pair) const;
  double smaller_size(const Pair& pair) const;
  void update_frozen_grid();
  double reach() const { return 2 * widest_ + (2 * options_.pair_slack + 0.05) * unit_; }

  const Dish& dish_;
  double unit_, widest_;  ///< metres
  WorldOptions options_;
  Threads threads_;
  Funnel funnel_;
  double friction_ = 0;  ///< friction of the present phase
  std::vector<RigidBody> bodies_;
  std::vector<Pair> pairs_;  ///< sorted by slots
  bool pairs_are_current_ = false;
  double moved_ = 0;        ///< metres: a bound for what any body has moved since the pairs were found
  int deep_pairs_ = 0;      ///< number of pairs that penetrate by more than may rest
  BroadPhase frozen_grid_;  ///< the frozen bodies
  bool frozen_grid_is_current_ = true;
  BroadPhase loose_grid_;  ///< all other bodies, at their places when pairs were found or they were added
};

}  // namespace pomona
