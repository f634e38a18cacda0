// SPDX-License-Identifier: Apache-2.0
// Pairs of boxes from the order of their ends along the three axes.
export module abut.broadphase.sweep_and_prune;
import abut.broadphase.box_record;
import abut.broadphase.kept.kept_pairs;
import abut.broadphase.proxy;
import abut.broadphase.kept.reused_list;
import abut.core.standard;
import abut.core.workers;
import abut.core;
import abut.math;
import abut.trees.volumes.box_sweep;

export namespace abut {

// The ends stay sorted from call to call (Baraff, "Dynamic simulation of non-penetrating rigid bodies", 1992): where
// the low end of a box comes to stand before the high end of another they have begun to overlap along that axis. When
// more ends change places than sorting them anew would cost, as after teleports or when much lies on one plane, they
// are sorted anew and one sweep along the axis of the widest spread finds all pairs. Boxes without bounds are in no
// order.
class SweepAndPrune {
 public:
  void insert(std::uint32_t proxy, const CompactAabb& box, Mobility mobility, std::uint32_t group);
  void erase(std::uint32_t proxy);
  void update(std::uint32_t proxy, const CompactAabb& box);
  void update_all(const Workers& workers, std::span<const std::uint32_t> proxies,
                  std::span<const CompactAabb> boxes_by_proxy);
  // A hidden box keeps its ends and its pairs, which are not reported.
  void hide(std::uint32_t proxy);
  void show(std::uint32_t proxy, const CompactAabb& box);

  void find_pairs(std::vector<ProxyPair>& out) { find_pairs(Workers(1), out); }
  void find_pairs(const Workers& workers, std::vector<ProxyPair>& out);

  // Queries try all boxes: the ends are in order after a search only.
  template <class Visitor>
  void visit(const CompactAabb& box, Visitor&& visit_proxy) const {
    BoxRecord given{};
    given.set_box(box);
    for (const std::uint32_t proxy : proxies_) {
      if (!records_[proxy].is(BoxRecord::hidden) && overlap(records_[proxy], given)) {
        visit_proxy(proxy);
      }
    }
  }

  template <class Visitor>
  void sweep(const Vec3& centre, const Vec3& half, const Vec3& displacement, Real most, Visitor&& visit_proxy) const {
    const BoxSweep sweep(centre, half, displacement);
    for (const std::uint32_t proxy : proxies_) {
      const BoxRecord& record = records_[proxy];
      const Real entry = record.is(BoxRecord::hidden) ? infinity : sweep.entry(record.box(), most);
      if (entry < infinity) {
        most = visit_proxy(proxy, entry);
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return proxies_.size(); }
  [[nodiscard]] std::size_t hidden() const { return hidden_; }
  [[nodiscard]] std::size_t bytes() const;
  // Ends that changed places in the last search, all axes together.
  [[nodiscard]] std::size_t swaps() const { return swaps_; }

 private:
  // Sorts by the value, low ends before high ones of the same value, then by the number of the box.
  struct End {
    std::uint64_t key;

    static constexpr std::uint64_t number_bits = 31;
    [[nodiscard]] static inline End of(const BoxRecord& record, std::uint32_t proxy, std::size_t axis, bool is_high) {
      const auto bits = std::bit_cast<std::uint32_t>((is_high ? record.high : record.low)[axis] + 0.0f);
      // The order of floats as that of integers.
      const std::uint32_t ordered = (bits & 0x80000000) != 0 ? ~bits : bits | 0x80000000;
      return {(std::uint64_t{ordered} << 32) | (is_high ? std::uint64_t{1} << number_bits : 0) | proxy};
    }
    [[nodiscard]] bool is_high() const { return (key >> number_bits & 1) != 0; }
    [[nodiscard]] std::uint32_t proxy() const {
      return static_cast<std::uint32_t>(key & ((std::uint64_t{1} << number_bits) - 1));
    }
    friend bool operator<(const End& a, const End& b) { return a.key < b.key; }
  };
  static constexpr std::uint32_t in_order = 64, fresh = 128;  // of the state of a record

  void place(std::uint32_t proxy);
  void refresh_ends();
  void insert_ends();
  [[nodiscard]] bool sort_by_swaps(std::size_t axis);
  void sort_anew();
  void add_if_overlapping(std::uint32_t a, std::uint32_t b);
  void sweep_for_fresh();
  void add_unbounded_pairs();

  std::vector<BoxRecord> records_;      // by number of box
  std::vector<std::uint32_t> places_;   // of each in proxies_, and among the open ones of a sweep
  std::vector<std::uint32_t> proxies_;  // all that are present
  std::vector<std::uint32_t> unbounded_;
  std::vector<std::uint32_t> fresh_;  // their pairs are not known
  std::array<std::vector<End>, 3> axes_;
  std::size_t stale_ends_ = 0;  // boxes whose ends have to go, at least
  bool is_changed_ = false;
  std::size_t hidden_ = 0, swaps_ = 0;
  KeptPairs kept_;

  // Scratch that keeps its memory from call to call.
  ReusedList<ProxyPair> found_;
  std::vector<End> added_;
  std::vector<std::uint32_t> open_, open_fresh_, open_places_;
};

}  // namespace abut
