// Every box against every box: for a few dozen of them nothing is faster.
module;
#include <cstddef>
#include <cstdint>
#include <vector>
export module abut.broadphase.brute;
import abut.broadphase.proxy;
import abut.math;

export namespace abut {

// Numbers of boxes are the caller's and small. Boxes of the same group never pair.
class Brute {
 public:
  void insert(std::uint32_t proxy, const CompactAabb& box, Mobility mobility, std::uint32_t group);
  void erase(std::uint32_t proxy);
  void update(std::uint32_t proxy, const CompactAabb& box);

  // All pairs of overlapping boxes, touching included, in order. O(n^2).
  void find_pairs(std::vector<ProxyPair>& out);

  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Entry {
    CompactAabb box;
    std::uint32_t proxy;
    std::uint32_t group;
    std::uint32_t is_moving;
  };
  [[nodiscard]] std::size_t place_of(std::uint32_t proxy) const;

  std::vector<Entry> entries_;  // in order of their numbers
};

}  // namespace abut
