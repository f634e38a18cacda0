// SPDX-License-Identifier: Apache-2.0
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/sphere.h>

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "broadphase.hpp"

namespace bench {
namespace {

using Object = fcl::CollisionObject<double>;

// The boxes are given to the objects as they are; their shape has no part in it.
class BoxObject final : public Object {
 public:
  using Object::Object;
  void place(const Box& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      aabb.min_[static_cast<int>(axis)] = static_cast<double>(box.low[axis]);
      aabb.max_[static_cast<int>(axis)] = static_cast<double>(box.high[axis]);
    }
  }
};

class FclPairs final : public BoxPairs {
 public:
  explicit FclPairs(const Boxes& boxes) {
    const auto shape = std::make_shared<fcl::Sphere<double>>(1);
    std::vector<Object*> moving, still;
    numbers_.resize(boxes.all.size());
    for (std::size_t i = 0; i < boxes.all.size(); ++i) {
      numbers_[i] = i;
      objects_.push_back(std::make_unique<BoxObject>(shape));
      objects_[i]->setUserData(&numbers_[i]);
      objects_[i]->place(boxes.all[i]);
      (i < boxes.moving ? moving : still).push_back(objects_[i].get());
    }
    moving_.registerObjects(moving);
    moving_.setup();
    still_.registerObjects(still);
    still_.setup();
  }

  void step(std::span<const Box> moving) override {
    for (std::size_t i = 0; i < moving.size(); ++i) {
      objects_[i]->place(moving[i]);
    }
    moving_.update();
    pairs_.clear();
    const auto keep = [](Object* a, Object* b, void* pairs) {
      static_cast<Pairs*>(pairs)->emplace_back(number(*a), number(*b));
      return false;
    };
    moving_.collide(&pairs_, keep);
    if (!still_.empty()) {
      moving_.collide(&still_, &pairs_, keep);
    }
  }

  [[nodiscard]] std::size_t pairs(std::span<const Box> all) const override {
    std::size_t count = 0;
    for (const auto& [a, b] : pairs_) {
      count += overlap(all[a], all[b]) ? 1 : 0;
    }
    return count;
  }

 private:
  using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
  [[nodiscard]] static std::size_t number(const Object& object) {
    return *static_cast<const std::size_t*>(object.getUserData());
  }

  std::vector<std::size_t> numbers_;
  std::vector<std::unique_ptr<BoxObject>> objects_;
  fcl::DynamicAABBTreeCollisionManager<double> moving_, still_;
  Pairs pairs_;
};

}  // namespace

std::unique_ptr<BoxPairs> make_fcl_broadphase(const Boxes& boxes) { return std::make_unique<FclPairs>(boxes); }

}  // namespace bench
