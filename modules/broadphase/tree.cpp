module;
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>
#include "../core/check.hpp"
module abut.broadphase.tree;
import abut.broadphase.box_tree;
import abut.broadphase.proxy;
import abut.core;
import abut.math;

namespace abut {
namespace {

// Surfaces of boxes beyond this would overflow in float.
constexpr float largest_bounded = 1e18f;

// How much larger the boxes in the trees are on each side, as a share of the mean side. More means
// fewer changes of the trees and more pairs to look at in every step.
constexpr float slack_share = 0.1f;

// They also reach ahead by the present motion times this many, up to a share of the mean side.
constexpr float updates_ahead = 5.0f;
constexpr float most_ahead = 0.5f;

// Visits of a tree have room for this many nodes from the start.
constexpr std::size_t usual_depth = 256;

bool is_bounded(const CompactAabb& box) {
  bool bounded = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bounded = bounded && box.low[axis] > -largest_bounded && box.high[axis] < largest_bounded;
  }
  return bounded;
}

float mean_side(const CompactAabb& box) {
  return (1.0f / 3.0f) * ((box.high[0] - box.low[0]) + (box.high[1] - box.low[1]) + (box.high[2] - box.low[2]));
}

CompactAabb enlarged(const CompactAabb& box, const CompactAabb& before) {
  const float side = mean_side(box);
  CompactAabb larger;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float shift = 0.5f * (box.low[axis] - before.low[axis]) + 0.5f * (box.high[axis] - before.high[axis]);
    const float ahead = std::clamp(updates_ahead * shift, -most_ahead * side, most_ahead * side);
    larger.low[axis] = box.low[axis] - slack_share * side + std::min(ahead, 0.0f);
    larger.high[axis] = box.high[axis] + slack_share * side + std::max(ahead, 0.0f);
  }
  return larger;
}

}  // namespace

void Tree::touch(std::uint32_t proxy) {
  if (!infos_[proxy].is_touched) {
    infos_[proxy].is_touched = true;
    touched_.push_back(proxy);
  }
}

void Tree::put(std::uint32_t proxy) {
  Info& info = infos_[proxy];
  if (is_bounded(boxes_[proxy])) {
    info.place = info.is_moving ? Place::moving_tree : Place::still_tree;
    larger_[proxy] = enlarged(boxes_[proxy], boxes_[proxy]);
    tree_of(info.place).insert(proxy, larger_[proxy]);
  } else {
    info.place = Place::unbounded;
    unbounded_.push_back(proxy);
  }
  touch(proxy);
}

void Tree::take_out(std::uint32_t proxy) {
  Info& info = infos_[proxy];
  if (info.place == Place::unbounded) {
    std::erase(unbounded_, proxy);
  } else {
    tree_of(info.place).erase(proxy);
  }
  info.place = Place::nowhere;
  touch(proxy);
}

void Tree::insert(std::uint32_t proxy, const CompactAabb& box, Mobility mobility, std::uint32_t group) {
  if (proxy >= infos_.size()) {
    boxes_.resize(std::size_t{proxy} + 1);
    larger_.resize(std::size_t{proxy} + 1);
    infos_.resize(std::size_t{proxy} + 1);
    stack_.reserve(usual_depth);
  }
  ABUT_CHECK(infos_[proxy].place == Place::nowhere);
  boxes_[proxy] = box;
  infos_[proxy].group = group;
  infos_[proxy].is_moving = mobility == Mobility::moving;
  put(proxy);
}

void Tree::erase(std::uint32_t proxy) {
  ABUT_CHECK(proxy < infos_.size() && infos_[proxy].place != Place::nowhere);
  take_out(proxy);
}

void Tree::update(std::uint32_t proxy, const CompactAabb& box) {
  ABUT_CHECK(proxy < infos_.size() && infos_[proxy].place != Place::nowhere);
  const CompactAabb before = boxes_[proxy];
  boxes_[proxy] = box;
  const bool was_bounded = infos_[proxy].place != Place::unbounded;
  if (was_bounded && larger_[proxy].contains(box)) {
    return;
  }
  if (was_bounded && is_bounded(box)) {
    larger_[proxy] = enlarged(box, before);
    tree_of(infos_[proxy].place).move(proxy, larger_[proxy]);
    touch(proxy);
  } else if (was_bounded || is_bounded(box)) {
    take_out(proxy);
    put(proxy);
  }
}

void Tree::drop_touched_pairs() {
  std::erase_if(kept_, [&](const ProxyPair& pair) { return infos_[pair.low].is_touched || infos_[pair.high].is_touched; });
}

void Tree::ask_for_neighbours(std::uint32_t proxy) {
  const Info info = infos_[proxy];
  const auto meet = [&](std::uint32_t other) {
    const Info& its = infos_[other];
    // Of two that both ask, the lower one keeps the pair.
    if (its.group != info.group && (!its.is_touched || proxy < other)) {
      kept_.push_back({std::min(proxy, other), std::max(proxy, other)});
    }
  };
  moving_.visit(larger_[proxy], stack_, meet);
  if (info.is_moving) {
    still_.visit(larger_[proxy], stack_, meet);
  }
}

void Tree::add_unbounded_pairs() {
  for (const std::uint32_t proxy : unbounded_) {
    const Info& info = infos_[proxy];
    for (std::uint32_t other = 0; other < infos_.size(); ++other) {
      const Info& its = infos_[other];
      const bool counts_here = its.place != Place::nowhere && (its.place != Place::unbounded || proxy < other);
      if (counts_here && its.group != info.group && (its.is_moving || info.is_moving) &&
          boxes_[other].overlaps(boxes_[proxy])) {
        overlapping_.push_back({std::min(proxy, other), std::max(proxy, other)});
      }
    }
  }
}

void Tree::find_pairs(std::vector<ProxyPair>& out) {
  if (!touched_.empty()) {
    drop_touched_pairs();
    for (const std::uint32_t proxy : touched_) {
      if (infos_[proxy].place == Place::moving_tree || infos_[proxy].place == Place::still_tree) {
        ask_for_neighbours(proxy);
      }
    }
    for (const std::uint32_t proxy : touched_) {
      infos_[proxy].is_touched = false;
    }
    touched_.clear();
  }
  std::size_t count = 0;
  overlapping_.resize(kept_.size());
  for (const ProxyPair& pair : kept_) {
    // Always written, kept only if the given boxes overlap: no branch to predict.
    overlapping_[count] = pair;
    count += std::size_t{boxes_[pair.low].overlaps(boxes_[pair.high])};
  }
  overlapping_.resize(count);
  add_unbounded_pairs();
  put_in_order(overlapping_, static_cast<std::uint32_t>(infos_.size()), starts_, out);
}

std::size_t Tree::bytes() const {
  return boxes_.capacity() * sizeof(CompactAabb) + larger_.capacity() * sizeof(CompactAabb) +
         infos_.capacity() * sizeof(Info) + moving_.bytes() + still_.bytes() +
         (unbounded_.capacity() + touched_.capacity() + stack_.capacity() + starts_.capacity()) * sizeof(std::uint32_t) +
         (kept_.capacity() + overlapping_.capacity()) * sizeof(ProxyPair);
}

}  // namespace abut
