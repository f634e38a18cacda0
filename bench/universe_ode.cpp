// SPDX-License-Identifier: Apache-2.0
// ODE in double precision: its hash space, and contacts of each pair that it finds.
#include <ode/ode.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "ode_shapes.hpp"
#include "universe.hpp"

namespace bench {
namespace {

struct DestroySpace {
  void operator()(dSpaceID space) const { dSpaceDestroy(space); }
};
using Space = std::unique_ptr<std::remove_pointer_t<dSpaceID>, DestroySpace>;

void examine(void* context, dGeomID a, dGeomID b) {
  constexpr int most_contacts = 4;
  Counts& counts = *static_cast<Counts*>(context);
  std::array<dContactGeom, most_contacts> contacts;
  const int count = dCollide(a, b, most_contacts, contacts.data(), sizeof(dContactGeom));
  ++counts.pairs;
  counts.touching += count > 0 ? 1 : 0;
  counts.points += static_cast<std::size_t>(count);
  for (const dContactGeom& contact : std::span(contacts).first(static_cast<std::size_t>(count))) {
    counts.overlapping += contact.depth > 0 ? 1 : 0;
  }
}

class OdeWorld final : public Detector {
 public:
  explicit OdeWorld(const World& world) : convexes_(ode_convexes(world.solids)), frames_(world.frames) {
    space_.reset(dHashSpaceCreate(nullptr));
    dSpaceSetCleanup(space_.get(), 0);
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      const std::size_t solid = world.bodies[i];
      geoms_.push_back(ode_geom(world.solids[solid], convexes_[solid], frames_.front()[i]));
      dSpaceAdd(space_.get(), geoms_.back().get());
    }
    ground_ = ode_geom(world.ground, {}, world.ground_at);
  }
  ~OdeWorld() override {
    for (const OdeGeom& geom : geoms_) {
      dSpaceRemove(space_.get(), geom.get());
    }
  }

  void place(std::size_t frame) override {
    for (std::size_t i = 0; i < geoms_.size(); ++i) {
      const Placement& placement = frames_[frame][i];
      dGeomSetPosition(geoms_[i].get(), placement.position[0], placement.position[1], placement.position[2]);
      dGeomSetQuaternion(geoms_[i].get(), placement.orientation.data());
    }
  }
  void detect() override {
    counts_ = {};
    dSpaceCollide(space_.get(), &counts_, examine);
    dSpaceCollide2(ground_.get(), space_as_geom(), &counts_, examine);
  }
  [[nodiscard]] Counts counts() const override { return counts_; }

 private:
  // A space is a geom of ODE, in another type.
  [[nodiscard]] dGeomID space_as_geom() const { return static_cast<dGeomID>(static_cast<void*>(space_.get())); }

  std::vector<OdeConvex> convexes_;
  std::vector<std::vector<Placement>> frames_;
  Space space_;
  std::vector<OdeGeom> geoms_;
  OdeGeom ground_;
  Counts counts_;
};

}  // namespace

std::unique_ptr<Detector> make_ode_world(const World& world) {
  return start_ode() ? std::make_unique<OdeWorld>(world) : nullptr;
}

}  // namespace bench
