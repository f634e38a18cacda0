// SPDX-License-Identifier: Apache-2.0
module abut.detect.lists.hash;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.scene.state.options;

namespace abut {
namespace {

// A chain of words, each of which changes all bits that follow.
class Hash {
 public:
  void add(std::uint64_t word) { state_ = scrambled(state_ ^ word); }
  void add(std::uint32_t low, std::uint32_t high) { add((std::uint64_t{high} << 32) | low); }
  void add(Real value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Vec3& v) {
    add(v.x);
    add(v.y);
    add(v.z);
  }
  // Slots say which geometries they are; generations differ from universe to universe.
  void add(const GeometryId& a, const GeometryId& b) { add(a.slot, b.slot); }
  void add(const Feature& feature) { add(static_cast<std::uint32_t>(feature.kind), feature.index); }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace

std::uint64_t hash_of(std::span<const Contact> contacts, std::span<const LocalPoints> locals,
                      std::span<const Event> events, std::span<const SleepChange> sleep_changes) {
  Hash hash;
  hash.add(std::uint64_t{contacts.size()});
  for (const Contact& contact : contacts) {
    hash.add(contact.geometry_a, contact.geometry_b);
    hash.add(contact.point.point_a);
    hash.add(contact.point.point_b);
    hash.add(contact.point.normal);
    hash.add(contact.point.distance);
    hash.add(contact.point.feature_a);
    hash.add(contact.point.feature_b);
    hash.add(contact.point.id);
    hash.add(contact.point.child_a, contact.point.child_b);
    hash.add(contact.flags, contact.age);
    hash.add(contact.user_data);
    hash.add(contact.material_a, contact.material_b);
    if (contact.toi != 0) {
      hash.add(contact.toi);
    }
  }
  for (const LocalPoints& points : locals) {
    hash.add(points.a);
    hash.add(points.b);
  }
  hash.add(std::uint64_t{events.size()});
  for (const Event& event : events) {
    hash.add(static_cast<std::uint32_t>(event.kind), event.flags);
    hash.add(event.geometry_a, event.geometry_b);
    hash.add(event.contact_id);
    hash.add(event.first_contact, event.contact_count);
  }
  for (const SleepChange& change : sleep_changes) {
    hash.add(change.part.slot, change.is_asleep ? 1 : 0);
  }
  return hash.value();
}

}  // namespace abut
