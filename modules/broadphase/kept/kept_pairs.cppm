// SPDX-License-Identifier: Apache-2.0
// Pairs that stay in order from call to call while some go and some come.
export module abut.broadphase.kept.kept_pairs;
import abut.broadphase.box_record;
import abut.broadphase.proxy;
import abut.broadphase.kept.reused_list;
import abut.core.standard;
import abut.core.workers;

export namespace abut {

// What is done with a pair that is kept already.
enum class Keeping : std::uint8_t {
  unless_touched,     // it stays unless one of its boxes was touched
  while_overlapping,  // as before, but it also goes when its boxes do not overlap
};

class KeptPairs {
 public:
  // Drops what is not to be kept, adds what has been found unless both boxes are of one group, and writes those whose
  // boxes overlap and are not hidden to `out`, by (low, high). What was found may come in any order and more than once;
  // it is lost.
  void renew(const Workers& workers, std::span<const BoxRecord> records, Keeping keeping, std::vector<ProxyPair>& found,
             std::vector<ProxyPair>& out);

  // What calls like the last one use again.
  void give_back_scratch();

  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Part {
    std::vector<ProxyPair> kept, out;
  };

  std::vector<ProxyPair> kept_, next_;
  ReusedList<ProxyPair> sorted_;  // scratch
  std::vector<Part> parts_;       // of each task, when there are several
};

}  // namespace abut
