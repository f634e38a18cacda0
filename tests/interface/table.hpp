// SPDX-License-Identifier: Apache-2.0
// What the headers say of each function: how to call it, and what may be given. Rows are made by scripts/interface.
#pragma once

#include <abut/abut.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

namespace abut_test::table {

enum class Role {
  number,
  choice,  // of an enumeration
  bits,
  id,
  structure,
  handle,
  handles,  // an array of them
  text,
  texts,  // that are answered
  bytes,
  callback,
  context,
  made,  // a handle that is answered
  lent   // a pointer that is answered
};

// Of a number. Those that say nothing else are finite.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  bool is_open = false;  // without `least`
  double most = std::numeric_limits<double>::infinity();
  bool may_be_infinite = false;
  bool may_be_nan = false;
  bool may_be_far = false;  // beyond 1e70
  bool is_reserved = false;
  bool is_unread = false;  // where another field is given
};

// A parameter of a function, or a field of a struct.
struct Value {
  std::string_view name;
  Role role;
  std::string_view type;
  std::size_t size;  // of one element
  std::size_t offset = 0;
  bool is_pointer = false;
  std::size_t fixed_count = 0;   // of an array within a struct
  std::string_view length = {};  // of an array: "count * 3"
  bool is_output = false;
  bool may_be_null = false;
  std::uint64_t known = 0;  // the last choice, or all bits
  bool is_real = false;
  Range range = {};
};

// An argument as it is passed: up to 16 bytes, which become whatever the function takes.
class Passed {
 public:
  template <class Number>
  void set(const Number& value) {
    static_assert(sizeof value <= sizeof bytes_);
    std::memcpy(bytes_.data(), &value, sizeof value);
  }
  void set_bytes(const void* bytes, std::size_t size) { std::memcpy(bytes_.data(), bytes, size); }
  template <class Number>
  operator Number() const {  // NOLINT(google-explicit-constructor): the parameter says what is wanted
    Number value;
    std::memcpy(&value, bytes_.data(), sizeof value);
    return value;
  }

 private:
  std::array<unsigned char, 16> bytes_{};
};
using Given = std::vector<Passed>;

struct Function {
  std::string_view name;
  abut_status (*call)(const Given&);
  bool is_exclusive;  // on a universe, and refused in a callback
  std::vector<Value> arguments;
};

struct Struct {
  std::string_view name;
  std::size_t size;
  void (*init)(void*, std::uint32_t);  // null: it has none
  std::vector<Value> fields;
};

std::vector<Function> functions_of_abut();
std::vector<Function> functions_of_picking();
std::vector<Function> functions_of_response();
std::vector<Struct> structs_of_abut();
std::vector<Struct> structs_of_picking();
std::vector<Struct> structs_of_response();

}  // namespace abut_test::table
