// The one file that knows Bullet's dynamics.
#include "generator/scene/settle/pile.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <btBulletDynamicsCommon.h>
#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/mesh/convex_hull.h"

namespace pomona {

namespace {

static_assert(sizeof(btScalar) == sizeof(double), "Bullet's headers and library must agree on double precision");

// Only lengths per step matter to the result, so time may have any unit. Bullet lets a body sleep after two
// of its seconds: with 30 steps a second, after 60 steps.
constexpr double steps_per_second = 30;
// A body that falls freely gains this many units a step, each step: 9.81 m/s^2 at 200 steps a second and
// 5 cm a unit.
constexpr double gravity_per_step = 0.005;

btVector3 to_bullet(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
glm::dvec3 to_glm(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// Bullet's world with a motion of its own: what Bullet does with the C library's sine and power, whose last
/// bits differ between processors, is done here by arithmetic alone, and no body outruns a step.
class SteadyWorld : public btDiscreteDynamicsWorld {
 public:
  SteadyWorld(btDispatcher* dispatcher, btBroadphaseInterface* broadphase, btConstraintSolver* solver,
              btCollisionConfiguration* configuration, double fastest)
      : btDiscreteDynamicsWorld(dispatcher, broadphase, solver, configuration), fastest_(fastest) {}

  /// Largest speed of any body that moves, units a step.
  double speed() const {
    double most = 0;
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
      const btRigidBody& body = *m_nonStaticRigidBodies[i];
      if (!body.isActive()) continue;
      most = std::max({most, body.getLinearVelocity().length(), 0.5 * body.getAngularVelocity().length()});
    }
    return most / steps_per_second;
  }

  void set_damping(double linear, double angular) {
    keep_linear_ = 1 - linear;
    keep_angular_ = 1 - angular;
  }

  void set_funnel(const Funnel& funnel) { funnel_ = funnel; }

 protected:
  void predictUnconstraintMotion(btScalar step) override {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
      btRigidBody& body = *m_nonStaticRigidBodies[i];
      if (body.isStaticOrKinematicObject()) continue;
      body.setLinearVelocity(body.getLinearVelocity() * keep_linear_);
      body.setAngularVelocity(body.getAngularVelocity() * keep_angular_);
      body.setInterpolationWorldTransform(moved(body, step));
    }
  }

  void integrateTransforms(btScalar step) override {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
      btRigidBody& body = *m_nonStaticRigidBodies[i];
      body.setHitFraction(1);
      if (!body.isActive() || body.isStaticOrKinematicObject()) continue;
      body.setLinearVelocity(limited(kept_in_funnel(body), fastest_));
      body.setAngularVelocity(limited(body.getAngularVelocity(), 2 * fastest_));
      body.proceedToTransform(moved(body, step));
    }
  }

 private:
  static btVector3 limited(const btVector3& velocity, double per_step) {
    const double speed = velocity.length() / steps_per_second;
    return speed > per_step ? velocity * (per_step / speed) : velocity;
  }

  /// The velocity of a body, without what leads it through the funnel's wall.
  btVector3 kept_in_funnel(const btRigidBody& body) const {
    const btVector3 velocity = body.getLinearVelocity();
    btVector3 center;
    btScalar radius;
    body.getCollisionShape()->getBoundingSphere(center, radius);
    center = body.getWorldTransform() * center;
    btVector3 outwards(center.x(), 0, center.z());
    const double distance = outwards.length();
    if (funnel_.radius <= 0 || center.y() < funnel_.low || distance + radius < funnel_.radius || distance <= 0)
      return velocity;
    outwards /= distance;
    const double outward_speed = velocity.dot(outwards);
    return outward_speed > 0 ? velocity - outwards * outward_speed : velocity;
  }

  static btTransform moved(const btRigidBody& body, btScalar step) {
    const btVector3& w = body.getAngularVelocity();
    btQuaternion turn = body.getWorldTransform().getRotation();
    const btQuaternion change = btQuaternion(w.x(), w.y(), w.z(), 0) * turn;
    turn += change * (0.5 * step);
    turn.normalize();
    return btTransform(turn, body.getWorldTransform().getOrigin() + body.getLinearVelocity() * step);
  }

  double fastest_;
  Funnel funnel_;  ///< in units
  double keep_linear_ = 1, keep_angular_ = 1;
};

/// Owns what a world is made of, in an order in which it can be taken apart.
class Heap {
 public:
  explicit Heap(const PileOptions& options)
      : options_(options),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_, options.fastest) {
    world_.setGravity({0, -gravity_per_step * steps_per_second * steps_per_second, 0});
    world_.getDispatchInfo().m_deterministicOverlappingPairs = true;
    btContactSolverInfo& info = world_.getSolverInfo();
    info.m_numIterations = 30;
    info.m_splitImpulse = 0;  // its correction of positions turns by the C library's sine
    info.m_erp2 = 0.15;
    info.m_solverMode &= ~SOLVER_RANDMIZE_ORDER;
    solver_.setRandSeed(0);
  }
  ~Heap() {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  Heap(const Heap&) = delete;
  Heap& operator=(const Heap&) = delete;

  SteadyWorld& world() { return world_; }
  const std::vector<std::unique_ptr<btRigidBody>>& bodies() const { return bodies_; }

  btConvexHullShape* make_hull(std::span<const glm::dvec3> corners) {
    auto shape = std::make_unique<btConvexHullShape>();
    for (const glm::dvec3& corner : corners) shape->addPoint(to_bullet(corner), false);
    shape->recalcLocalAabb();
    shape->setMargin(options_.margin);
    return keep(std::move(shape));
  }

  template <typename Shape>
  Shape* keep(std::unique_ptr<Shape> shape) {
    Shape* const raw = shape.get();
    shapes_.push_back(std::move(shape));
    return raw;
  }

  btRigidBody* add(btCollisionShape* shape, double mass, const btTransform& start) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, inertia);
    info.m_startWorldTransform = start;
    info.m_friction = options_.friction;
    info.m_rollingFriction = options_.rolling_friction;
    info.m_spinningFriction = options_.rolling_friction;
    info.m_linearSleepingThreshold = 2 * options_.at_rest * steps_per_second;
    info.m_angularSleepingThreshold = 4 * options_.at_rest * steps_per_second;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    if (mass > 0) bodies_.back()->setFlags(0);
    world_.addRigidBody(bodies_.back().get());
    return bodies_.back().get();
  }

 private:
  PileOptions options_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  SteadyWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

/// Corners in simulation units about the centre, shrunken by the margin that Bullet adds again, and no more of
/// them than an eye would miss: the extreme ones in some 80 directions.
std::vector<glm::dvec3> simulated_corners(const ConvexPart& part, const glm::dvec3& center,
                                          const PileOptions& options) {
  constexpr int directions = 80;
  std::vector<glm::dvec3> points;
  for (const glm::dvec3& p : part) points.push_back((p - center) / options.unit);
  if (points.size() > 40) {
    std::vector<std::uint8_t> wanted(points.size());
    for (int k = 0; k < directions; ++k) {
      // A spiral of even steps in height and golden angles goes evenly over the sphere.
      const double y = 1 - (2 * k + 1.0) / directions, r = std::sqrt(1 - y * y), angle = k * 2.399963229728653;
      const glm::dvec3 d(r * reproducible::cos(angle), y, r * reproducible::sin(angle));
      std::size_t best = 0;
      for (std::size_t i = 1; i < points.size(); ++i)
        if (glm::dot(points[i], d) > glm::dot(points[best], d)) best = i;
      wanted[best] = 1;
    }
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (wanted[i]) kept.push_back(points[i]);
    points = std::move(kept);
  }
  return shrunken_corners(points, options.margin);
}

btCollisionShape* make_shape(Heap& heap, const PileBody& body, const PileOptions& options) {
  if (body.parts.size() == 1) return heap.make_hull(simulated_corners(body.parts[0], body.center, options));
  auto compound = std::make_unique<btCompoundShape>(true, static_cast<int>(body.parts.size()));
  for (const ConvexPart& part : body.parts)
    compound->addChildShape(btTransform::getIdentity(), heap.make_hull(simulated_corners(part, body.center, options)));
  return heap.keep(std::move(compound));
}

btTransform start_of(const PileBody& body, double unit) {
  const glm::dquat& q = body.start.rotation;
  const glm::dvec3 center = q * body.center + body.start.translation;
  return btTransform(btQuaternion(q.x, q.y, q.z, q.w), to_bullet(center / unit));
}

glm::dvec3 around_axis(const glm::dvec2& p, double angle) {
  return {p.x * reproducible::cos(angle), p.y, p.x * reproducible::sin(angle)};
}

/// The stand as thick convex blocks: between every two points of the profile a ring of them, as many as keep
/// the chords within a hundredth of a unit of the circle.
void add_stand(Heap& heap, std::span<const glm::dvec2> profile, const PileOptions& options) {
  constexpr double thickness = 0.25, sagitta = 0.01;
  auto compound = std::make_unique<btCompoundShape>(true);
  for (std::size_t k = 1; k < profile.size(); ++k) {
    const glm::dvec2 a = profile[k - 1] / options.unit, b = profile[k] / options.unit;
    const glm::dvec2 inwards = glm::normalize(glm::dvec2(b.y - a.y, a.x - b.x));
    const int count = std::clamp(static_cast<int>(pi * std::sqrt(0.5 * b.x / sagitta)), 6, 64);
    for (int i = 0; i < count; ++i) {
      std::vector<glm::dvec3> corners;
      for (const int side : {i, i + 1}) {
        for (const glm::dvec2& p : {a, b}) {
          for (const double depth : {options.margin, thickness}) {
            const glm::dvec2 q = p + inwards * depth;
            corners.push_back(around_axis({std::max(0.0, q.x), q.y}, 2 * pi * side / count));
          }
        }
      }
      compound->addChildShape(btTransform::getIdentity(), heap.make_hull(corners));
    }
  }
  heap.add(heap.keep(std::move(compound)), 0, btTransform::getIdentity());

  // Beyond the profile.
  const double ground = profile.back().y / options.unit;
  auto* const plane = heap.keep(std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), ground));
  heap.add(plane, 0, btTransform::getIdentity());
}

/// Steps until nothing moves faster than `still`, units a step; the number of steps taken, or the most if something
/// still does.
int run(Heap& heap, int most, double still) {
  constexpr int calm_steps = 10;
  int calm = 0;
  for (int step = 1; step <= most; ++step) {
    heap.world().stepSimulation(1 / steps_per_second, 0);
    calm = heap.world().speed() < still ? calm + 1 : 0;
    if (calm >= calm_steps) return step;
  }
  return most;
}

}  // namespace

Piled pile(std::span<const PileBody> bodies, std::span<const glm::dvec2> stand, const Funnel& funnel,
           const PileOptions& options) {
  Heap heap(options);
  add_stand(heap, stand, options);
  std::vector<btRigidBody*> falling;
  for (const PileBody& body : bodies)
    falling.push_back(heap.add(make_shape(heap, body, options), body.mass, start_of(body, options.unit)));

  // Fall until all have landed; then, without the funnel and ever more slowly, come to rest.
  Piled result;
  heap.world().set_funnel({funnel.radius / options.unit, funnel.low / options.unit});
  heap.world().set_damping(0.03, 0.06);
  result.steps = run(heap, options.most_steps / 2, 8 * options.at_rest);
  heap.world().set_funnel({});
  for (btRigidBody* const body : falling) body->activate(true);
  heap.world().set_damping(0.1, 0.2);
  result.steps += run(heap, options.most_steps / 8, 2 * options.at_rest);
  heap.world().set_damping(0.3, 0.4);
  const int rest = options.most_steps - result.steps;
  const int more = run(heap, rest, options.at_rest);
  result.steps += more;
  result.at_rest = more < rest;

  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const btTransform& at = falling[i]->getWorldTransform();
    const btQuaternion q = at.getRotation();
    Pose pose;
    pose.rotation = glm::normalize(glm::dquat(q.w(), q.x(), q.y(), q.z()));
    pose.translation = to_glm(at.getOrigin()) * options.unit - pose.rotation * bodies[i].center;
    result.poses.push_back(pose);
  }
  return result;
}

}  // namespace pomona
