// SPDX-License-Identifier: Apache-2.0
module abut.detect.pairs.sides;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.surfaces.kept_sides;
import abut.pairs.table;
import abut.scene.state.options;
import abut.scene.state.places;

namespace abut {
namespace {

template <class T>
std::pair<std::uint32_t, std::uint32_t> places_of(const T& its) {
  return {its.low, its.high};
}

template <class T>
const T* find_of(std::span<const T> all, std::uint32_t low, std::uint32_t high) {
  const std::pair wanted(low, high);
  const auto at = std::lower_bound(all.begin(), all.end(), wanted,
                                   [](const T& its, const auto& other) { return places_of(its) < other; });
  return at != all.end() && places_of(*at) == wanted ? &*at : nullptr;
}

bool keeps_side(std::uint32_t low, std::uint32_t high, const Places& places) {
  return places.infos[low].keeps_side || places.infos[high].keeps_side;
}

}  // namespace

// Whether both geometries and their shapes are those that it was of.
bool SideStage::is_same(const Kept& kept, const Places& places) {
  return kept.generation_low == places.infos[kept.low].generation &&
         kept.generation_high == places.infos[kept.high].generation &&
         !places.has_happened(kept.low, happened_to_shape) && !places.has_happened(kept.high, happened_to_shape);
}

void SideStage::add_case(const PairJob& its, std::size_t job, const Places& places) {
  const std::uint32_t low = std::min(its.a, its.b), high = std::max(its.a, its.b);
  if (!keeps_side(low, high, places)) {
    return;
  }
  const Kept* const kept = find_of<Kept>(kept_, low, high);
  const bool is_known = kept != nullptr && is_same(*kept, places);
  case_of_job_[job] = static_cast<std::uint32_t>(cases_.size());
  cases_.push_back({low, high, {is_known ? kept->memories : std::vector<SidesOfChildren>{}, {}}});
}

void SideStage::start(bool is_used, const Places& places, const JobList& jobs) {
  cases_.clear();
  case_of_job_.clear();
  if (!is_used) {
    return;
  }
  case_of_job_.resize(jobs.jobs().size(), no_index);
  for (const Chunk& chunk : jobs.chunks()) {
    if (!is_pair_run(chunk.run)) {
      continue;
    }
    if (!may_keep_side(chunk.run / shape_kind_count, chunk.run % shape_kind_count)) {
      continue;
    }
    for (std::uint32_t job = chunk.begin; job < chunk.end; ++job) {
      add_case(jobs.jobs()[job], job, places);
    }
  }
}

bool SideStage::find(std::size_t job, const PairJob& its, const Places& places, const QuerySettings& settings,
                     Manifold& out) {
  return contacts_on_side(*places.shapes[its.a], *places.shapes[its.b],
                          relative(places.worlds[its.a], places.worlds[its.b]), settings,
                          cases_[case_of_job_[job]].side, out);
}

void SideStage::settle(const Places& places, std::span<const Pair> pairs) {
  if (kept_.empty() && cases_.empty()) {
    return;
  }
  const auto key = [](const auto& its) { return places_of(its); };
  std::ranges::sort(cases_, {}, key);
  // Whoever was examined is there anew, or has parted.
  std::erase_if(kept_, [&](const Kept& its) {
    const Pair* const pair = find_of<Pair>(pairs, its.low, its.high);
    return pair == nullptr || !pair->is_admitted || !keeps_side(its.low, its.high, places) || !is_same(its, places) ||
           find_of<Case>(cases_, its.low, its.high) != nullptr;
  });
  for (Case& its : cases_) {
    if (!its.side.after.empty()) {
      kept_.push_back({its.low, its.high, places.infos[its.low].generation, places.infos[its.high].generation,
                       std::move(its.side.after)});
    }
  }
  std::ranges::sort(kept_, {}, key);
  cases_.clear();
  case_of_job_.clear();
}

bool SideStage::is_right(const Places& places) const {
  const auto is_of_pair = [&](const Kept& its) {
    if (its.low >= its.high || its.high >= places.infos.size()) {
      return false;
    }
    const std::uint32_t kind_low = places.infos[its.low].kind, kind_high = places.infos[its.high].kind;
    const bool is_a_low = kind_low <= kind_high;  // as in jobs
    return may_keep_side(kind_low, kind_high) && may_be_of(its.memories, *places.shapes[is_a_low ? its.low : its.high],
                                                           *places.shapes[is_a_low ? its.high : its.low]);
  };
  bool are_right = std::ranges::all_of(kept_, is_of_pair);
  for (std::size_t i = 1; i < kept_.size(); ++i) {
    are_right = are_right && places_of(kept_[i - 1]) < places_of(kept_[i]);
  }
  return are_right;
}

std::size_t SideStage::bytes() const {
  std::size_t memories = 0, parts = 0;
  for (const Kept& its : kept_) {
    memories += its.memories.capacity();
    for (const SidesOfChildren& of_children : its.memories) {
      parts += of_children.memory.parts.capacity();
    }
  }
  return kept_.capacity() * sizeof(Kept) + memories * sizeof(SidesOfChildren) + parts * sizeof(SideOfPart) +
         cases_.capacity() * sizeof(Case) + case_of_job_.capacity() * sizeof(std::uint32_t);
}

}  // namespace abut
