// A detection: from pairs to contacts.
module abut.universe;
import abut.any_shape;
import abut.contact;
import abut.core;
import abut.core.standard;
import abut.dispatch;
import abut.math;
import abut.registry;
import abut.shape;
import abut.universe.jobs;
import abut.universe.pairs;
import abut.universe.policies;

namespace abut {
namespace {

// Pairs that a thread takes at once.
constexpr std::size_t block_size = 256;
// Contacts are fetched from memory so many pairs before they are written.
constexpr std::size_t pairs_ahead = 8;

// Without a tolerance touching counts; otherwise an overlap has to exceed the dead band, or a
// separation to be below the margin.
bool is_reported(Real distance, Real margin) { return margin == 0 ? distance <= 0 : distance < margin; }

}  // namespace

// Keeps of the points of a job what is reported, reduced and moved to the world. Jobs come in the order of kinds, so that
// whatever it reads of its pair is far away in memory: only reductions, which are rare, look there.
void Universe::finish_job(std::size_t job, std::uint32_t chunk, std::size_t first, std::size_t count) {
  ChunkScratch& scratch = jobs_.scratch(chunk);
  const PairJob& its = jobs_.jobs()[job];
  const std::uint32_t place = jobs_.pair_of(job);
  const std::span<ContactPoint> found = std::span(scratch.points).subspan(first, count);
  const auto reported = [&](const ContactPoint& contact) { return is_reported(contact.distance, its.margin); };
  const auto kept = static_cast<std::size_t>(std::partition(found.begin(), found.end(), reported) - found.begin());
  scratch.ids.clear();
  if (options_.max_contacts != 0 && kept > options_.max_contacts) {
    const Pair& pair = pairs_.all()[place];
    for (const ContactHistory& history : std::span(histories_).subspan(pair.first_before, pair.count_before)) {
      scratch.ids.push_back(history.id);
    }
  }
  std::size_t left = reduce_children(found.first(kept), options_.max_contacts, scratch.ids);
  left = policies_.at(jobs_.chunks()[chunk].policy).detail == Detail::point ? std::min<std::size_t>(left, 1) : left;
  const bool is_swapped = its.a > its.b;
  for (ContactPoint& contact : found.first(left)) {
    move_by(contact, worlds_[its.a], is_swapped);
  }
  jobs_.result(place) = {chunk, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(left)};
}

void Universe::find_contacts_of_chunk(std::size_t number) {
  const Chunk& chunk = jobs_.chunks()[number];
  ChunkScratch& scratch = jobs_.scratch(number);
  const std::span<const PairJob> jobs = jobs_.jobs().subspan(chunk.begin, chunk.end - chunk.begin);
  const auto& kernels = pair_kernels(chunk.run / shape_kind_count, chunk.run % shape_kind_count);
  const Policy& policy = policies_.at(chunk.policy);
  const QuerySettings settings{.algorithm = policy.algorithm, .error_bound = policy.error_bound};
  scratch.points.clear();
  scratch.results.resize(jobs.size());
  const std::span<PairMemory> memories = pairs_.memories();
  kernels.contacts_of_run(shapes_, worlds_, jobs, settings, memories, scratch.points, scratch.results);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    std::size_t end = scratch.results[i].contacts_end;
    const std::size_t next = end;
    if (scratch.results[i].outcome != Outcome::ok) {
      // The pair does not have the algorithm of the policy, or that gave up.
      begin = scratch.points.size();
      kernels.contacts_of_run(shapes_, worlds_, jobs.subspan(i, 1), QuerySettings{}, memories, scratch.points,
                              std::span(scratch.results).subspan(i, 1));
      end = scratch.points.size();
    }
    finish_job(chunk.begin + i, static_cast<std::uint32_t>(number), begin, end - begin);
    begin = next;
  }
}

// In runs of equal kinds, each pair in the frame of its first shape.
void Universe::find_contacts() {
  workers_.for_each(jobs_.chunks().size(), [&](std::size_t chunk) { find_contacts_of_chunk(chunk); });
}

// What the pair at a place has found, or what it had.
void Universe::write_contacts_of(std::size_t place) {
  const Pair& pair = pairs_.all()[place];
  const std::span<const ContactHistory> before = std::span(histories_before_).subspan(pair.first_before, pair.count_before);
  const std::span<ContactHistory> histories = std::span(histories_).subspan(pair.first_contact, pair.contact_count);
  const std::span<Contact> out = std::span(contacts_).subspan(pair.first_contact, pair.contact_count);
  if (pair.job == no_job) {
    std::ranges::copy(std::span(contacts_before_).subspan(pair.first_before, pair.count_before), out.begin());
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].age += pair.is_covered ? 1 : 0;
      histories[i] = {before[i].id, before[i].user_data, out[i].age};
    }
    return;
  }
  const PlaceInfo &low = infos_[pair.low], &high = infos_[pair.high];
  const std::span<const ContactPoint> found = jobs_.found_by(place);
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

// Contacts in the order of the pairs: counts first, then all pairs at once.
void Universe::collect_contacts() {
  contacts_before_.swap(contacts_);
  histories_before_.swap(histories_);
  tallies_.fill({});
  stats_.candidate_pairs = stats_.filtered_pairs = stats_.unsupported_pairs = stats_.touching_pairs = 0;
  std::uint32_t total = 0;
  const std::span<Pair> pairs = pairs_.all();
  for (std::size_t place = 0; place < pairs.size(); ++place) {
    Pair& pair = pairs[place];
    if (pair.job != no_job) {
      pair.contact_count = jobs_.result(place).count;
      pair.is_touching = pair.contact_count > 0;
    }
    pair.first_contact = total;
    total += pair.contact_count;
    const bool is_candidate = pair.is_admitted && (pair.is_supported || pair.is_touching);
    KindTally& tally = tallies_[pair.run];
    tally.candidates += pair.is_admitted ? 1 : 0;
    tally.examined += pair.job != no_job ? 1 : 0;
    tally.touching += pair.is_touching ? 1 : 0;
    tally.contacts += pair.contact_count;
    stats_.candidate_pairs += is_candidate ? 1 : 0;
    stats_.filtered_pairs += pair.is_admitted ? 0 : 1;
    stats_.unsupported_pairs += pair.is_admitted && !is_candidate ? 1 : 0;
    stats_.touching_pairs += pair.is_touching ? 1 : 0;
  }
  contacts_.resize(total);
  histories_.resize(total);
  workers_.for_each((pairs.size() + block_size - 1) / block_size, [&](std::size_t block) {
    const std::size_t begin = block * block_size, end = std::min(begin + block_size, pairs.size());
    for (std::size_t place = begin; place < end; ++place) {
      if (const std::size_t ahead = place + pairs_ahead; ahead < end && pairs[ahead].job != no_job) {
        jobs_.fetch_found_by(ahead);
      }
      if (pairs[place].contact_count > 0) {
        write_contacts_of(place);
      }
    }
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
