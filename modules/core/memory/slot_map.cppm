// SPDX-License-Identifier: Apache-2.0
// SlotMap: values under ids that go stale when the value is erased.
//
// Each map numbers its generations from a start of its own. So an id of one universe is stale in any other. A foreign
// id passes only in one case of 2^32: the starting points of the maps differ by exactly the difference in how often the
// slot was reused.
export module abut.core.memory.slot_map;
import abut.core.id;
import abut.core.standard;

export namespace abut {

template <class T, class Tag>
class SlotMap {
 public:
  explicit SlotMap(std::uint32_t first_generation) : first_generation_(first_generation) {}

  [[nodiscard]] Id<Tag> insert(T value) {
    if (!free_.empty()) {
      const std::uint32_t slot = free_.back();
      free_.pop_back();
      Entry& entry = entries_[slot - 1];
      entry.value.emplace(std::move(value));
      ++size_;
      return {slot, entry.generation};
    }
    // Room first, so that nothing fails half-way; and for as many free slots, so that erase cannot fail.
    if (entries_.size() == std::min(entries_.capacity(), free_.capacity())) {
      const std::size_t room = std::max<std::size_t>(16, 2 * entries_.size());
      free_.reserve(room);
      entries_.reserve(room);
    }
    entries_.push_back({std::move(value), first_generation_});
    ++size_;
    return {static_cast<std::uint32_t>(entries_.size()), first_generation_};
  }

  // True when there was such a value.
  bool erase(Id<Tag> id) noexcept {
    if (!contains(id)) {
      return false;
    }
    Entry& entry = entries_[id.slot - 1];
    entry.value.reset();
    ++entry.generation;
    free_.push_back(id.slot);
    --size_;
    return true;
  }

  [[nodiscard]] bool contains(Id<Tag> id) const noexcept {
    return id.slot != 0 && id.slot <= entries_.size() && entries_[id.slot - 1].generation == id.generation &&
           entries_[id.slot - 1].value.has_value();
  }

  // The value of an id that `contains` has confirmed.
  [[nodiscard]] T& at(Id<Tag> id) [[clang::lifetimebound]] { return entries_[id.slot - 1].value.value(); }
  [[nodiscard]] const T& at(Id<Tag> id) const [[clang::lifetimebound]] { return entries_[id.slot - 1].value.value(); }

  // The id of whatever lives in a slot now, or null.
  [[nodiscard]] Id<Tag> id_at_slot(std::uint32_t slot) const {
    return slot != 0 && slot <= entries_.size() && entries_[slot - 1].value
               ? Id<Tag>{slot, entries_[slot - 1].generation}
               : Id<Tag>{};
  }

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] std::uint32_t slot_count() const noexcept { return static_cast<std::uint32_t>(entries_.size()); }
  [[nodiscard]] std::size_t bytes() const noexcept {
    return entries_.capacity() * sizeof(Entry) + free_.capacity() * sizeof(std::uint32_t);
  }

  // A map that was read has the ids of the map that was written. It also gives out the same ones next.
  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    archive(self.first_generation_, self.entries_, self.free_);
    if constexpr (Archive::is_reading) {
      archive.require(self.restore(), "slots that are free are in use, or in no list");
    }
  }

  // Calls visit(id, value) in order of slots.
  template <class Visitor>
  void for_each(Visitor&& visit) const {
    for (std::uint32_t slot = 1; slot <= slot_count(); ++slot) {
      const Entry& entry = entries_[slot - 1];
      if (entry.value) {
        visit(Id<Tag>{slot, entry.generation}, *entry.value);
      }
    }
  }

 private:
  struct Entry {
    std::optional<T> value;
    std::uint32_t generation;
  };

  // Whether each slot that was read has a value, or is free once.
  [[nodiscard]] bool restore() {
    std::vector<bool> is_free(entries_.size());
    for (const std::uint32_t slot : free_) {
      if (slot == 0 || slot > entries_.size() || entries_[slot - 1].value || is_free[slot - 1]) {
        return false;
      }
      is_free[slot - 1] = true;
    }
    size_ = entries_.size() - free_.size();
    free_.reserve(entries_.capacity());
    const auto has_value = [](const Entry& entry) { return entry.value.has_value(); };
    return static_cast<std::size_t>(std::ranges::count_if(entries_, has_value)) == size_;
  }

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> free_;
  std::uint32_t first_generation_;
  std::size_t size_ = 0;
};

}  // namespace abut
