// SPDX-License-Identifier: Apache-2.0
#include "call.hpp"

#include <cctype>

namespace abut_test::table {
namespace {

constexpr std::size_t capacity = 64;
constexpr unsigned char untouched = 0xA5;
constexpr std::array<const char*, texts> words{"friction", "table", "new"};

template <class Number>
void put(unsigned char* place, const Number& number) {
  std::memcpy(place, &number, sizeof number);
}

bool is_count(std::string_view name) { return name == "size" || name.ends_with("count"); }
bool is_of_grid(std::string_view name) { return name == "columns" || name == "rows" || name == "layers"; }

// A number that the range holds.
double real_in(const Range& range) {
  constexpr double good = 0.5;
  return good < range.least ? range.least + 1 : good > range.most ? range.most : good;
}

// Numbers of an array: corners of a tetrahedron or of a cube, halves, halves of both signs, or a matrix of 4 x 4.
double real_at(std::size_t pattern, std::size_t index) {
  constexpr std::array<double, 12> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  if (pattern == 0) return corners.at(index % corners.size());
  if (pattern == 1) return (index / 3 >> index % 3) % 2 == 0 ? 0 : 2;
  if (pattern == 4) return index % 5 == 0 ? 1 : 0;
  return pattern == 2 || index % 2 == 0 ? 0.5 : -0.5;
}

void never_called() { ADD_FAILURE() << "a function of the caller was called"; }

// Vectors that differ, of which no three lie in one plane with the origin.
abut_vec3 vector_at(std::size_t index) {
  const double i = static_cast<double>(index);
  return {1 + 0.25 * i, 0.5 + 0.125 * i * i, 0.25 - 0.5 * i};
}

}  // namespace

const Struct& find_struct(std::string_view name) {
  static const std::vector<Struct> all = [] {
    std::vector<Struct> structs = structs_of_abut();
#ifdef ABUT_TABLE_HAS_PICKING
    for (const Struct& each : structs_of_picking()) structs.push_back(each);
#endif
#ifdef ABUT_TABLE_HAS_RESPONSE
    for (const Struct& each : structs_of_response()) structs.push_back(each);
#endif
    return structs;
  }();
  return *std::find_if(all.begin(), all.end(), [&](const Struct& each) { return each.name == name; });
}

Call::Call(const Function& function, const World& world, const Choice& choice)
    : function_(function),
      world_(world),
      choice_(choice),
      given_(function.arguments.size()),
      memory_(function.arguments.size()) {
  for (std::size_t i = 0; i < given_.size(); ++i) {
    if (!function.arguments[i].is_pointer) pass_value(i);
  }
  for (std::size_t i = 0; i < given_.size(); ++i) {
    if (function.arguments[i].is_pointer) pass_memory(i);
  }
  remember();
}

std::uint64_t Call::whole(const Value& value) const {
  if (value.name == "size") return world_.saved(choice_.saved).size();
  if (value.name.ends_with("capacity")) return capacity;
  if (value.type == "abut_shape_kind") return abut_shape_kind_by_name("sphere");
  if (value.name == "major") return ABUT_VERSION_MAJOR;
  if (value.name == "minor") return ABUT_VERSION_MINOR;
  if (is_count(value.name)) return choice_.count;
  if (is_of_grid(value.name))
    return std::max(choice_.grid, static_cast<std::uint32_t>(std::max(0.0, value.range.least)));
  return value.name == "link" || value.name == "threads" ? 1 : 0;
}

void Call::pass_value(std::size_t argument) {
  const Value& value = function_.arguments[argument];
  Passed& passed = given_[argument];
  if (value.role == Role::id) {
    // Two geometries of one call differ.
    const std::size_t index = numbers_[std::string(value.type)]++;
    if (value.type == "abut_part_id") passed.set(world_.part(choice_.kind, index));
    if (value.type == "abut_geometry_id") passed.set(world_.geometry(choice_.kind, index));
  } else if (value.is_real) {
    passed.set(real_in(value.range));
  } else if (value.role == Role::number || value.role == Role::choice || value.role == Role::bits) {
    const std::uint64_t number = whole(value);
    passed.set(number);
    numbers_[std::string(value.name)] = number;
  } else if (value.role == Role::callback && !value.may_be_null) {
    passed.set(&never_called);
  }
}

// A sum or a product of numbers and of names of other arguments, from left to right.
std::size_t Call::length_of(std::string_view length) const {
  std::size_t result = 0;
  char operation = '+';
  for (std::size_t at = 0; at < length.size();) {
    const std::size_t end = std::min(length.find(' ', at), length.size());
    const std::string_view word = length.substr(at, end - at);
    at = end + 1;
    if (word == "*" || word == "+") {
      operation = word[0];
      continue;
    }
    const bool is_number = std::isdigit(static_cast<unsigned char>(word[0])) != 0;
    const std::size_t operand = is_number ? std::stoul(std::string(word)) : numbers_.find(word)->second;
    result = operation == '*' ? result * operand : result + operand;
  }
  return result;
}

std::size_t Call::count(std::size_t argument) const {
  const std::string_view length = function_.arguments[argument].length;
  return length.empty() ? 1 : length_of(length);
}

void Call::pass_memory(std::size_t argument) {
  const Value& value = function_.arguments[argument];
  Passed& passed = given_[argument];
  std::vector<unsigned char>& memory = memory_[argument];
  if (value.role == Role::context) return;
  if (value.role == Role::handle) {
    passed.set(world_.object(value.type, choice_.kind));
    return;
  }
  if (value.role == Role::text && !value.is_output) {
    if (!value.may_be_null) passed.set(words.at(choice_.text));
    return;
  }
  if (value.role == Role::bytes && !value.is_output) {
    memory = world_.saved(choice_.saved);
  } else {
    memory.assign(std::max<std::size_t>(count(argument) * value.size, 8), untouched);
    const bool is_read = !value.is_output ||
                         (value.role == Role::structure && find_struct(value.type).init != nullptr) ||
                         value.type == "abut_pair_memory";
    for (std::size_t i = 0; is_read && i < count(argument); ++i) fill(&memory.at(i * value.size), value, argument, i);
  }
  passed.set(memory.data());
}

// `first` differs from argument to argument.
void Call::fill(unsigned char* place, const Value& value, std::size_t first, std::size_t index) {
  constexpr std::array<std::uint32_t, 12> faces{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  std::memset(place, 0, value.size);
  if (value.role == Role::structure) {
    fill_struct(place, find_struct(value.type), first + index);
  } else if (value.is_real) {
    put(place, real_at(choice_.pattern, index));
  } else if (value.role == Role::number && value.size == sizeof(std::uint32_t)) {
    // Of one pattern the corners of tetrahedra.
    put(place, choice_.pattern == 3 ? static_cast<std::uint32_t>(index % 4) : faces.at(index % faces.size()));
  } else if (value.role == Role::handles) {
    put(place, world_.shape(choice_.kind));
  } else if (value.type == "abut_part_id") {
    put(place, world_.part(choice_.kind, index % World::of_a_kind));
  } else if (value.type == "abut_geometry_id") {
    put(place, world_.geometry(choice_.kind, index % World::of_a_kind));
  }
}

void Call::fill_struct(unsigned char* place, const Struct& its, std::size_t index) {
  if (its.init != nullptr) {
    its.init(place, static_cast<std::uint32_t>(its.size));
    fill_fields(place, its);
  } else if (its.name == "abut_vec3") {
    put(place, vector_at(index));
  } else if (its.name == "abut_quat") {
    put(place, no_rotation);
  } else if (its.name == "abut_aabb") {
    put(place, abut_aabb{{-1, -1, -1}, {1, 1, 1}});
  } else if (its.name == "abut_collidable") {
    const abut_geometry_id id = world_.geometry(choice_.kind, 0);
    put(place, abut_collidable{ABUT_COLLIDABLE_GEOMETRY, id.slot, id.generation});
  } else if (its.name == "abut_contact") {
    put(place, contacts_of(world_.shape(0), at(0, 0, 0), world_.shape(0), at(1.5, 0, 0)).front());
  } else if (its.name == "abut_backend_contact") {
    abut_backend_contact contact{};
    contact.normal.z = 1;
    put(place, contact);
  } else if (its.name != "abut_pair_memory") {
    for (const Value& field : its.fields) {
      if (field.role == Role::structure) fill_struct(place + field.offset, find_struct(field.type), index);
      if (field.is_real && field.fixed_count == 0) put(place + field.offset, real_in(field.range));
    }
  }
}

// Fields of which the default is no good value.
void Call::fill_fields(unsigned char* place, const Struct& its) {
  for (const Value& field : its.fields) {
    if (field.is_real && !field.is_pointer && field.fixed_count == 0) {
      double number = 0;
      std::memcpy(&number, place + field.offset, sizeof number);
      const bool is_low = number < field.range.least || (field.range.is_open && number == field.range.least);
      if (is_low) put(place + field.offset, real_in(field.range));
    } else if (!field.is_pointer && field.size == 4 && field.range.least >= 1) {
      // The smallest is the quickest.
      put(place + field.offset, static_cast<std::uint32_t>(field.range.least));
#ifdef ABUT_TABLE_HAS_RESPONSE
    } else if (field.type == "abut_mass_properties") {
      put(place + field.offset, abut_mass_properties{1, {0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1}});
#endif
    } else if (field.type == "abut_shape_kind") {
      put(place + field.offset, abut_shape_kind_by_name("sphere"));
    } else if (field.role == Role::id && !field.may_be_null) {
      fill(place + field.offset, field, 0, 0);
    }
  }
  for (const Value& field : its.fields) {
    if (!field.is_pointer || field.may_be_null || field.length.empty()) continue;
    for (const Value& other : its.fields) {
      std::uint64_t number = 0;
      if (field.length == other.name && is_count(other.name)) put(place + other.offset, number = choice_.count);
      std::memcpy(&number, place + other.offset, std::min(other.size, sizeof number));
      numbers_[std::string(other.name)] = number;
    }
    std::vector<unsigned char>& array = inner_.emplace_back(length_of(field.length) * field.size);
    for (std::size_t i = 0; field.is_real && i < array.size() / sizeof(double); ++i) {
      put(&array.at(i * sizeof(double)), real_at(choice_.pattern, i));
    }
    put(place + field.offset, array.data());
  }
}

void Call::release_made() const {
  for (std::size_t i = 0; i < memory_.size(); ++i) {
    if (function_.arguments[i].role != Role::made) continue;
    void* object = nullptr;
    std::memcpy(static_cast<void*>(&object), memory_[i].data(), sizeof object);
    release(function_.arguments[i].type, object);
  }
}

}  // namespace abut_test::table
