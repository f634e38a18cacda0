// SPDX-License-Identifier: Apache-2.0
// A call with good arguments, made of what the table says of them, which a test then spoils one by one.
#pragma once

#include "table.hpp"
#include "world.hpp"

#include <deque>
#include <map>
#include <string>

namespace abut_test::table {

// Which good values are taken, where the type of a parameter does not tell.
struct Choice {
  std::size_t kind = 0;     // of shapes and geometries
  std::size_t count = 4;    // of elements
  std::size_t pattern = 0;  // of arrays of numbers
  std::uint32_t grid = 1;   // columns, rows and layers
  std::size_t text = 0;
  std::size_t saved = 0;
};

const Struct& find_struct(std::string_view name);

constexpr std::size_t patterns = 5, texts = 3;

class Call {
 public:
  Call(const Function& function, const World& world, const Choice& choice);

  const Given& given() const { return given_; }
  abut_status make() const { return function_.call(given_); }
  // The same with one argument in the place of another.
  template <class Other>
  abut_status make_with(std::size_t argument, const Other& other) const {
    Given given = given_;
    given.at(argument).set(other);
    return function_.call(given);
  }

  abut_status make_with_bytes(std::size_t argument, const void* bytes, std::size_t size) const {
    Given given = given_;
    given.at(argument).set_bytes(bytes, size);
    return function_.call(given);
  }

  // The memory that an argument points to.
  std::vector<unsigned char>& memory(std::size_t argument) { return memory_.at(argument); }
  // How many elements an array has.
  std::size_t count(std::size_t argument) const;
  bool is_untouched() const { return memory_ == before_; }
  void remember() { before_ = memory_; }
  // Takes back what the call has made.
  void release_made() const;

 private:
  void pass_value(std::size_t argument);
  void pass_memory(std::size_t argument);
  void fill(unsigned char* place, const Value& value, std::size_t first, std::size_t index);
  void fill_struct(unsigned char* place, const Struct& its, std::size_t index);
  void fill_fields(unsigned char* place, const Struct& its);
  std::uint64_t whole(const Value& value) const;
  std::size_t length_of(std::string_view length) const;

  const Function& function_;
  const World& world_;
  Choice choice_;
  Given given_;
  std::vector<std::vector<unsigned char>> memory_, before_;
  std::deque<std::vector<unsigned char>> inner_;  // arrays that fields point to
  std::map<std::string, std::size_t, std::less<>> numbers_;
};

}  // namespace abut_test::table
