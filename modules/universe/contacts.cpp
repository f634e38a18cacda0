// A detection: from pairs to contacts.
module abut.universe;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.manifold;
import abut.pairs.any_shape;
import abut.pairs.registry.self_contacts;
import abut.pairs.registry;
import abut.pairs.table;
import abut.universe.jobs;
import abut.universe.pairs;
import abut.universe.policies;
import abut.universe.stopwatch;

namespace abut {
namespace {

// Fewer pairs are looked at faster than a thread is called.
constexpr std::size_t least_of_task = 1024;
// Contacts are fetched from memory so many pairs before they are written, and where they lie before that.
constexpr std::size_t pairs_ahead = 8, results_ahead = 16;

// Of a pair whose job is done and whose contacts are not in the list yet.
JobResult result_of(const Pair& pair) { return {pair.job, pair.first_contact, pair.contact_count}; }

// Without a tolerance touching counts; otherwise an overlap has to exceed the dead band, or a
// separation to be below the margin.
bool is_reported(Real distance, Real margin) { return margin == 0 ? distance <= 0 : distance < margin; }

// What belongs to the contacts of pairs that were not examined goes to where it belongs, within the list: a second one
// would hold as much again. The order stays, so that what goes down, first to last, and what goes up, last to first,
// runs over nothing that has yet to go.
template <class Value>
void move_kept(std::span<const Pair> pairs, std::span<Value> list) {
  const auto before_of = [&](const Pair& pair) { return list.subspan(pair.first_before, pair.contact_count); };
  const auto after_of = [&](const Pair& pair) { return list.subspan(pair.first_contact, pair.contact_count); };
  for (const Pair& pair : pairs) {
    if (pair.job == no_job && pair.first_contact < pair.first_before) {
      std::ranges::copy(before_of(pair), after_of(pair).begin());
    }
  }
  for (std::size_t place = pairs.size(); place-- > 0;) {
    const Pair& pair = pairs[place];
    if (pair.job == no_job && pair.first_contact > pair.first_before) {
      const std::span<Value> before = before_of(pair);
      std::move_backward(before.begin(), before.end(), after_of(pair).end());
    }
  }
}

}  // namespace

// Keeps of the points of a job what is reported, reduced and moved to the world. Jobs come in the order of kinds, so
// that whatever it reads of its pair is far away in memory: only reductions, which are rare, look there.
void Universe::finish_job(std::size_t job, std::uint32_t chunk, std::size_t first, std::size_t count) {
  ChunkScratch& scratch = jobs_.scratch(chunk);
  const PairJob& its = jobs_.jobs()[job];
  const std::span<ContactPoint> found = std::span(scratch.points).subspan(first, count);
  const auto reported = [&](const ContactPoint& contact) { return is_reported(contact.distance, its.margin); };
  const auto kept = static_cast<std::size_t>(std::partition(found.begin(), found.end(), reported) - found.begin());
  scratch.ids.clear();
  if (options_.max_contacts != 0 && kept > options_.max_contacts) {
    const Pair& pair = pairs_.all()[jobs_.pair_of(job)];
    for (const ContactHistory& history : std::span(histories_).subspan(pair.first_before, pair.count_before)) {
      scratch.ids.push_back(history.id);
    }
  }
  std::size_t left = reduce_children(found.first(kept), options_.max_contacts, scratch.ids);
  left = cap(found.first(left), options_.max_pair_contacts);
  left = policies_.at(jobs_.chunks()[chunk].policy).detail == Detail::point ? std::min<std::size_t>(left, 1) : left;
  const bool is_swapped = its.a > its.b;
  for (ContactPoint& contact : found.first(left)) {
    move_by(contact, worlds_[its.a], is_swapped);
  }
  if (options_.keeps_local_points) {
    const Pose &a = worlds_[is_swapped ? its.b : its.a], &b = worlds_[is_swapped ? its.a : its.b];
    scratch.locals.resize(scratch.points.size());
    for (std::size_t i = 0; i < left; ++i) {
      scratch.locals[first + i] = {a.undo(found[i].point_a), b.undo(found[i].point_b)};
    }
  }
  jobs_.result(job) = {chunk, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(left)};
}

void Universe::find_contacts_of_chunk(std::size_t number) {
  const Chunk& chunk = jobs_.chunks()[number];
  ChunkScratch& scratch = jobs_.scratch(number);
  const std::span<const PairJob> jobs = jobs_.jobs().subspan(chunk.begin, chunk.end - chunk.begin);
  const Policy& policy = policies_.at(chunk.policy);
  const QuerySettings settings{.algorithm = policy.algorithm, .error_bound = policy.error_bound};
  scratch.points.clear();
  scratch.results.resize(jobs.size());
  const auto run = [&](std::span<const PairJob> some, const QuerySettings& its, std::span<PairResult> results) {
    if (is_self_run(chunk.run)) {
      self_contacts_of_run(shapes_, some, its, scratch.points, results);
    } else {
      const auto& kernels = pair_kernels(chunk.run / shape_kind_count, chunk.run % shape_kind_count);
      contacts_of_run<AnyShape>(kernels, shapes_, worlds_, some, its, pairs_.memories(), scratch.points, results);
    }
  };
  run(jobs, settings, scratch.results);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    std::size_t end = scratch.results[i].contacts_end;
    const std::size_t next = end;
    if (scratch.results[i].outcome != Outcome::ok) {
      // The pair does not have the algorithm of the policy, or that gave up.
      begin = scratch.points.size();
      run(jobs.subspan(i, 1), QuerySettings{}, std::span(scratch.results).subspan(i, 1));
      end = scratch.points.size();
    }
    finish_job(chunk.begin + i, static_cast<std::uint32_t>(number), begin, end - begin);
    begin = next;
  }
}

// In runs of equal kinds, each pair in the frame of its first shape.
void Universe::find_contacts() {
  const bool is_timed = are_pairs_timed_.load(std::memory_order_relaxed);
  workers_.for_each(jobs_.chunks().size(), [&](std::size_t chunk) {
    Stopwatch watch(is_timed);
    find_contacts_of_chunk(chunk);
    jobs_.scratch(chunk).microseconds = watch.lap();
  });
}

// What the chunks took, to the tallies of their runs.
void Universe::time_kinds() {
  for (std::size_t chunk = 0; chunk < jobs_.chunks().size(); ++chunk) {
    KindTally& tally = tallies_[jobs_.chunks()[chunk].run];
    tally.microseconds += jobs_.scratch(chunk).microseconds;
    tally.is_timed = true;
  }
}

// What a pair has found. What it has kept is there already.
void Universe::write_contacts_of(const Pair& pair, std::span<const ContactPoint> found) {
  const std::span<const ContactHistory> before =
      std::span(histories_before_).subspan(pair.first_before, pair.count_before);
  const std::span<ContactHistory> histories = std::span(histories_).subspan(pair.first_contact, pair.contact_count);
  const std::span<Contact> out = std::span(contacts_).subspan(pair.first_contact, pair.contact_count);
  if (pair.job == no_job) {
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].age += pair.is_covered ? 1 : 0;
      histories[i] = {out[i].point.id, out[i].user_data, out[i].age};
    }
    return;
  }
  const PlaceInfo &low = infos_[pair.low], &high = infos_[pair.high];
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto same = std::ranges::find(before, found[i].id, &ContactHistory::id);
    const bool is_kept = same != before.end();
    histories[i] = {found[i].id, is_kept ? same->user_data : 0, is_kept ? same->age + 1 : 0};
    out[i] = {.geometry_a = {pair.low + 1, pair.generation_low},
              .geometry_b = {pair.high + 1, pair.generation_high},
              .point = found[i],
              .flags = pair.is_sensor ? std::uint32_t{contact_of_sensor} : 0,
              .age = histories[i].age,
              .user_data = histories[i].user_data,
              .material_a = low.material,
              .material_b = high.material};
  }
}

// What the pairs from begin to end have come to.
void Universe::count_contacts(std::size_t begin, std::size_t end, ContactTask& out) {
  const std::span<Pair> pairs = pairs_.all();
  ContactTask task;
  for (std::size_t place = begin; place < end; ++place) {
    Pair& pair = pairs[place];
    if (const std::size_t ahead = place + results_ahead; ahead < end && pairs[ahead].job != no_job) {
      jobs_.fetch_result(pairs[ahead].job);
    }
    if (pair.job != no_job) {
      const JobResult its = jobs_.result(pair.job);
      pair.job = its.chunk;
      pair.first_contact = its.first;
      pair.contact_count = its.count;
      pair.is_touching = its.count > 0;
    }
    task.kept += pair.job == no_job ? pair.contact_count : 0;
    const bool is_candidate = pair.is_admitted && (pair.is_supported || pair.is_touching);
    KindTally& tally = task.tallies[pair.run];
    tally.candidates += pair.is_admitted ? 1 : 0;
    tally.examined += pair.job != no_job ? 1 : 0;
    tally.touching += pair.is_touching ? 1 : 0;
    tally.contacts += pair.contact_count;
    task.contacts += pair.contact_count;
    task.candidates += is_candidate ? 1 : 0;
    task.filtered += pair.is_admitted ? 0 : 1;
    task.unsupported += pair.is_admitted && !is_candidate ? 1 : 0;
    task.touching += pair.is_touching ? 1 : 0;
  }
  out = task;
}

void Universe::write_contacts(std::size_t begin, std::size_t end, std::uint32_t first_contact) {
  const std::span<Pair> pairs = pairs_.all();
  for (std::size_t place = begin; place < end; ++place) {
    if (const std::size_t ahead = place + pairs_ahead; ahead < end && pairs[ahead].job != no_job) {
      jobs_.fetch_found(result_of(pairs[ahead]));
    }
    Pair& pair = pairs[place];
    const JobResult its = result_of(pair);
    pair.first_contact = first_contact;
    first_contact += pair.contact_count;
    if (pair.contact_count > 0) {
      write_contacts_of(pair, pair.job != no_job ? jobs_.found(its) : std::span<const ContactPoint>());
    }
    if (options_.keeps_local_points && pair.job != no_job) {
      std::ranges::copy(jobs_.locals(its), locals_.begin() + static_cast<std::ptrdiff_t>(pair.first_contact));
    }
  }
}

// What the pairs that were not examined have kept moves to its place among the contacts of this detection.
void Universe::move_kept_contacts() {
  const std::span<Pair> pairs = pairs_.all();
  std::uint32_t next = 0;
  for (Pair& pair : pairs) {
    const std::uint32_t first = std::exchange(next, next + pair.contact_count);
    pair.first_contact = pair.job == no_job ? first : pair.first_contact;
  }
  move_kept<Contact>(pairs, contacts_);
  if (options_.keeps_local_points) {
    move_kept<LocalPoints>(pairs, locals_);
  }
}

// Room for so many contacts and, as their number changes from step to step, for some more: a list that grows is there
// twice.
void Universe::make_room_for_contacts(std::size_t count) {
  constexpr std::size_t share_more = 8;
  if (contacts_.capacity() < count) {
    contacts_.reserve(count + count / share_more);
  }
}

// Contacts in the order of the pairs: counts first, then all pairs at once.
void Universe::collect_contacts() {
  histories_before_.swap(histories_);
  const Cuts cuts = workers_.cut(pairs_.all().size(), least_of_task);
  contact_tasks_.resize(std::max(contact_tasks_.size(), cuts.tasks()));
  const std::span<ContactTask> tasks = std::span(contact_tasks_).first(cuts.tasks());
  workers_.for_each(cuts.tasks(),
                    [&](std::size_t task) { count_contacts(cuts.begin(task), cuts.end(task), tasks[task]); });
  tallies_.fill({});
  stats_.candidate_pairs = stats_.filtered_pairs = stats_.unsupported_pairs = stats_.touching_pairs = 0;
  std::uint32_t total = 0, kept = 0;
  for (ContactTask& task : tasks) {
    for (std::size_t run = 0; run < run_count; ++run) {
      tallies_[run] += task.tallies[run];
    }
    stats_.candidate_pairs += task.candidates;
    stats_.filtered_pairs += task.filtered;
    stats_.unsupported_pairs += task.unsupported;
    stats_.touching_pairs += task.touching;
    task.first_contact = std::exchange(total, total + task.contacts);
    kept += task.kept;
  }
  if (are_pairs_timed_.load(std::memory_order_relaxed)) {
    time_kinds();
  }
  make_room_for_contacts(total);
  if (kept > 0) {
    contacts_.resize(std::max<std::size_t>(contacts_.size(), total));
    locals_.resize(options_.keeps_local_points ? contacts_.size() : 0);
    move_kept_contacts();
  }
  contacts_.resize(total);
  locals_.resize(options_.keeps_local_points ? total : 0);
  histories_.resize(total);
  workers_.for_each(cuts.tasks(), [&](std::size_t task) {
    write_contacts(cuts.begin(task), cuts.end(task), tasks[task].first_contact);
  });
}

Result<void> Universe::set_contact_user_data(std::span<const std::uint64_t> user_data) {
  if (user_data.size() != contacts_.size()) {
    return error_about(Errc::invalid_argument, "count", static_cast<std::uint64_t>(user_data.size()),
                       std::to_string(contacts_.size()) + ", one for each contact");
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    contacts_[i].user_data = histories_[i].user_data = user_data[i];
  }
  return {};
}

}  // namespace abut
