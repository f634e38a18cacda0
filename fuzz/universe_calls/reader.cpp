// SPDX-License-Identifier: Apache-2.0
#include "reader.hpp"

#include <algorithm>

namespace universe_calls {
namespace {

Slots slots_of(const abut_geometry_id& a, const abut_geometry_id& b) { return {a.slot, b.slot}; }

}  // namespace

std::string name_of(const Slots& slots) { return std::to_string(slots.first) + "-" + std::to_string(slots.second); }

bool is_same(const abut_geometry_id& a, const abut_geometry_id& b) {
  return a.slot == b.slot && a.generation == b.generation;
}

const abut_contact* find(const std::vector<abut_contact>& contacts, std::uint64_t id) {
  const auto found = std::ranges::find(contacts, id, &abut_contact::id);
  return found == contacts.end() ? nullptr : &*found;
}

void Reader::expect_event(abut_event_kind kind, const Pair& pair, const abut_contact* contact, std::size_t first,
                          std::size_t count) {
  const Geometry &a = world_.geometries.at(pair.low), &b = world_.geometries.at(pair.high);
  const std::string what =
      "event of " + name_of({a.ids[0].slot, b.ids[0].slot}) + (contact != nullptr ? " (contact)" : "");
  require(next_event_ < found_.events.size(), "missing " + what);
  const abut_event& event = found_.events[next_event_++];
  require(is_same(event.geometry_a, a.ids[0]) && is_same(event.geometry_b, b.ids[0]),
          "instead of the " + what + " there is one of " + name_of(slots_of(event.geometry_a, event.geometry_b)));
  require(event.kind == kind, what + " has kind " + std::to_string(event.kind) + ", expected " + std::to_string(kind));
  require(((event.flags & ABUT_EVENT_CONTACT) != 0) == (contact != nullptr),
          what + " speaks of a pair instead of a contact, or the reverse");
  require(event.contact_id == (contact != nullptr ? contact->id : 0), what + " has another contact id");
  if (kind == ABUT_EVENT_END) {
    require(event.first_contact == 0 && event.contact_count == 0, what + " is an end with contacts");
    return;
  }
  const bool is_sensor = ((a.options.flags | b.options.flags) & ABUT_GEOMETRY_SENSOR) != 0;
  require(((event.flags & ABUT_EVENT_SENSOR) != 0) == is_sensor, what + " has a wrong sensor flag");
  require(event.contact_count == count,
          what + " has " + std::to_string(event.contact_count) + " contacts, expected " + std::to_string(count));
  require(count == 0 || event.first_contact == first, what + " points to other contacts");
}

void Reader::expect_end(const Pair& pair) {
  if (!pair.is_touching) {
    return;
  }
  if (has(ABUT_EVENTS_PAIRS)) {
    expect_event(ABUT_EVENT_END, pair, nullptr, 0, 0);
  }
  if (has(ABUT_EVENTS_CONTACTS)) {
    for (const abut_contact& contact : pair.contacts) {
      expect_event(ABUT_EVENT_END, pair, &contact, 0, 0);
    }
  }
}

void Reader::expect_events(const Pair& before, const Pair& after) {
  const std::size_t first = next_contact_ - after.contacts.size();
  if (!after.is_touching) {
    expect_end(before);
    return;
  }
  const bool begins = !before.is_touching;
  if (has(ABUT_EVENTS_PAIRS) && (begins || has(ABUT_EVENTS_PERSIST))) {
    expect_event(begins ? ABUT_EVENT_BEGIN : ABUT_EVENT_PERSIST, after, nullptr, first, after.contacts.size());
  }
  if (!has(ABUT_EVENTS_CONTACTS)) {
    return;
  }
  for (std::size_t i = 0; i < after.contacts.size(); ++i) {
    const bool is_new = find(before.contacts, after.contacts[i].id) == nullptr;
    if (is_new || has(ABUT_EVENTS_PERSIST)) {
      expect_event(is_new ? ABUT_EVENT_BEGIN : ABUT_EVENT_PERSIST, after, &after.contacts[i], first + i, 1);
    }
  }
  for (const abut_contact& contact : before.contacts) {
    if (find(after.contacts, contact.id) == nullptr) {
      expect_event(ABUT_EVENT_END, after, &contact, 0, 0);
    }
  }
}

std::optional<bool> Reader::said_touching(const Slots& slots) const {
  if (next_event_ == found_.events.size()) {
    return std::nullopt;
  }
  const abut_event& event = found_.events[next_event_];
  if (slots_of(event.geometry_a, event.geometry_b) != slots || (event.flags & ABUT_EVENT_CONTACT) != 0) {
    return std::nullopt;
  }
  return event.kind != ABUT_EVENT_END;
}

std::vector<abut_contact> Reader::contacts_at(const Slots& slots) {
  std::vector<abut_contact> present;
  while (next_contact_ < found_.contacts.size() &&
         slots_of(found_.contacts[next_contact_].geometry_a, found_.contacts[next_contact_].geometry_b) == slots) {
    present.push_back(found_.contacts[next_contact_++]);
  }
  return present;
}

bool Reader::next_is_of(const Slots& slots) const {
  return next_event_ < found_.events.size() &&
         slots_of(found_.events[next_event_].geometry_a, found_.events[next_event_].geometry_b) == slots;
}

void Reader::expect_nothing_left() const {
  require(next_contact_ == found_.contacts.size(),
          "contacts are not in the order of slots, or of no pair that is alive");
  require(next_event_ == found_.events.size(), "events are not in the order of slots, or too many");
}

}  // namespace universe_calls
