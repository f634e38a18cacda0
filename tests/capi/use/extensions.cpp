// SPDX-License-Identifier: Apache-2.0
// Extension libraries that stand on a universe, as the plan tells them.
#include <thread>

#include "support.hpp"

namespace {

using namespace abut_test;

std::string explain(const abut_universe* universe, abut_status (*words)(const abut_universe*, char*, std::size_t,
                                                                        std::size_t*) = abut_universe_explain) {
  std::size_t needed = 0;
  require(words(universe, nullptr, 0, &needed));
  std::string text(needed, '?');
  require(words(universe, text.data(), text.size(), &needed));
  return text;
}
bool tells(const abut_universe* universe, std::string_view words) {
  return explain(universe).find(words) != std::string::npos;
}

TEST(Extensions, AreToldByNameAndCount) {
  const Universe universe;
  EXPECT_TRUE(tells(universe, "  extensions: none attached\n"));
  require(abut_universe_attach(universe, "response"));
  require(abut_universe_attach(universe, "picking"));
  require(abut_universe_attach(universe, "response"));
  EXPECT_TRUE(tells(universe, "\nextensions: 1 picking, 2 response\n")) << explain(universe);
  EXPECT_FALSE(tells(universe, "none attached"));
  EXPECT_NE(explain(universe, abut_universe_explain_json).find(R"("extensions": [{"name": "picking", "count": 1}, )"),
            std::string::npos);
  require(abut_universe_detach(universe, "picking"));
  require(abut_universe_detach(universe, "response"));
  EXPECT_TRUE(tells(universe, "\nextensions: 1 response\n"));
  require(abut_universe_detach(universe, "response"));
  EXPECT_TRUE(tells(universe, "  extensions: none attached\n"));
}

TEST(Extensions, BelongToTheirUniverse) {
  const Universe universe, other;
  require(abut_universe_attach(universe, "a.b-c_1"));
  EXPECT_TRUE(tells(universe, "1 a.b-c_1"));
  EXPECT_TRUE(tells(other, "none attached"));
}

TEST(Extensions, AreCountedByManyThreadsAtOnce) {
  const Universe universe;
  constexpr int rounds = 500;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int round = 0; round < rounds; ++round) {
        require(abut_universe_attach(universe, "one"));
        require(abut_universe_attach(universe, "two"));
        require(abut_universe_detach(universe, "one"));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_TRUE(tells(universe, "\nextensions: " + std::to_string(4 * rounds) + " two\n"));
}

// What stands on a universe may go after its creator has let go of it, on any thread.
TEST(Extensions, KeepTheirUniverse) {
  constexpr std::uint64_t words = 2048;  // of messages that are kept
  std::uint64_t bytes = 0, before = 0, blocks = 0;
  require(abut_memory_in_use(&before, &blocks));
  abut_universe* universe = nullptr;
  require(abut_universe_create(nullptr, &universe));
  constexpr int count = 8;
  for (int i = 0; i < count; ++i) require(abut_universe_attach(universe, "response"));
  abut_universe_destroy(universe);
  EXPECT_TRUE(refused(abut_universe_detach(universe, "picking"), ABUT_UNKNOWN_VALUE, {"name", "picking"}));
  require(abut_memory_in_use(&bytes, &blocks));
  EXPECT_GT(bytes, before + words) << "it is there";
  std::vector<std::thread> threads;
  for (int i = 0; i < count; ++i)
    threads.emplace_back([universe] { require(abut_universe_detach(universe, "response")); });
  for (std::thread& thread : threads) thread.join();
  require(abut_memory_in_use(&bytes, &blocks));
  EXPECT_LE(bytes, before + words) << "the last one has destroyed it";
}

// Times are there in the step after the first question, and not before.
TEST(Extensions, TimesOfPairsComeAfterTheFirstQuestion) {
  Universe universe;
  const Shape ball = make_sphere(1);
  const abut_part_id part = universe.add_part(identity);
  universe.add_geometry(part, ball);
  universe.add(ball, at(1, 0, 0));
  universe.step();
  EXPECT_FALSE(tells(universe, "us a pair"));
  universe.move(part, at(0.1, 0, 0));
  universe.step();
  EXPECT_TRUE(tells(universe, "us a pair")) << explain(universe);
  EXPECT_NE(explain(universe, abut_universe_explain_json).find(R"("contacts": 1, "microseconds": )"),
            std::string::npos);
}

}  // namespace
