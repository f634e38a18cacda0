// SPDX-License-Identifier: Apache-2.0
// What contacts do to bodies: response.h for C++17 and newer. Link libabut_response as well.
#ifndef ABUT_RESPONSE_HPP
#define ABUT_RESPONSE_HPP

#include <abut/abut.hpp>
#include <abut/response.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut {

using Residuals = abut_residuals;

// Two bodies that touch, or a body and what no impulse moves. The fields are those of abut_contact_problem.
struct ProblemContact {
  std::uint32_t a = ABUT_NO_BODY, b = ABUT_NO_BODY;
  Vec3 point{}, normal{0, 0, 1};  // from a to b
  double friction = 0;
  double compliance = 0;  // velocity per impulse
  double offset = 0;      // velocity: the gap divided by the step
  Vec3 surface_velocity{};
};

struct ContactSolution {
  std::vector<Velocity> velocities;  // of bodies
  std::vector<Vec3> impulses;        // on b of contacts
  Residuals residuals{};
};

inline namespace ABUT_ANSWERS {

struct SolverOptions : Defaulted<SolverOptions, abut_solver_options, abut_solver_options_init> {
  using C = abut_solver_options;
  [[nodiscard]] SolverOptions with_most_rounds(std::uint32_t value) const { return with(&C::most_rounds, value); }
  [[nodiscard]] SolverOptions with_tolerance(double value) const { return with(&C::tolerance, value); }
  [[nodiscard]] SolverOptions with_speed(double value) const { return with(&C::speed, value); }
};

// Bodies and contacts at one moment, collected one by one.
class ContactProblem {
 public:
  // The inertia is about the centre of mass, along the axes of the world. The number of the body, from 0.
  std::uint32_t add_body(double mass, const std::array<double, 9>& inertia, const Vec3& centre, const Velocity& free) {
    masses_.push_back(mass);
    inertias_.insert(inertias_.end(), inertia.begin(), inertia.end());
    centres_.push_back(centre);
    free_.push_back(free);
    return static_cast<std::uint32_t>(masses_.size() - 1);
  }
  void add_contact(const ProblemContact& contact) {
    sides_.push_back(contact.a);
    sides_.push_back(contact.b);
    points_.push_back(contact.point);
    normals_.push_back(contact.normal);
    frictions_.insert(frictions_.end(), 2, contact.friction);
    compliances_.push_back(contact.compliance);
    offsets_.push_back(contact.offset);
    surfaces_.push_back(contact.surface_velocity);
  }

  // Where a solution of as many bodies and contacts is given, the search begins there.
  [[nodiscard]] Answer<ContactSolution> solve(const SolverOptions& options = SolverOptions(),
                                              const ContactSolution* first = nullptr) const {
    abut_contact_problem problem;
    abut_contact_problem_init(&problem, sizeof problem);
    problem.body_count = static_cast<std::uint32_t>(masses_.size());
    problem.contact_count = static_cast<std::uint32_t>(points_.size());
    problem.masses = masses_.data();
    problem.inertias = inertias_.data();
    problem.centres = numbers_of(centres_);
    problem.free_velocities = numbers_of(free_);
    problem.bodies = sides_.data();
    problem.points = numbers_of(points_);
    problem.normals = numbers_of(normals_);
    problem.frictions = frictions_.data();
    problem.compliances = compliances_.data();
    problem.offsets = offsets_.data();
    problem.surface_velocities = numbers_of(surfaces_);
    abut_status sizes = ABUT_OK;
    if (first != nullptr) {
      sizes = detail::expect_as_many("first->velocities", first->velocities.size(), "bodies", masses_.size());
      if (sizes == ABUT_OK)
        sizes = detail::expect_as_many("first->impulses", first->impulses.size(), "contacts", points_.size());
      problem.first_velocities = numbers_of(first->velocities);
      problem.first_impulses = numbers_of(first->impulses);
    }
    ContactSolution out;
    out.velocities.resize(masses_.size());
    out.impulses.resize(points_.size());
    double* const velocities = out.velocities.empty() ? nullptr : &out.velocities.front().linear.x;
    double* const impulses = out.impulses.empty() ? nullptr : &out.impulses.front().x;
    const abut_status status =
        sizes != ABUT_OK ? sizes
                         : abut_contact_problem_solve(&problem, &options, velocities, impulses, &out.residuals);
    return detail::answer(status, out);
  }

 private:
  // Vectors and velocities are numbers one behind the other.
  static const double* numbers_of(const std::vector<Vec3>& list) { return list.empty() ? nullptr : &list.front().x; }
  static const double* numbers_of(const std::vector<Velocity>& list) {
    return list.empty() ? nullptr : &list.front().linear.x;
  }

  std::vector<double> masses_, inertias_, frictions_, compliances_, offsets_;
  std::vector<Vec3> centres_, points_, normals_, surfaces_;
  std::vector<Velocity> free_;
  std::vector<std::uint32_t> sides_;
};

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
