// SPDX-License-Identifier: Apache-2.0
module abut.detect.seams;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.detect.jobs;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.registry.seams;
import abut.pairs.registry;
import abut.pairs.table;
import abut.scene.options;
import abut.scene.places;

namespace abut {
namespace {

// Contacts that stay, as they have become, move to the front, those of the local frames with them. `a`, `b`: where the
// two geometries are.
void keep(std::span<const ContactPoint> kept, const Pose& a, const Pose& b, JobList& jobs, JobResult& result) {
  ChunkScratch& scratch = jobs.scratch(result.chunk);
  const std::span<ContactPoint> all = std::span(scratch.points).subspan(result.first, result.count);
  std::size_t left = 0;
  for (const ContactPoint& contact : all) {
    const auto same = std::ranges::find(kept, contact.id, &ContactPoint::id);
    if (same == kept.end()) {
      continue;
    }
    all[left] = *same;
    if (!scratch.locals.empty()) {
      scratch.locals[result.first + left] = {a.undo(same->point_a), b.undo(same->point_b)};
    }
    ++left;
  }
  result.count = static_cast<std::uint32_t>(left);
}

}  // namespace

void SeamStage::find_sides(const Places& places, const JobList& jobs) {
  sides_.clear();
  const auto add = [&](std::uint32_t body, std::uint32_t surface, std::uint32_t job) {
    if (!places.infos[surface].is_dynamic) {
      sides_.push_back({body, surface, job});
    }
  };
  for (const Chunk& chunk : jobs.chunks()) {
    if (!is_pair_run(chunk.run)) {
      continue;
    }
    const bool is_row = is_surface_kind(chunk.run / shape_kind_count),
               is_column = is_surface_kind(chunk.run % shape_kind_count);
    for (std::uint32_t job = chunk.begin; (is_row || is_column) && job < chunk.end; ++job) {
      if (jobs.result(job).count == 0) {
        continue;
      }
      // Side a of a job is of the kind of the row.
      const PairJob& its = jobs.jobs()[job];
      if (is_row) {
        add(its.b, its.a, job);
      }
      if (is_column) {
        add(its.a, its.b, job);
      }
    }
  }
}

void SeamStage::run(const Places& places, JobList& jobs) {
  find_sides(places, jobs);
  const auto is_other = [&](const Side& side) { return side.surface != sides_.front().surface; };
  if (sides_.empty() || std::ranges::none_of(sides_, is_other)) {
    return;
  }
  std::ranges::sort(sides_, {}, [](const Side& side) { return std::tie(side.body, side.surface, side.job); });
  std::vector<Seam> seams;
  for (std::size_t begin = 0, end = 0; begin < sides_.size(); begin = end) {
    while (end < sides_.size() && sides_[end].body == sides_[begin].body) {
      ++end;
    }
    if (end - begin < 2) {
      continue;
    }
    const std::uint32_t body = sides_[begin].body;
    seams.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const std::span<const ContactPoint> found = jobs.found(jobs.result(sides_[i].job));
      seams.push_back({places.shapes[sides_[i].surface],
                       places.worlds[sides_[i].surface],
                       sides_[i].surface > body,
                       {found.begin(), found.end()}});
    }
    const Aabb box = aabb_of(*places.shapes[body], Pose::identity());
    leave_out_at_seams(seams, 0.5 * largest_magnitude(box.high - box.low));
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t low = std::min(body, sides_[i].surface), high = std::max(body, sides_[i].surface);
      keep(seams[i - begin].contacts, places.worlds[low], places.worlds[high], jobs, jobs.result(sides_[i].job));
    }
  }
}

}  // namespace abut
