module;
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>
#include "../core/check.hpp"
module abut.universe;
import abut.any_shape;
import abut.broadphase;
import abut.contact;
import abut.core;
import abut.dispatch;
import abut.math;
import abut.registry;
import abut.shape;
import abut.universe.pairs;

namespace abut {
namespace {

// Up to the first number of geometries every pair is tried, from the second one on there is a tree;
// in between, the present choice stays, so that a scene at the border does not go back and forth.
constexpr std::size_t most_for_brute = 48;
constexpr std::size_t fewest_for_tree = 96;

class Stopwatch {
 public:
  // Microseconds since it was made or read last.
  [[nodiscard]] double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double, std::micro> passed = now - last_;
    last_ = now;
    return passed.count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// Without a tolerance touching counts; otherwise an overlap has to exceed the dead band, or a
// separation to be below the margin.
bool is_reported(Real distance, Real margin) { return margin == 0 ? distance <= 0 : distance < margin; }

// The contacts of a pair in the step before. They are in the order of the pairs, in which they are asked for, so that
// what is left of them shrinks from pair to pair. None for geometries that have taken the slots of others.
std::span<const Contact> take_contacts_of(const GeometryId& a, const GeometryId& b, std::span<const Contact>& left) {
  const auto is_before = [&](const Contact& contact) {
    return std::pair(contact.geometry_a.slot, contact.geometry_b.slot) < std::pair(a.slot, b.slot);
  };
  const auto is_of_pair = [&](const Contact& contact) { return contact.geometry_a == a && contact.geometry_b == b; };
  std::size_t passed = 0, found = 0;
  while (passed < left.size() && is_before(left[passed])) {
    ++passed;
  }
  left = left.subspan(passed);
  while (found < left.size() && is_of_pair(left[found])) {
    ++found;
  }
  return left.first(found);
}

}  // namespace

template <class Visitor>
void Universe::for_each_moved_geometry(Visitor&& visit) const {
  for (const PartId id : moved_parts_) {
    if (parts_.contains(id)) {
      const Part& part = parts_.at(id);
      for (const GeometryId geometry : part.geometries) {
        visit(geometry, part);
      }
    }
  }
  for (const GeometryId geometry : new_geometries_) {
    if (geometries_.contains(geometry)) {
      const Part& part = parts_.at(geometries_.at(geometry).part);
      if (!part.is_moved) {
        visit(geometry, part);
      }
    }
  }
}

// Poses to boxes, for what moved or is new.
void Universe::refresh() {
  fresh_.clear();
  for_each_moved_geometry([&](GeometryId id, const Part& part) {
    const std::uint32_t place = id.slot - 1;
    worlds_[place] = part.pose * geometries_.at(id).local_pose;
    Aabb box = aabb_of(*shapes_[place], worlds_[place]);
    if (options_.tolerance_mode == ToleranceMode::margin) {
      box = box.inflated(tolerances_[place]);
    }
    boxes_[place] = compact(box, options_.origin);
    fresh_.push_back(place);
  });
  for (const PartId id : moved_parts_) {
    if (parts_.contains(id)) {
      parts_.at(id).is_moved = false;
    }
  }
  moved_parts_.clear();
  new_geometries_.clear();
}

// Makes the other broad phase when the number of geometries asks for it, with nothing in it yet.
void Universe::choose_broadphase() {
  const bool has_tree = std::holds_alternative<Tree>(broadphase_);
  bool wants_tree = options_.broadphase == Broadphase::tree;
  if (options_.broadphase == Broadphase::automatic) {
    wants_tree = geometries_.size() > (has_tree ? most_for_brute : fewest_for_tree - 1);
  }
  if (wants_tree == has_tree) {
    return;
  }
  if (wants_tree) {
    broadphase_.emplace<Tree>();
  } else {
    broadphase_.emplace<Brute>();
  }
  in_broadphase_.assign(in_broadphase_.size(), 0);
  fresh_.clear();
  geometries_.for_each([&](GeometryId id, const Geometry&) { fresh_.push_back(id.slot - 1); });
}

// Boxes to pairs.
void Universe::update_broadphase() {
  choose_broadphase();
  std::visit(
      [&](auto& broadphase) {
        for (const std::uint32_t proxy : fresh_) {
          if (in_broadphase_[proxy] != 0) {
            broadphase.update(proxy, boxes_[proxy]);
            continue;
          }
          const PartId part = geometries_.at(geometries_.id_at_slot(proxy + 1)).part;
          const Mobility mobility = parts_.at(part).motion == MotionKind::dynamic ? Mobility::moving : Mobility::still;
          broadphase.insert(proxy, boxes_[proxy], mobility, part.slot);
          in_broadphase_[proxy] = 1;
        }
        broadphase.find_pairs(pairs_);
      },
      broadphase_);
}

// Pairs to manifolds, each in the frame of its first shape, in runs of equal kinds.
void Universe::find_manifolds() {
  runs_.arrange(pairs_, kinds_, tolerances_, options_.tolerance_mode);
  results_.resize(runs_.jobs().size());
  manifold_.clear();
  const QuerySettings settings;
  for (std::size_t row = 0; row < shape_kind_count; ++row) {
    for (std::size_t column = row; column < shape_kind_count; ++column) {
      const std::size_t run = PairRuns::run_of(row, column);
      const std::span<const PairJob> jobs = runs_.jobs_of_run(run);
      if (!jobs.empty()) {
        pair_kernels(row, column)
            .contacts_of_run(shapes_, worlds_, jobs, settings, manifold_,
                             std::span(results_).subspan(runs_.start_of_run(run), jobs.size()));
      }
    }
  }
}

// Manifolds to contacts, in the world frame and in the order of the pairs.
void Universe::collect_contacts() {
  contacts_before_.swap(contacts_);
  contacts_.clear();
  std::span<const Contact> left = contacts_before_;
  stats_.touching_pairs = 0;
  for (std::size_t run = 0; run < PairRuns::run_count; ++run) {
    tallies_[run] = {.candidates = runs_.candidates_of_run(run)};
  }
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const std::uint32_t at = runs_.job_of(i);
    if (at == PairRuns::no_job) {
      continue;
    }
    const std::size_t begin = at == 0 ? 0 : results_[at - 1].contacts_end;
    const std::span<ContactPoint> found = std::span(manifold_).subspan(begin, results_[at].contacts_end - begin);
    if (found.empty()) {
      continue;
    }
    const PairJob& job = runs_.jobs()[at];
    const auto kept = static_cast<std::size_t>(
        std::partition(found.begin(), found.end(), [&](const ContactPoint& c) { return is_reported(c.distance, job.margin); }) -
        found.begin());
    const GeometryId low = geometries_.id_at_slot(pairs_[i].low + 1), high = geometries_.id_at_slot(pairs_[i].high + 1);
    const std::span<const Contact> before = take_contacts_of(low, high, left);
    const auto id_of = [](const Contact& contact) { return contact.point.id; };
    ids_before_.resize(before.size());
    std::ranges::transform(before, ids_before_.begin(), id_of);
    const std::size_t count = reduce_children(found.first(kept), options_.max_contacts, ids_before_);
    if (count == 0) {
      continue;
    }
    for (ContactPoint& contact : found.first(count)) {
      move_by(contact, worlds_[job.a], job.a != pairs_[i].low);
      const auto same = std::ranges::find(before, contact.id, id_of);
      contacts_.push_back(same == before.end() ? Contact{low, high, contact} : Contact{low, high, contact, same->age + 1, same->user_data});
    }
    KindTally& tally = tallies_[PairRuns::run_of(kinds_[job.a], kinds_[job.b])];
    ++tally.touching;
    tally.contacts += count;
    ++stats_.touching_pairs;
  }
}

Result<void> Universe::set_contact_user_data(std::span<const std::uint64_t> user_data) {
  if (user_data.size() != contacts_.size()) {
    return error_about(Errc::invalid_argument, "count", static_cast<std::uint64_t>(user_data.size()),
                       std::to_string(contacts_.size()) + ", one for each contact");
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    contacts_[i].user_data = user_data[i];
  }
  return {};
}

Result<void> Universe::step(Real dt) {
  if (!std::isfinite(dt)) {
    return error_about(Errc::not_finite, "dt", dt, "finite");
  }
  if (dt < 0) {
    return error_about(Errc::out_of_range, "dt", dt, "zero or positive");
  }
  Stopwatch watch;
  refresh();
  stats_.moved = fresh_.size();
  stats_.refresh_microseconds = watch.lap();
  update_broadphase();
  stats_.broadphase_microseconds = watch.lap();
  find_manifolds();
  stats_.narrowphase_microseconds = watch.lap();
  collect_contacts();
  stats_.contact_microseconds = watch.lap();
  stats_.parts = parts_.size();
  stats_.geometries = geometries_.size();
  stats_.candidate_pairs = pairs_.size() - runs_.unsupported();
  stats_.unsupported_pairs = runs_.unsupported();
  stats_.contacts = contacts_.size();
  stats_.bytes = bytes();
  return {};
}

}  // namespace abut
