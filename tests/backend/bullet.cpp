// SPDX-License-Identifier: Apache-2.0
// Bullet behind the seam: its shapes are made from the parameters of those of abut, and its dispatcher chooses the
// algorithm of two shapes. Contacts have no ids there, so that abut numbers them.
#include <btBulletCollisionCommon.h>

#include <array>
#include <map>
#include <memory>

#include "detector.hpp"
#include "support.hpp"

namespace backend {
namespace {

btScalar to_bullet(double value) { return static_cast<btScalar>(value); }
btVector3 to_bullet(const abut_vec3& v) { return {to_bullet(v.x), to_bullet(v.y), to_bullet(v.z)}; }
btTransform to_bullet(const abut_pose& pose) {
  const abut_quat& q = pose.orientation;
  return btTransform(btQuaternion(to_bullet(q.x), to_bullet(q.y), to_bullet(q.z), to_bullet(q.w)),
                     to_bullet(pose.position));
}
abut_vec3 from_bullet(const btVector3& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

const abut_shape_kind sphere = abut_shape_kind_by_name("sphere");
const abut_shape_kind box = abut_shape_kind_by_name("box");
const abut_shape_kind capsule = abut_shape_kind_by_name("capsule");

// Margins are 0 where Bullet lets them, so that distances are those of the shape itself.
std::unique_ptr<btConvexShape> shape_of(const abut_shape* shape) {
  std::array<double, 3> sizes{};
  std::size_t count = 0;
  abut_test::require(abut_shape_parameters(shape, sizes.data(), sizes.size(), &count));
  const abut_shape_kind kind = abut_shape_kind_of(shape);
  if (kind == sphere) return std::make_unique<btSphereShape>(to_bullet(sizes[0]));
  if (kind == capsule) return std::make_unique<btCapsuleShapeZ>(to_bullet(sizes[0]), to_bullet(2 * sizes[1]));
  auto made = std::make_unique<btBoxShape>(to_bullet(abut_vec3{sizes[0], sizes[1], sizes[2]}));
  made->setMargin(0);
  return made;
}

// Takes contacts as an algorithm finds them, without a manifold that lasts.
class Collector final : public btManifoldResult {
 public:
  Collector(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b, double margin)
      : btManifoldResult(&a, &b), first_(a.getCollisionObject()) {
    m_closestPointDistanceThreshold = to_bullet(margin);
  }
  void addContactPoint(const btVector3& normal, const btVector3& point, btScalar depth) override {
    // From the second shape of the algorithm to its first one; the point lies on the second one.
    const bool is_swapped = m_manifoldPtr->getBody0() != first_;
    const btVector3 other = point + normal * depth;
    contacts.push_back(contact_of(from_bullet(is_swapped ? point : other), from_bullet(is_swapped ? other : point),
                                  from_bullet(is_swapped ? normal : -normal)));
  }

  std::vector<abut_backend_contact> contacts;

 private:
  const btCollisionObject* first_;
};

class Bullet {
 public:
  std::vector<abut_backend_contact> find(const abut_backend_pair& pair) {
    const auto shape_a = shape_of(pair.shape_a), shape_b = shape_of(pair.shape_b);
    btCollisionObject a, b;
    a.setCollisionShape(shape_a.get());
    b.setCollisionShape(shape_b.get());
    a.setWorldTransform(to_bullet(pair.pose_a));
    b.setWorldTransform(to_bullet(pair.pose_b));
    const btCollisionObjectWrapper first(nullptr, shape_a.get(), &a, a.getWorldTransform(), -1, -1),
        second(nullptr, shape_b.get(), &b, b.getWorldTransform(), -1, -1);
    const auto kinds = pair.margin > 0 ? BT_CLOSEST_POINT_ALGORITHMS : BT_CONTACT_POINT_ALGORITHMS;
    btCollisionAlgorithm* const algorithm = dispatcher_.findAlgorithm(&first, &second, nullptr, kinds);
    Collector found(first, second, pair.margin);
    algorithm->processCollision(&first, &second, info_, &found);
    algorithm->~btCollisionAlgorithm();
    dispatcher_.freeCollisionAlgorithm(algorithm);
    return found.contacts;
  }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDispatcherInfo info_;
};

std::uint32_t accepts(void* /*context*/, abut_shape_kind a, abut_shape_kind b) {
  const auto is_known = [](abut_shape_kind kind) { return kind == sphere || kind == box || kind == capsule; };
  return is_known(a) && is_known(b) ? 1 : 0;
}

void find(void* context, abut_universe* universe, const abut_backend_pair* pairs, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) answer(universe, i, static_cast<Bullet*>(context)->find(pairs[i]));
}

}  // namespace

Detector bullet() {
  static Bullet its;
  return {"bullet", accepts, find, &its, 2e-3};
}

}  // namespace backend
