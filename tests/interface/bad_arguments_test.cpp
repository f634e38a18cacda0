// SPDX-License-Identifier: Apache-2.0
// Each argument of each function under bad input: null, stale, not finite, out of its range, unknown, of a wrong size,
// reserved, too many. The table says what may be given. Every refusal names the argument and changes nothing, and the
// call with good arguments succeeds.
#include "call.hpp"

#include <functional>
#include <map>
#include <ostream>

namespace abut_test::table {

void PrintTo(const Function& function, std::ostream* out) { *out << function.name; }

}  // namespace abut_test::table

namespace {

using namespace abut_test;
using namespace abut_test::table;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<std::pair<double, std::string_view>, 3> not_finite{
    {{std::numeric_limits<double>::quiet_NaN(), "nan"}, {infinity, "inf"}, {-infinity, "inf"}}};

std::vector<Function> all_functions() {
  std::vector<Function> functions = functions_of_abut();
#ifdef ABUT_TABLE_HAS_PICKING
  for (const Function& each : functions_of_picking()) functions.push_back(each);
#endif
#ifdef ABUT_TABLE_HAS_RESPONSE
  for (const Function& each : functions_of_response()) functions.push_back(each);
#endif
  // Answers the status that it is given.
  std::erase_if(functions, [](const Function& each) { return each.name == "abut_set_last_error"; });
  return functions;
}

// The first good values with which a call succeeds, in the world that it changes then.
class Search {
 public:
  explicit Search(const Function& function) : function_(function) {}

  bool find(const World& world) {
    const std::size_t kinds = uses({"abut_shape", "abut_geometry_id", "abut_part_id"}) ? World::kinds() : 1;
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      for (std::size_t pattern = 0; pattern < patterns; ++pattern) {
        for (const std::size_t count : {4U, 1U, 3U, 2U}) {
          if (find(world, {.kind = kind, .count = count, .pattern = pattern})) return true;
        }
      }
    }
    return false;
  }

  Choice choice;
  std::string message;

 private:
  bool find(const World& world, Choice some) {
    const std::size_t saved = uses({"void"}) ? 2 : 1;
    for (some.grid = 1; some.grid < 4; ++some.grid) {
      for (some.text = 0; some.text < texts; ++some.text) {
        for (some.saved = 0; some.saved < saved; ++some.saved) {
          if (is_good(Call(function_, world, some))) {
            choice = some;
            return true;
          }
        }
      }
    }
    return false;
  }
  bool is_good(const Call& call) {
    const bool is_done = call.make() == ABUT_OK;
    if (is_done) call.release_made();
    if (!is_done) message = abut_last_error_message();
    return is_done;
  }
  bool uses(std::initializer_list<std::string_view> types) const {
    return std::any_of(function_.arguments.begin(), function_.arguments.end(), [&](const Value& value) {
      return std::find(types.begin(), types.end(), value.type) != types.end();
    });
  }

  const Function& function_;
};

// Where a value lies: makes the call with other bytes there.
using With = std::function<abut_status(const void* bytes, std::size_t size)>;

// Gives one bad value after the other. Each has to be refused with its status, by the name of the argument or the
// field.
class Spoiler {
 public:
  Spoiler(const Function& function, const World& world, const Choice& choice)
      : function_(function), call_(function, world, choice), world_(world) {}

  void spoil_all() {
    for (std::size_t i = 0; i < function_.arguments.size(); ++i) spoil_argument(function_.arguments[i], i);
    EXPECT_TRUE(call_.is_untouched()) << "memory of the caller was written";
    EXPECT_TRUE(world_.is_unchanged());
  }

 private:
  using Words = std::vector<std::string>;

  void expect_refused(abut_status status, abut_status expected, const Words& words) {
    const std::string message = abut_last_error_message();
    EXPECT_EQ(abut_status_name(status), std::string(abut_status_name(expected))) << testing::PrintToString(words);
    for (const std::string& word : words)
      EXPECT_NE(message.find(word), std::string::npos) << message << " lacks " << word;
  }
  template <class Number>
  void expect_bad(const With& with, Number number, abut_status expected, const Words& words) {
    expect_refused(with(&number, sizeof number), expected, words);
  }

  void spoil_argument(const Value& value, std::size_t argument) {
    const Words names{std::string(value.name)};
    if ((value.is_pointer || value.role == Role::callback) && !value.may_be_null) {
      expect_refused(call_.make_with(argument, static_cast<const void*>(nullptr)), ABUT_NULL_ARGUMENT,
                     {names[0], "null"});
    }
    if (!value.is_pointer) {
      spoil_value(
          value, [&](const void* bytes, std::size_t size) { return call_.make_with_bytes(argument, bytes, size); },
          names);
      if (is_length(value)) spoil_length(value, argument);
    } else if (!value.is_output) {
      spoil_memory(value, argument);
    } else if (value.role == Role::structure && find_struct(value.type).init != nullptr) {
      spoil_size(find_struct(value.type), argument, {0, 3, find_struct(value.type).size - 1});
    }
  }

  // The last element of an array, or the only one.
  void spoil_memory(const Value& value, std::size_t argument) {
    if (value.role == Role::text || value.role == Role::bytes || value.role == Role::handle) return;
    const std::size_t last = call_.count(argument) - 1;
    const std::size_t place = last * value.size;
    if (value.role == Role::handles) {
      expect_bad(at_place(argument, place), static_cast<const void*>(nullptr), ABUT_NULL_ARGUMENT,
                 {element(value, last), "null"});
    } else if (value.role == Role::structure) {
      const Struct& its = find_struct(value.type);
      spoil_fields(its, argument, place, {element(value, last)}, value.range);
      if (its.init != nullptr) {
        spoil_size(its, argument, {0, 1, 3, its.size - 1});
        if (call_.count(argument) == 1) spoil_tail(its, argument);
      }
    } else {
      // Parameters of a kind of shape have names of their own.
      spoil_value(value, at_place(argument, place), value.name == "parameters" ? Words{} : Words{element(value, last)});
    }
  }

  void spoil_fields(const Struct& its, std::size_t argument, std::size_t place, const Words& names,
                    const Range& outer) {
    for (Value field : its.fields) {
      field.range.may_be_infinite = field.range.may_be_infinite || outer.may_be_infinite;
      field.range.may_be_far = field.range.may_be_far || outer.may_be_far;
      // A field of options may be named by itself, vectors and the like as a whole.
      Words words = its.init != nullptr ? Words{} : names;
      if (its.init != nullptr || its.fields[0].role == Role::structure) words.emplace_back(field.name);
      const std::size_t at = place + field.offset;
      if (field.name == "struct_size") continue;
      if (field.is_pointer) {
        if (!field.may_be_null && !field.length.empty()) {
          words.emplace_back("null");
          expect_bad(at_place(argument, at), static_cast<const void*>(nullptr), ABUT_NULL_ARGUMENT, words);
        }
      } else if (field.type == "abut_quat") {
        spoil_rotation(at_place(argument, at), words);
      } else if (field.role == Role::structure) {
        spoil_fields(find_struct(field.type), argument, at, words, field.range);
      } else {
        const std::size_t last = field.fixed_count > 0 ? (field.fixed_count - 1) * field.size : 0;
        const With with = at_place(argument, at + last);
        spoil_value(field, with, words);
        if (its.name == "abut_vec3" && !field.range.may_be_far) expect_bad(with, -1e71, ABUT_OUT_OF_RANGE, words);
      }
    }
  }

  // Lengths are within 1e-3 of 1.
  void spoil_rotation(const With& with, const Words& names) {
    for (const auto& [bad, word] : not_finite) {
      for (const abut_quat& quat : {abut_quat{bad, 0, 0, 0}, {1, bad, 0, 0}, {1, 0, bad, 0}, {1, 0, 0, bad}})
        expect_bad(with, quat, ABUT_NOT_FINITE, plus(names, std::string(word)));
    }
    for (const double zero : {0.0, -0.0}) expect_bad(with, abut_quat{zero, 0, zero, 0}, ABUT_ZERO_VECTOR, names);
    for (const double length : {2.0, 0.5, 1.0015, 0.9985, 1e-200, 1e200}) {
      expect_bad(with, abut_quat{length, 0, 0, 0}, ABUT_NOT_UNIT, names);
      expect_bad(with, abut_quat{0, 0.6 * length, 0, 0.8 * length}, ABUT_NOT_UNIT, names);
    }
  }

  void spoil_value(const Value& value, const With& with, const Words& names) {
    if (value.range.is_unread) return;
    if (value.range.is_reserved) {
      expect_bad(with, std::uint64_t{1} << 1U, value.size, ABUT_INVALID_ARGUMENT, names);
    } else if (value.role == Role::id) {
      // A record by itself names geometries of whatever universe.
      if (function_.arguments[0].role != Role::handle) return;
      for (const std::uint64_t stale : world_.stale(value.type)) {
        if (static_cast<std::uint32_t>(stale) == 0 && value.may_be_null) continue;
        expect_bad(with, stale, ABUT_STALE_ID, plus(names, std::to_string(static_cast<std::uint32_t>(stale))));
      }
    } else if (value.role == Role::choice || value.role == Role::bits) {
      const bool is_choice = value.role == Role::choice;
      for (const std::uint64_t number :
           {is_choice ? value.known + 1 : ~value.known & (value.known + 1), ~std::uint64_t{0}}) {
        const auto narrow = static_cast<std::uint32_t>(number);
        expect_bad(with, narrow, ABUT_UNKNOWN_VALUE, plus(names, std::to_string(narrow)));
      }
    } else if (value.is_real) {
      spoil_real(value.range, with, names);
    } else if (value.role == Role::number) {
      spoil_whole(value, with, names);
    }
  }

  void spoil_real(const Range& range, const With& with, const Words& names) {
    for (const auto& [number, word] : not_finite) {
      const bool is_nan = number != number;
      if (is_nan ? range.may_be_nan : range.may_be_infinite) continue;
      expect_bad(with, number, ABUT_NOT_FINITE, plus(names, std::string(word)));
    }
    if (range.least > -infinity) expect_bad(with, range.least - 2.5, ABUT_OUT_OF_RANGE, names);
    if (range.is_open) expect_bad(with, range.least, ABUT_OUT_OF_RANGE, names);
    if (range.most < infinity) expect_bad(with, 2 * range.most + 1, ABUT_OUT_OF_RANGE, names);
  }

  void spoil_whole(const Value& value, const With& with, const Words& names) {
    const abut_status below = is_length(value) ? ABUT_EMPTY : ABUT_OUT_OF_RANGE;
    if (value.range.least >= 1) {
      const auto number = static_cast<std::uint64_t>(value.range.least) - 1;
      expect_bad(with, number, value.size, below, names);
    }
    if (value.range.most < infinity) {
      const auto number = static_cast<std::uint64_t>(value.range.most) + 1;
      expect_bad(with, number, value.size, ABUT_OUT_OF_RANGE, plus(names, std::to_string(number)));
    }
  }

  // So many elements do not fit into memory. Each wraps to something small when multiplied.
  void spoil_length(const Value& value, std::size_t argument) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    for (const std::uint64_t number : {most, most / 2 + 1}) {
      expect_refused(call_.make_with(argument, number), ABUT_SIZE_OVERFLOW,
                     {std::string(value.name), std::to_string(number)});
    }
  }

  void spoil_size(const Struct& its, std::size_t argument, std::initializer_list<std::size_t> sizes) {
    EXPECT_EQ(its.fields[0].name, "struct_size");
    for (const std::size_t size : sizes) {
      expect_bad(at_place(argument, 0), static_cast<std::uint32_t>(size), ABUT_WRONG_STRUCT_SIZE,
                 {"struct_size", std::to_string(size)});
    }
  }

  // A struct of a later version of the header, with a field that is unknown here.
  void spoil_tail(const Struct& its, std::size_t argument) {
    std::vector<unsigned char> later = call_.memory(argument);
    const auto size = static_cast<std::uint32_t>(its.size + 16);
    later.resize(size);
    std::memcpy(later.data(), &size, sizeof size);
    for (const std::size_t place : {its.size, its.size + 15}) {
      later[place] = 1;
      expect_refused(call_.make_with(argument, later.data()), ABUT_WRONG_STRUCT_SIZE,
                     {"struct_size", std::to_string(size)});
      later[place] = 0;
    }
  }

  void expect_bad(const With& with, std::uint64_t number, std::size_t size, abut_status expected, const Words& words) {
    expect_refused(with(&number, size), expected, words);
  }
  With at_place(std::size_t argument, std::size_t place) {
    return [this, argument, place](const void* bytes, std::size_t size) {
      unsigned char* const at = &call_.memory(argument).at(place);
      std::vector<unsigned char> before(at, at + size);
      std::memcpy(at, bytes, size);
      const abut_status status = call_.make();
      std::memcpy(at, before.data(), size);
      return status;
    };
  }
  // As messages name it.
  static std::string element(const Value& value, std::size_t index) {
    return std::string(value.name) + (value.length.empty() ? "" : "[" + std::to_string(index) + "]");
  }
  static Words plus(Words words, std::string word) {
    words.push_back(std::move(word));
    return words;
  }
  // Whether the length of an array that is read or written follows from it.
  bool is_length(const Value& value) const {
    return value.type == "size_t" &&
           std::any_of(function_.arguments.begin(), function_.arguments.end(), [&](const Value& other) {
             return (" " + std::string(other.length) + " ").find(" " + std::string(value.name) + " ") !=
                    std::string::npos;
           });
  }

  const Function& function_;
  Call call_;
  const World& world_;
};

// Calls for which no good arguments are at hand.
const std::map<std::string_view, std::string_view> without_success{
    {"abut_backend_answer", "is refused outside of abut_backend_find"},
    {"abut_set_allocator", "is refused while there is anything"},
    {"abut_response_release", "ends bonds, of which there are none"}};

class Arguments : public testing::TestWithParam<Function> {
 protected:
  void SetUp() override {
    const World world;
    Search search(function());
    has_success_ = !without_success.contains(function().name);
    EXPECT_EQ(search.find(world), has_success_) << "no good arguments; the last try: " << search.message;
    choice_ = search.choice;
  }
  const Function& function() const { return GetParam(); }
  bool has_success() const { return has_success_; }

  // A call with good arguments, of which `change` replaces some, succeeds in a world of its own.
  template <class Change>
  void expect_good(std::string_view what, const Change& change) const {
    const World world;
    Call call(function(), world, choice_);
    Given given = call.given();
    change(call, given);
    EXPECT_EQ(function().call(given), ABUT_OK) << what << ": " << abut_last_error_message();
    call.release_made();
  }
  const Choice& choice() const { return choice_; }

 private:
  bool has_success_ = false;
  Choice choice_;
};

TEST_P(Arguments, ThatAreBadAreRefusedByName) {
  const World world;
  Spoiler spoiler(function(), world, choice());
  spoiler.spoil_all();
}

// Pointers that may be null, and structs of a later version of the header that ask for nothing new.
TEST_P(Arguments, MayBeNullOrOfALaterHeader) {
  for (std::size_t i = 0; has_success() && i < function().arguments.size(); ++i) {
    const Value& value = function().arguments[i];
    if (value.may_be_null && value.is_pointer) {
      expect_good(value.name, [&](const Call&, Given& given) { given[i].set(static_cast<const void*>(nullptr)); });
    }
    if (value.role == Role::structure && value.is_pointer && value.length.empty() &&
        find_struct(value.type).init != nullptr) {
      expect_good(value.name, [&](Call& call, Given& given) {
        std::vector<unsigned char>& later = call.memory(i);
        const auto size = static_cast<std::uint32_t>(later.size() + 16);
        later.resize(size);
        std::memcpy(later.data(), &size, sizeof size);
        given[i].set(later.data());
      });
    }
  }
}

// Arrays of no elements may be null, of functions that need none.
TEST_P(Arguments, MayBeArraysOfNothing) {
  const std::vector<Value>& arguments = function().arguments;
  const auto count = std::find_if(arguments.begin(), arguments.end(), [](const Value& value) {
    return value.type == "size_t" && !value.is_pointer && (value.name == "count" || value.name == "pair_count");
  });
  if (!has_success() || count == arguments.end()) return;
  const World world;
  const Call call(function(), world, choice());
  Given given = call.given();
  given.at(static_cast<std::size_t>(count - arguments.begin())).set(std::uint64_t{0});
  if (function().call(given) != ABUT_OK) return;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].length.starts_with(count->name) && !arguments[i].length.ends_with("+ 1")) {
      given[i].set(static_cast<const void*>(nullptr));
    }
  }
  EXPECT_EQ(function().call(given), ABUT_OK) << abut_last_error_message();
}

// What may change a universe is refused in a callback of it.
struct InCallback {
  const Call& call;
  int times = 0;
};
std::uint32_t call_in_filter(void* context, const abut_universe* universe, const abut_geometry_id* a,
                             const abut_geometry_id* b) {
  static_cast<void>(universe);
  static_cast<void>(a);
  static_cast<void>(b);
  auto& its = *static_cast<InCallback*>(context);
  ++its.times;
  EXPECT_EQ(its.call.make(), ABUT_BUSY) << abut_last_error_message();
  return 1;
}

TEST_P(Arguments, OfAChangeAreRefusedInACallback) {
  if (!function().is_exclusive || function().arguments[0].type != "abut_universe") return;
  const World world;
  const Call call(function(), world, choice());
  InCallback context{call};
  require(abut_universe_set_pointer_filter(world.universe(), call_in_filter, &context));
  require(abut_universe_step(world.universe(), 0));
  EXPECT_GT(context.times, 0);
  EXPECT_TRUE(call.is_untouched());
}

std::string name_of(const testing::TestParamInfo<Function>& info) { return std::string(info.param.name); }

INSTANTIATE_TEST_SUITE_P(Table, Arguments, testing::ValuesIn(all_functions()), name_of);

}  // namespace
