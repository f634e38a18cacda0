// SPDX-License-Identifier: Apache-2.0
// Who meets whom in a universe, and how: rules, the filter, policies, the focus, materials and a back end.
#ifndef ABUT_CPP_UNIVERSE_RULES_HPP
#define ABUT_CPP_UNIVERSE_RULES_HPP

#include <abut/abut.h>
#include <abut/cpp/universe_geometries.hpp>

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <utility>

namespace abut {
inline namespace ABUT_ANSWERS {

class UniverseRules : public UniverseGeometries {
 public:
  // Decides about a pair: false leaves it out. It may ask what is const of its universe, and park. What it throws comes
  // out of the step or detection when that is over: the pair is left out until the next one, which asks again.
  using Filter = std::function<bool(GeometryId, GeometryId)>;

  Answer<void> set_rule(const Collidable& a, const Collidable& b, Rule rule) {
    return detail::answer(abut_rule_set(get(), &a, &b, rule));
  }
  Answer<void> clear_rules() { return detail::answer(abut_rules_clear(get())); }

  // The rule that counts for two geometries, and the collidables that it names.
  [[nodiscard]] Answer<RuleVerdict> rule_between(GeometryId geometry_a, GeometryId geometry_b) const {
    std::uint32_t rule = ABUT_RULE_NONE;
    RuleVerdict out{};
    const abut_status status = abut_rule_between(get(), geometry_a, geometry_b, &rule, &out.a, &out.b);
    out.rule = static_cast<Rule>(rule);
    return detail::answer(status, out);
  }
  // Why two geometries are not examined, as bits such as ABUT_APART_LAYERS; 0 where they are.
  [[nodiscard]] Answer<abut_apart_reasons> why_apart(GeometryId geometry_a, GeometryId geometry_b) const {
    abut_apart_reasons out = 0;
    return detail::answer(abut_universe_why_apart(get(), geometry_a, geometry_b, &out), out);
  }

  // The universe keeps the filter; an empty one takes it away.
  Answer<void> set_filter(Filter filter) {
    auto kept = filter ? std::make_unique<KeptFilter>(KeptFilter{std::move(filter), nullptr}) : nullptr;
    const abut_status status = abut_universe_set_filter(get(), kept ? &call_filter : nullptr, kept.get());
    if (status == ABUT_OK) filter_ = std::move(kept);
    return detail::answer(status);
  }
  // Asks the filter about all pairs again at the next step.
  Answer<void> refilter() { return detail::answer(abut_universe_refilter(get())); }

  // A detector of your own in place of the narrow phase. `find` gets all pairs of a step or detection that `accepts`
  // lets through, and answers each by answer_pair, or leaves it to abut. It may ask what is const of its universe.
  // What it throws comes out of the step or detection when that is over; the next one asks about all pairs again.
  using BackendFind = std::function<void(Span<const BackendPair>)>;
  using BackendAccepts = std::function<bool(ShapeKind, ShapeKind)>;

  // The universe keeps both; an empty `find` takes them away, an empty `accepts` accepts all kinds.
  Answer<void> set_backend(BackendFind find, BackendAccepts accepts = {}) {
    auto kept =
        find ? std::make_unique<KeptBackend>(KeptBackend{std::move(find), std::move(accepts), nullptr}) : nullptr;
    const abut_status status = abut_backend_set(get(), kept && kept->accepts ? &call_accepts : nullptr,
                                                kept ? &call_find : nullptr, kept.get());
    if (status == ABUT_OK) backend_ = std::move(kept);
    return detected(status);
  }
  // From within `find`: the contacts of a pair by its place; none where the two do not touch.
  Answer<void> answer_pair(std::size_t pair, Span<const BackendContact> contacts) {
    return detail::answer(abut_backend_answer(get(), pair, contacts.data(), contacts.size()));
  }

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

  // The answer of a call that asks the filter or the back end.
  abut_status heard(abut_status status) {
#ifndef ABUT_NO_EXCEPTIONS
    std::exception_ptr failure = filter_ ? std::exchange(filter_->failure, nullptr) : nullptr;
    if (backend_ && backend_->failure) failure = std::exchange(backend_->failure, nullptr);
    if (failure) {
      if (status == ABUT_OK) status = abut_universe_refilter(get());
      if (status == ABUT_OK) std::rethrow_exception(failure);
    }
#endif
    return status;
  }
  Answer<void> detected(abut_status status) { return detail::answer(heard(status)); }

 private:
  struct KeptFilter {
    Filter filter;
    std::exception_ptr failure;
  };
  struct KeptBackend {
    BackendFind find;
    BackendAccepts accepts;
    std::exception_ptr failure;
  };

#ifdef ABUT_NO_EXCEPTIONS
  static std::uint32_t call_accepts(void* context, abut_shape_kind a, abut_shape_kind b) {
    return static_cast<const KeptBackend*>(context)->accepts(static_cast<ShapeKind>(a), static_cast<ShapeKind>(b)) ? 1
                                                                                                                : 0;
  }
  static void call_find(void* context, abut_universe*, const abut_backend_pair* pairs, std::size_t count) {
    static_cast<const KeptBackend*>(context)->find({pairs, count});
  }
  static std::uint32_t call_filter(void* context, const abut_universe*, abut_geometry_id a, abut_geometry_id b) {
    return static_cast<const KeptFilter*>(context)->filter(a, b) ? 1 : 0;
  }
#else
  // No exception crosses the C interface.
  static std::uint32_t call_filter(void* context, const abut_universe*, abut_geometry_id a, abut_geometry_id b) {
    auto* const kept = static_cast<KeptFilter*>(context);
    try {
      return !kept->failure && kept->filter(a, b) ? 1 : 0;
    } catch (...) {
      kept->failure = std::current_exception();
      return 0;
    }
  }
  static std::uint32_t call_accepts(void* context, abut_shape_kind a, abut_shape_kind b) {
    auto* const kept = static_cast<KeptBackend*>(context);
    try {
      return !kept->failure && kept->accepts(static_cast<ShapeKind>(a), static_cast<ShapeKind>(b)) ? 1 : 0;
    } catch (...) {
      kept->failure = std::current_exception();
      return 0;
    }
  }
  static void call_find(void* context, abut_universe*, const abut_backend_pair* pairs, std::size_t count) {
    auto* const kept = static_cast<KeptBackend*>(context);
    try {
      kept->find({pairs, count});
    } catch (...) {
      kept->failure = std::current_exception();
    }
  }
#endif

  std::unique_ptr<KeptFilter> filter_;
  std::unique_ptr<KeptBackend> backend_;
};

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
