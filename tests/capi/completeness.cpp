// SPDX-License-Identifier: Apache-2.0
// Every function of abut.h has a suite of its own name here. It has a test for each kind of bad input that its
// parameters make possible. abut_shape_cast_ray belongs to the suite ShapeCastRay.
#include <cctype>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "support.hpp"

namespace {

struct Declaration {
  std::string name;
  std::string parameters;
  bool can_fail = false;
};

std::string text_of_the_header() {
  std::ifstream file(ABUT_HEADER_PATH);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Declarations begin with ABUT_API at the start of a line and end with a semicolon.
std::vector<Declaration> declarations() {
  std::vector<Declaration> found;
  const std::string text = text_of_the_header();
  constexpr std::string_view mark = "\nABUT_API ";
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
    const std::string line = text.substr(at + mark.size(), text.find(';', at) - at - mark.size());
    const std::size_t open = line.find('(');
    std::size_t begin = open;
    while (begin > 0 && line.at(begin - 1) != ' ' && line.at(begin - 1) != '*') --begin;
    found.push_back({line.substr(begin, open - begin), line.substr(open), line.starts_with("abut_status ")});
  }
  return found;
}

// abut_shape_cast_ray -> ShapeCastRay
std::string suite_of(const std::string& function) {
  std::string suite;
  bool capital = true;
  for (const char letter : function.substr(std::string_view("abut_").size())) {
    if (letter == '_') {
      capital = true;
      continue;
    }
    suite += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
    capital = false;
  }
  return suite;
}

bool has(const std::string& text, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [&](auto word) { return text.find(word) != std::string::npos; });
}

// Numbers come by value, or in arrays and structs that are only read. Places for answers are not const.
bool takes_numbers(const std::string& parameters) {
  std::string rest = parameters.substr(1);
  for (std::size_t answer = rest.find(", double *"); answer != std::string::npos; answer = rest.find(", double *")) {
    rest.erase(answer, std::string_view(", double *").size());
  }
  return rest.starts_with("double ") ||
         has(rest, {", double ", "const double *", "const abut_pose *", "const abut_vec3 *", "const abut_aabb *",
                    "const abut_ray *", "const abut_geometry_options *", "const abut_policy *", "const abut_focus *",
                    "const abut_sleep *", "const abut_velocity *", "const abut_acceleration *", "const abut_movement *",
                    "_desc *"});
}

// The words that the tests of a function must name.
std::vector<std::string_view> obligations(const Declaration& declaration) {
  std::vector<std::string_view> words;
  if (!declaration.can_fail) return words;
  const std::string& parameters = declaration.parameters;
  const bool is_extension_entry = declaration.name == "abut_set_last_error";
  if (is_extension_entry) return words;
  words.emplace_back("Refuses");
  if (has(parameters, {"*"})) words.emplace_back("Null");
  if (takes_numbers(parameters)) words.emplace_back("NonFinite");
  if (has(parameters,
          {"abut_part_id part,", "abut_part_id part)", "const abut_part_id *parts", "abut_geometry_id geometry,",
           "abut_geometry_id geometry)", "const abut_geometry_id *", "const abut_collidable *"})) {
    words.emplace_back("Stale");
  }
  if (has(parameters, {"_options *", "_desc *", "_info *", "_stats *", "_report *", "abut_policy *", "abut_focus *",
                       "abut_sleep *"}))
    words.emplace_back("StructSize");
  const bool is_parking = declaration.name.ends_with("_park");
  if (parameters.starts_with("(abut_universe *") && !is_parking) words.emplace_back("Busy");
  if (has(parameters, {"size_t count", "size_t point_count", "size_t vertex_count"})) words.emplace_back("Overflow");
  return words;
}

std::map<std::string, std::set<std::string>> registered_tests() {
  std::map<std::string, std::set<std::string>> tests;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int suite = 0; suite < all.total_test_suite_count(); ++suite) {
    const testing::TestSuite& each = *all.GetTestSuite(suite);
    for (int test = 0; test < each.total_test_count(); ++test)
      tests[each.name()].insert(each.GetTestInfo(test)->name());
  }
  return tests;
}

TEST(Completeness, FindsTheDeclarations) {
  const std::vector<Declaration> all = declarations();
  EXPECT_GE(all.size(), 97U);
  EXPECT_EQ(suite_of("abut_shape_cast_ray"), "ShapeCastRay");
  const auto step =
      std::find_if(all.begin(), all.end(), [](const auto& each) { return each.name == "abut_universe_step"; });
  ASSERT_NE(step, all.end());
  EXPECT_TRUE(step->can_fail);
}

TEST(Completeness, EveryFunctionHasItsTests) {
  const auto tests = registered_tests();
  for (const Declaration& declaration : declarations()) {
    const auto suite = tests.find(suite_of(declaration.name));
    if (suite == tests.end()) {
      ADD_FAILURE() << declaration.name << " has no tests";
      continue;
    }
    for (const std::string_view word : obligations(declaration)) {
      const bool is_met = std::any_of(suite->second.begin(), suite->second.end(),
                                      [&](const std::string& name) { return name.find(word) != std::string::npos; });
      EXPECT_TRUE(is_met) << declaration.name << " has no test of \"" << word << "\"";
    }
  }
}

}  // namespace
