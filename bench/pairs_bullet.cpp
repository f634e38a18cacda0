// SPDX-License-Identifier: Apache-2.0
// Bullet, single precision as most builds have it. Margins are 0 where the shape allows it, so that the
// distance is that of the shape itself.
#include <btBulletCollisionCommon.h>

#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <algorithm>
#include <memory>
#include <vector>

#include "bullet_shapes.hpp"
#include "pairs.hpp"

namespace bench {
namespace {

struct Job {
  std::size_t a, b;
  btTransform pose_a, pose_b;
  btTransform end_b;
};

std::vector<Job> jobs_of(const Cell& cell) {
  const Solid& first = cell.solids_a.front();
  const btVector3 middle =
      first.kind == Kind::height_field ? to_bullet(BulletField::middle(first)) : btVector3(0, 0, 0);
  std::vector<Job> jobs;
  for (const Case& one : cell.cases) {
    const btTransform pose_a = bullet_transform(one.pose_a);
    Placement end = one.pose_b;
    for (std::size_t i = 0; i < 3; ++i) {
      end.position.at(i) += one.motion.at(i);
    }
    end.orientation = product(turn_by(one.turn), end.orientation);
    jobs.push_back({one.a, one.b, btTransform(pose_a.getBasis(), pose_a(middle)), bullet_transform(one.pose_b),
                    bullet_transform(end)});
  }
  return jobs;
}

std::vector<std::unique_ptr<btCollisionShape>> shapes_of(std::span<const Solid> solids) {
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  for (const Solid& solid : solids) {
    shapes.push_back(bullet_shape(solid, 0));
  }
  return shapes;
}

class Distance final : public Contender {
 public:
  explicit Distance(const Cell& cell)
      : jobs_(jobs_of(cell)), shapes_a_(shapes_of(cell.solids_a)), shapes_b_(shapes_of(cell.solids_b)) {}

  void answer(std::span<Answer> answers) override {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const Job& job = jobs_[i];
      btGjkPairDetector detector(static_cast<const btConvexShape*>(shapes_a_[job.a].get()),
                                 static_cast<const btConvexShape*>(shapes_b_[job.b].get()), &simplex_, &depth_);
      btGjkPairDetector::ClosestPointInput input;
      input.m_transformA = job.pose_a;
      input.m_transformB = job.pose_b;
      btPointCollector result;
      detector.getClosestPointsNonVirtual(input, result, nullptr);
      answers[i] = {static_cast<double>(result.m_distance), result.m_hasResult ? 1u : 0u};
    }
  }

 private:
  std::vector<Job> jobs_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_a_, shapes_b_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver depth_;
};

// What its world asks for sweeps of convex shapes.
class Cast final : public Contender {
 public:
  explicit Cast(const Cell& cell)
      : jobs_(jobs_of(cell)), shapes_a_(shapes_of(cell.solids_a)), shapes_b_(shapes_of(cell.solids_b)) {}

  void answer(std::span<Answer> answers) override {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const Job& job = jobs_[i];
      btContinuousConvexCollision search(static_cast<const btConvexShape*>(shapes_b_[job.b].get()),
                                         static_cast<const btConvexShape*>(shapes_a_[job.a].get()), &simplex_, &depth_);
      btConvexCast::CastResult result;
      result.m_fraction = 1;
      const bool is_hit = search.calcTimeOfImpact(job.pose_b, job.end_b, job.pose_a, job.pose_a, result);
      answers[i] = {is_hit ? static_cast<double>(result.m_fraction) : 1, 1};
    }
  }

 private:
  std::vector<Job> jobs_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_a_, shapes_b_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver depth_;
};

// What its world asks for rays, and for sweeps onto surfaces.
class OfWorld final : public Contender {
 public:
  OfWorld(Query query, const Cell& cell)
      : query_(query), jobs_(jobs_of(cell)), shapes_a_(shapes_of(cell.solids_a)), shapes_b_(shapes_of(cell.solids_b)) {}

  void answer(std::span<Answer> answers) override {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const Job& job = jobs_[i];
      const btVector3 &from = job.pose_b.getOrigin(), &to = job.end_b.getOrigin();
      const btCollisionShape* shape = shapes_a_[job.a].get();
      object_.setWorldTransform(job.pose_a);
      if (query_ == Query::ray) {
        btCollisionWorld::ClosestRayResultCallback hit(from, to);
        btCollisionWorld::rayTestSingle(job.pose_b, job.end_b, &object_, shape, job.pose_a, hit);
        answers[i] = {static_cast<double>(hit.m_closestHitFraction), 1};
      } else {
        btCollisionWorld::ClosestConvexResultCallback hit(from, to);
        btCollisionWorld::objectQuerySingle(static_cast<const btConvexShape*>(shapes_b_[job.b].get()), job.pose_b,
                                            job.end_b, &object_, shape, job.pose_a, hit, 0);
        answers[i] = {static_cast<double>(hit.m_closestHitFraction), 1};
      }
    }
  }

 private:
  Query query_;
  std::vector<Job> jobs_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_a_, shapes_b_;
  btCollisionObject object_;
};

class Contacts final : public Contender {
 public:
  Contacts(Query query, const Cell& cell)
      : query_(query), jobs_(jobs_of(cell)), shapes_a_(shapes_of(cell.solids_a)), shapes_b_(shapes_of(cell.solids_b)) {
    object_a_.setCollisionShape(shapes_a_.front().get());
    object_b_.setCollisionShape(shapes_b_.front().get());
    const btCollisionObjectWrapper a(nullptr, object_a_.getCollisionShape(), &object_a_, object_a_.getWorldTransform(),
                                     -1, -1);
    const btCollisionObjectWrapper b(nullptr, object_b_.getCollisionShape(), &object_b_, object_b_.getWorldTransform(),
                                     -1, -1);
    algorithm_ = dispatcher_.findAlgorithm(&a, &b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    // Some algorithms make their manifold with the first call.
    btManifoldResult result(&a, &b);
    algorithm_->processCollision(&a, &b, dispatch_info_, &result);
    btManifoldArray manifolds;
    algorithm_->getAllContactManifolds(manifolds);
    manifold_ = manifolds.at(0);
  }
  ~Contacts() override {
    algorithm_->~btCollisionAlgorithm();
    dispatcher_.freeCollisionAlgorithm(algorithm_);
  }

  void answer(std::span<Answer> answers) override {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const Job& job = jobs_[i];
      manifold_->clearManifold();
      const btCollisionObjectWrapper a(nullptr, shapes_a_[job.a].get(), &object_a_, job.pose_a, -1, -1);
      const btCollisionObjectWrapper b(nullptr, shapes_b_[job.b].get(), &object_b_, job.pose_b, -1, -1);
      object_a_.setWorldTransform(job.pose_a);
      object_b_.setWorldTransform(job.pose_b);
      btManifoldResult result(&a, &b);
      algorithm_->processCollision(&a, &b, dispatch_info_, &result);
      Answer found;
      for (int p = 0; p < manifold_->getNumContacts(); ++p) {
        const auto distance = static_cast<double>(manifold_->getContactPoint(p).getDistance());
        if (distance < 0) {
          found.distance = std::min(found.distance, distance);
          ++found.points;
        }
      }
      answers[i] = query_ == Query::contacts ? found : Answer{found.points > 0 ? -1.0 : 1.0, 1};
    }
  }

 private:
  Query query_;
  std::vector<Job> jobs_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_a_, shapes_b_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDispatcherInfo dispatch_info_;
  btCollisionObject object_a_, object_b_;
  btPersistentManifold* manifold_ = nullptr;
  btCollisionAlgorithm* algorithm_ = nullptr;
};

}  // namespace

std::unique_ptr<Contender> make_bullet(Query query, const Cell& cell) {
  const auto has = [&cell](Kind kind) {
    return cell.solids_a.front().kind == kind || cell.solids_b.front().kind == kind;
  };
  if (has(Kind::ellipsoid) || has(Kind::solid_mesh) || has(Kind::distance_field) || has(Kind::particles) ||
      has(Kind::composite)) {
    return nullptr;
  }
  if (query == Query::contacts || query == Query::overlap) {
    return std::make_unique<Contacts>(query, cell);
  }
  const bool is_convex = is_bounded_and_convex(cell.solids_a.front().kind);
  if (query == Query::ray || (query == Query::cast && !is_convex)) {
    return std::make_unique<OfWorld>(query, cell);
  }
  if (!is_convex) {
    return nullptr;
  }
  if (query == Query::cast || query == Query::impact) {
    return std::make_unique<Cast>(cell);
  }
  return std::make_unique<Distance>(cell);
}

}  // namespace bench
