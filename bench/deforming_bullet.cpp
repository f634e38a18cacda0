// SPDX-License-Identifier: Apache-2.0
// The trees of boxes of Bullet, in single precision, as its soft bodies use them: a leaf for each element, which moves
// with it.
#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <cmath>

#include "deforming_boxes.hpp"

namespace bench {
namespace {

class Tree {
 public:
  explicit Tree(const Elements& elements, double reach) {
    for (std::uint32_t i = 0; i < elements.boxes.size(); ++i) {
      leaves_.push_back(tree_.insert(volume(elements.boxes[i], reach), nullptr));
      leaves_.back()->dataAsInt = static_cast<int>(i);
    }
  }
  void fit(const Elements& elements, double reach) {
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
      const int number = leaves_[i]->dataAsInt;
      btDbvtVolume box = volume(elements.boxes[i], reach);
      tree_.update(leaves_[i], box);
      leaves_[i]->dataAsInt = number;
    }
  }
  [[nodiscard]] const btDbvtNode* root() const { return tree_.m_root; }
  btDbvt& tree() { return tree_; }

 private:
  // Half of the reach on each side of both trees. Rounded outwards, so that nothing is missed.
  static btDbvtVolume volume(const Bounds& box, double reach) {
    const auto down = [reach](double x) {
      return std::nextafter(static_cast<btScalar>(x - reach / 2), -BT_LARGE_FLOAT);
    };
    const auto up = [reach](double x) { return std::nextafter(static_cast<btScalar>(x + reach / 2), BT_LARGE_FLOAT); };
    return btDbvtVolume::FromMM(btVector3(down(box.low[0]), down(box.low[1]), down(box.low[2])),
                                btVector3(up(box.high[0]), up(box.high[1]), up(box.high[2])));
  }

  btDbvt tree_;
  std::vector<btDbvtNode*> leaves_;
};

struct Trees {
  Tree vertices, edges, faces;

  Trees(const AllElements& all, double reach)
      : vertices(all.vertices, reach), edges(all.edges, reach), faces(all.faces, reach) {}
  void fit(const AllElements& all, double reach) {
    vertices.fit(all.vertices, reach);
    edges.fit(all.edges, reach);
    faces.fit(all.faces, reach);
  }
};

struct Collect final : btDbvt::ICollide {
  const Sides* sides = nullptr;
  std::vector<ElementPair>* pairs = nullptr;

  void Process(const btDbvtNode* a, const btDbvtNode* b) override {
    auto i = static_cast<std::uint32_t>(a->dataAsInt), j = static_cast<std::uint32_t>(b->dataAsInt);
    // A tree with itself gives each pair once, in any order.
    if (sides->is_one_list && i > j) {
      std::swap(i, j);
    }
    if (sides->counts(i, j)) {
      pairs->push_back({sides->kind, i, j});
    }
  }
};

class Bullet final : public DeformingWay {
 public:
  explicit Bullet(const DeformingCase& first)
      : a_(AllElements(first.a, true), first.reach),
        b_(first.is_of_one() ? nullptr : std::make_unique<Trees>(AllElements(first.b, true), first.reach)) {}

  void answer(const DeformingCase& step, Found& found) override {
    found.pairs.clear();
    const AllElements a(step.a, true), b(step.is_of_one() ? step.a : step.b, true);
    a_.fit(a, step.reach);
    if (b_) {
      b_->fit(b, step.reach);
    }
    Trees& other = b_ ? *b_ : a_;
    for_each_sides(step, a, b, [&](const Sides& sides) {
      Collect collect;
      collect.sides = &sides;
      collect.pairs = &found.pairs;
      Tree &one = tree_of(a_, sides.kind, true), &two = tree_of(other, sides.kind, false);
      one.tree().collideTTpersistentStack(one.root(), two.root(), collect);
    });
  }

 private:
  static Tree& tree_of(Trees& trees, PairKind kind, bool is_first) {
    if (kind == PairKind::edge_edge) {
      return trees.edges;
    }
    return (kind == PairKind::vertex_face) == is_first ? trees.vertices : trees.faces;
  }

  Trees a_;
  std::unique_ptr<Trees> b_;
};

}  // namespace

std::vector<NamedWay> bullet_ways(Asked asked, const DeformingCase& first) {
  std::vector<NamedWay> ways;
  if (asked == Asked::candidates) {
    ways.push_back({"bullet", std::make_unique<Bullet>(first)});
  }
  return ways;
}

}  // namespace bench
