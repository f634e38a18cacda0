// SPDX-License-Identifier: Apache-2.0
// A universe as bytes: a head, then its options, the scene, and what detections keep.
module abut.universe;
import abut.broadphase;
import abut.capability;
import abut.core.archive;
import abut.core.standard;
import abut.core;
import abut.detect.lists.contacts;
import abut.detect.continuous;
import abut.detect.elements;
import abut.detect.lists.events;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.detect.pairs.selection;
import abut.detect.pairs.sides;
import abut.math;
import abut.scene.meetings;
import abut.scene.state.places;
import abut.scene.meetings.policies;

namespace abut {
namespace {

// "abut-uni", lowest byte first.
constexpr std::uint64_t mark = 0x696e752d74756261;
// Grows whenever something is written that was not, or no more.
constexpr std::uint32_t present_version = 6;
constexpr std::size_t head_size = 24;

struct Head {
  std::uint64_t mark;
  std::uint32_t version;
  std::uint32_t checksum;  // of all that follows the head
  std::uint64_t size;      // of that
};

// The geometries of a contact are those of its pair.
struct SavedContact {
  ContactPoint point;
  std::uint32_t flags, age;
  std::uint64_t user_data;
  std::uint32_t material_a, material_b;
  Real toi;
};

Error refused(std::string_view what) { return {Errc::invalid_argument, "bytes " + std::string(what)}; }

// What follows the head.
Result<std::span<const std::uint8_t>> checked_body(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < head_size) {
    return refused("end within the head of a universe, after " + std::to_string(bytes.size()));
  }
  ByteReader in(bytes.first(head_size));
  Head head{};
  in(head);
  if (head.mark != mark) {
    return refused("are not those of a universe: they begin otherwise");
  }
  if (head.version != present_version) {
    return Error{Errc::unsupported, "bytes are of version " + std::to_string(head.version) +
                                        " of saved universes; this version of abut reads version " +
                                        std::to_string(present_version)};
  }
  const auto body = bytes.subspan(head_size);
  if (head.size != body.size()) {
    return refused("are " + std::to_string(bytes.size()) + "; a head that says " +
                   std::to_string(head.size + head_size) + " precedes them");
  }
  if (head.checksum != checksum_of(body)) {
    return refused("have changed since they were saved: their checksum is another one");
  }
  return body;
}

bool are_right(const UniverseOptions& its) {
  constexpr std::uint32_t most_threads = 1024;
  return its.broadphase <= BroadphaseKind::hash_grid && its.tolerance_mode <= ToleranceMode::margin &&
         is_finite(its.origin) && largest_magnitude(its.origin) <= largest_coordinate && its.threads <= most_threads &&
         its.events <= (event_pairs | event_persist | event_contacts | event_elements);
}

bool is_right(const SavedContact& its) {
  constexpr Real slack = 1e-6;
  return is_finite(its.point.point_a) && is_finite(its.point.point_b) && std::isfinite(its.point.distance) &&
         std::fabs(squared_norm(its.point.normal) - 1) <= slack &&
         its.flags <= (contact_of_sensor | contact_speculative) && its.toi >= 0 && its.toi <= 1 &&
         its.point.feature_a.kind <= FeatureKind::particle && its.point.feature_b.kind <= FeatureKind::particle;
}

bool is_right(const StepImpact& its, std::size_t contacts) {
  return its.lower >= 0 && its.lower <= its.upper && its.upper <= 1 && its.first_contact <= contacts &&
         its.contact_count <= contacts - its.first_contact;
}

bool is_right(const Event& its, std::size_t contacts, std::size_t element_contacts) {
  constexpr std::uint32_t all_flags = event_of_sensor | event_of_contact | event_asleep | event_of_elements;
  const std::size_t most = (its.flags & event_of_elements) != 0 ? element_contacts : contacts;
  return its.kind <= EventKind::end && its.flags <= all_flags && its.first_contact <= most &&
         its.contact_count <= most - its.first_contact;
}

}  // namespace

std::vector<std::uint8_t> Universe::save() const {
  ByteWriter body;
  body(options_);
  Scene::save(body);
  std::vector<SavedContact> contacts;
  contacts.reserve(contacts_.all().size());
  for (const Contact& its : contacts_.all()) {
    contacts.push_back({its.point, its.flags, its.age, its.user_data, its.material_a, its.material_b, its.toi});
  }
  const auto pairs = pairs_.all();
  const auto locals = contacts_.locals();
  const auto events = events_.all();
  const auto impacts = impacts_.all();
  body(step_, follows_islands_, islands_, sides_, elements_);
  body(std::vector<Pair>(pairs.begin(), pairs.end()), contacts, std::vector<LocalPoints>(locals.begin(), locals.end()),
       std::vector<Event>(events.begin(), events.end()), std::vector<StepImpact>(impacts.begin(), impacts.end()));
  ByteWriter head;
  head(Head{mark, present_version, checksum_of(body.bytes()), body.bytes().size()});
  std::vector<std::uint8_t> all(head.bytes().begin(), head.bytes().end());
  all.insert(all.end(), body.bytes().begin(), body.bytes().end());
  return all;
}

Result<UniverseOptions> Universe::saved_options(std::span<const std::uint8_t> bytes) {
  const auto body = checked_body(bytes);
  if (!body) {
    return body.error();
  }
  ByteReader in(body.value());
  UniverseOptions options;
  in(options);
  in.require(are_right(options), "the options of the universe are none");
  return in.fault() ? Result<UniverseOptions>(*in.fault()) : Result<UniverseOptions>(options);
}

Result<void> Universe::load(std::span<const std::uint8_t> bytes) {
  const auto body = checked_body(bytes);
  if (!body) {
    return body.error();
  }
  ByteReader in(body.value());
  UniverseOptions options;
  in(options);
  Scene::load(in, workers_);
  in(step_, follows_islands_, islands_, sides_, elements_);
  if (!swept_places_.empty() && !follows_paths) {
    in.fail({Errc::unsupported, "a geometry is fast or speculative, and this build is without the feature \"motion\""});
  }
  in.require(in.has_failed() || sides_.is_right(places_), "a side is kept of no pair or triangle");
  if (!finds_elements && meetings_.policies.tags_of_elements() != 0) {
    in.fail({Errc::unsupported, "a policy asks for elements, and this build is without the feature \"deforming\""});
  }
  in.require(in.has_failed() || elements_.restore(places_, meetings_.policies), "an element contact is none");
  if (!in.has_failed()) {
    load_pairs(in);
  }
  in.require(in.is_at_end(), "something follows the end");
  if (in.fault()) {
    return Error{in.fault()->code, "bytes: " + in.fault()->message};
  }
  return {};
}

// Pairs are in order, and their contacts follow each other.
void Universe::load_pairs(ByteReader& in) {
  std::vector<Pair> pairs;
  in(pairs);
  std::uint64_t contacts = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Pair& its = pairs[i];
    const bool follows = i == 0 || std::pair(pairs[i - 1].low, pairs[i - 1].high) < std::pair(its.low, its.high);
    // Before pairs are asked again, their policies may have gone.
    const bool has_policy = meetings_.must_ask_again || its.policy < meetings_.policies.size();
    if (!follows || its.low > its.high || its.high >= places_.infos.size() || !has_policy) {
      in.require(false, "a pair is of no geometries or policy, or there twice");
      return;
    }
    its.first_contact = static_cast<std::uint32_t>(contacts);
    contacts += its.contact_count;
    its.run = static_cast<std::uint16_t>(run_of(its, places_.infos[its.low].kind, places_.infos[its.high].kind));
    its.is_supported = jobs_.is_supported(its.run);
    if (!meetings_.must_ask_again) {
      its.is_by_elements = asks_for_elements(its, places_, meetings_.policies);
    }
  }
  pairs_.restore(std::move(pairs));
  load_contacts(in, contacts);
}

void Universe::load_contacts(ByteReader& in, std::uint64_t count) {
  std::vector<SavedContact> saved;
  std::vector<LocalPoints> locals;
  std::vector<Event> events;
  std::vector<StepImpact> impacts;
  in(saved, locals, events, impacts);
  in.require(saved.size() == count, "the contacts are not as many as those of the pairs");
  in.require(locals.size() == (options_.keeps_local_points ? count : 0), "the local points are not those of contacts");
  in.require(std::ranges::all_of(saved, [](const SavedContact& its) { return is_right(its); }),
             "a contact has numbers that none has");
  in.require(std::ranges::all_of(
                 events, [&](const Event& its) { return is_right(its, saved.size(), elements_.contact_count()); }),
             "an event is none");
  in.require(std::ranges::all_of(impacts, [&](const StepImpact& its) { return is_right(its, saved.size()); }),
             "an impact is none");
  if (in.has_failed()) {
    return;
  }
  std::vector<Contact> contacts;
  contacts.reserve(saved.size());
  for (const Pair& pair : pairs_.all()) {
    for (const SavedContact& its : std::span(saved).subspan(pair.first_contact, pair.contact_count)) {
      contacts.push_back({.geometry_a = {pair.low + 1, pair.generation_low},
                          .geometry_b = {pair.high + 1, pair.generation_high},
                          .point = its.point,
                          .flags = its.flags,
                          .age = its.age,
                          .user_data = its.user_data,
                          .material_a = its.material_a,
                          .material_b = its.material_b,
                          .toi = its.toi});
    }
  }
  contacts_.restore(std::move(contacts), std::move(locals));
  events_.restore(std::move(events));
  impacts_.restore(std::move(impacts));
  had_paths_ = !swept_places_.empty();
}

}  // namespace abut
