// SPDX-License-Identifier: Apache-2.0
// Projected Gauss-Seidel on the same law: contact after contact, each solved with the others held. Cheap, and slow to
// converge where masses differ or stacks are high; the residual tells. Jean, "The non-smooth contact dynamics method"
// (1999), https://doi.org/10.1016/S0045-7825(98)00383-1.
module;

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

// A residual costs as much as a sweep.
constexpr std::uint32_t sweeps_per_residual = 8;

// How easily a contact moves: along its normal, and at most along a tangent or any axis.
struct Mobility {
  double normal, tangents, all;
};

class [[gsl::Pointer]] Sweeps {
 public:
  Sweeps(const Problem& problem, Solution& solution) : problem_(problem), solution_(solution) {
    for (const ContactRows& contact : problem.contacts) {
      const Triple diagonal = diagonal_of(contact, problem.bodies);
      const double tangents = diagonal[0] + diagonal[1];
      mobilities_.push_back({.normal = diagonal[2], .tangents = tangents, .all = tangents + diagonal[2]});
    }
    solution_.velocities = velocities_of(problem, solution.impulses);
  }

  void sweep() {
    for (std::size_t k = 0; k < problem_.contacts.size(); ++k) {
      const ContactRows& contact = problem_.contacts[k];
      if (contact.law == Law::hold) {
        hold(k, contact);
      } else {
        push(k, contact);
        if (contact.friction > 0) rub(k, contact);
      }
    }
  }

  // Rounding of the single changes does not stay.
  void settle() { solution_.velocities = velocities_of(problem_, solution_.impulses); }

 private:
  void change_to(std::size_t k, const Triple& impulse) {
    const ContactRows& contact = problem_.contacts[k];
    Triple& now = solution_.impulses[k];
    const Triple change{impulse[0] - now[0], impulse[1] - now[1], impulse[2] - now[2]};
    now = impulse;
    for (const BodyRows& its : contact.bodies) {
      Row sum{};
      for (std::size_t i = 0; i < change.size(); ++i) {
        for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += its.rows[i][j] * change[i];
      }
      const Row gain = velocity_of_impulse(problem_.bodies[its.body], sum);
      for (std::size_t j = 0; j < gain.size(); ++j) solution_.velocities[its.body][j] += gain[j];
    }
  }

  void push(std::size_t k, const ContactRows& contact) {
    Triple impulse = solution_.impulses[k];
    const Triple u = relative_velocity(contact, solution_.velocities);
    const double missing = (u[2] + contact.compliance * impulse[2]) / (mobilities_[k].normal + contact.compliance);
    impulse[2] = std::max(0.0, impulse[2] - missing);
    change_to(k, impulse);
  }

  void rub(std::size_t k, const ContactRows& contact) {
    Triple impulse = solution_.impulses[k];
    const Triple u = relative_velocity(contact, solution_.velocities);
    for (std::size_t i = 0; i < 2; ++i) impulse[i] -= u[i] / mobilities_[k].tangents;
    const double size = norm_of(impulse[0], impulse[1]), most = contact.friction * impulse[2];
    if (size > most) {
      for (std::size_t i = 0; i < 2; ++i) impulse[i] *= most / size;
    }
    change_to(k, impulse);
  }

  void hold(std::size_t k, const ContactRows& contact) {
    Triple impulse = solution_.impulses[k];
    const Triple u = relative_velocity(contact, solution_.velocities);
    const double whole = mobilities_[k].all + contact.compliance;
    for (std::size_t i = 0; i < u.size(); ++i) impulse[i] -= (u[i] + contact.compliance * impulse[i]) / whole;
    change_to(k, allowed(contact, impulse));
  }

  const Problem& problem_;
  Solution& solution_;
  std::vector<Mobility> mobilities_;
};

}  // namespace

SolverReport sweeps_of(const Problem& problem, const SolverOptions& options, double speed, Solution& solution) {
  SolverReport report;
  report.speed = speed;
  const double tolerance = options.tolerance * speed;
  Sweeps sweeps(problem, solution);
  report.residuals = residuals_of(problem, solution);
  while (report.residuals.excess > tolerance && report.rounds < options.most_rounds) {
    ++report.rounds;
    sweeps.sweep();
    if (report.rounds % sweeps_per_residual != 0 && report.rounds < options.most_rounds) continue;
    sweeps.settle();
    report.residuals = residuals_of(problem, solution);
  }
  report.is_converged = report.residuals.excess <= tolerance;
  return report;
}

}  // namespace abut::response
