// SPDX-License-Identifier: Apache-2.0
// Which of some measured routes a time budget takes, and what a table of them may look like.
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>

import abut.capability;
import abut.pairs.any_shape;
import abut.pairs.two_shapes.measured_routes;

namespace {

using namespace abut;

constexpr std::array<MeasuredRoute, 4> routes{{{.error_bound = 1e-12, .seconds = 8e-7, .worst_error = 1e-12},
                                               {.error_bound = 1e-4, .seconds = 4e-7, .worst_error = 1e-4},
                                               {.algorithm = Algorithm::gjk_epa, .seconds = 5e-7, .worst_error = 1e-4},
                                               {.error_bound = 1e-2, .seconds = 2e-7, .worst_error = 1e-2}}};

TEST(ChooseRoute, TakesTheLeastErrorThatFitsTheTime) {
  EXPECT_EQ(choose_route(routes, {.seconds = 1}), 0U);
  EXPECT_EQ(choose_route(routes, {.seconds = 8e-7}), 0U) << "the budget itself fits";
  EXPECT_EQ(choose_route(routes, {.seconds = 7e-7}), 1U) << "of equal errors the cheaper one";
  EXPECT_EQ(choose_route(routes, {.seconds = 3e-7}), 3U);
}

TEST(ChooseRoute, TakesTheCheapestWhereNothingFits) {
  EXPECT_EQ(choose_route(routes, {.seconds = 1e-9}), 3U);
  EXPECT_EQ(choose_route({}, {.seconds = 1}), std::nullopt);
}

TEST(ChooseRoute, KeepsABoundBeforeABudget) {
  EXPECT_EQ(choose_route(routes, {.seconds = 1, .error_bound = 1e-2}), 3U) << "the cheapest that keeps it";
  EXPECT_EQ(choose_route(routes, {.seconds = 1, .error_bound = 1e-3}), 1U);
  EXPECT_EQ(choose_route(routes, {.seconds = 1e-9, .error_bound = 1e-6}), 0U);
  EXPECT_EQ(choose_route(routes, {.seconds = 1, .error_bound = 1e-15}), std::nullopt);
}

TEST(LoadRoutes, NamesTheLineThatIsWrong) {
  const std::string head = "# abut routes 1\n", good = "distance box box auto 0 1e-07 1e-12\n";
  const auto message_of = [&](const std::string& text) {
    const auto fault = load_routes(text);
    return fault ? fault->message : std::string();
  };
  EXPECT_NE(message_of("").find("line 1 is ''"), std::string::npos);
  EXPECT_NE(message_of("# abut routes 2\n").find("'# abut routes 1'"), std::string::npos);
  for (const char* line : {"distance box box auto 0 1e-07", "distance box box auto 0 1e-07 1e-12 1",
                           "depth box box auto 0 1e-07 1e-12", "distance box box libccd_mpr 0 1e-07 1e-12",
                           "distance box box auto -1 1e-07 1e-12", "distance box box auto 0 nan 1e-12",
                           "distance box box auto 0 1e-07x 1e-12", "distance  box auto 0 1e-07 1e-12"}) {
    EXPECT_NE(message_of(head + good + line).find("line 3 is '" + std::string(line)), std::string::npos) << line;
  }
  std::string many = head;
  for (int i = 0; i < 1025; ++i) {
    many += good;
  }
  EXPECT_NE(message_of(many).find("1025"), std::string::npos);
  EXPECT_EQ(message_of(head + "\n# a comment\ndistance nobody box auto 0 1e-07 1e-12\n" + good), "");
  const std::size_t box = *find_kind(std::string_view("box"));
  EXPECT_EQ(measured_routes(Question::distance, box, box).size(), 1U);
  EXPECT_TRUE(measured_routes(Question::contacts, box, box).empty());
  restore_routes();
  EXPECT_FALSE(measured_routes(Question::contacts, box, box).empty());
}

}  // namespace
