// SPDX-License-Identifier: Apache-2.0
// Detections of a universe and what they leave: contacts, events, islands, counts, the plan in words. What is answered
// as a Span belongs to the universe, until its next call that is not const.
#ifndef ABUT_CPP_UNIVERSE_STEPS_HPP
#define ABUT_CPP_UNIVERSE_STEPS_HPP

#include <abut/abut.h>
#include <abut/cpp/universe_rules.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace abut {
inline namespace ABUT_ANSWERS {

class UniverseSteps : public UniverseRules {
 public:
  Answer<void> step(double dt) { return detected(abut_universe_step(get(), dt)); }
  Answer<void> detect_all() { return detected(abut_universe_detect_all(get())); }
  Answer<void> detect_changed() { return detected(abut_universe_detect_changed(get())); }
  // Pair i is a[i] with b[i].
  Answer<void> detect_pairs(Span<const GeometryId> a, Span<const GeometryId> b) {
    const abut_status sizes = detail::expect_as_many("b", b.size(), "a", a.size());
    return detected(sizes != ABUT_OK ? sizes : abut_universe_detect_pairs(get(), a.data(), b.data(), a.size()));
  }
  Answer<void> detect_region(const Aabb& region) { return detected(abut_universe_detect_region(get(), &region)); }
  // Moves all parts along their paths, until the first of the fast geometries would touch.
  Answer<StepImpact> advance_to_first_impact(double dt) {
    StepImpact out{};
    const abut_status status = heard(abut_universe_advance_to_first_impact(get(), dt, &out));
    return detail::answer(status, out);
  }
  // Queries see poses as of the last step or refresh.
  Answer<void> refresh() { return detail::answer(abut_universe_refresh(get())); }

  [[nodiscard]] Answer<Span<const Contact>> contacts() const& { return borrow(abut_universe_contacts); }
  Answer<Span<const Contact>> contacts() const&& = delete;
  [[nodiscard]] Answer<Span<const LocalPoints>> local_points() const& { return borrow(abut_universe_local_points); }
  Answer<Span<const LocalPoints>> local_points() const&& = delete;
  // Of pairs whose policy has ABUT_DETAIL_ELEMENTS.
  [[nodiscard]] Answer<Span<const ElementContact>> element_contacts() const& {
    return borrow(abut_universe_element_contacts);
  }
  Answer<Span<const ElementContact>> element_contacts() const&& = delete;
  [[nodiscard]] Answer<Span<const Event>> events() const& { return borrow(abut_universe_events); }
  Answer<Span<const Event>> events() const&& = delete;
  [[nodiscard]] Answer<Span<const StepImpact>> impacts() const& { return borrow(abut_universe_impacts); }
  Answer<Span<const StepImpact>> impacts() const&& = delete;
  [[nodiscard]] Answer<Span<const SleepChange>> sleep_changes() const& { return borrow(abut_universe_sleep_changes); }
  Answer<Span<const SleepChange>> sleep_changes() const&& = delete;

  // One value for each contact of the last step.
  Answer<void> set_contact_user_data(Span<const std::uint64_t> user_data) {
    return detail::answer(abut_contacts_set_user_data(get(), user_data.data(), user_data.size()));
  }

  Answer<void> follow_islands(bool are_followed) {
    return detail::answer(abut_universe_follow_islands(get(), are_followed ? 1 : 0));
  }
  [[nodiscard]] Answer<Span<const Island>> islands() const& { return borrow(abut_universe_islands); }
  Answer<Span<const Island>> islands() const&& = delete;
  [[nodiscard]] Answer<Span<const PartId>> island_parts() const& { return borrow(abut_universe_island_parts); }
  Answer<Span<const PartId>> island_parts() const&& = delete;
  [[nodiscard]] Answer<Island> island(PartId part) const {
    Island out{};
    return detail::answer(abut_part_island(get(), part, &out), out);
  }

  [[nodiscard]] Answer<std::uint64_t> hash() const {
    std::uint64_t out = 0;
    return detail::answer(abut_universe_hash(get(), &out), out);
  }
  [[nodiscard]] Answer<StepStats> stats() const {
    StepStats out;
    return detail::answer(abut_universe_stats(get(), &out), out);
  }
  [[nodiscard]] Answer<std::string> explain() const {
    return detail::collect_text([this](char* text, std::size_t capacity, std::size_t* needed) {
      return abut_universe_explain(get(), text, capacity, needed);
    });
  }
  [[nodiscard]] Answer<std::string> explain_json() const {
    return detail::collect_text([this](char* text, std::size_t capacity, std::size_t* needed) {
      return abut_universe_explain_json(get(), text, capacity, needed);
    });
  }
  // What is odd about the scene; empty where nothing is.
  [[nodiscard]] Answer<std::vector<Finding>> validate() const {
    return detail::collect<Finding>([this](Finding* data, std::size_t capacity, std::size_t* count) {
      return abut_universe_validate(get(), data, capacity, count);
    });
  }

  [[nodiscard]] Answer<Revision> revision() const {
    Revision out{};
    return detail::answer(abut_universe_revision(get(), &out), out);
  }
  [[nodiscard]] Answer<Counters> counters() const& {
    Counters out{};
    return detail::answer(abut_universe_counters(get(), &out.geometries, &out.poses), out);
  }
  Answer<Counters> counters() const&& = delete;

  // The geometries that have changed since a revision; one that has gone has the generation 0. None where more has
  // changed than the universe remembers: then all are to be looked at.
  [[nodiscard]] Answer<std::optional<std::vector<GeometryId>>> changes(const Revision& since) const {
    std::vector<GeometryId> found(8);
    std::size_t count = 0;
    std::uint32_t is_known = 0;
    const auto fill = [&] {
      return abut_universe_changes(get(), &since, found.data(), found.size(), &count, &is_known);
    };
    abut_status status = fill();
    if (status == ABUT_OK && count > found.size()) {
      found.resize(count);
      status = fill();
    }
    found.resize(status == ABUT_OK ? count : 0);
    return detail::answer_if_found(status, is_known, found);
  }

  // For libraries that stand on a universe.
  Answer<void> attach(const std::string& name) const {
    return detail::answer(abut_universe_attach(get(), name.c_str()));
  }
  Answer<void> detach(const std::string& name) const {
    return detail::answer(abut_universe_detach(get(), name.c_str()));
  }

 protected:
  using UniverseRules::UniverseRules;

 private:
  template <class T>
  Answer<Span<const T>> borrow(abut_status (*lend)(const abut_universe*, const T**, std::size_t*)) const {
    const T* data = nullptr;
    std::size_t count = 0;
    const abut_status status = lend(get(), &data, &count);
    return detail::answer_with(status, [&] { return Span<const T>(data, count); });
  }
};

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
