// SPDX-License-Identifier: Apache-2.0
// What the broad phases that keep pairs from call to call have in common, whatever finds neighbours for them.
module;
#include "../../core/check.hpp"
export module abut.broadphase.kept.followed_boxes;
import abut.broadphase.box_record;
import abut.broadphase.kept.kept_pairs;
import abut.broadphase.kept.pair_order;
import abut.broadphase.proxy;
import abut.broadphase.kept.reused_list;
import abut.core.standard;
import abut.core.workers;
import abut.core;
import abut.math;
import abut.trees.volumes.box_sweep;
import abut.trees.volumes.larger_box;

export namespace abut {

// The index holds boxes that are a little larger than the given ones, so that most motion leaves it as it is, and the
// pairs of those larger boxes are kept from call to call. Only what has left its larger box is moved in the index and
// asks for its neighbours anew. Still boxes have an index of their own, which only moving ones ask. Boxes without
// bounds are in none; they are tried with all.
template <class Index>
class FollowedBoxes {
 public:
  FollowedBoxes() = default;

  void insert(std::uint32_t proxy, const CompactAabb& box, Mobility mobility, std::uint32_t group) {
    if (proxy >= records_.size()) {
      records_.resize(std::size_t{proxy} + 1, {});
      larger_.resize(std::size_t{proxy} + 1, {});
    }
    BoxRecord& record = records_[proxy];
    ABUT_CHECK(!record.is(BoxRecord::present));
    record.set_box(box);
    record.group = group;
    record.state = (record.state & BoxRecord::touched) | BoxRecord::present |
                   (mobility == Mobility::moving ? BoxRecord::moving : 0);
    ++size_;
    ++came_;
    larger_[proxy] = enlarged(box, box);
    put(proxy);
  }

  void erase(std::uint32_t proxy) {
    BoxRecord& record = records_[proxy];
    ABUT_CHECK(record.is(BoxRecord::present));
    take_out(proxy);
    --size_;
    hidden_ -= record.is(BoxRecord::hidden) ? 1 : 0;
    record.state &= BoxRecord::touched;
  }

  void update(std::uint32_t proxy, const CompactAabb& box) {
    BoxRecord& record = records_[proxy];
    ABUT_CHECK((record.state & (BoxRecord::present | BoxRecord::hidden)) == BoxRecord::present);
    if (!larger_[proxy].contains(box)) {
      follow(proxy, box, record.box());
    }
    record.set_box(box);
  }

  // Each number comes once; its box is at that place of the others.
  void update_all(const Workers& workers, std::span<const std::uint32_t> proxies,
                  std::span<const CompactAabb> boxes_by_proxy) {
    constexpr std::size_t least_of_task = 1024;
    const Cuts cuts = workers.cut(proxies.size(), least_of_task);
    make_parts(cuts.tasks());
    workers.for_each(cuts.tasks(), [&](std::size_t task) {
      Part& part = parts_[task];
      part.leaving.clear();
      part.leaving.reserve(cuts.of(proxies, task).size());
      for (const std::uint32_t proxy : cuts.of(proxies, task)) {
        update_one(proxy, boxes_by_proxy[proxy], part);
      }
    });
    order_.all.clear();
    for (const Part& part : std::span(parts_).first(cuts.tasks())) {
      order_.all.insert(order_.all.end(), part.leaving.begin(), part.leaving.end());
    }
    follow_all(workers);
    tidy();
  }

  // A hidden box keeps its place and its pairs but overlaps nothing.
  void hide(std::uint32_t proxy) {
    BoxRecord& record = records_[proxy];
    ABUT_CHECK((record.state & (BoxRecord::present | BoxRecord::hidden)) == BoxRecord::present);
    record.state |= BoxRecord::hidden;
    record.set_box(nowhere);
    ++hidden_;
  }
  void show(std::uint32_t proxy, const CompactAabb& box) {
    BoxRecord& record = records_[proxy];
    ABUT_CHECK(record.is(BoxRecord::present | BoxRecord::hidden));
    record.state &= ~BoxRecord::hidden;
    if (!larger_[proxy].contains(box)) {
      follow(proxy, box, box);
    }
    record.set_box(box);
    --hidden_;
  }

  void find_pairs(std::vector<ProxyPair>& out) { find_pairs(Workers(1), out); }
  void find_pairs(const Workers& workers, std::vector<ProxyPair>& out) {
    tidy();
    found_.all.clear();
    order_.all.clear();
    if (!touched_.empty()) {
      find_neighbours(workers);
    }
    kept_.renew(workers, records_, Keeping::unless_touched, found_.all, out);
    for (std::size_t i = 0; i < touched_.size(); ++i) {
      __builtin_prefetch(&records_[touched_[std::min(i + ahead, touched_.size() - 1)]]);
      records_[touched_[i]].state &= ~BoxRecord::touched;
    }
    touched_.clear();
    end_call();
  }

  template <class Visitor>
  void visit(const CompactAabb& box, Visitor&& visit_proxy) const {
    BoxRecord given{};
    given.set_box(box);
    const auto meet = [&](std::uint32_t proxy) {
      if (overlap(records_[proxy], given)) {
        visit_proxy(proxy);
      }
    };
    moving_.visit(box, meet);
    still_.visit(box, meet);
    for (const std::uint32_t proxy : unbounded_) {
      meet(proxy);
    }
  }

  template <class Visitor>
  void sweep(const Vec3& centre, const Vec3& half, const Vec3& displacement, Real most, Visitor&& visit_proxy) const {
    const BoxSweep sweep(centre, half, displacement);
    const auto meet = [&](std::uint32_t proxy) {
      const BoxRecord& record = records_[proxy];
      const Real entry = record.is(BoxRecord::hidden) ? infinity : sweep.entry(record.box(), most);
      if (entry < infinity) {
        most = visit_proxy(proxy, entry);
      }
      return most;
    };
    for (const std::uint32_t proxy : unbounded_) {
      meet(proxy);
    }
    const CompactSweep compact_sweep(sweep);
    moving_.sweep(compact_sweep, most, meet);
    still_.sweep(compact_sweep, most, meet);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t hidden() const { return hidden_; }
  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = records_.capacity() * sizeof(BoxRecord) + larger_.capacity() * sizeof(CompactAabb) +
                      moving_.bytes() + still_.bytes() + kept_.bytes() +
                      (unbounded_.capacity() + touched_.capacity()) * sizeof(std::uint32_t) + found_.bytes() +
                      order_.bytes() + scratch_.bytes();
    for (const Part& part : parts_) {
      sum += sizeof(Part) + (part.found.capacity() + part.leaving.capacity()) * sizeof(ProxyPair);
    }
    return sum;
  }

 private:
  // What one task finds.
  struct Part {
    std::vector<ProxyPair> found, leaving;
  };
  void make_parts(std::size_t count) {
    if (parts_.size() < count) {
      parts_.resize(count);
    }
  }

  // The first search finds all pairs, later ones a few: of many boxes most may never move.
  void end_call() {
    constexpr std::size_t many = 65'536;
    if (came_ >= many && 2 * came_ > size_) {
      kept_.give_back_scratch();
      found_.give_back();
      order_.give_back();
      scratch_.give_back();
      std::vector<Part>().swap(parts_);
    }
    found_.end_call();
    order_.end_call();
    scratch_.end_call();
    came_ = 0;
  }

  // After updates too: whoever only queries never asks for pairs.
  void tidy() {
    moving_.tidy();
    still_.tidy();
  }

  [[nodiscard]] Index& index_of(const BoxRecord& record) [[clang::lifetimebound]] {
    return record.is(BoxRecord::moving) ? moving_ : still_;
  }

  void touch(std::uint32_t proxy) {
    if (!records_[proxy].is(BoxRecord::touched)) {
      records_[proxy].state |= BoxRecord::touched;
      touched_.push_back(proxy);
    }
  }

  void put(std::uint32_t proxy) {
    const CompactAabb& larger = larger_[proxy];
    if (is_bounded(larger)) {
      index_of(records_[proxy]).insert(proxy, larger);
    } else {
      records_[proxy].state |= BoxRecord::unbounded;
      unbounded_.push_back(proxy);
    }
    touch(proxy);
  }

  void take_out(std::uint32_t proxy) {
    BoxRecord& record = records_[proxy];
    if (record.is(BoxRecord::unbounded)) {
      std::erase(unbounded_, proxy);
      record.state &= ~BoxRecord::unbounded;
    } else {
      index_of(record).erase(proxy);
    }
    touch(proxy);
  }

  // The box has left its larger one.
  void follow(std::uint32_t proxy, const CompactAabb& box, const CompactAabb& before) {
    larger_[proxy] = enlarged(box, before);
    follow_elsewhere(proxy);
  }
  void follow_elsewhere(std::uint32_t proxy) {
    const BoxRecord& record = records_[proxy];
    const CompactAabb& larger = larger_[proxy];
    const bool was_bounded = !record.is(BoxRecord::unbounded);
    if (was_bounded != is_bounded(larger)) {
      take_out(proxy);
      put(proxy);
      return;
    }
    if (was_bounded) {
      index_of(record).move(proxy, larger);
    }
    touch(proxy);
  }

  // Boxes that are asked for in no order of their numbers are asked of the cache so many before.
  static constexpr std::size_t ahead = 16;
  void expect(std::uint32_t proxy) const {
    __builtin_prefetch(&larger_[proxy]);
    __builtin_prefetch(&records_[proxy]);
    moving_.expect(proxy);
  }
  void expect(const ProxyPair& place_and_proxy) const {
    moving_.expect_place(place_and_proxy.low);
    expect(place_and_proxy.high);
  }

  // Gives a box another larger one where it has left its own. The index follows later.
  void update_one(std::uint32_t proxy, const CompactAabb& box, Part& part) {
    BoxRecord& record = records_[proxy];
    ABUT_CHECK((record.state & (BoxRecord::present | BoxRecord::hidden)) == BoxRecord::present);
    if (!larger_[proxy].contains(box)) {
      leave(proxy, enlarged(box, record.box()), part);
    }
    record.set_box(box);
  }
  [[gnu::noinline]] void leave(std::uint32_t proxy, const CompactAabb& larger, Part& part) {
    larger_[proxy] = larger;
    part.leaving.push_back({place_of(proxy), proxy});
  }

  [[nodiscard]] std::uint32_t place_of(std::uint32_t proxy) const {
    const BoxRecord& record = records_[proxy];
    return record.is(BoxRecord::unbounded) ? 0 : (record.is(BoxRecord::moving) ? moving_ : still_).place_of(proxy);
  }

  // One after the other they are in much the same part of the index.
  void arrange_by_place() {
    constexpr std::size_t least_to_arrange = 2048;
    if (order_.all.size() >= least_to_arrange) {
      gather_by_lower(order_.all, scratch_.all);
    }
  }

  // Brings the index up to date with those whose larger box is another one: first what may be done for several at once,
  // then the rest. What is left to do for each is written where its place in the index was, so that there is no list to
  // grow.
  enum Left : std::uint32_t { nothing, to_remember, to_move };
  void follow_all(const Workers& workers) {
    constexpr std::size_t least_of_task = 256;
    arrange_by_place();
    const std::span<ProxyPair> leaving(order_.all);
    const Cuts cuts = workers.cut(leaving.size(), least_of_task);
    workers.for_each(cuts.tasks(), [&](std::size_t task) {
      const std::span<ProxyPair> its = cuts.of(leaving, task);
      for (std::size_t i = 0; i < its.size(); ++i) {
        expect(its[std::min(i + ahead, its.size() - 1)]);
        its[i].low = follow_in_place(its[i].high);
      }
    });
    for (std::size_t i = 0; i < leaving.size(); ++i) {
      if (const ProxyPair& next = leaving[std::min(i + ahead, leaving.size() - 1)]; next.low == to_move) {
        expect(next.high);
      }
      if (leaving[i].low == to_move) {
        follow_elsewhere(leaving[i].high);
      } else if (leaving[i].low == to_remember) {
        touched_.push_back(leaving[i].high);
      }
    }
  }

  [[nodiscard]] Left follow_in_place(std::uint32_t proxy) {
    BoxRecord& record = records_[proxy];
    const CompactAabb& larger = larger_[proxy];
    const bool is_in_index = !record.is(BoxRecord::unbounded) && is_bounded(larger);
    if (!is_in_index || !index_of(record).moved_in_place(proxy, larger)) {
      return to_move;
    }
    if (record.is(BoxRecord::touched)) {
      return nothing;
    }
    record.state |= BoxRecord::touched;
    return to_remember;
  }

  void find_neighbours(const Workers& workers) {
    for (std::size_t i = 0; i < touched_.size(); ++i) {
      expect(touched_[std::min(i + ahead, touched_.size() - 1)]);
      if (const std::uint32_t proxy = touched_[i]; records_[proxy].is(BoxRecord::present)) {
        order_.all.push_back({place_of(proxy), proxy});
      }
    }
    arrange_by_place();
    constexpr std::size_t least_of_task = 256;
    const std::span<const ProxyPair> asking(order_.all);
    const Cuts cuts = workers.cut(asking.size(), least_of_task);
    if (cuts.tasks() == 1) {
      ask_for_neighbours(asking, found_.all);
      return;
    }
    make_parts(cuts.tasks());
    workers.for_each(cuts.tasks(), [&](std::size_t task) {
      parts_[task].found.clear();
      ask_for_neighbours(cuts.of(asking, task), parts_[task].found);
    });
    for (const Part& part : std::span(parts_).first(cuts.tasks())) {
      found_.all.insert(found_.all.end(), part.found.begin(), part.found.end());
    }
  }

  void ask_for_neighbours(std::span<const ProxyPair> asking, std::vector<ProxyPair>& found) const {
    const bool all_ask = order_.all.size() == size_;
    for (std::size_t i = 0; i < asking.size(); ++i) {
      expect(asking[std::min(i + ahead, asking.size() - 1)]);
      ask_for_neighbours(asking[i].high, all_ask, found);
    }
  }

  // Two that both ask find their pair twice, unless all do: then the lower number finds it.
  void ask_for_neighbours(std::uint32_t proxy, bool all_ask, std::vector<ProxyPair>& found) const {
    const CompactAabb& larger = larger_[proxy];
    const bool is_moving = records_[proxy].is(BoxRecord::moving);
    const std::uint32_t first = all_ask ? proxy : 0;
    const auto meet = [&](std::uint32_t other) {
      if (other != proxy && other >= first) {
        found.push_back({std::min(proxy, other), std::max(proxy, other)});
      }
    };
    moving_.visit(larger, meet);
    if (is_moving) {
      still_.visit(larger, meet);
    }
    for (const std::uint32_t other : unbounded_) {
      if ((is_moving || records_[other].is(BoxRecord::moving)) && larger_[other].overlaps(larger)) {
        meet(other);
      }
    }
  }

  // By number of box.
  std::vector<BoxRecord> records_;
  std::vector<CompactAabb> larger_;

  Index moving_, still_;
  std::vector<std::uint32_t> unbounded_;
  std::vector<std::uint32_t> touched_;  // their kept pairs are out of date
  KeptPairs kept_;                      // of larger boxes
  std::size_t size_ = 0, hidden_ = 0;
  std::size_t came_ = 0;  // since the last search

  // Scratch that keeps its memory from call to call.
  ReusedList<ProxyPair> found_, order_, scratch_;
  std::vector<Part> parts_;
};

}  // namespace abut
