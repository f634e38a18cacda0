// SPDX-License-Identifier: Apache-2.0
// Every box against every box: for a few dozen of them nothing is faster.
export module abut.broadphase.brute;
import abut.broadphase.box_record;
import abut.broadphase.proxy;
import abut.core.standard;
import abut.core.workers;
import abut.math;
import abut.trees.volumes.box_sweep;
import abut.trees.volumes.eight_boxes;

export namespace abut {

// The boxes are kept in the order of their numbers, so that pairs are found in order. O(n^2), eight at once.
class Brute {
 public:
  void insert(std::uint32_t proxy, const CompactAabb& box, Mobility mobility, std::uint32_t group);
  void erase(std::uint32_t proxy);
  void update(std::uint32_t proxy, const CompactAabb& box);
  void update_all(const Workers& workers, std::span<const std::uint32_t> proxies,
                  std::span<const CompactAabb> boxes_by_proxy);
  void hide(std::uint32_t proxy);
  void show(std::uint32_t proxy, const CompactAabb& box);

  void find_pairs(std::vector<ProxyPair>& out);
  void find_pairs(const Workers& workers, std::vector<ProxyPair>& out);

  template <class Visitor>
  void visit(const CompactAabb& box, Visitor&& visit_proxy) const {
    const BoxSides limits = limits_of(box);
    for (const Block& block : blocks_) {
      for (std::uint32_t met = block.boxes.overlapping(limits); met != 0; met &= met - 1) {
        visit_proxy(block.boxes.numbers[static_cast<std::size_t>(std::countr_zero(met))]);
      }
    }
  }

  template <class Visitor>
  void sweep(const Vec3& centre, const Vec3& half, const Vec3& displacement, Real most, Visitor&& visit_proxy) const {
    const BoxSweep sweep(centre, half, displacement);
    const CompactSweep compact_sweep(sweep);
    float most_way = compact_sweep.way_of(most);
    for (const Block& block : blocks_) {
      const EightBoxes::Floats ways = block.boxes.entries(compact_sweep, most_way);
      for (std::uint32_t met = EightBoxes::met(ways) & block.shown; met != 0; met &= met - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(met));
        const Real entry = sweep.entry(box_of(block.boxes.sides_of_lane(lane)), most);
        if (entry < infinity) {
          most = visit_proxy(block.boxes.numbers[lane], entry);
          most_way = compact_sweep.way_of(most);
        }
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t hidden() const { return hidden_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  static constexpr std::size_t width = EightBoxes::width;
  struct Block {
    EightBoxes boxes;
    EightBoxes::Numbers groups{};
    std::uint32_t moving = 0, shown = 0;  // a bit for each box
  };
  struct Entry {
    BoxSides sides;
    std::uint32_t proxy, group;
    bool is_moving, is_shown;
  };
  [[nodiscard]] std::size_t place_of(std::uint32_t proxy) const;
  [[nodiscard]] std::uint32_t proxy_at(std::size_t place) const {
    return blocks_[place / width].boxes.numbers[place % width];
  }
  [[nodiscard]] Entry entry_at(std::size_t place) const;
  void set_entry(std::size_t place, const Entry& entry);
  void set_shown(std::size_t place, bool is_shown, const BoxSides& sides);
  void find_pairs_of(std::size_t first_block, std::vector<ProxyPair>& out) const;

  std::vector<Block> blocks_;
  std::size_t size_ = 0, hidden_ = 0;
  std::vector<std::vector<ProxyPair>> parts_;  // of each task, when there are several
};

}  // namespace abut
