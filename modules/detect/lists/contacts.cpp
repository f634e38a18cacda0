// SPDX-License-Identifier: Apache-2.0
module abut.detect.lists.contacts;
import abut.capability;
import abut.core.standard;
import abut.core.workers;
import abut.core;
import abut.math;
import abut.detect.pairs.contact_index;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.pairs.any_shape;
import abut.scene.state.options;
import abut.scene.state.places;

namespace abut {
namespace {

// Below this many pairs a task costs more than it saves.
constexpr std::size_t least_of_task = 1024;
// Contacts are fetched from memory so many pairs before they are written, and where they lie before that.
constexpr std::size_t pairs_ahead = 8, results_ahead = 16;

// Of a pair whose job is done and whose contacts are not in the list yet.
JobResult result_of(const Pair& pair) { return {pair.job, pair.first_contact, pair.contact_count}; }

// Of a child that has one of its own, else of its geometry.
std::uint32_t material_of(std::span<const std::uint32_t> of_children, std::uint32_t child, std::uint32_t of_geometry) {
  return child < of_children.size() && of_children[child] != 0 ? of_children[child] : of_geometry;
}

// What belongs to the contacts of pairs that were not examined goes to where it belongs, within the list: a second one
// would hold as much again. The order stays. What goes down moves first to last, what goes up last to first, so
// that nothing is written over before it has gone.
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

// What a pair has found. What it has kept is there already.
void ContactList::write_pair(const Pair& pair, std::span<const ContactPoint> found, const Places& places,
                             ContactIndex& index) {
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
  const PlaceInfo &low = places.infos[pair.low], &high = places.infos[pair.high];
  const std::span<const std::uint32_t> of_low = materials_of_children(*places.shapes[pair.low]),
                                       of_high = materials_of_children(*places.shapes[pair.high]);
  index.look_at(before);
  for (std::size_t i = 0; i < found.size(); ++i) {
    index.expect(found[std::min(i + results_ahead, found.size() - 1)].id);
    const std::uint32_t same = index.place_of(found[i].id, before);
    const bool is_kept = same != no_index;
    histories[i] = {found[i].id, is_kept ? before[same].user_data : 0, is_kept ? before[same].age + 1 : 0};
    out[i] = {.geometry_a = {pair.low + 1, pair.generation_low},
              .geometry_b = {pair.high + 1, pair.generation_high},
              .point = found[i],
              .flags = pair.is_sensor ? std::uint32_t{contact_of_sensor} : 0,
              .age = histories[i].age,
              .user_data = histories[i].user_data,
              .material_a = material_of(of_low, found[i].child_a, low.material),
              .material_b = material_of(of_high, found[i].child_b, high.material)};
  }
}

// What the pairs from begin to end have come to.
void ContactList::count(std::size_t begin, std::size_t end, const JobList& jobs, std::span<Pair> pairs, Task& out) {
  Task task;
  for (std::size_t place = begin; place < end; ++place) {
    Pair& pair = pairs[place];
    if (const std::size_t ahead = place + results_ahead; ahead < end && pairs[ahead].job != no_job) {
      jobs.fetch_result(pairs[ahead].job);
    }
    if (pair.job != no_job) {
      const JobResult its = jobs.result(pair.job);
      pair.job = its.chunk;
      pair.first_contact = its.first;
      pair.contact_count = its.count;
      pair.is_touching = its.count > 0 || its.is_touching;
    }
    task.kept += pair.job == no_job ? pair.contact_count : 0;
    const bool is_candidate = pair.is_admitted && (pair.is_supported || pair.is_touching);
    const std::uint32_t touching = pair.is_touching ? 1 : 0;
    KindTally& tally = task.tallies[pair.run];
    tally.candidates += pair.is_admitted ? 1 : 0;
    tally.examined += pair.job != no_job ? 1 : 0;
    tally.touching += touching;
    tally.contacts += pair.contact_count;
    task.contacts += pair.contact_count;
    task.candidates += is_candidate ? 1 : 0;
    task.filtered += pair.is_admitted ? 0 : 1;
    task.unsupported += pair.is_admitted && !is_candidate ? 1 : 0;
    task.touching += touching;
  }
  out = task;
}

void ContactList::write(std::size_t begin, std::size_t end, std::uint32_t first_contact, const JobList& jobs,
                        const Places& places, std::span<Pair> pairs, ContactIndex& index) {
  for (std::size_t place = begin; place < end; ++place) {
    if (const std::size_t ahead = place + pairs_ahead; ahead < end && pairs[ahead].job != no_job) {
      jobs.fetch_found(result_of(pairs[ahead]));
    }
    Pair& pair = pairs[place];
    const JobResult its = result_of(pair);
    pair.first_contact = first_contact;
    first_contact += pair.contact_count;
    if (pair.contact_count > 0) {
      write_pair(pair, pair.job != no_job ? jobs.found(its) : std::span<const ContactPoint>(), places, index);
    }
    if (keeps_local_points_ && pair.job != no_job) {
      std::ranges::copy(jobs.locals(its), locals_.begin() + static_cast<std::ptrdiff_t>(pair.first_contact));
    }
  }
}

// What the pairs that were not examined have kept moves to its place among the contacts of this detection.
void ContactList::move_all_kept(std::span<Pair> pairs) {
  std::uint32_t next = 0;
  for (Pair& pair : pairs) {
    const std::uint32_t first = std::exchange(next, next + pair.contact_count);
    pair.first_contact = pair.job == no_job ? first : pair.first_contact;
  }
  move_kept<Contact>(pairs, contacts_);
  if (keeps_local_points_) {
    move_kept<LocalPoints>(pairs, locals_);
  }
}

// What the chunks took, to the tallies of their runs.
void ContactList::time_kinds(const JobList& jobs) {
  for (std::size_t chunk = 0; chunk < jobs.chunks().size(); ++chunk) {
    const std::size_t run = jobs.chunks()[chunk].run;
    if (run >= path_run) {
      continue;
    }
    KindTally& tally = tallies_[run];
    tally.microseconds += jobs.scratch(chunk).microseconds;
    tally.is_timed = true;
  }
}

// Room for so many contacts and, as their number changes from step to step, for some more: a list that grows is there
// twice.
void ContactList::make_room(std::size_t count) {
  constexpr std::size_t share_more = 8;
  if (contacts_.capacity() < count) {
    contacts_.reserve(count + count / share_more);
  }
}

// Contacts in the order of the pairs: counts first, then all pairs at once.
ContactCounts ContactList::collect(const Workers& workers, const Places& places, bool is_timed, const JobList& jobs,
                                   std::span<Pair> pairs) {
  histories_before_.swap(histories_);
  const Cuts cuts = workers.cut(pairs.size(), least_of_task);
  tasks_.resize(std::max(tasks_.size(), cuts.tasks()));
  indices_.resize(tasks_.size());
  const std::span<Task> tasks = std::span(tasks_).first(cuts.tasks());
  workers.for_each(cuts.tasks(),
                   [&](std::size_t task) { count(cuts.begin(task), cuts.end(task), jobs, pairs, tasks[task]); });
  tallies_.fill({});
  ContactCounts sum;
  std::uint32_t total = 0, kept = 0;
  for (Task& task : tasks) {
    for (std::size_t run = 0; run < run_count; ++run) {
      tallies_[run] += task.tallies[run];
    }
    sum.candidates += task.candidates;
    sum.filtered += task.filtered;
    sum.unsupported += task.unsupported;
    sum.touching += task.touching;
    task.first_contact = std::exchange(total, total + task.contacts);
    kept += task.kept;
  }
  if (is_timed) {
    time_kinds(jobs);
  }
  make_room(total);
  if (kept > 0) {
    contacts_.resize(std::max<std::size_t>(contacts_.size(), total));
    locals_.resize(keeps_local_points_ ? contacts_.size() : 0);
    move_all_kept(pairs);
  }
  contacts_.resize(total);
  locals_.resize(keeps_local_points_ ? total : 0);
  histories_.resize(total);
  workers.for_each(cuts.tasks(), [&](std::size_t task) {
    write(cuts.begin(task), cuts.end(task), tasks[task].first_contact, jobs, places, pairs, std::span(indices_)[task]);
  });
  return sum;
}

void ContactList::mark_ahead(std::uint32_t first, std::uint32_t count, Real toi, Real touching) {
  for (Contact& contact : std::span(contacts_).subspan(first, count)) {
    contact.toi = toi;
    contact.flags |= toi > 0 || contact.point.distance > touching ? std::uint32_t{contact_speculative} : 0;
  }
}

void ContactList::restore(std::vector<Contact> contacts, std::vector<LocalPoints> locals) {
  contacts_ = std::move(contacts);
  locals_ = std::move(locals);
  histories_.reserve(contacts_.size());
  for (const Contact& contact : contacts_) {
    histories_.push_back({contact.point.id, contact.user_data, contact.age});
  }
}

Result<void> ContactList::set_user_data(std::span<const std::uint64_t> user_data) {
  if (user_data.size() != contacts_.size()) {
    return error_about(Errc::invalid_argument, "count", static_cast<std::uint64_t>(user_data.size()),
                       std::to_string(contacts_.size()) + ", one for each contact");
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    contacts_[i].user_data = histories_[i].user_data = user_data[i];
  }
  return {};
}

std::size_t ContactList::bytes() const {
  std::size_t bytes_of_indices = 0;
  for (const ContactIndex& index : indices_) {
    bytes_of_indices += sizeof(ContactIndex) + index.bytes();
  }
  return contacts_.capacity() * sizeof(Contact) + locals_.capacity() * sizeof(LocalPoints) +
         (histories_.capacity() + histories_before_.capacity()) * sizeof(ContactHistory) +
         tasks_.capacity() * sizeof(Task) + bytes_of_indices;
}

}  // namespace abut
