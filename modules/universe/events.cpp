// What began, persists and ended in a detection.
module abut.universe;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.universe.pairs;

namespace abut {
namespace {

// Fewer pairs are looked at faster than a thread is called.
constexpr std::size_t least_of_task = 8192;

std::pair<std::uint32_t, std::uint32_t> places_of(const Pair& pair) { return {pair.low, pair.high}; }

bool has(std::span<const ContactHistory> contacts, std::uint64_t id) {
  return std::ranges::find(contacts, id, &ContactHistory::id) != contacts.end();
}

// A chain of words, each of which changes all bits that follow.
class Hash {
 public:
  void add(std::uint64_t word) { state_ = mixed(state_ ^ word); }
  void add(std::uint32_t low, std::uint32_t high) { add((std::uint64_t{high} << 32) | low); }
  void add(Real value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const Vec3& v) {
    add(v.x);
    add(v.y);
    add(v.z);
  }
  // Slots say which geometries they are; generations differ from universe to universe.
  void add(const GeometryId& a, const GeometryId& b) { add(a.slot, b.slot); }
  void add(const Feature& feature) { add(static_cast<std::uint32_t>(feature.kind), feature.index); }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace

std::uint32_t Universe::event_flags_of(const Pair& pair) const {
  return (pair.is_sensor ? std::uint32_t{event_of_sensor} : 0) | (is_asleep(pair) ? std::uint32_t{event_asleep} : 0);
}

void Universe::write_event(EventKind kind, const Pair& pair, std::vector<Event>& out) const {
  const bool is_end = kind == EventKind::end;
  out.push_back({.kind = kind,
                 .flags = event_flags_of(pair),
                 .geometry_a = {pair.low + 1, pair.generation_low},
                 .geometry_b = {pair.high + 1, pair.generation_high},
                 .contact_id = 0,
                 .first_contact = is_end ? 0 : pair.first_contact,
                 .contact_count = is_end ? 0 : pair.contact_count});
}

// First those that are there, in their order, then those that are gone, in theirs.
void Universe::write_contact_events(const Pair& pair, std::vector<Event>& out) const {
  const std::span<const ContactHistory> before =
      std::span(histories_before_).subspan(pair.first_before, pair.count_before);
  const std::span<const ContactHistory> present = std::span(histories_).subspan(pair.first_contact, pair.contact_count);
  const std::uint32_t flags = std::uint32_t{event_of_contact} | event_flags_of(pair);
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
  for (std::uint32_t i = 0; i < present.size(); ++i) {
    const std::uint64_t id = present[i].id;
    const bool is_new = pair.job != no_job && !has(before, id);
    if (is_new || (options_.events & event_persist) != 0) {
      write(is_new ? EventKind::begin : EventKind::persist, id, pair.first_contact + i);
    }
  }
  for (const ContactHistory& history : before) {
    if (!has(present, history.id)) {
      write(EventKind::end, history.id, 0);
    }
  }
}

// Of pairs in order, and of those that are lost among them.
void Universe::write_events(std::span<const Pair> pairs, std::span<const Pair> lost, std::vector<Event>& out) const {
  const bool with_contacts = (options_.events & event_contacts) != 0,
             with_persist = (options_.events & event_persist) != 0;
  const bool with_pairs = (options_.events & event_pairs) != 0;
  const auto end = [&](const Pair& pair) {
    Pair gone = pair;
    gone.is_touching = false;
    if (with_pairs) {
      write_event(EventKind::end, gone, out);
    }
    if (with_contacts) {
      gone.first_before = std::exchange(gone.first_contact, 0);
      gone.count_before = std::exchange(gone.contact_count, 0);
      write_contact_events(gone, out);
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
    if (with_pairs && (kind != EventKind::persist || with_persist)) {
      write_event(kind, pair, out);
    }
    if (with_contacts) {
      write_contact_events(pair, out);
    }
  }
  std::ranges::for_each(lost, end);
}

// Each task writes a list, and they are put behind each other.
void Universe::collect_events() {
  events_.clear();
  const std::span<const Pair> pairs = pairs_.all(), lost = pairs_.lost();
  const Cuts cuts = workers_.cut(pairs.size(), least_of_task);
  if (cuts.tasks() == 1) {
    write_events(pairs, lost, events_);
    return;
  }
  event_tasks_.resize(std::max(event_tasks_.size(), cuts.tasks()));
  const auto lost_at = [&](std::size_t task) {
    if (task == 0 || task == cuts.tasks()) {
      return task == 0 ? 0 : lost.size();
    }
    const auto is_before = [](const Pair& a, const Pair& b) { return places_of(a) < places_of(b); };
    return static_cast<std::size_t>(std::lower_bound(lost.begin(), lost.end(), pairs[cuts.begin(task)], is_before) -
                                    lost.begin());
  };
  workers_.for_each(cuts.tasks(), [&](std::size_t task) {
    const std::size_t begin = lost_at(task), end = lost_at(task + 1);
    event_tasks_[task].events.clear();
    write_events(cuts.of(pairs, task), lost.subspan(begin, end - begin), event_tasks_[task].events);
  });
  std::size_t total = 0;
  for (EventTask& task : std::span(event_tasks_).first(cuts.tasks())) {
    task.first = std::exchange(total, total + task.events.size());
  }
  events_.resize(total);
  workers_.for_each(cuts.tasks(), [&](std::size_t task) {
    std::ranges::copy(event_tasks_[task].events,
                      events_.begin() + static_cast<std::ptrdiff_t>(event_tasks_[task].first));
  });
}

std::uint64_t Universe::hash() const {
  Hash hash;
  hash.add(std::uint64_t{contacts_.size()});
  for (const Contact& contact : contacts_) {
    hash.add(contact.geometry_a, contact.geometry_b);
    hash.add(contact.point.point_a);
    hash.add(contact.point.point_b);
    hash.add(contact.point.normal);
    hash.add(contact.point.distance);
    hash.add(contact.point.feature_a);
    hash.add(contact.point.feature_b);
    hash.add(contact.point.id);
    hash.add(contact.point.child_a, contact.point.child_b);
    hash.add(contact.flags, contact.age);
    hash.add(contact.user_data);
    hash.add(contact.material_a, contact.material_b);
  }
  for (const LocalPoints& points : locals_) {
    hash.add(points.a);
    hash.add(points.b);
  }
  hash.add(std::uint64_t{events_.size()});
  for (const Event& event : events_) {
    hash.add(static_cast<std::uint32_t>(event.kind), event.flags);
    hash.add(event.geometry_a, event.geometry_b);
    hash.add(event.contact_id);
    hash.add(event.first_contact, event.contact_count);
  }
  for (const SleepChange& change : sleep_.changes()) {
    hash.add(change.part.slot, change.is_asleep ? 1 : 0);
  }
  return hash.value();
}

}  // namespace abut
