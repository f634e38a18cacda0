// SPDX-License-Identifier: Apache-2.0
// A response as bytes: a mark, a version, a checksum of the rest, and the rest. Numbers of eight bytes, the lowest
// first.
module;

#include <abut/response.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

module abut.response;

namespace abut::response {

std::uint64_t hash_of(std::span<const std::byte> bytes) {
  // FNV-1a, http://www.isthe.com/chongo/tech/comp/fnv/
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const std::byte byte : bytes) hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001B3U;
  return hash;
}

namespace {

constexpr std::uint64_t mark = 0x5345525455424100U, version = 3;
constexpr std::size_t head = 3 * sizeof(std::uint64_t);

class Writer {
 public:
  void number(std::uint64_t value) {
    for (std::size_t i = 0; i < sizeof value; ++i) bytes_.push_back(static_cast<std::byte>(value >> (8 * i)));
  }
  void take(const std::uint64_t& value) { number(value); }
  void take(const std::uint32_t& value) { number(value); }
  void take(const bool& value) { number(value ? 1 : 0); }
  void take(const double& value) { number(std::bit_cast<std::uint64_t>(value)); }
  void take(const std::string& text) {
    number(text.size());
    for (const char c : text) bytes_.push_back(static_cast<std::byte>(c));
  }
  template <class List, class Each>
  void list(const List& all, const Each& each) {
    number(all.size());
    for (const auto& one : all) each(one);
  }
  [[nodiscard]] std::vector<std::byte> finished() {
    Writer front;
    front.number(mark);
    front.number(version);
    front.number(hash_of(bytes_));
    front.bytes_.insert(front.bytes_.end(), bytes_.begin(), bytes_.end());
    return std::move(front.bytes_);
  }

 private:
  std::vector<std::byte> bytes_;
};

// Reads zeros from the first number on that cannot be.
class [[gsl::Pointer]] Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  [[nodiscard]] std::uint64_t number() {
    std::uint64_t value = 0;
    if (bytes_.size() < sizeof value) {
      fail();
      return 0;
    }
    for (std::size_t i = 0; i < sizeof value; ++i) value |= static_cast<std::uint64_t>(bytes_[i]) << (8 * i);
    bytes_ = bytes_.subspan(sizeof value);
    return value;
  }
  void take(std::uint64_t& value) { value = number(); }
  void take(std::uint32_t& value) {
    const std::uint64_t wide = number();
    value = static_cast<std::uint32_t>(wide);
    if (value != wide) fail();
  }
  void take(bool& value) { value = number() != 0; }
  void take(double& value) {
    value = std::bit_cast<double>(number());
    if (!std::isfinite(value)) fail();
  }
  void take(std::string& text) {
    const std::uint64_t size = number();
    if (size > bytes_.size()) return fail();
    text.clear();
    for (const std::byte byte : bytes_.first(size)) text += static_cast<char>(byte);
    bytes_ = bytes_.subspan(size);
  }
  template <class List, class Each>
  void list(List& all, const Each& each) {
    const std::uint64_t size = number();
    // Each element has a number at least.
    if (size > bytes_.size() / sizeof(std::uint64_t)) return fail();
    all.assign(size, {});
    for (auto& one : all) each(one);
  }

  void fail() { is_good_ = false; }
  [[nodiscard]] bool is_good() const { return is_good_; }
  [[nodiscard]] bool is_done() const { return is_good_ && bytes_.empty(); }

 private:
  std::span<const std::byte> bytes_;
  bool is_good_ = true;
};

template <class Archive, class... Values>
void take(Archive& archive, Values&... values) {
  (archive.take(values), ...);
}
template <class Archive, class Vector3>
void take_vector(Archive& archive, Vector3& v) {
  take(archive, v.x, v.y, v.z);
}
template <class Archive, class Id>
void take_id(Archive& archive, Id& id) {
  take(archive, id.slot, id.generation);
}
template <class Archive, class Id>
void take_pair(Archive& archive, Id& pair) {
  take_id(archive, pair.first);
  take_id(archive, pair.second);
}

// What a rule is in bytes.
struct StoredRule {
  abut_response_side a{}, b{};
  std::uint32_t kind = 0;
  std::string text;
};

template <class Archive>
void take_rules(Archive& archive, std::vector<StoredRule>& rules) {
  archive.list(rules, [&](auto& its) {
    take(archive, its.a.kind, its.a.slot, its.a.generation, its.b.kind, its.b.slot, its.b.generation, its.kind,
         its.text);
  });
}

void write_rules(Writer& archive, const Rules& rules) {
  std::vector<std::string> kinds;
  for (const Kind& kind : rules.kinds()) {
    if (kind.response == Response::custom) kinds.push_back(kind.name);
  }
  archive.list(kinds, [&](const std::string& name) { archive.take(name); });
  std::vector<StoredRule> all, own;
  for (const Rules::Rule& its : rules.rules()) all.push_back({its.a, its.b, its.kind, its.parameters.text()});
  for (const auto& [key, its] : rules.of_geometries())
    own.push_back({{0, key.first, key.second}, {}, its.kind, its.parameters.text()});
  take_rules(archive, all);
  take_rules(archive, own);
  std::vector<std::pair<std::string, std::string>> variables(rules.variables().begin(), rules.variables().end());
  archive.list(variables, [&](const auto& its) { take(archive, its.first, its.second); });
}

void read_rules(Reader& archive, Rules& rules) {
  std::vector<std::string> kinds;
  archive.list(kinds, [&](std::string& name) { archive.take(name); });
  for (const std::string& name : kinds) {
    if (rules.add_kind(name, {})) archive.fail();
  }
  std::vector<StoredRule> all, own;
  take_rules(archive, all);
  take_rules(archive, own);
  for (const StoredRule& its : all) {
    if (!rules.restore(its.a, its.b, its.kind, its.text)) archive.fail();
  }
  for (const StoredRule& its : own) {
    if (!rules.restore(abut_geometry_id{its.a.slot, its.a.generation}, its.kind, its.text)) archive.fail();
  }
  std::vector<std::pair<std::string, std::string>> variables;
  archive.list(variables, [&](auto& its) { take(archive, its.first, its.second); });
  for (const auto& [name, value] : variables) rules.set_variable(name, value);
}

}  // namespace

template <class Archive, class Self>
void Simulation::exchange(Archive& archive, Self& its) {
  auto& options = its.options_;
  take(archive, options.most_rounds, options.tolerance, options.slop, options.flags, options.solver, options.threads,
       its.time_, its.next_link_);
  take_vector(archive, options.gravity);
  archive.list(its.bodies_, [&](auto& body) {
    take_id(archive, body.part);
    take(archive, body.mass.mass, body.integrator);
    take_vector(archive, body.mass.centre);
    for (auto& number : body.mass.inertia) archive.take(number);
    take_vector(archive, body.force);
    take_vector(archive, body.torque);
  });
  archive.list(its.grains_, [&](auto& grains) {
    take_id(archive, grains.geometry);
    for (auto* const numbers : {&grains.masses, &grains.xyz, &grains.velocities})
      archive.list(*numbers, [&](auto& number) { archive.take(number); });
    archive.list(grains.springs, [&](auto& spring) {
      take(archive, spring.a, spring.b, spring.rest, spring.stiffness, spring.damping);
    });
    archive.list(grains.tetrahedra, [&](auto& element) {
      for (auto& node : element.nodes) archive.take(node);
      for (auto& number : element.inverse) archive.take(number);
      take(archive, element.volume, element.shear, element.lame, element.damping);
    });
  });
  archive.list(its.surfaces_, [&](auto& surface) {
    take_id(archive, surface.geometry);
    take_id(archive, surface.carrier);
    archive.list(surface.nodes, [&](auto& node) { archive.take(node); });
    archive.list(surface.weights, [&](auto& weight) { archive.take(weight); });
  });
  archive.list(its.kept_, [&](auto& contact) {
    take_id(archive, contact.a);
    take_id(archive, contact.b);
    take(archive, contact.id, contact.is_sticking);
    take_vector(archive, contact.force);
    take_vector(archive, contact.creep);
  });
  archive.list(its.links_, [&](auto& link) {
    take(archive, link.number, link.stiffness, link.damping, link.most_force, link.break_force, link.contact,
         link.kind);
    for (auto* const anchor : {&link.a, &link.b}) {
      take_id(archive, anchor->part);
      take_vector(archive, anchor->point);
    }
    take_id(archive, link.geometry_a);
    take_id(archive, link.geometry_b);
    take_vector(archive, link.force);
    take_vector(archive, link.normal);
  });
  archive.list(its.released_, [&](auto& pair) { take_pair(archive, pair); });
  archive.list(its.objects_, [&](auto& object) {
    take_id(archive, object.geometry_a);
    take_id(archive, object.geometry_b);
    take(archive, object.kind, object.event, object.contact_count, object.bond_count, object.age);
    take_vector(archive, object.impulse);
    take_vector(archive, object.force);
  });
}

std::vector<std::byte> Simulation::save() const {
  Writer writer;
  exchange(writer, *this);
  write_rules(writer, rules_);
  return writer.finished();
}

bool Simulation::load(std::span<const std::byte> bytes) {
  if (bytes.size() < head) return false;
  Reader front(bytes.first(head));
  if (front.number() != mark || front.number() != version) return false;
  if (front.number() != hash_of(bytes.subspan(head))) return false;
  options_.struct_size = sizeof options_;
  Reader reader(bytes.subspan(head));
  exchange(reader, *this);
  read_rules(reader, rules_);
  const auto is_kind = [&](std::uint32_t kind) { return kind < rules_.kinds().size(); };
  bool is_good = reader.is_done() && time_ >= 0 && next_link_ > 0;
  for (const Body& body : bodies_) is_good = is_good && body.integrator <= ABUT_INTEGRATOR_IMPLICIT;
  for (const Grains& grains : grains_) {
    const std::size_t numbers = 3 * grains.masses.size();
    is_good = is_good && grains.xyz.size() == numbers && grains.velocities.size() == numbers;
    for (const double mass : grains.masses) is_good = is_good && mass >= 0;
    const auto is_node = [&](std::uint32_t node) { return node < grains.masses.size(); };
    for (const Spring& its : grains.springs) {
      is_good = is_good && is_node(its.a) && is_node(its.b) && its.a != its.b && its.rest >= 0 && its.stiffness >= 0 &&
                its.damping >= 0;
    }
    for (const Tetrahedron& its : grains.tetrahedra) {
      is_good = is_good && std::ranges::all_of(its.nodes, is_node) && its.volume > 0 && its.shear >= 0 &&
                its.lame >= 0 && its.damping >= 0;
    }
  }
  for (const Surface& its : surfaces_) {
    const Grains* const carrier = particles_of(its.carrier);
    is_good = is_good && carrier != nullptr && its.nodes.size() == its.weights.size() &&
              its.nodes.size() % Surface::width == 0 &&
              std::ranges::all_of(its.nodes, [&](std::uint32_t node) { return node < carrier->masses.size(); });
  }
  for (const Link& link : links_) {
    is_good = is_good && is_kind(link.kind) && link.number < next_link_ && link.stiffness >= 0 && link.damping >= 0 &&
              link.most_force >= 0;
  }
  for (const abut_response_object& object : objects_) is_good = is_good && is_kind(object.kind);
  return is_good;
}

std::vector<abut_part_id> Simulation::parts() const {
  std::vector<abut_part_id> out;
  out.reserve(bodies_.size());
  for (const Body& body : bodies_) out.push_back(body.part);
  return out;
}

}  // namespace abut::response
