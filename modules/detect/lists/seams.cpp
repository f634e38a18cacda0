// SPDX-License-Identifier: Apache-2.0
module abut.detect.lists.seams;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.detect.pairs.jobs;
import abut.detect.pairs.manifolds;
import abut.detect.pairs;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.composites.seams;
import abut.pairs.pair_job;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.meetings.policies;

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

// The same of contacts that have come as well: all move behind those of the chunk, reduced as the options say.
void replace(const Seam& seam, const SeamScene& scene, std::uint32_t job, JobList& jobs) {
  JobResult& result = jobs.result(job);
  ChunkScratch& scratch = jobs.scratch(result.chunk);
  const PairJob& its = jobs.jobs()[job];
  const AnyShape &a = *scene.places.shapes[std::min(its.a, its.b)], &b = *scene.places.shapes[std::max(its.a, its.b)];
  const Pair& pair = scene.pairs[jobs.pair_of(job)];
  const std::size_t first = scratch.points.size();
  scratch.points.insert(scratch.points.end(), seam.contacts.begin(), seam.contacts.end());
  scratch.points.insert(scratch.points.end(), seam.added.begin(), seam.added.end());
  const auto surfaces = [&](const ContactPoint& contact) { return surfaces_of(a, b, contact); };
  const std::size_t left = keep_best(
      std::span(scratch.points).subspan(first), scene.options, scene.policies.at(pair.policy).detail, surfaces, scratch,
      [](const ContactPoint&) { return true; },
      [&] { return scene.histories.subspan(pair.first_before, pair.count_before); });
  scratch.points.resize(first + left, ContactPoint{});
  if (scene.options.keeps_local_points) {
    const Pose &pose_a = scene.places.worlds[std::min(its.a, its.b)],
               &pose_b = scene.places.worlds[std::max(its.a, its.b)];
    scratch.locals.resize(first);
    for (const ContactPoint& contact : std::span(scratch.points).subspan(first)) {
      scratch.locals.push_back({pose_a.undo(contact.point_a), pose_b.undo(contact.point_b)});
    }
  }
  result.first = static_cast<std::uint32_t>(first);
  result.count = static_cast<std::uint32_t>(left);
}

}  // namespace

void SeamStage::find_sides(const SeamScene& scene, const JobList& jobs) {
  sides_.clear();
  const bool is_welded = scene.options.welds;
  const auto add = [&](std::uint32_t body, std::uint32_t part, std::uint32_t job) {
    const PlaceInfo& info = scene.places.infos[part];
    if (!info.is_dynamic && !(info.is_sensor && is_weldable_kind(info.kind))) {
      sides_.push_back({body, part, job});
    }
  };
  for (const Chunk& chunk : jobs.chunks()) {
    if (!is_pair_run(chunk.run)) {
      continue;
    }
    const bool is_row = is_part_at_seams(chunk.run / shape_kind_count, is_welded),
               is_column = is_part_at_seams(chunk.run % shape_kind_count, is_welded);
    for (std::uint32_t job = chunk.begin; (is_row || is_column) && job < chunk.end; ++job) {
      if (jobs.result(job).count == 0 || jobs.result(job).is_given) {
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

void SeamStage::run(const SeamScene& scene, JobList& jobs) {
  find_sides(scene, jobs);
  const auto is_other = [&](const Side& side) { return side.part != sides_.front().part; };
  if (sides_.empty() || std::ranges::none_of(sides_, is_other)) {
    return;
  }
  std::ranges::sort(sides_, {}, [](const Side& side) { return std::tie(side.body, side.part, side.job); });
  const Places& places = scene.places;
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
      seams.push_back({places.shapes[sides_[i].part],
                       places.worlds[sides_[i].part],
                       sides_[i].part > body,
                       {found.begin(), found.end()},
                       jobs.jobs()[sides_[i].job].margin});
    }
    settle_at_seams(seams, {*places.shapes[body], places.worlds[body]}, half_size_of(*places.shapes[body]));
    for (std::size_t i = begin; i < end; ++i) {
      const Seam& seam = seams[i - begin];
      const std::uint32_t low = std::min(body, sides_[i].part), high = std::max(body, sides_[i].part);
      if (seam.added.empty()) {
        keep(seam.contacts, places.worlds[low], places.worlds[high], jobs, jobs.result(sides_[i].job));
      } else {
        replace(seam, scene, sides_[i].job, jobs);
      }
    }
  }
}

}  // namespace abut
