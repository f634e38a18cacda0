module abut.universe;
import abut.broadphase;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.registry;
import abut.universe.jobs;
import abut.universe.pairs;
import abut.universe.policies;

namespace abut {
namespace {

// Distinct for up to 2^32 universes, and far apart for neighbours (Knuth's multiplicative hash).
std::uint32_t first_generation(std::uint32_t number, std::uint32_t salt) {
  constexpr std::uint64_t golden = 0x9e3779b1;
  return static_cast<std::uint32_t>((number * golden + salt) & 0xffffffff);
}

Fault check_tags(std::uint32_t tag_a, std::uint32_t tag_b) {
  if (tag_a < tag_count && tag_b < tag_count) {
    return std::nullopt;
  }
  const bool is_first = tag_a >= tag_count;
  return error_about(Errc::out_of_range, is_first ? "tag_a" : "tag_b", std::uint64_t{is_first ? tag_a : tag_b},
                     "below " + std::to_string(tag_count));
}

}  // namespace

Universe::Universe(const UniverseOptions& options, std::uint32_t number)
    : options_(options),
      parts_(first_generation(number, 1)),
      geometries_(first_generation(number, 0x80000001)),
      vacant_(AnyShape(Shapes::At<0>::samples().front())),
      workers_(options.threads) {}

Result<void> Universe::set_rule(const Collidable& a, const Collidable& b, Rule rule) {
  const auto is_known = [&](const Collidable& its) {
    return (its.kind != CollidableKind::geometry || geometries_.contains(GeometryId{its.slot, its.generation})) &&
           (its.kind != CollidableKind::part || parts_.contains(PartId{its.slot, its.generation}));
  };
  if (!is_known(a) || !is_known(b)) {
    return Error{Errc::stale_id, std::string(is_known(a) ? "b" : "a") +
                                     " names a geometry or a part that is stale or belongs to another universe"};
  }
  rules_.set(a, b, rule);
  must_refilter_ = true;
  return {};
}

void Universe::clear_rules() {
  must_refilter_ = must_refilter_ || !rules_.is_empty();
  rules_.clear();
}

void Universe::set_filter(Filter filter) {
  filter_ = std::move(filter);
  must_refilter_ = true;
}

void Universe::refilter() { must_refilter_ = true; }

Result<void> Universe::set_policy(std::uint32_t tag_a, std::uint32_t tag_b, const Policy& policy) {
  if (Fault fault = check_tags(tag_a, tag_b)) {
    return *fault;
  }
  if (Fault fault = check_policy(policy)) {
    return *fault;
  }
  const Real before = policies_.largest_tolerance();
  policies_.set(tag_a, tag_b, policy);
  must_refilter_ = true;
  // Boxes have to reach as far as the largest tolerance.
  if (options_.tolerance_mode == ToleranceMode::margin && policies_.largest_tolerance() != before) {
    for (const GeometryId geometry : geometries()) {
      infos_[geometry.slot - 1].is_box_stale = true;
      change(geometry);
    }
  }
  return {};
}

Result<Policy> Universe::policy(std::uint32_t tag_a, std::uint32_t tag_b) const {
  if (Fault fault = check_tags(tag_a, tag_b)) {
    return *fault;
  }
  return policies_.of(tag_a, tag_b);
}

Result<void> Universe::set_material(std::uint32_t a, std::uint32_t b, const std::optional<ContactMaterial>& row) {
  if (row) {
    if (Fault fault = check_material(*row)) {
      return *fault;
    }
  }
  materials_.set(a, b, row);
  return {};
}

std::size_t Universe::bytes() const {
  const std::size_t per_geometry = shapes_.capacity() * sizeof(ShapeHandle) + worlds_.capacity() * sizeof(Pose) +
                                   boxes_.capacity() * sizeof(CompactAabb) + infos_.capacity() * sizeof(PlaceInfo) +
                                   happened_.capacity() + presence_.capacity();
  const std::size_t changes =
      moved_parts_.capacity() * sizeof(PartId) + changed_geometries_.capacity() * sizeof(GeometryId) +
      patches_.capacity() * sizeof(Patch) +
      (self_places_.capacity() + fresh_.capacity() + queue_.capacity() + updates_.capacity() + rejoining_.capacity()) *
          sizeof(std::uint32_t);
  const std::size_t results = near_.capacity() * sizeof(ProxyPair) + pairs_.bytes() + jobs_.bytes() +
                              contacts_.capacity() * sizeof(Contact) + locals_.capacity() * sizeof(LocalPoints) +
                              (histories_.capacity() + histories_before_.capacity()) * sizeof(ContactHistory) +
                              events_.capacity() * sizeof(Event);
  std::size_t tasks = change_tasks_.capacity() * sizeof(ChangeTask) + pair_tasks_.capacity() * sizeof(PairTask) +
                      contact_tasks_.capacity() * sizeof(ContactTask) + event_tasks_.capacity() * sizeof(EventTask);
  for (const ChangeTask& task : change_tasks_) {
    tasks += (task.queue.capacity() + task.fresh.capacity()) * sizeof(std::uint32_t);
  }
  for (const PairTask& task : pair_tasks_) {
    tasks += task.lost.capacity() * sizeof(Pair) + task.without_memory.capacity() * sizeof(std::uint32_t);
  }
  for (const EventTask& task : event_tasks_) {
    tasks += task.events.capacity() * sizeof(Event);
  }
  const std::size_t broadphase = std::visit([](const auto& its) { return its.bytes(); }, broadphase_);
  return sizeof(Universe) + parts_.bytes() + geometries_.bytes() + list_bytes_ + per_geometry + changes + results +
         tasks + broadphase + rules_.bytes() + policies_.bytes() + focus_.bytes() +
         switched_.capacity() * sizeof(std::uint32_t) + materials_.bytes() + sleep_.bytes() + velocities_.bytes() +
         island_links_.bytes() + islands_.bytes() + dynamic_parts_.capacity() * sizeof(PartId);
}

}  // namespace abut
