// SPDX-License-Identifier: Apache-2.0
// The contacts of a detection, and what the next one asks about them.
export module abut.detect.lists.contacts;
import abut.capability;
import abut.core.standard;
import abut.core.workers;
import abut.core;
import abut.math;
import abut.detect.pairs.contact_index;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.scene.state.options;
import abut.scene.state.places;

export namespace abut {

// How many pairs of a detection are what.
struct ContactCounts {
  std::uint64_t candidates = 0, filtered = 0, unsupported = 0, touching = 0;
};

class ContactList {
 public:
  explicit ContactList(bool keeps_local_points) : keeps_local_points_(keeps_local_points) {}

  // Puts all contacts in the order of the pairs, those that were kept among those that jobs have found. Pairs learn
  // where theirs are, and whether they touch.
  [[nodiscard]] ContactCounts collect(const Workers& workers, const Places& places, bool is_timed, const JobList& jobs,
                                      std::span<Pair> pairs);

  // Ordered by the slots of the two geometries, of which a has the lower one, then deepest first.
  [[nodiscard]] std::span<const Contact> all() const [[clang::lifetimebound]] { return contacts_; }
  [[nodiscard]] std::span<const LocalPoints> locals() const [[clang::lifetimebound]] { return locals_; }
  [[nodiscard]] std::span<const ContactHistory> histories() const [[clang::lifetimebound]] { return histories_; }
  // Of a pair, in this detection and in the one before.
  [[nodiscard]] std::span<const ContactHistory> histories_of(const Pair& pair) const [[clang::lifetimebound]] {
    return std::span(histories_).subspan(pair.first_contact, pair.contact_count);
  }
  [[nodiscard]] std::span<const ContactHistory> histories_before_of(const Pair& pair) const [[clang::lifetimebound]] {
    return std::span(histories_before_).subspan(pair.first_before, pair.count_before);
  }
  // By run.
  [[nodiscard]] const KindTally& tally(std::size_t run) const [[clang::lifetimebound]] { return tallies_[run]; }
  // Some contacts are ahead of a touch: those that are on the way of the step, or further apart than what touches.
  void mark_ahead(std::uint32_t first, std::uint32_t count, Real toi, Real touching);
  // Into a list that is new, with a local point for each where they are kept.
  void restore(std::vector<Contact> contacts, std::vector<LocalPoints> locals);
  [[nodiscard]] Result<void> set_user_data(std::span<const std::uint64_t> user_data);
  [[nodiscard]] std::size_t bytes() const;

 private:
  // What one task counts.
  struct Task {
    std::array<KindTally, run_count> tallies{};
    std::uint64_t candidates = 0, filtered = 0, unsupported = 0, touching = 0;
    std::uint32_t contacts = 0, kept = 0, first_contact = 0;  // kept: of pairs that were not examined
  };
  static void count(std::size_t begin, std::size_t end, const JobList& jobs, std::span<Pair> pairs, Task& out);
  void write(std::size_t begin, std::size_t end, std::uint32_t first_contact, const JobList& jobs, const Places& places,
             std::span<Pair> pairs, ContactIndex& index);
  void write_pair(const Pair& pair, std::span<const ContactPoint> found, const Places& places, ContactIndex& index);
  void move_all_kept(std::span<Pair> pairs);
  void make_room(std::size_t count);
  void time_kinds(const JobList& jobs);

  bool keeps_local_points_;
  std::vector<Contact> contacts_;
  std::vector<LocalPoints> locals_;  // of the contacts, where they are kept; else empty
  std::vector<ContactHistory> histories_, histories_before_;
  std::array<KindTally, run_count> tallies_{};
  std::vector<Task> tasks_;
  std::vector<ContactIndex> indices_;  // one for each task
};

}  // namespace abut
