// SPDX-License-Identifier: Apache-2.0
#include "judge.hpp"

#include <algorithm>
#include <set>

#include "reader.hpp"

namespace universe_calls {
namespace {

// Judges one detection, pair by pair in the order of slots.
class Judge {
 public:
  Judge(World& world, const Scope& scope, const Found& found)
      : world_(world), scope_(scope), found_(found), reader_(world, found) {}

  void judge() {
    for (const std::size_t i : world_.living_geometries()) {
      living_[world_.geometries.at(i).ids[0].slot] = i;
    }
    std::map<Slots, Pair> after;
    for (const Slots& slots : all_slots()) {
      judge_slots(slots, after);
    }
    reader_.expect_nothing_left();
    judge_counts(after);
    world_.pairs = std::move(after);
    for (Geometry& geometry : world_.geometries) {
      // What is parked is not looked at before it comes back.
      if (geometry.options.parking == ABUT_PARKING_NONE) {
        geometry.is_moved = geometry.is_reshaped = false;
      }
      geometry.is_switched = false;
    }
  }

 private:
  std::set<Slots> all_slots() const {
    std::set<Slots> all;
    for (const auto& [slots, pair] : world_.pairs) {
      all.insert(slots);
    }
    for (const auto& [low, i] : living_) {
      for (const auto& [high, k] : living_) {
        if (low < high) {
          all.insert({low, high});
        }
      }
    }
    return all;
  }

  void judge_contacts(const Pair& pair, const std::vector<abut_contact>& contacts) const {
    const Geometry &a = world_.geometries.at(pair.low), &b = world_.geometries.at(pair.high);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const abut_contact& contact = contacts[i];
      judge_contact(contact);
      require(is_same(contact.geometry_a, a.ids[0]) && is_same(contact.geometry_b, b.ids[0]),
              "a contact of others than " + name_of({a.ids[0].slot, b.ids[0].slot}));
      require(i == 0 || contacts[i - 1].distance <= contact.distance, "contacts of a pair are not deepest first");
      require(find(contacts, contact.id) == &contact, "two contacts of a pair have one id");
    }
    if (world_.max_contacts > 0 && box_of(world_, a) && box_of(world_, b)) {
      require(contacts.size() <= world_.max_contacts, "too many contacts of two boxes");
    }
  }

  // Why these contacts are not those of the detection before, or nothing when
  // they are.
  static std::optional<std::string> differs_from_kept(const Pair& before, const std::vector<abut_contact>& present,
                                                      Answer covered) {
    if (present.size() != before.contacts.size()) {
      return "another number of contacts";
    }
    for (std::size_t i = 0; i < present.size(); ++i) {
      const std::uint32_t age = before.contacts[i].age;
      abut_contact kept = before.contacts[i];
      kept.age = present[i].age;
      if (!universe_calls::is_same(kept, present[i])) {
        return "other contacts";
      }
      const bool grows = kept.age == age + 1, stays = kept.age == age;
      if (!(covered == Answer::yes ? grows : covered == Answer::no ? stays : grows || stays)) {
        return "a wrong age";
      }
    }
    return std::nullopt;
  }

  // Why these contacts are not those of the present poses, or nothing when they
  // are.
  std::optional<std::string> differs_from_fresh(const Pair& before, const std::vector<abut_contact>& present,
                                                bool is_touching) const {
    const Geometry &a = world_.geometries.at(before.low), &b = world_.geometries.at(before.high);
    const bool is_box = world_.policy_of(a, b).detail == ABUT_DETAIL_BOX;
    if (!is_box && is_touching != !present.empty()) {
      return "a touch without contacts";
    }
    const Answer wanted = is_box ? world_.is_near(a, b) : world_.touches(a, b);
    if (wanted != Answer::maybe && is_touching != (wanted == Answer::yes)) {
      return is_touching ? "a touch where there is none" : "no touch where there is one";
    }
    if ((is_box && !present.empty()) || (world_.policy_of(a, b).detail == ABUT_DETAIL_POINT && present.size() > 1)) {
      return "more contacts than the policy wants";
    }
    for (const abut_contact& contact : present) {
      const abut_contact* old = find(before.contacts, contact.id);
      if (contact.age != (old != nullptr ? old->age + 1 : 0) ||
          contact.user_data != (old != nullptr ? old->user_data : 0)) {
        return "a wrong age or user data";
      }
      try {
        judge_points(world_, a, b, contact);
      } catch (const Finding& finding) {
        return finding.what();
      }
    }
    return std::nullopt;
  }

  void judge_slots(const Slots& slots, std::map<Slots, Pair>& after) {
    const auto known = world_.pairs.find(slots);
    const bool was_known = known != world_.pairs.end();
    const auto low = living_.find(slots.first), high = living_.find(slots.second);
    const bool lives = low != living_.end() && high != living_.end();
    const bool is_same_pair =
        was_known && lives && known->second.low == low->second && known->second.high == high->second;
    const bool is_reshaped = is_same_pair && (world_.geometries.at(low->second).is_reshaped ||
                                              world_.geometries.at(high->second).is_reshaped);
    Pair before;
    if (lives) {
      before.low = low->second;
      before.high = high->second;
    }
    if (was_known && (!is_same_pair || (is_reshaped && known->second.is_touching))) {
      reader_.expect_end(known->second);
    } else if (was_known) {
      before = known->second;
    }
    if (is_reshaped) {
      before.is_stale = true;
      before.is_new = before.is_new || known->second.is_new;
    }
    if (lives && (world_.geometries.at(low->second).is_switched || world_.geometries.at(high->second).is_switched)) {
      // Its policy is another one, which no period delays.
      before.is_stale = before.is_new = true;
    }
    const std::vector<abut_contact> present = reader_.contacts_at(slots);
    if (!lives) {
      require(present.empty(), "contacts of geometries that are gone");
      return;
    }
    judge_living(slots, before, present, after);
  }

  void judge_living(const Slots& slots, const Pair& before, const std::vector<abut_contact>& present,
                    std::map<Slots, Pair>& after) {
    const Geometry &a = world_.geometries.at(before.low), &b = world_.geometries.at(before.high);
    const Answer near = world_.is_near(a, b);
    if (near == Answer::no || !world_.is_admitted(a, b)) {
      require(present.empty(), "contacts of " + name_of(slots) + ", which do not meet");
      reader_.expect_end(before);
      return;
    }
    judge_contacts(before, present);
    Answer covered = world_.is_covered(a, b, scope_);
    const std::optional<bool> said = reader_.said_touching(slots);
    const bool is_box = world_.policy_of(a, b).detail == ABUT_DETAIL_BOX;
    Pair pair = before;
    pair.contacts = present;
    if (!present.empty()) {
      pair.is_touching = true;
    } else if (reader_.has(ABUT_EVENTS_PAIRS)) {
      const bool is_silent_no = covered == Answer::yes && reader_.has(ABUT_EVENTS_PERSIST);
      pair.is_touching = said ? *said : !is_silent_no && before.is_touching;
    } else {
      pair.is_touching = covered != Answer::no ? is_box : before.is_touching && before.contacts.empty();
    }
    if (near == Answer::maybe && !pair.is_touching && before.is_touching) {
      // Out of reach, or covered and apart: the events are the same.
      reader_.expect_end(before);
      pair.is_stale = true;
      pair.is_new = false;  // it may have been examined, so that a period may delay it
      pair.waiting = 0;
      after[slots] = pair;
      return;
    }
    if (covered == Answer::maybe && reader_.has(ABUT_EVENTS_PAIRS) && said) {
      covered = Answer::yes;
    }
    judge_change(slots, before, covered, pair);
    if (covered == Answer::maybe) {
      // Silent where a covered pair would have spoken, if it touches.
      const bool must_speak = pair.is_touching && reader_.has(ABUT_EVENTS_PAIRS) &&
                              (reader_.has(ABUT_EVENTS_PERSIST) || !before.is_touching);
      covered = must_speak ? Answer::no : covered;
    }
    if (covered == Answer::yes || (covered == Answer::maybe && reader_.next_is_of(slots))) {
      reader_.expect_events(before, pair);
    }
    after[slots] = pair;
  }

  // Whether a pair has kept what it had or was found anew, and whether it had
  // to.
  void judge_change(const Slots& slots, const Pair& before, Answer covered, Pair& pair) const {
    const Geometry &a = world_.geometries.at(before.low), &b = world_.geometries.at(before.high);
    const std::uint32_t period = world_.policy_of(a, b).period;
    const bool is_box = world_.policy_of(a, b).detail == ABUT_DETAIL_BOX;
    const bool is_stale = before.is_stale || a.is_moved || b.is_moved;
    const bool may_wait = period > 1 && !is_box && !before.is_new && scope_.coverage != Coverage::everything &&
                          before.waiting + 1 < period;
    const bool may_keep = covered != Answer::yes || !is_stale || may_wait;
    const bool may_be_fresh = covered != Answer::no && is_stale;
    std::optional<std::string> kept = differs_from_kept(before, pair.contacts, covered);
    if (!kept && pair.is_touching != before.is_touching) {
      kept = "a change of touch";
    }
    const std::optional<std::string> fresh = differs_from_fresh(before, pair.contacts, pair.is_touching);
    require((may_keep && !kept) || (may_be_fresh && !fresh),
            name_of(slots) + (may_keep && kept ? ": kept: " + *kept : "") +
                (may_be_fresh && fresh ? ": found anew: " + *fresh : "") +
                (may_be_fresh ? "" : " (nothing has changed, or it is not covered)"));
    const bool had_to_be_fresh = !may_keep;
    pair.is_stale = is_stale && !had_to_be_fresh;
    pair.is_new = before.is_new && covered == Answer::no;
    pair.waiting = pair.is_stale && fresh && covered == Answer::yes ? before.waiting + 1 : 0;
  }

  void judge_counts(const std::map<Slots, Pair>& after) const {
    const abut_step_stats& stats = found_.stats;
    require(stats.contacts == found_.contacts.size() && stats.events == found_.events.size(),
            "the statistics count other contacts or events");
    require(stats.parts == world_.living_parts().size() && stats.geometries == living_.size(),
            "the statistics count other parts or geometries");
    require(stats.parked == world_.parked_count(), "the statistics count other parked geometries");
    require(stats.candidate_pairs == stats.examined_pairs + stats.kept_pairs,
            "examined and kept pairs are not the candidates");
    const auto touching = static_cast<std::uint64_t>(
        std::ranges::count_if(after, [](const auto& entry) { return entry.second.is_touching; }));
    require(!reader_.has(ABUT_EVENTS_PAIRS) || stats.touching_pairs == touching,
            "the statistics count " + std::to_string(stats.touching_pairs) + " touching pairs, expected " +
                std::to_string(touching));
  }

  World& world_;
  const Scope& scope_;
  const Found& found_;
  std::map<std::uint32_t, std::size_t> living_;
  Reader reader_;
};

}  // namespace

void judge_detection(World& world, const Scope& scope, const Found& found) { Judge(world, scope, found).judge(); }

}  // namespace universe_calls
