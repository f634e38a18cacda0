// SPDX-License-Identifier: Apache-2.0
// Who meets whom in a universe, and how: rules, the filter, policies, the focus and materials.
#ifndef ABUT_CPP_UNIVERSE_RULES_HPP
#define ABUT_CPP_UNIVERSE_RULES_HPP

#include <abut/abut.h>
#include <abut/cpp/universe_geometries.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

namespace abut {
inline namespace ABUT_ANSWERS {

class UniverseRules : public UniverseGeometries {
 public:
  // Decides about a pair: false leaves it out. It may ask what is const of its universe, and park. It must not throw:
  // the step answers ABUT_INTERNAL then, and so does the universe from then on.
  using Filter = std::function<bool(GeometryId, GeometryId)>;

  Answer<void> set_rule(const Collidable& a, const Collidable& b, Rule rule) {
    return detail::answer(abut_rule_set(get(), &a, &b, rule));
  }
  Answer<void> clear_rules() { return detail::answer(abut_rules_clear(get())); }

  // The universe keeps the filter; an empty one takes it away.
  Answer<void> set_filter(Filter filter) {
    auto kept = filter ? std::make_unique<Filter>(std::move(filter)) : nullptr;
    const abut_status status = abut_universe_set_filter(get(), kept ? &call_filter : nullptr, kept.get());
    if (status == ABUT_OK) filter_ = std::move(kept);
    return detail::answer(status);
  }
  // Asks the filter about all pairs again at the next step.
  Answer<void> refilter() { return detail::answer(abut_universe_refilter(get())); }

  // How geometries of two tags meet; without a Policy by default.
  Answer<void> set_policy(std::uint32_t tag_a, std::uint32_t tag_b, OptionalRef<abut_policy> policy) {
    return detail::answer(abut_policy_set(get(), tag_a, tag_b, policy.get()));
  }
  [[nodiscard]] Answer<Policy> policy(std::uint32_t tag_a, std::uint32_t tag_b) const {
    Policy out;
    return detail::answer(abut_policy_get(get(), tag_a, tag_b, &out), out);
  }
  // Tags by distance from centres; without a Focus tags stay as they are.
  Answer<void> set_focus(OptionalRef<abut_focus> focus, Span<const Vec3> centres = {}) {
    return detail::answer(abut_universe_set_focus(get(), focus.get(), centres.data(), centres.size()));
  }

  // What contacts of two materials are like; without a ContactMaterial the row is taken away.
  Answer<void> set_material_pair(std::uint32_t material_a, std::uint32_t material_b,
                                 OptionalRef<abut_contact_material> row) {
    return detail::answer(abut_material_pair_set(get(), material_a, material_b, row.get()));
  }
  [[nodiscard]] Answer<ContactMaterial> material_pair(std::uint32_t material_a, std::uint32_t material_b) const {
    ContactMaterial out;
    return detail::answer(abut_material_pair_get(get(), material_a, material_b, &out), out);
  }

 protected:
  using UniverseGeometries::UniverseGeometries;

 private:
  static std::uint32_t call_filter(void* context, const abut_universe*, abut_geometry_id a, abut_geometry_id b) {
    return (*static_cast<const Filter*>(context))(a, b) ? 1 : 0;
  }

  std::unique_ptr<Filter> filter_;
};

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
