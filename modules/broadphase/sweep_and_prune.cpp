// SPDX-License-Identifier: Apache-2.0
module;
#include "../core/check.hpp"
module abut.broadphase.sweep_and_prune;
import abut.broadphase.box_record;
import abut.broadphase.kept.kept_pairs;
import abut.broadphase.proxy;
import abut.core.standard;
import abut.core.workers;
import abut.core;
import abut.math;
import abut.trees.volumes.larger_box;

namespace abut {
namespace {

// Changing places costs about so much less per end than sorting anew per end and doubling of their number.
constexpr std::size_t swaps_of_sorting = 4;

}  // namespace

void SweepAndPrune::place(std::uint32_t proxy) {
  BoxRecord& record = records_[proxy];
  const bool was_unbounded = record.is(BoxRecord::unbounded), is_unbounded = !is_bounded(record.box());
  is_changed_ = true;
  if (was_unbounded == is_unbounded) {
    return;
  }
  if (is_unbounded) {
    record.state |= BoxRecord::unbounded;
    unbounded_.push_back(proxy);
    stale_ends_ += record.is(in_order) ? 1 : 0;
  } else {
    record.state &= ~BoxRecord::unbounded;
    std::erase(unbounded_, proxy);
    if (!record.is(fresh)) {
      record.state |= fresh;
      fresh_.push_back(proxy);
    }
  }
}

void SweepAndPrune::insert(std::uint32_t proxy, const CompactAabb& box, Mobility mobility, std::uint32_t group) {
  if (proxy >= records_.size()) {
    records_.resize(std::size_t{proxy} + 1, {});
    places_.resize(std::size_t{proxy} + 1, 0);
    open_places_.resize(std::size_t{proxy} + 1, 0);
  }
  BoxRecord& record = records_[proxy];
  ABUT_CHECK(!record.is(BoxRecord::present));
  const bool was_fresh = record.is(fresh);
  record.set_box(box);
  record.group = group;
  // Touched: the pairs of who had the number before go.
  record.state =
      (record.state & in_order) | fresh | BoxRecord::present | (mobility == Mobility::moving ? BoxRecord::moving : 0);
  places_[proxy] = static_cast<std::uint32_t>(proxies_.size());
  proxies_.push_back(proxy);
  if (!was_fresh) {
    fresh_.push_back(proxy);
  }
  place(proxy);
}

void SweepAndPrune::erase(std::uint32_t proxy) {
  BoxRecord& record = records_[proxy];
  ABUT_CHECK(record.is(BoxRecord::present));
  const std::uint32_t last = proxies_.back();
  proxies_[places_[proxy]] = last;
  places_[last] = places_[proxy];
  proxies_.pop_back();
  hidden_ -= record.is(BoxRecord::hidden) ? 1 : 0;
  if (record.is(BoxRecord::unbounded)) {
    std::erase(unbounded_, proxy);
  }
  record.state &= in_order | fresh;
  stale_ends_ += record.is(in_order) ? 1 : 0;
  record.set_box(nowhere);
  is_changed_ = true;
  if (!record.is(fresh)) {
    record.state |= fresh;
    fresh_.push_back(proxy);
  }
}

void SweepAndPrune::update(std::uint32_t proxy, const CompactAabb& box) {
  ABUT_CHECK((records_[proxy].state & (BoxRecord::present | BoxRecord::hidden)) == BoxRecord::present);
  records_[proxy].set_box(box);
  place(proxy);
}

void SweepAndPrune::update_all(const Workers&, std::span<const std::uint32_t> proxies,
                               std::span<const CompactAabb> boxes_by_proxy) {
  for (const std::uint32_t proxy : proxies) {
    update(proxy, boxes_by_proxy[proxy]);
  }
}

void SweepAndPrune::hide(std::uint32_t proxy) {
  ABUT_CHECK((records_[proxy].state & (BoxRecord::present | BoxRecord::hidden)) == BoxRecord::present);
  records_[proxy].state |= BoxRecord::hidden;
  ++hidden_;
}

void SweepAndPrune::show(std::uint32_t proxy, const CompactAabb& box) {
  ABUT_CHECK(records_[proxy].is(BoxRecord::present | BoxRecord::hidden));
  records_[proxy].state &= ~BoxRecord::hidden;
  records_[proxy].set_box(box);
  place(proxy);
  --hidden_;
}

// Takes out the ends that have to go and gives the others their values.
void SweepAndPrune::refresh_ends() {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (stale_ends_ > 0) {
      std::erase_if(axes_[axis], [&](const End& end) {
        BoxRecord& record = records_[end.proxy()];
        const bool goes = (record.state & (BoxRecord::present | BoxRecord::unbounded)) != BoxRecord::present;
        record.state &= goes && axis == 2 ? ~in_order : ~0u;
        return goes;
      });
    }
    for (End& end : axes_[axis]) {
      end = End::of(records_[end.proxy()], end.proxy(), axis, end.is_high());
    }
  }
  stale_ends_ = 0;
}

// Those that come are sorted and merged in one pass; the axes are in order.
void SweepAndPrune::insert_ends() {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    added_.clear();
    for (const std::uint32_t proxy : fresh_) {
      const BoxRecord& record = records_[proxy];
      if ((record.state & (BoxRecord::present | BoxRecord::unbounded | in_order)) == BoxRecord::present) {
        added_.push_back(End::of(record, proxy, axis, false));
        added_.push_back(End::of(record, proxy, axis, true));
      }
    }
    std::sort(added_.begin(), added_.end());
    // From the back, so that none is overwritten before it has moved.
    std::vector<End>& ends = axes_[axis];
    std::size_t old = ends.size(), to = ends.size() + added_.size();
    ends.resize(to, End{0});
    for (std::size_t i = added_.size(); i > 0; --i) {
      while (old > 0 && added_[i - 1] < ends[old - 1]) {
        ends[--to] = ends[--old];
      }
      ends[--to] = added_[i - 1];
    }
  }
  for (const std::uint32_t proxy : fresh_) {
    BoxRecord& record = records_[proxy];
    if ((record.state & (BoxRecord::present | BoxRecord::unbounded)) == BoxRecord::present) {
      record.state |= in_order;
    }
  }
}

void SweepAndPrune::add_if_overlapping(std::uint32_t a, std::uint32_t b) {
  const BoxRecord &first = records_[a], &second = records_[b];
  if (((first.state | second.state) & BoxRecord::moving) != 0 && overlap(first, second)) {
    found_.all.push_back({std::min(a, b), std::max(a, b)});
  }
}

// False when it would cost more than sorting anew.
bool SweepAndPrune::sort_by_swaps(std::size_t axis) {
  std::vector<End>& ends = axes_[axis];
  const std::size_t budget =
      swaps_ + swaps_of_sorting * ends.size() * static_cast<std::size_t>(std::bit_width(ends.size()));
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const End end = ends[i];
    std::size_t to = i;
    for (; to > 0 && end < ends[to - 1]; --to) {
      if (ends[to - 1].is_high() && !end.is_high()) {
        add_if_overlapping(end.proxy(), ends[to - 1].proxy());
      }
      ends[to] = ends[to - 1];
    }
    ends[to] = end;
    swaps_ += i - to;
    if (swaps_ > budget) {
      return false;
    }
  }
  return true;
}

void SweepAndPrune::sort_anew() {
  for (std::vector<End>& ends : axes_) {
    std::sort(ends.begin(), ends.end());
  }
  for (const std::uint32_t proxy : proxies_) {
    BoxRecord& record = records_[proxy];
    if (!record.is(fresh)) {
      record.state |= fresh;
      fresh_.push_back(proxy);
    }
  }
}

// Along the axis on which the centres are spread most; pairs of which one box is fresh.
void SweepAndPrune::sweep_for_fresh() {
  std::array<Real, 3> sum{}, squares{};
  Real count = 0;
  for (const std::uint32_t proxy : proxies_) {
    const BoxRecord& record = records_[proxy];
    if (!record.is(BoxRecord::unbounded)) {
      count += 1;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Real middle = static_cast<Real>(record.low[axis]) + static_cast<Real>(record.high[axis]);
        sum[axis] += middle;
        squares[axis] += middle * middle;
      }
    }
  }
  std::size_t widest = 0;
  const auto spread = [&](std::size_t axis) { return squares[axis] * count - sum[axis] * sum[axis]; };
  for (std::size_t axis = 1; axis < 3; ++axis) {
    widest = spread(axis) > spread(widest) ? axis : widest;
  }
  open_.clear();
  open_fresh_.clear();
  for (const End& end : axes_[widest]) {
    const std::uint32_t proxy = end.proxy();
    const bool is_fresh = records_[proxy].is(fresh);
    std::vector<std::uint32_t>& its = is_fresh ? open_fresh_ : open_;
    if (end.is_high()) {
      its[open_places_[proxy]] = its.back();
      open_places_[its.back()] = open_places_[proxy];
      its.pop_back();
      continue;
    }
    for (const std::uint32_t other : open_fresh_) {
      add_if_overlapping(proxy, other);
    }
    if (is_fresh) {
      for (const std::uint32_t other : open_) {
        add_if_overlapping(proxy, other);
      }
    }
    open_places_[proxy] = static_cast<std::uint32_t>(its.size());
    its.push_back(proxy);
  }
}

void SweepAndPrune::add_unbounded_pairs() {
  for (const std::uint32_t proxy : unbounded_) {
    for (const std::uint32_t other : proxies_) {
      if (other != proxy) {
        add_if_overlapping(proxy, other);
      }
    }
  }
}

void SweepAndPrune::find_pairs(const Workers& workers, std::vector<ProxyPair>& out) {
  found_.all.clear();
  swaps_ = 0;
  if (is_changed_) {
    refresh_ends();
    if (!sort_by_swaps(0) || !sort_by_swaps(1) || !sort_by_swaps(2)) {
      found_.all.clear();
      sort_anew();
    }
    if (!fresh_.empty()) {
      insert_ends();
      sweep_for_fresh();
    }
    add_unbounded_pairs();
    for (const std::uint32_t proxy : fresh_) {
      records_[proxy].state = (records_[proxy].state & ~fresh) | BoxRecord::touched;
    }
  }
  kept_.renew(workers, records_, Keeping::while_overlapping, found_.all, out);
  found_.end_call();
  for (const std::uint32_t proxy : fresh_) {
    records_[proxy].state &= ~BoxRecord::touched;
  }
  fresh_.clear();
  is_changed_ = false;
}

std::size_t SweepAndPrune::bytes() const {
  std::size_t sum =
      records_.capacity() * sizeof(BoxRecord) + kept_.bytes() + found_.bytes() + added_.capacity() * sizeof(End);
  for (const std::vector<End>& ends : axes_) {
    sum += ends.capacity() * sizeof(End);
  }
  return sum + (places_.capacity() + proxies_.capacity() + unbounded_.capacity() + fresh_.capacity() +
                open_.capacity() + open_fresh_.capacity() + open_places_.capacity()) *
                   sizeof(std::uint32_t);
}

}  // namespace abut
