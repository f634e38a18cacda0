// SPDX-License-Identifier: Apache-2.0
// The last stage: what began, persists and ended in a detection.
export module abut.detect.lists.events;
import abut.core.standard;
import abut.core.workers;
import abut.detect.elements;
import abut.detect.pairs.contact_index;
import abut.detect.lists.contacts;
import abut.detect.pairs;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.rest.sleep;

export namespace abut {

class EventList {
 public:
  // `wanted`: bits of EventBits. In order of the pairs; of one pair what ends comes before what begins, and the pair
  // before its contacts and element contacts.
  void collect(const Workers& workers, std::uint32_t wanted, const PairStore& store, std::span<const PlaceInfo> infos,
               const ContactList& contacts, const ElementStage& elements, const SleepTable& sleep);
  [[nodiscard]] std::span<const Event> all() const [[clang::lifetimebound]] { return events_; }
  void restore(std::vector<Event> events) { events_ = std::move(events); }
  [[nodiscard]] std::size_t bytes() const;

 private:
  // What one task writes.
  struct Task {
    std::vector<Event> events;
    ContactIndex index;
    std::size_t first = 0;  // where they go
  };
  std::vector<Event> events_;
  std::vector<Task> tasks_;
};

}  // namespace abut
