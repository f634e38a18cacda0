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
  btVector3 motion;
};

std::vector<Job> jobs_of(const Cell& cell) {
  const Solid& first = cell.solids_a.front();
  const btVector3 middle =
      first.kind == Kind::height_field ? to_bullet(BulletField::middle(first)) : btVector3(0, 0, 0);
  std::vector<Job> jobs;
  for (const Case& one : cell.cases) {
    const btTransform pose_a = bullet_transform(one.pose_a);
    jobs.push_back({one.a, one.b, btTransform(pose_a.getBasis(), pose_a(middle)), bullet_transform(one.pose_b),
                    to_bullet(one.motion)});
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
      const btTransform end(job.pose_b.getBasis(), job.pose_b.getOrigin() + job.motion);
      btConvexCast::CastResult result;
      result.m_fraction = 1;
      const bool is_hit = search.calcTimeOfImpact(job.pose_b, end, job.pose_a, job.pose_a, result);
      answers[i] = {is_hit ? static_cast<double>(result.m_fraction) : 1, 1};
    }
  }

 private:
  std::vector<Job> jobs_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_a_, shapes_b_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver depth_;
};

class Contacts final : public Contender {
 public:
  explicit Contacts(const Cell& cell)
      : jobs_(jobs_of(cell)), shapes_a_(shapes_of(cell.solids_a)), shapes_b_(shapes_of(cell.solids_b)) {
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
      answers[i] = found;
    }
  }

 private:
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
  if (has(Kind::ellipsoid)) {
    return nullptr;
  }
  if (query == Query::contacts) {
    return std::make_unique<Contacts>(cell);
  }
  // The closest-point query is one of convex shapes, which Bullet's plane is not.
  if (has(Kind::plane)) {
    return nullptr;
  }
  if (query == Query::cast) {
    return std::make_unique<Cast>(cell);
  }
  return std::make_unique<Distance>(cell);
}

}  // namespace bench
