// SPDX-License-Identifier: Apache-2.0
module abut.detect.lists.events;
import abut.capability;
import abut.core.standard;
import abut.core.workers;
import abut.detect.elements;
import abut.detect.pairs.contact_index;
import abut.detect.lists.contacts;
import abut.detect.pairs;
import abut.detect.lists.sleep;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.rest.sleep;

namespace abut {
namespace {

// Below this many pairs a task costs more than it saves.
constexpr std::size_t least_of_task = 8192;

std::pair<std::uint32_t, std::uint32_t> places_of(const Pair& pair) { return {pair.low, pair.high}; }

void write_event(EventKind kind, const Pair& pair, std::uint32_t flags, std::vector<Event>& out) {
  const bool is_end = kind == EventKind::end;
  out.push_back({.kind = kind,
                 .flags = flags,
                 .geometry_a = {pair.low + 1, pair.generation_low},
                 .geometry_b = {pair.high + 1, pair.generation_high},
                 .contact_id = 0,
                 .first_contact = is_end ? 0 : pair.first_contact,
                 .contact_count = is_end ? 0 : pair.contact_count});
}

// First those that are there, in their order, then those that are gone, in theirs.
// `first`: the place of the first one that is there, in its list.
void write_contact_events(const Pair& pair, std::uint32_t flags, bool with_persist,
                          std::span<const ContactHistory> before, std::span<const ContactHistory> present,
                          std::size_t first, ContactIndex& index, std::vector<Event>& out) {
  const auto write = [&](EventKind kind, std::uint64_t id, std::uint32_t place) {
    const bool is_end = kind == EventKind::end;
    out.push_back({.kind = kind,
                   .flags = flags,
                   .geometry_a = {pair.low + 1, pair.generation_low},
                   .geometry_b = {pair.high + 1, pair.generation_high},
                   .contact_id = id,
                   .first_contact = is_end ? 0 : place,
                   .contact_count = is_end ? 0u : 1u});
  };
  index.look_at(before);
  for (std::uint32_t i = 0; i < present.size(); ++i) {
    const std::uint64_t id = present[i].id;
    const bool is_new = pair.job != no_job && index.place_of(id, before) == no_index;
    if (is_new || with_persist) {
      write(is_new ? EventKind::begin : EventKind::persist, id, static_cast<std::uint32_t>(first + i));
    }
  }
  index.look_at(present);
  for (const ContactHistory& history : before) {
    if (index.place_of(history.id, present) == no_index) {
      write(EventKind::end, history.id, 0);
    }
  }
}

std::uint32_t flags_of(const Pair& pair, std::span<const PlaceInfo> infos, const SleepTable& sleep) {
  return (pair.is_sensor ? std::uint32_t{event_of_sensor} : 0) |
         (is_asleep(pair, infos, sleep) ? std::uint32_t{event_asleep} : 0);
}

// Of pairs in order, and of those that are lost among them.
void write_events(std::uint32_t wanted, std::span<const Pair> pairs, std::span<const Pair> lost,
                  std::span<const PlaceInfo> infos, const ContactList& contacts, const ElementStage& elements,
                  const SleepTable& sleep, ContactIndex& index, std::vector<Event>& out) {
  const bool with_pairs = (wanted & event_pairs) != 0, with_contacts = (wanted & event_contacts) != 0;
  const bool with_persist = (wanted & event_persist) != 0, with_elements = (wanted & event_elements) != 0;
  const auto write_contacts = [&](const Pair& pair, std::uint32_t flags) {
    write_contact_events(pair, flags | event_of_contact, with_persist, contacts.histories_before_of(pair),
                         contacts.histories_of(pair), pair.first_contact, index, out);
  };
  const auto write_elements = [&](const Pair& pair, std::uint32_t flags, bool is_lost) {
    const auto present = is_lost ? std::span<const ContactHistory>() : elements.histories_of(pair);
    write_contact_events(pair, flags | event_of_elements, with_persist, elements.histories_before_of(pair, is_lost),
                         present, elements.first_of(pair), index, out);
  };
  const auto end = [&](const Pair& pair) {
    Pair gone = pair;
    gone.is_touching = false;
    const std::uint32_t flags = flags_of(gone, infos, sleep);
    if (with_pairs) {
      write_event(EventKind::end, gone, flags, out);
    }
    if (with_contacts) {
      gone.first_before = std::exchange(gone.first_contact, 0);
      gone.count_before = std::exchange(gone.contact_count, 0);
      write_contacts(gone, flags);
    }
    if (with_elements) {
      write_elements(gone, flags, true);
    }
  };
  for (const Pair& pair : pairs) {
    while (!lost.empty() && places_of(lost.front()) <= places_of(pair)) {
      end(lost.front());
      lost = lost.subspan(1);
    }
    if (!pair.is_covered || !(pair.is_touching || pair.was_touching)) {
      continue;
    }
    const EventKind kind = !pair.is_touching    ? EventKind::end
                           : !pair.was_touching ? EventKind::begin
                                                : EventKind::persist;
    const bool is_written = with_pairs && (kind != EventKind::persist || with_persist);
    if (!is_written && !with_contacts && !with_elements) {
      continue;
    }
    const std::uint32_t flags = flags_of(pair, infos, sleep);
    if (is_written) {
      write_event(kind, pair, flags, out);
    }
    if (with_contacts) {
      write_contacts(pair, flags);
    }
    if (with_elements) {
      write_elements(pair, flags, false);
    }
  }
  std::ranges::for_each(lost, end);
}

}  // namespace

// Each task writes a list, and they are put behind each other.
void EventList::collect(const Workers& workers, std::uint32_t wanted, const PairStore& store,
                        std::span<const PlaceInfo> infos, const ContactList& contacts, const ElementStage& elements,
                        const SleepTable& sleep) {
  events_.clear();
  const std::span<const Pair> pairs = store.all(), lost = store.lost();
  const Cuts cuts = workers.cut(pairs.size(), least_of_task);
  tasks_.resize(std::max(tasks_.size(), cuts.tasks()));
  if (cuts.tasks() == 1) {
    write_events(wanted, pairs, lost, infos, contacts, elements, sleep, tasks_.front().index, events_);
    return;
  }
  const auto lost_at = [&](std::size_t task) {
    if (task == 0 || task == cuts.tasks()) {
      return task == 0 ? 0 : lost.size();
    }
    const auto is_before = [](const Pair& a, const Pair& b) { return places_of(a) < places_of(b); };
    return static_cast<std::size_t>(std::lower_bound(lost.begin(), lost.end(), pairs[cuts.begin(task)], is_before) -
                                    lost.begin());
  };
  workers.for_each(cuts.tasks(), [&](std::size_t task) {
    const std::size_t begin = lost_at(task), end = lost_at(task + 1);
    tasks_[task].events.clear();
    write_events(wanted, cuts.of(pairs, task), lost.subspan(begin, end - begin), infos, contacts, elements, sleep,
                 tasks_[task].index, tasks_[task].events);
  });
  std::size_t total = 0;
  for (Task& task : std::span(tasks_).first(cuts.tasks())) {
    task.first = std::exchange(total, total + task.events.size());
  }
  events_.resize(total);
  workers.for_each(cuts.tasks(), [&](std::size_t task) {
    std::ranges::copy(tasks_[task].events, events_.begin() + static_cast<std::ptrdiff_t>(tasks_[task].first));
  });
}

std::size_t EventList::bytes() const {
  std::size_t sum = events_.capacity() * sizeof(Event) + tasks_.capacity() * sizeof(Task);
  for (const Task& task : tasks_) {
    sum += task.events.capacity() * sizeof(Event) + task.index.bytes();
  }
  return sum;
}

}  // namespace abut
