// SPDX-License-Identifier: Apache-2.0
#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "broadphase.hpp"

namespace bench {
namespace {

btVector3 vector_of(const std::array<float, 3>& p) { return {p[0], p[1], p[2]}; }

class BulletPairs final : public BoxPairs {
 public:
  BulletPairs(const Boxes& boxes, std::unique_ptr<btBroadphaseInterface> broadphase)
      : broadphase_(std::move(broadphase)) {
    numbers_.resize(boxes.all.size());
    for (std::size_t i = 0; i < boxes.all.size(); ++i) {
      numbers_[i] = i;
      const bool moves = i < boxes.moving;
      const int group = moves ? btBroadphaseProxy::DefaultFilter : btBroadphaseProxy::StaticFilter;
      const int mask =
          moves ? btBroadphaseProxy::AllFilter : btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter;
      proxies_.push_back(broadphase_->createProxy(vector_of(boxes.all[i].low), vector_of(boxes.all[i].high), 0,
                                                  &numbers_[i], group, mask, nullptr));
    }
  }
  ~BulletPairs() override {
    // The pairs go first: taking a proxy away would look through all of them.
    broadphase_->resetPool(nullptr);
    for (btBroadphaseProxy* proxy : proxies_) {
      broadphase_->destroyProxy(proxy, nullptr);
    }
  }

  void step(std::span<const Box> moving) override {
    for (std::size_t i = 0; i < moving.size(); ++i) {
      broadphase_->setAabb(proxies_[i], vector_of(moving[i].low), vector_of(moving[i].high), nullptr);
    }
    broadphase_->calculateOverlappingPairs(nullptr);
  }

  [[nodiscard]] std::size_t pairs(std::span<const Box> all) const override {
    const btBroadphasePairArray& found = broadphase_->getOverlappingPairCache()->getOverlappingPairArray();
    std::size_t count = 0;
    for (int i = 0; i < found.size(); ++i) {
      const auto number = [](const btBroadphaseProxy* proxy) {
        return *static_cast<const std::size_t*>(proxy->m_clientObject);
      };
      count += overlap(all[number(found[i].m_pProxy0)], all[number(found[i].m_pProxy1)]) ? 1 : 0;
    }
    return count;
  }

 private:
  std::vector<std::size_t> numbers_;
  std::vector<btBroadphaseProxy*> proxies_;
  std::unique_ptr<btBroadphaseInterface> broadphase_;
};

}  // namespace

std::unique_ptr<BoxPairs> make_bullet_broadphase(const Boxes& boxes, BulletBroadphase kind, float extent) {
  if (kind == BulletBroadphase::dbvt) {
    return std::make_unique<BulletPairs>(boxes, std::make_unique<btDbvtBroadphase>());
  }
  // Without the tree for rays that it keeps beside the axes.
  return std::make_unique<BulletPairs>(
      boxes,
      std::make_unique<bt32BitAxisSweep3>(btVector3(-extent, -extent, -extent), btVector3(extent, extent, extent),
                                          static_cast<unsigned>(boxes.all.size() + 1), nullptr, true));
}

}  // namespace bench
