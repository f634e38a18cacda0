// SPDX-License-Identifier: Apache-2.0
// Reads the contacts and events of a detection in the order in which they have
// to be.
#pragma once

#include <string>
#include <vector>

#include "model.hpp"
#include "universes.hpp"

namespace universe_calls {

std::string name_of(const Slots& slots);
bool is_same(const abut_geometry_id& a, const abut_geometry_id& b);
const abut_contact* find(const std::vector<abut_contact>& contacts, std::uint64_t id);

class Reader {
 public:
  Reader(const World& world, const Found& found) : world_(world), found_(found) {}

  bool has(abut_event_bits bit) const { return (world_.events & bit) != 0; }
  // Takes the contacts of a pair, if they are next.
  std::vector<abut_contact> contacts_at(const Slots& slots);

  // A touch that is over, with its contacts.
  void expect_end(const Pair& pair);
  // A pair that a detection has covered, and that touches or did so. Its
  // contacts are those that were taken last.
  void expect_events(const Pair& before, const Pair& after);
  // Whether the next event says that the pair touches; nothing if it is silent
  // about it.
  std::optional<bool> said_touching(const Slots& slots) const;
  bool next_is_of(const Slots& slots) const;
  void expect_nothing_left() const;

 private:
  // The next event has to be this one.
  void expect_event(abut_event_kind kind, const Pair& pair, const abut_contact* contact, std::size_t first,
                    std::size_t count);

  const World& world_;
  const Found& found_;
  std::size_t next_contact_ = 0, next_event_ = 0;
};

}  // namespace universe_calls
