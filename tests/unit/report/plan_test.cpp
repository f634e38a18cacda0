// SPDX-License-Identifier: Apache-2.0
// The plan as text and as JSON.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

import abut.scene.state.options;
import abut.report.plan;

namespace {

using namespace abut;

Plan some_plan() {
  StepStats stats;
  stats.parts = 3;
  stats.geometries = 1;
  stats.bytes = 12345;
  return {.stats = stats,
          .broadphase = "tree",
          .broadphase_reason = "because of \"many\" \\ boxes",
          .is_margin = true,
          .max_contacts = 4,
          .threads = 2,
          .rules = 5,
          .policies = 6,
          .stages = {{"refresh", 1.25, "one"}, {"a name longer than its column", 0.5, "two"}},
          .kinds = {{"box", "sphere", 10, 9, 8, 7, "closed form", "it has one", 0.25}},
          .left_out = {{"sleep", "set for no part"}},
          .islands = Plan::IslandCounts{2, 3, 2},
          .velocities = Plan::VelocityCounts{1, 4},
          .extensions = {{"picking", 2}, {"response", 1}}};
}

TEST(Plan, AsJsonIsWhatItWas) {
  const nlohmann::json json = nlohmann::json::parse(to_json(some_plan()));
  EXPECT_EQ(json["counts"]["parts"], 3);
  EXPECT_EQ(json["counts"]["bytes"], 12345);
  EXPECT_EQ(json["broadphase"]["algorithm"], "tree");
  EXPECT_EQ(json["broadphase"]["reason"], "because of \"many\" \\ boxes");
  EXPECT_EQ(json["tolerance_mode"], "margin");
  EXPECT_EQ(json["stages"].size(), 2U);
  EXPECT_EQ(json["stages"][0]["microseconds"], 1.25);
  EXPECT_EQ(json["pairs_of_kinds"][0]["touching"], 8);
  EXPECT_EQ(json["left_out"][0]["why"], "set for no part");
  EXPECT_EQ(json["islands"]["largest"], 2);
  EXPECT_EQ(json["velocities"]["from_poses"], 4);
  EXPECT_EQ(json["extensions"][0]["name"], "picking");
  EXPECT_EQ(json["extensions"][0]["count"], 2);
  EXPECT_EQ(json["pairs_of_kinds"][0]["microseconds"], 0.25);
  EXPECT_EQ(json["rules"], 5);
}

TEST(Plan, AsJsonCanBeEmpty) {
  Plan plan = some_plan();
  plan.stages.clear();
  plan.kinds.clear();
  plan.left_out.clear();
  const nlohmann::json json = nlohmann::json::parse(to_json(plan));
  EXPECT_TRUE(json["stages"].empty());
  EXPECT_TRUE(json["pairs_of_kinds"].empty());
}

TEST(Plan, AsTextHasALineForEverything) {
  const std::string text = to_text(some_plan());
  for (const char* line :
       {"universe: 3 parts, 1 geometry, 12345 bytes\n", "  refresh             1.3 us  one\n",
        "broad phase: tree, because of", "threads: 2\n", "tolerance: margin",
        "  box - sphere: 10 candidates, 9 examined, 8 touching, 7 contacts; 0.25 us a pair; closed form (it has one)\n",
        "islands: 2 of 3 parts, the largest of 2\n", "velocities: 1 given, 4 from poses\n",
        "extensions: 2 picking, 1 response\n", "  sleep: set for no part\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
  }
}

}  // namespace
