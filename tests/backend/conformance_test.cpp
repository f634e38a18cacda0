// SPDX-License-Identifier: Apache-2.0
// Two detectors under one suite, and what the suite says of detectors that are wrong.
#include "conformance.hpp"
#include "support.hpp"

namespace {

using backend::Detector;

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& its : sentences) text += its + "\n";
  return text;
}

class Conforms : public testing::TestWithParam<Detector> {};

TEST_P(Conforms, InEveryScene) {
  const std::vector<std::string> shortfalls = backend::shortfalls_of(GetParam());
  EXPECT_TRUE(shortfalls.empty()) << joined(shortfalls);
}

std::string name_of(const testing::TestParamInfo<Detector>& info) { return info.param.name; }
#ifdef ABUT_TEST_HAS_BULLET
INSTANTIATE_TEST_SUITE_P(Backend, Conforms, testing::Values(backend::plain(), backend::bullet()), name_of);
#else
INSTANTIATE_TEST_SUITE_P(Backend, Conforms, testing::Values(backend::plain()), name_of);
#endif

// The plain detector with one mistake.
using Mistake = void (*)(const abut_backend_pair& pair, std::vector<abut_backend_contact>& contacts);

void find_wrongly(void* context, abut_universe* universe, const abut_backend_pair* pairs, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    auto contacts = backend::contacts_of(pairs[i]).value();
    (*static_cast<Mistake*>(context))(pairs[i], contacts);
    backend::answer(universe, i, contacts);
  }
}

// Which part of the suite has to notice.
void expect_noticed(Mistake mistake, std::string_view word) {
  const Detector wrong{"wrong", nullptr, find_wrongly, &mistake, 1e-9};
  const std::string text = joined(backend::shortfalls_of(wrong));
  EXPECT_NE(text.find(word), std::string::npos) << "the suite should say \"" << word << "\", and says:\n" << text;
}

TEST(ConformanceSuite, NoticesContactsThatAreMissing) {
  expect_noticed([](const abut_backend_pair&, std::vector<abut_backend_contact>& its) { its.clear(); },
                 "have no contact");
}

TEST(ConformanceSuite, NoticesAContactOfShapesThatAreApart) {
  expect_noticed(
      [](const abut_backend_pair& pair, std::vector<abut_backend_contact>& its) {
        if (its.empty()) its.push_back(backend::contact_of(pair.pose_b.position, pair.pose_a.position, {1, 0, 0}));
      },
      "have contacts and are");
}

TEST(ConformanceSuite, NoticesNormalsFromBToA) {
  expect_noticed(
      [](const abut_backend_pair&, std::vector<abut_backend_contact>& its) {
        for (abut_backend_contact& each : its) each.normal = {-each.normal.x, -each.normal.y, -each.normal.z};
      },
      "have no contact");
}

TEST(ConformanceSuite, NoticesPointsInTheFrameOfAShape) {
  expect_noticed(
      [](const abut_backend_pair& pair, std::vector<abut_backend_contact>& its) {
        for (abut_backend_contact& each : its) {
          for (abut_vec3* point : {&each.point_a, &each.point_b}) {
            *point = {point->x - pair.pose_a.position.x, point->y - pair.pose_a.position.y,
                      point->z - pair.pose_a.position.z};
          }
        }
      },
      "off its surface");
}

TEST(ConformanceSuite, NoticesAAndBInTheWrongOrder) {
  expect_noticed(
      [](const abut_backend_pair&, std::vector<abut_backend_contact>& its) {
        for (abut_backend_contact& each : its) std::swap(each.point_a, each.point_b);
      },
      "off its surface");
}

TEST(ConformanceSuite, NoticesDepthsThatAreALittleOff) {
  expect_noticed(
      [](const abut_backend_pair&, std::vector<abut_backend_contact>& its) {
        for (abut_backend_contact& each : its) each.point_b.x += 1e-6 * each.normal.x;
      },
      "the contacts say");
}

TEST(ConformanceSuite, NoticesIdsThatChange) {
  expect_noticed(
      [](const abut_backend_pair&, std::vector<abut_backend_contact>& its) {
        static std::uint64_t next = 1;
        for (abut_backend_contact& each : its) each.id = next++;
      },
      "keep their ids");
}

TEST(ConformanceSuite, NoticesAnswersThatDependOnTheSlots) {
  expect_noticed(
      [](const abut_backend_pair& pair, std::vector<abut_backend_contact>& its) {
        if (pair.geometry_a.slot == 1) its.clear();
      },
      "the order takes the contacts");
}

}  // namespace
