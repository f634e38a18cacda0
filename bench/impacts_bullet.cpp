// SPDX-License-Identifier: Apache-2.0
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "bullet_shapes.hpp"
#include "impacts.hpp"

namespace bench {
namespace {

struct Way {
  btTransform from_a, to_a, from_b, to_b;
};

class BulletImpacts final : public ImpactFinder {
 public:
  explicit BulletImpacts(const Flights& flights) : a_(bullet_shape(flights.a, -1)), b_(bullet_shape(flights.b, -1)) {
    for (const Flight& flight : flights.all) {
      ways_.push_back({bullet_transform(flight.from_a), bullet_transform(flight.to_a), bullet_transform(flight.from_b),
                       bullet_transform(flight.to_b)});
    }
  }

  [[nodiscard]] std::size_t answer() override {
    std::size_t touching = 0;
    btContinuousConvexCollision search(static_cast<const btConvexShape*>(a_.get()),
                                       static_cast<const btConvexShape*>(b_.get()), &simplex_, &depth_);
    for (const Way& way : ways_) {
      btConvexCast::CastResult result;
      touching += search.calcTimeOfImpact(way.from_a, way.to_a, way.from_b, way.to_b, result) ? 1 : 0;
    }
    return touching;
  }

 private:
  std::unique_ptr<btCollisionShape> a_, b_;
  std::vector<Way> ways_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver depth_;
};

}  // namespace

std::unique_ptr<ImpactFinder> make_bullet_impacts(const Flights& flights) {
  return std::make_unique<BulletImpacts>(flights);
}

}  // namespace bench
