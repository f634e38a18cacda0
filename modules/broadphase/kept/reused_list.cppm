// SPDX-License-Identifier: Apache-2.0
// A list that is filled anew in every call.
export module abut.broadphase.kept.reused_list;
import abut.core.standard;

export namespace abut {

// It keeps its memory for the calls to come. What a rare call needed is given back once many after it have done with
// much less: calls that need much and little in turn ask for nothing.
template <class Element>
class ReusedList {
 public:
  std::vector<Element> all;

  // All is lost.
  void end_call() {
    constexpr std::size_t calls_of_spell = 64, least = 4096, most_excess = 8;
    most_ = std::max(most_, all.size());
    all.clear();
    if (++calls_ < calls_of_spell) {
      return;
    }
    if (all.capacity() > least && all.capacity() > most_excess * most_) {
      give_back();
      all.reserve(2 * most_);
    }
    calls_ = most_ = 0;
  }
  void give_back() { std::vector<Element>().swap(all); }

  [[nodiscard]] std::size_t bytes() const { return all.capacity() * sizeof(Element); }

 private:
  std::size_t most_ = 0, calls_ = 0;  // in this spell
};

}  // namespace abut
