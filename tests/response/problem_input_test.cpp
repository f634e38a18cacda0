// SPDX-License-Identifier: Apache-2.0
// Bad input of contact problems: a status, and a message with name and value. Nothing is written.
#include <abut/response.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

// Two bodies, one on the other, and all that a problem may have.
struct Given {
  std::vector<double> masses{1, 2};
  std::vector<double> inertias{1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0.1, 0, 0.1, 2, 0, 0, 0, 2};
  std::vector<double> centres{0, 0, 1, 0, 0, 3};
  std::vector<double> free{0, 0, -1, 0, 0, 0, 0, 0, -1, 0, 0, 0};
  std::vector<std::uint32_t> bodies{ABUT_NO_BODY, 0, 0, 1};
  std::vector<double> points{0, 0, 0, 0, 0, 2};
  std::vector<double> normals{0, 0, 1, 0, 0, 1};
  std::vector<double> tangents{1, 0, 0, 1, 0, 0};
  std::vector<double> frictions{0.5, 0.4, 0.5, 0.5};
  std::vector<double> compliances{0, 0.1};
  std::vector<double> offsets{0, 0.1};
  std::vector<double> surfaces{0, 0, 0, 1, 0, 0};
  std::vector<double> first_velocities = free;
  std::vector<double> first_impulses{0, 0, 1, 0, 0, 1};

  abut_contact_problem problem{};
  abut_solver_options options{};

  Given() {
    abut_contact_problem_init(&problem, sizeof problem);
    abut_solver_options_init(&options, sizeof options);
    problem.body_count = problem.contact_count = 2;
    problem.masses = masses.data();
    problem.inertias = inertias.data();
    problem.centres = centres.data();
    problem.free_velocities = free.data();
    problem.bodies = bodies.data();
    problem.points = points.data();
    problem.normals = normals.data();
    problem.tangents = tangents.data();
    problem.frictions = frictions.data();
    problem.compliances = compliances.data();
    problem.offsets = offsets.data();
    problem.surface_velocities = surfaces.data();
    problem.first_velocities = first_velocities.data();
    problem.first_impulses = first_impulses.data();
  }
  Given(const Given&) = delete;
  Given& operator=(const Given&) = delete;
};

struct Written {
  std::array<double, 12> velocities;
  std::array<double, 6> impulses;
  abut_residuals residuals;
  Written() : residuals{} {
    residuals.contact = residuals.motion = -7;
    velocities.fill(-7);
    impulses.fill(-7);
  }
  [[nodiscard]] bool is_untouched() const {
    const auto is_seven = [](double number) { return number == -7; };
    bool all = residuals.contact == -7 && residuals.motion == -7;
    for (const double number : velocities) all = all && is_seven(number);
    for (const double number : impulses) all = all && is_seven(number);
    return all;
  }
};

void expect_refused(const std::function<void(Given&)>& spoil, abut_status expected,
                    const std::vector<std::string_view>& words) {
  Given given;
  spoil(given);
  Written out;
  const abut_status status = abut_contact_problem_solve(&given.problem, &given.options, out.velocities.data(),
                                                        out.impulses.data(), &out.residuals);
  const std::string message = abut_last_error_message();
  EXPECT_STREQ(abut_status_name(status), abut_status_name(expected)) << message;
  for (const std::string_view word : words) {
    EXPECT_NE(message.find(word), std::string::npos) << message << " has no " << word;
  }
  EXPECT_TRUE(out.is_untouched()) << message;
}

TEST(ContactProblemInput, IsGoodAsItStands) {
  Given given;
  Written out;
  EXPECT_EQ(abut_contact_problem_solve(&given.problem, &given.options, out.velocities.data(), out.impulses.data(),
                                       &out.residuals),
            ABUT_OK)
      << abut_last_error_message();
  EXPECT_EQ(out.residuals.is_converged, 1U);
}

TEST(ContactProblemInput, RefusesNullPointers) {
  Given given;
  Written out;
  const auto call = [&](const abut_contact_problem* problem, double* velocities, double* impulses,
                        abut_residuals* residuals, std::string_view name) {
    EXPECT_EQ(abut_contact_problem_solve(problem, nullptr, velocities, impulses, residuals), ABUT_NULL_ARGUMENT);
    EXPECT_NE(std::string(abut_last_error_message()).find(name), std::string::npos) << abut_last_error_message();
  };
  call(nullptr, out.velocities.data(), out.impulses.data(), &out.residuals, "problem");
  call(&given.problem, nullptr, out.impulses.data(), &out.residuals, "velocities");
  call(&given.problem, out.velocities.data(), nullptr, &out.residuals, "impulses");
  call(&given.problem, out.velocities.data(), out.impulses.data(), nullptr, "out");
  for (const auto& [name, member] : {std::pair("problem.masses", &abut_contact_problem::masses),
                                     {"problem.inertias", &abut_contact_problem::inertias},
                                     {"problem.centres", &abut_contact_problem::centres},
                                     {"problem.free_velocities", &abut_contact_problem::free_velocities},
                                     {"problem.points", &abut_contact_problem::points},
                                     {"problem.normals", &abut_contact_problem::normals}}) {
    expect_refused([&](Given& its) { its.problem.*member = nullptr; }, ABUT_NULL_ARGUMENT, {name, "null"});
  }
  expect_refused([](Given& its) { its.problem.bodies = nullptr; }, ABUT_NULL_ARGUMENT, {"problem.bodies", "null"});
}

// Each array, at each place: what is no number, and what is out of range.
TEST(ContactProblemInput, RefusesBadNumbersByNameAndValue) {
  constexpr struct {
    const char* name;
    std::vector<double> Given::* numbers;
    double beyond;
    const char* value;
  } arrays[] = {{"masses", &Given::masses, 0, "is 0;"},
                {"masses", &Given::masses, -1, "is -1;"},
                {"inertias", &Given::inertias, -2e30, "is -2e+30;"},
                {"centres", &Given::centres, 2e30, "is 2e+30;"},
                {"free_velocities", &Given::free, 2e30, "is 2e+30;"},
                {"points", &Given::points, 2e30, "is 2e+30;"},
                {"normals", &Given::normals, 2e30, "is 2e+30;"},
                {"tangents", &Given::tangents, 2e30, "is 2e+30;"},
                {"frictions", &Given::frictions, -1, "is -1;"},
                {"frictions", &Given::frictions, 2e6, "is 2000000;"},
                {"compliances", &Given::compliances, -1, "is -1;"},
                {"offsets", &Given::offsets, -2e30, "is -2e+30;"},
                {"surface_velocities", &Given::surfaces, 2e30, "is 2e+30;"},
                {"first_velocities", &Given::first_velocities, 2e30, "is 2e+30;"},
                {"first_impulses", &Given::first_impulses, 2e30, "is 2e+30;"}};
  for (const auto& array : arrays) {
    const std::size_t count = (Given().*array.numbers).size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::string name = std::string("problem.") + array.name + "[" + std::to_string(i) + "]";
      for (const double bad : {nan, infinity, -infinity}) {
        expect_refused([&](Given& its) { (its.*array.numbers)[i] = bad; }, ABUT_NOT_FINITE, {name, "finite"});
      }
      expect_refused([&](Given& its) { (its.*array.numbers)[i] = array.beyond; }, ABUT_OUT_OF_RANGE,
                     {name, array.value});
    }
  }
}

TEST(ContactProblemInput, RefusesMatricesThatAreNoInertia) {
  expect_refused([](Given& its) { its.inertias[10] = 0.2; }, ABUT_INVALID_ARGUMENT,
                 {"inertias[10]", "0.2", "symmetric"});
  expect_refused([](Given& its) { its.inertias[4] = 0; }, ABUT_OUT_OF_RANGE, {"inertias[4]", "is 0;", "positive"});
  expect_refused([](Given& its) { its.inertias[10] = its.inertias[12] = 3; }, ABUT_OUT_OF_RANGE,
                 {"inertias[13]", "positive definite"});
}

TEST(ContactProblemInput, RefusesSidesThatAreNoTwoBodies) {
  expect_refused([](Given& its) { its.bodies[3] = 2; }, ABUT_INDEX_OUT_OF_RANGE, {"bodies[3]", "is 2;", "body_count"});
  expect_refused([](Given& its) { its.bodies[3] = 0; }, ABUT_INVALID_ARGUMENT, {"bodies[3]", "is 0;", "differ"});
  expect_refused([](Given& its) { its.bodies[1] = ABUT_NO_BODY; }, ABUT_INVALID_ARGUMENT, {"bodies[1]", "differ"});
}

TEST(ContactProblemInput, RefusesDirectionsWithoutLength) {
  expect_refused([](Given& its) { its.normals[5] = 0; }, ABUT_ZERO_VECTOR, {"normals[3]", "length"});
  expect_refused([](Given& its) { its.tangents[3] = 0; }, ABUT_ZERO_VECTOR, {"tangents[3]", "length"});
  expect_refused(
      [](Given& its) {
        its.tangents[3] = 0;
        its.tangents[5] = 4;
      },
      ABUT_ZERO_VECTOR, {"tangents[3]", "beside the normal"});
  expect_refused([](Given& its) { its.problem.tangents = nullptr; }, ABUT_INVALID_ARGUMENT,
                 {"frictions[1]", "0.4", "tangents is null"});
}

TEST(ContactProblemInput, RefusesStructsOfOtherSizes) {
  expect_refused([](Given& its) { its.problem.struct_size = 0; }, ABUT_WRONG_STRUCT_SIZE, {"problem.struct_size"});
  expect_refused([](Given& its) { its.problem.struct_size = 8; }, ABUT_WRONG_STRUCT_SIZE, {"problem.struct_size", "8"});
  expect_refused([](Given& its) { its.problem.reserved = 3; }, ABUT_INVALID_ARGUMENT, {"problem.reserved", "3"});
  expect_refused([](Given& its) { its.options.struct_size = 4; }, ABUT_WRONG_STRUCT_SIZE, {"options.struct_size"});
  expect_refused([](Given& its) { its.options.most_rounds = 0; }, ABUT_OUT_OF_RANGE, {"options.most_rounds"});
  expect_refused([](Given& its) { its.options.tolerance = -1; }, ABUT_OUT_OF_RANGE, {"options.tolerance", "-1"});
  expect_refused([](Given& its) { its.options.tolerance = nan; }, ABUT_NOT_FINITE, {"options.tolerance"});
  expect_refused([](Given& its) { its.options.speed = -1; }, ABUT_OUT_OF_RANGE, {"options.speed", "-1"});
}

// Those of null arrays that may be.
TEST(ContactProblemInput, TakesDefaultsForWhatIsNotThere) {
  Given given;
  given.problem.tangents = given.problem.frictions = given.problem.compliances = given.problem.offsets = nullptr;
  given.problem.surface_velocities = given.problem.first_velocities = given.problem.first_impulses = nullptr;
  Written out;
  EXPECT_EQ(
      abut_contact_problem_solve(&given.problem, nullptr, out.velocities.data(), out.impulses.data(), &out.residuals),
      ABUT_OK)
      << abut_last_error_message();
  EXPECT_NEAR(out.velocities[2], 0, 1e-8);
  EXPECT_NEAR(out.impulses[2], 3, 1e-8);
}

}  // namespace
