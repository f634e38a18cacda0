// SPDX-License-Identifier: Apache-2.0
module abut.detect.continuous.impacts;
import abut.core.standard;
import abut.core.workers;
import abut.capability;
import abut.detect.lists.contacts;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.detect.continuous.path_contacts;
import abut.detect.paths;
import abut.detect.continuous.sweeps;
import abut.detect.continuous.touches;
import abut.math;
import abut.motion.impacts.convex_impact;
import abut.pairs.taken_apart.convex_part;
import abut.motion.time_of_impact;
import abut.pairs.any_shape;
import abut.pairs.pair_job;
import abut.scene.state.options;
import abut.scene.state.places;

namespace abut {
namespace {

// Pairs next to each other that one task takes.
constexpr std::size_t pairs_of_block = 8;
// Data is fetched from memory so many pairs before it is needed.
constexpr std::size_t pairs_ahead = 4;

// Whether the path of a pair tells all its contacts, whatever it leads to. Others keep those of their present poses
// where their path has no answer.
bool is_told_by_path(const Pair& pair, const Paths& paths, const Places& places) {
  const PlaceInfo &low = places.infos[pair.low], &high = places.infos[pair.high];
  return (low.sweeping == Sweeping::impacts || high.sweeping == Sweeping::impacts) &&
         (paths.moves(pair.low) || paths.moves(pair.high)) &&
         !(paths.begins_at_pose(pair.low) && paths.begins_at_pose(pair.high)) && is_convex_kind(low.kind) &&
         is_convex_kind(high.kind);
}

PathPair path_pair(const PathScene& scene, const Sides& sides, Real margin) {
  return {{*scene.places.shapes[sides.job.a], sides.a, sides.box_a},
          {*scene.places.shapes[sides.job.b], sides.b, sides.box_b},
          margin};
}

// A geometry on its path. What is no mover has its path here.
class [[gsl::Pointer]] Traveller {
 public:
  Traveller(const PathScene& scene [[clang::lifetimebound]], std::uint32_t place)
      : shape_(*scene.places.shapes[place]), mover_(scene.sweeps.mover_at(place)) {
    if (mover_ == nullptr) {
      const Path path = scene.paths.of(place);
      slow_.emplace(path, path.at(1), ConvexPart::of(shape_));
    }
  }

  [[nodiscard]] const Path& path() const [[clang::lifetimebound]] {
    return mover_ != nullptr ? mover_->path : slow_->path;
  }
  [[nodiscard]] Aabb own_box() const { return mover_ != nullptr ? mover_->own : aabb_of(shape_, Pose::identity()); }
  // Of a convex shape.
  [[nodiscard]] PassingPart passing() const [[clang::lifetimebound]] {
    if (mover_ != nullptr) {
      return {*mover_->part, mover_->path, mover_->reach, mover_->end};
    }
    const Reach reach =
        slow_->path.turns() ? slow_->path.reach_of(own_box().inflated(-slow_->part->radius())) : Reach{0, 0};
    return {*slow_->part, slow_->path, reach, slow_->end};
  }

 private:
  struct Slow {
    Path path;
    Pose end;
    std::optional<ConvexPart> part;
  };
  const AnyShape& shape_;
  const Sweeps::Mover* mover_;
  std::optional<Slow> slow_;
};

}  // namespace

// A touch on the way: its contacts follow those that the pair has.
void ImpactStage::add_touch(const PathScene& scene, const Sides& sides, const Impact& impact, const Pair& pair,
                            const Block& block, JobList& jobs, Ahead& its) {
  JobResult& result = jobs.result(its.job);
  const std::uint32_t before = result.count;
  const std::uint32_t touch = its.touch_count + (its.count_at_start > 0 ? 1 : 0);
  report_touch(scene, sides, impact, pair, touch, its.touching, jobs.scratch(block.number), result);
  block.touches.push_back({impact.lower, impact.upper, result.count - before, impact.state == ImpactState::undecided});
  ++its.touch_count;
}

// The touches that follow one at a time.
void ImpactStage::follow(const PathScene& scene, const Sides& sides, const Pair& pair, Real time, const Block& block,
                         JobList& jobs, Ahead& its) {
  JobResult& result = jobs.result(its.job);
  const PathPair paths = path_pair(scene, sides, its.touching);
  for (std::optional<Impact> next; its.touch_count < most_touches; time = next->upper) {
    next = find_touch_after(paths, time);
    if (!next) {
      return;
    }
    if (result.chunk != block.number) {
      take_over(block.number, jobs, result);
    }
    add_touch(scene, sides, *next, pair, block, jobs, its);
    if (next->state == ImpactState::undecided) {
      return;
    }
  }
}

void ImpactStage::examine(const PathScene& scene, const Pair& pair, const Block& block, JobList& jobs, Ahead& its) {
  const PairJob& job = jobs.jobs()[its.job];
  const Places& places = scene.places;
  const auto has = [&](Sweeping sweeping) {
    return places.infos[job.a].sweeping == sweeping || places.infos[job.b].sweeping == sweeping;
  };
  if (!its.is_told_by_path && !scene.paths.moves(job.a) && !scene.paths.moves(job.b)) {
    return;
  }
  const Traveller a(scene, job.a), b(scene, job.b);
  JobResult& result = jobs.result(its.job);
  its.touching = std::max<Real>(job.margin, 0);
  Real begin = 0;  // before it they are apart
  if (its.is_told_by_path) {
    result = empty_result(block.number, jobs.scratch(block.number));
    begin = free_until(a.passing(), b.passing(), its.touching);
    if (begin >= 1) {
      return;
    }
  }
  const Sides sides{job, a.path(), b.path(), a.own_box(), b.own_box()};
  if (!has(Sweeping::impacts)) {
    its.is_speculative = true;
    report_speculative(scene, sides, pair, block.number, its.touching, jobs, result);
    return;
  }
  if (its.is_told_by_path && begin == 0) {
    report_start(scene, sides, pair, its.touching, jobs.scratch(block.number), result);
  }
  const auto begins_here = [&] { return scene.paths.begins_at_pose(job.a) && scene.paths.begins_at_pose(job.b); };
  if (result.count > 0 && (its.is_told_by_path || begins_here())) {
    its.count_at_start = result.count;
    follow(scene, sides, pair, 0, block, jobs, its);
    return;
  }
  Impact impact;
  if (find_touch(path_pair(scene, sides, its.touching), begin, impact) != Outcome::ok) {
    return;
  }
  result = empty_result(block.number, jobs.scratch(block.number));
  if (impact.state == ImpactState::starts_together) {
    report_touch(scene, sides, impact, pair, 0, its.touching, jobs.scratch(block.number), result);
    its.count_at_start = result.count;
  } else if (impact.state != ImpactState::apart) {
    add_touch(scene, sides, impact, pair, block, jobs, its);
  }
  if (impact.state == ImpactState::starts_together || impact.state == ImpactState::touches) {
    follow(scene, sides, pair, impact.upper, block, jobs, its);
  }
}

void ImpactStage::start(std::span<const std::uint32_t> wanted, const Paths& paths, const Places& places,
                        std::span<Pair> pairs) {
  ahead_.clear();
  for (const std::uint32_t number : wanted) {
    const bool is_told = is_told_by_path(pairs[number], paths, places);
    pairs[number].is_on_path = is_told;
    ahead_.push_back({.pair = number, .is_told_by_path = is_told});
  }
}

// What will be asked of a pair lies anywhere.
void ImpactStage::fetch(const PathScene& scene, std::span<const Pair> pairs, const JobList& jobs,
                        std::size_t number) const {
  if (number >= ahead_.size()) {
    return;
  }
  __builtin_prefetch(&pairs[ahead_[number].pair]);
  const PairJob& job = jobs.jobs()[ahead_[number].job];
  for (const std::uint32_t place : {job.a, job.b}) {
    __builtin_prefetch(&scene.places.shapes[place]);
    __builtin_prefetch(&scene.places.infos[place]);
    __builtin_prefetch(&scene.places.worlds[place].rotation);
    __builtin_prefetch(&scene.places.worlds[place].position);
  }
}

void ImpactStage::run(const Workers& workers, const PathScene& scene, std::span<Pair> pairs, JobList& jobs) {
  for (Ahead& its : ahead_) {
    pairs[its.pair].is_on_path = false;
    its.job = pairs[its.pair].job;
  }
  std::erase_if(ahead_, [&](const Ahead& its) { return its.job == no_job || pairs[its.pair].is_by_elements; });
  const std::size_t blocks = (ahead_.size() + pairs_of_block - 1) / pairs_of_block;
  const std::size_t first = jobs.add_scratch(blocks);
  touches_.resize(std::max(touches_.size(), blocks));
  workers.for_each(blocks, [&](std::size_t number) {
    const Block block{first + number, touches_[number]};
    ChunkScratch& scratch = jobs.scratch(block.number);
    scratch.points.clear();
    scratch.locals.clear();
    block.touches.clear();
    const std::size_t begin = number * pairs_of_block, end = std::min(begin + pairs_of_block, ahead_.size());
    for (std::size_t i = begin; i < end; ++i) {
      fetch(scene, pairs, jobs, i + pairs_ahead);
      ahead_[i].first_touch = static_cast<std::uint32_t>(block.touches.size());
      examine(scene, pairs[ahead_[i].pair], block, jobs, ahead_[i]);
    }
  });
}

void ImpactStage::mark(std::span<const Pair> pairs, ContactList& contacts) {
  impacts_.clear();
  for (std::size_t i = 0; i < ahead_.size(); ++i) {
    const Ahead& its = ahead_[i];
    const Pair& pair = pairs[its.pair];
    if (its.is_speculative) {
      contacts.mark_ahead(pair.first_contact, pair.contact_count, 0, its.touching);
    }
    std::uint32_t first = pair.first_contact + its.count_at_start;
    for (const Touch& touch : std::span(touches_[i / pairs_of_block]).subspan(its.first_touch, its.touch_count)) {
      contacts.mark_ahead(first, touch.contact_count, touch.lower, its.touching);
      impacts_.push_back({.geometry_a = {pair.low + 1, pair.generation_low},
                          .geometry_b = {pair.high + 1, pair.generation_high},
                          .lower = touch.lower,
                          .upper = touch.upper,
                          .is_undecided = touch.is_undecided,
                          .first_contact = first,
                          .contact_count = touch.contact_count});
      first += touch.contact_count;
    }
  }
  std::ranges::sort(impacts_, {}, [](const StepImpact& its) {
    return std::tuple(its.lower, its.geometry_a.slot, its.geometry_b.slot);
  });
}

std::size_t ImpactStage::bytes() const {
  std::size_t sum = ahead_.capacity() * sizeof(Ahead) + impacts_.capacity() * sizeof(StepImpact) +
                    touches_.capacity() * sizeof(std::vector<Touch>);
  for (const std::vector<Touch>& touches : touches_) {
    sum += touches.capacity() * sizeof(Touch);
  }
  return sum;
}

}  // namespace abut
