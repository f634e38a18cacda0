// Pairs of boxes from trees that follow their motion.
module;
#include <cstddef>
#include <cstdint>
#include <vector>
export module abut.broadphase.tree;
import abut.broadphase.box_tree;
import abut.broadphase.proxy;
import abut.math;

export namespace abut {

// The trees hold boxes that are a little larger than the given ones, so that most motion leaves them as
// they are, and the pairs of those larger boxes are kept from call to call. Only what has left its
// larger box is moved in its tree and asks for its neighbours anew. Still boxes have a tree of their
// own, which only moving ones ask. Boxes without bounds are in no tree; they are tried with all.
//
// Numbers of boxes are the caller's and small. Boxes of the same group never pair.
class Tree {
 public:
  void insert(std::uint32_t proxy, const CompactAabb& box, Mobility mobility, std::uint32_t group);
  void erase(std::uint32_t proxy);
  void update(std::uint32_t proxy, const CompactAabb& box);

  // All pairs of overlapping boxes, touching included, in order: the same as those of Brute.
  // O(m log n + pairs) for m boxes that have left their larger ones.
  void find_pairs(std::vector<ProxyPair>& out);

  [[nodiscard]] std::size_t bytes() const;

 private:
  enum class Place : std::uint8_t { nowhere, moving_tree, still_tree, unbounded };
  struct Info {
    std::uint32_t group = 0;
    Place place = Place::nowhere;
    bool is_moving = false;
    bool is_touched = false;  // its kept pairs are out of date
  };

  void put(std::uint32_t proxy);
  void take_out(std::uint32_t proxy);
  void touch(std::uint32_t proxy);
  void drop_touched_pairs();
  void ask_for_neighbours(std::uint32_t proxy);
  void add_unbounded_pairs();
  [[nodiscard]] BoxTree& tree_of(Place place) [[clang::lifetimebound]] {
    return place == Place::moving_tree ? moving_ : still_;
  }

  // By number of box.
  std::vector<CompactAabb> boxes_;
  std::vector<CompactAabb> larger_;
  std::vector<Info> infos_;

  BoxTree moving_, still_;
  std::vector<std::uint32_t> unbounded_;
  std::vector<std::uint32_t> touched_;
  std::vector<ProxyPair> kept_;  // pairs of larger boxes

  // Scratch that keeps its memory from call to call.
  std::vector<std::uint32_t> stack_, starts_;
  std::vector<ProxyPair> overlapping_;
};

}  // namespace abut
