// SPDX-License-Identifier: Apache-2.0
// The solver: multipliers outside, Newton's method inside.
//
// Each round minimises the squared distance to the free motion in the metric of the mass. A proximal weight `epsilon`
// keeps impulses near those of the round before, so that they follow from velocities in closed form. Newton's method
// then has velocities as its only unknowns, and rigid contacts and compliant ones are one formula.
// Inner problem: Castro et al., "An unconstrained convex formulation of compliant contact" (2022),
// https://arxiv.org/abs/2110.10107. Multipliers around it: https://arxiv.org/abs/2502.16898.
// Coulomb friction is exact by de Saxce's shift of the normal velocity, which a round takes from the one before.
module;
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Weverything"
#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#pragma clang diagnostic pop

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

using Vector = Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;
using Rows = Eigen::Matrix<double, 3, 6>;
using Block = Eigen::Matrix<double, 6, 6>;
using Small = Eigen::Matrix3d;

constexpr double largest_epsilon = 0.3, least_epsilon = 1e-8;

// Under a weight so small, velocities off by rounding stand for impulses off by a part of 1e-8. That part is of an
// impulse that would stop the fastest body; where light bodies bear far larger ones, the weight may be smaller. It must
// be: it converges as fast as it is small against the mobility of the heaviest body.
[[nodiscard]] double least_epsilon_for(double speed, double largest_impulse_speed) {
  constexpr double ordinary = 1e3, least_part = 1e-6;
  if (!(largest_impulse_speed > ordinary * speed)) return least_epsilon;
  return least_epsilon * std::max(least_part, ordinary * speed / largest_impulse_speed);
}

constexpr std::uint32_t most_newton_steps = 25;
// From this round on the shift moves half the way only, which stops it from swinging in heaps.
constexpr std::uint32_t damped_from = 16;
// Groups of more bodies take no steps on the exact law: its matrix is not symmetric, and is factored as a dense one.
// SparseLU of Eigen does not notice where there is no memory.
constexpr std::size_t most_exact_bodies = 16;

[[nodiscard]] Rows matrix_of(const std::array<Row, 3>& rows) {
  Rows out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 6; ++j) out(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  return out;
}

[[nodiscard]] double tangent_speed(const Triple& u) { return std::sqrt(u[0] * u[0] + u[1] * u[1]); }

// The matrix of Newton's method: a block of 6 x 6 for each body, and for each two that touch. Its places are found
// once.
class Blocks {
 public:
  explicit Blocks(const Problem& problem) : columns_(problem.bodies.size()) {
    for (std::uint32_t i = 0; i < columns_.size(); ++i) columns_[i].push_back(i);
    for (const ContactRows& contact : problem.contacts) {
      for (const BodyRows& column : contact.bodies) {
        for (const BodyRows& row : contact.bodies) columns_[column.body].push_back(row.body);
      }
    }
    for (const Element& element : problem.elements) {
      for (std::uint32_t i = 0; i < element.count; ++i) {
        for (std::uint32_t j = 0; j < element.count; ++j) {
          const std::uint32_t row = element.bodies[i], column = element.bodies[j];
          if (row != no_body && column != no_body) columns_[column].push_back(row);
        }
      }
    }
    Eigen::Index count = 0;
    for (std::vector<std::uint32_t>& column : columns_) {
      std::ranges::sort(column);
      column.erase(std::ranges::unique(column).begin(), column.end());
      starts_.push_back(count);
      count += 36 * static_cast<Eigen::Index>(column.size());
    }
    const auto size = 6 * static_cast<Eigen::Index>(columns_.size());
    matrix_.resize(size, size);
    matrix_.reserve(count);
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      for (int of_six = 0; of_six < 6; ++of_six) {
        const auto column = 6 * static_cast<Eigen::Index>(j) + of_six;
        matrix_.startVec(column);
        for (const std::uint32_t row : columns_[j]) {
          for (int i = 0; i < 6; ++i) matrix_.insertBack(6 * static_cast<Eigen::Index>(row) + i, column) = 0;
        }
      }
    }
    matrix_.finalize();
  }

  [[nodiscard]] const Sparse& matrix() const { return matrix_; }
  void clear() { matrix_.coeffs().setZero(); }

  void add(std::uint32_t row, std::uint32_t column, const Block& block) {
    const std::vector<std::uint32_t>& rows = columns_[column];
    const auto place = std::ranges::lower_bound(rows, row) - rows.begin();
    for (int j = 0; j < 6; ++j) {
      const auto first = starts_[column] + 6 * (j * static_cast<Eigen::Index>(rows.size()) + place);
      matrix_.coeffs().segment<6>(first) += block.col(j).array();
    }
  }

 private:
  std::vector<std::vector<std::uint32_t>> columns_;  // the bodies of each column, in their order
  std::vector<Eigen::Index> starts_;                 // of each column among the numbers
  Sparse matrix_;
};

// The friction of the inner problem: that of the round before, or the one that belongs to the velocity.
enum class Shift : unsigned char { kept, exact };

class [[gsl::Pointer]] Rounds {
 public:
  Rounds(const Problem& problem, Solution& solution)
      : problem_(problem), solution_(solution), blocks_(problem), shifts_(problem.contacts.size()) {
    for (const ContactRows& contact : problem.contacts) {
      std::vector<Rows>& its = rows_.emplace_back();
      for (const BodyRows& body : contact.bodies) its.push_back(matrix_of(body.rows));
    }
    for (const BodyMass& body : problem.bodies) {
      Block mass = Block::Zero();
      mass.topLeftCorner<3, 3>() = body.mass * Small::Identity();
      mass.bottomRightCorner<3, 3>() = Eigen::Map<const Small>(body.inertia.data());
      masses_.push_back(mass);
    }
    take_shifts(solution.velocities, 0);
  }

  SolverReport run(const SolverOptions& options, double speed);

 private:
  using Velocities = std::vector<Row>;

  // The point that is projected on the cone to have the impulse of a velocity.
  [[nodiscard]] Triple argument(std::size_t k, const Triple& u, Shift shift) const {
    const ContactRows& contact = problem_.contacts[k];
    const Triple& kept = solution_.impulses[k];
    const double q = epsilon_ * contact.weight;
    const double s = shift == Shift::exact ? contact.friction * tangent_speed(u) : shifts_[k];
    const double along = (q * kept[2] - (u[2] + s)) / (q + contact.compliance);
    if (contact.law == Law::contact) return {kept[0] - u[0] / q, kept[1] - u[1] / q, along};
    const double whole = q + contact.compliance;
    return {(q * kept[0] - u[0]) / whole, (q * kept[1] - u[1]) / whole, along};
  }

  [[nodiscard]] Triple impulse(std::size_t k, const Triple& u, Shift shift) const {
    const ContactRows& contact = problem_.contacts[k];
    const double q = epsilon_ * contact.weight;
    return allowed(contact, argument(k, u, shift), q, q + contact.compliance);
  }

  // What an impulse loses for each velocity that is gained: minus its derivative.
  [[nodiscard]] Small stiffness(std::size_t k, const Triple& u, Shift shift) const {
    const ContactRows& contact = problem_.contacts[k];
    const double q = epsilon_ * contact.weight;
    const ConePoint at = allowed_with_derivative(contact, argument(k, u, shift), q, q + contact.compliance);
    const double across = contact.law == Law::contact ? q : q + contact.compliance;
    Small out;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        out(i, j) = at.derivative[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] /
                    (j == 2 ? q + contact.compliance : across);
      }
    }
    if (const double length = tangent_speed(u); shift == Shift::exact && length > 0) {
      const Eigen::RowVector2d along = contact.friction / length * Eigen::RowVector2d(u[0], u[1]);
      out.leftCols<2>() += out.col(2) * along;
    }
    return out;
  }

  [[nodiscard]] std::vector<Triple> impulses(const Velocities& v, Shift shift) const {
    std::vector<Triple> out(problem_.contacts.size());
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = impulse(k, relative_velocity(problem_.contacts[k], v), shift);
    return out;
  }

  // The equation of motion: zero at the solution of the inner problem.
  [[nodiscard]] Vector gradient(const Velocities& v, Shift shift) const {
    Velocities sums(v.size());
    for (std::size_t k = 0; k < problem_.contacts.size(); ++k) {
      const ContactRows& contact = problem_.contacts[k];
      add_impulse(contact, impulse(k, relative_velocity(contact, v), shift), sums);
    }
    add_elements(problem_, v, sums);
    Vector out(6 * static_cast<Eigen::Index>(v.size()));
    for (std::size_t i = 0; i < v.size(); ++i) {
      Eigen::Matrix<double, 6, 1> change;
      for (std::size_t j = 0; j < 6; ++j) change[static_cast<Eigen::Index>(j)] = v[i][j] - problem_.free[i][j];
      out.segment<6>(6 * static_cast<Eigen::Index>(i)) =
          masses_[i] * change - Eigen::Map<const Eigen::Matrix<double, 6, 1>>(sums[i].data());
    }
    return out;
  }

  // The largest linear velocity that a gradient stands for.
  [[nodiscard]] double norm(const Vector& gradient) const {
    double largest = 0;
    for (std::size_t i = 0; i < masses_.size(); ++i) {
      const double mass = problem_.bodies[i].mass;
      largest = std::max(largest, gradient.segment<3>(6 * static_cast<Eigen::Index>(i)).norm() / mass);
    }
    return largest;
  }

  // Whether a gradient is what rounding leaves of all that is added up for each body.
  [[nodiscard]] static bool is_rounding(const Vector& gradient, const Velocities& sizes) {
    constexpr double rounding = 2e-16;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        if (std::fabs(gradient[static_cast<Eigen::Index>(6 * i + j)]) > rounding * sizes[i][j]) return false;
      }
    }
    return true;
  }

  void assemble(const Element& element) {
    const std::size_t rows = 3 * std::size_t{element.count};
    for (std::size_t i = 0; i < element.count; ++i) {
      for (std::size_t j = 0; j < element.count; ++j) {
        if (element.bodies[i] == no_body || element.bodies[j] == no_body) continue;
        Block block = Block::Zero();
        for (std::size_t k = 0; k < 9; ++k) {
          block(static_cast<Eigen::Index>(k / 3), static_cast<Eigen::Index>(k % 3)) =
              element.change[rows * (3 * i + k / 3) + 3 * j + k % 3];
        }
        blocks_.add(element.bodies[i], element.bodies[j], block);
      }
    }
  }

  void assemble(const Velocities& v, Shift shift) {
    blocks_.clear();
    for (std::uint32_t i = 0; i < masses_.size(); ++i) blocks_.add(i, i, masses_[i]);
    for (const Element& element : problem_.elements) assemble(element);
    for (std::size_t k = 0; k < problem_.contacts.size(); ++k) {
      const ContactRows& contact = problem_.contacts[k];
      const Small d = stiffness(k, relative_velocity(contact, v), shift);
      for (std::size_t j = 0; j < contact.bodies.size(); ++j) {
        const Rows column = d * rows_[k][j];
        for (std::size_t i = 0; i < contact.bodies.size(); ++i)
          blocks_.add(contact.bodies[i].body, contact.bodies[j].body, rows_[k][i].transpose() * column);
      }
    }
  }

  [[nodiscard]] static Velocities moved(const Velocities& v, const Vector& step, double length) {
    Velocities out = v;
    for (std::size_t i = 0; i < v.size(); ++i) {
      for (std::size_t j = 0; j < 6; ++j) out[i][j] += length * step[static_cast<Eigen::Index>(6 * i + j)];
    }
    return out;
  }

  // Shifts follow the velocities; `kept` is the part of the old ones that stays.
  void take_shifts(const Velocities& v, double kept) {
    for (std::size_t k = 0; k < shifts_.size(); ++k) {
      const ContactRows& contact = problem_.contacts[k];
      const double now = contact.friction * tangent_speed(relative_velocity(contact, v));
      shifts_[k] = kept * shifts_[k] + (1 - kept) * now;
    }
  }

  [[nodiscard]] Velocities along(const Velocities& v, const Vector& step, const Vector& gradient_at_v);
  std::uint32_t minimise(double wanted);
  void step_on_exact_law(double tolerance, Residuals& residuals);

  const Problem& problem_;
  Solution& solution_;
  Blocks blocks_;
  std::vector<std::vector<Rows>> rows_;  // of contacts, for each of their bodies
  std::vector<Block> masses_;
  std::vector<double> shifts_;
  Eigen::SimplicialLDLT<Sparse> factors_;
  bool is_analysed_ = false;
  double epsilon_ = 0;
};

// How far along a step: where the slope has fallen. Energies cancel to half of the digits; slopes do not.
Rounds::Velocities Rounds::along(const Velocities& v, const Vector& step, const Vector& gradient_at_v) {
  const double slope = std::fabs(gradient_at_v.dot(step));
  Velocities whole = moved(v, step, 1);
  const Vector end = gradient(whole, Shift::kept);
  if (end.dot(step) <= 0.3 * slope || norm(end) <= 0.5 * norm(gradient_at_v)) return whole;
  constexpr int most_halvings = 20;
  double low = 0, high = 1, length = 1;
  for (int i = 0; i < most_halvings; ++i) {
    length = 0.5 * (low + high);
    const double here = gradient(moved(v, step, length), Shift::kept).dot(step);
    if (std::fabs(here) < 0.1 * slope) break;
    (here > 0 ? high : low) = length;
  }
  return moved(v, step, length);
}

// Newton's method with the shifts of the round before: a convex problem. How many steps it took.
std::uint32_t Rounds::minimise(double wanted) {
  double best = std::numeric_limits<double>::infinity();
  int without_gain = 0;
  const Velocities sizes = sizes_of(problem_, solution_);
  for (std::uint32_t i = 0; i < most_newton_steps; ++i) {
    const Vector g = gradient(solution_.velocities, Shift::kept);
    const double size = norm(g);
    if (!(size > wanted) || is_rounding(g, sizes)) return i;
    without_gain = size < 0.9 * best ? 0 : without_gain + 1;
    best = std::min(best, size);
    if (without_gain > 4) return i;
    assemble(solution_.velocities, Shift::kept);
    if (!is_analysed_) factors_.analyzePattern(blocks_.matrix());
    is_analysed_ = true;
    factors_.factorize(blocks_.matrix());
    if (factors_.info() != Eigen::Success) return i;
    const Vector step = factors_.solve(-g);
    if (!step.allFinite()) return i;
    solution_.velocities = along(solution_.velocities, step, g);
  }
  return most_newton_steps;
}

// A few steps of Newton's method with shifts that follow the velocity, kept as far as each halves the residual. They
// save many rounds where a few contacts slide, and do not converge in heaps.
void Rounds::step_on_exact_law(double tolerance, Residuals& residuals) {
  constexpr int most_steps = 3;
  Solution trial = solution_, best;
  bool is_better = false;
  for (int i = 0; i < most_steps && residuals.excess > tolerance; ++i) {
    const Vector g = gradient(trial.velocities, Shift::exact);
    assemble(trial.velocities, Shift::exact);
    const Vector step = Eigen::PartialPivLU<Eigen::MatrixXd>(blocks_.matrix()).solve(-g);
    if (!step.allFinite()) break;
    trial.velocities = moved(trial.velocities, step, 1);
    trial.impulses = impulses(trial.velocities, Shift::exact);
    const Residuals now = residuals_of(problem_, trial);
    if (!(now.excess < 0.8 * residuals.excess)) break;
    residuals = now;
    best = trial;
    is_better = true;
  }
  if (!is_better) return;
  solution_ = best;
  take_shifts(solution_.velocities, 0);
}

SolverReport Rounds::run(const SolverOptions& options, double speed) {
  SolverReport report;
  report.speed = speed;
  const double tolerance = options.tolerance * speed;
  epsilon_ = 1e-2;
  double last_residual = std::numeric_limits<double>::infinity(), last_change = last_residual;
  Solution best = solution_;
  report.residuals = residuals_of(problem_, best);
  report.is_converged = report.residuals.excess <= tolerance;
  while (!report.is_converged && report.rounds < options.most_rounds) {
    ++report.rounds;
    const std::uint32_t steps = minimise(std::max(0.1 * tolerance, 1e-2 * last_residual));
    report.newton_steps += steps;
    std::vector<Triple> found = impulses(solution_.velocities, Shift::kept);
    // How much of the residual the multipliers make, and how much the shifts.
    double change = 0, shift_change = 0, largest = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
      const ContactRows& contact = problem_.contacts[k];
      const Triple &now = found[k], &before = solution_.impulses[k];
      const double moved_by = norm_of(now[0] - before[0], now[1] - before[1], now[2] - before[2]);
      change = std::max(change, epsilon_ * contact.weight * moved_by);
      largest = std::max(largest, contact.weight * norm_of(now[0], now[1], now[2]));
      if (now[2] > 0) {
        const double shift = contact.friction * tangent_speed(relative_velocity(contact, solution_.velocities));
        shift_change = std::max(shift_change, std::fabs(shift - shifts_[k]));
      }
    }
    solution_.impulses = std::move(found);
    take_shifts(solution_.velocities, report.rounds >= damped_from ? 0.5 : 0);
    Residuals residuals = residuals_of(problem_, solution_);
    if (residuals.excess > tolerance && shift_change > 1e-3 * residuals.excess &&
        problem_.bodies.size() <= most_exact_bodies) {
      step_on_exact_law(tolerance, residuals);
    }
    if (residuals.excess < report.residuals.excess) {
      report.residuals = residuals;
      best = solution_;
    }
    report.is_converged = residuals.excess <= tolerance;
    if (steps > 8) {
      epsilon_ = std::min(largest_epsilon, 3 * epsilon_);
    } else if (steps <= 3 && change > 0.2 * last_change && change > 0.3 * shift_change) {
      epsilon_ = std::max(least_epsilon_for(speed, largest), 0.3 * epsilon_);
    }
    last_change = change;
    last_residual = residuals.excess;
  }
  solution_ = std::move(best);
  return report;
}

}  // namespace

SolverReport rounds_of_newton(const Problem& problem, const SolverOptions& options, double speed, Solution& solution) {
  return Rounds(problem, solution).run(options, speed);
}

}  // namespace abut::response
