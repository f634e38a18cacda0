// SPDX-License-Identifier: Apache-2.0
// Where the contacts of a pair were a detection ago, by their numbers.
export module abut.detect.pairs.contact_index;
import abut.capability;
import abut.core.standard;
import abut.scene.state.options;

export namespace abut {

// Of one pair at a time. A pair mostly has a few contacts, which are looked through; particles and meshes may have a
// million, for which a hash table is kept.
class ContactIndex {
 public:
  // Looks at a list that outlives the questions.
  void look_at(std::span<const ContactHistory> contacts) {
    table_.clear();
    if (contacts.size() > most_to_look_through) {
      fill(contacts);
    }
  }

  // Asks the cache for what place_of will need.
  void expect(std::uint64_t id) const {
    if (!table_.empty()) {
      __builtin_prefetch(&table_[first_slot_of(id)]);
    }
  }
  // The place of the first contact of that number in the list that was looked at, or no_index.
  [[nodiscard]] std::uint32_t place_of(std::uint64_t id, std::span<const ContactHistory> contacts) const {
    if (!table_.empty()) {
      return table_[slot_of(id, contacts)].place;
    }
    const auto same = std::ranges::find(contacts, id, &ContactHistory::id);
    return same == contacts.end() ? no_index : static_cast<std::uint32_t>(same - contacts.begin());
  }

  [[nodiscard]] std::size_t bytes() const { return table_.capacity() * sizeof(Slot); }

 private:
  static constexpr std::size_t most_to_look_through = 24;

  // Some bits of a number, which tell most others from it, and where it is.
  struct Slot {
    std::uint32_t bits;
    std::uint32_t place;
  };

  // Open addressing, half empty.
  [[nodiscard]] static std::uint64_t hash_of(std::uint64_t id) { return id * 0x9e3779b97f4a7c15u; }
  [[nodiscard]] std::size_t first_slot_of(std::uint64_t id) const { return hash_of(id) >> shift_; }
  [[nodiscard]] std::size_t slot_of(std::uint64_t id, std::span<const ContactHistory> contacts) const {
    const auto bits = static_cast<std::uint32_t>(hash_of(id));
    std::size_t slot = first_slot_of(id);
    while (table_[slot].place != no_index && (table_[slot].bits != bits || contacts[table_[slot].place].id != id)) {
      slot = slot + 1 < table_.size() ? slot + 1 : 0;
    }
    return slot;
  }
  void fill(std::span<const ContactHistory> contacts) {
    const std::size_t slots = std::bit_ceil(2 * contacts.size());
    shift_ = 64 - static_cast<unsigned>(std::countr_zero(slots));
    table_.assign(slots, {0, no_index});
    for (std::uint32_t place = 0; place < contacts.size(); ++place) {
      const std::uint64_t id = contacts[place].id;
      Slot& at = table_[slot_of(id, contacts)];
      at = at.place == no_index ? Slot{static_cast<std::uint32_t>(hash_of(id)), place} : at;
    }
  }

  std::vector<Slot> table_;  // of places, or no_index; empty for short lists
  unsigned shift_ = 0;
};

}  // namespace abut
