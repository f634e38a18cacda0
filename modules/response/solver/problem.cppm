// SPDX-License-Identifier: Apache-2.0
// One group of bodies and the contacts between them: unknown velocities and impulses.
//
// The law, for each contact with relative velocity u = J v + drift of b less a:
//   mass * (v - free) = sum of J^T impulse + sum of elements (impulse - change * v)
//
//   0 <= impulse_n, 0 <= u_n + compliance * impulse_n, one of them 0 (the offset of the gap is part of the drift)
//   |impulse_T| <= friction * impulse_n; where it slides, impulse_T is against u_T and as large as it may be
//
// A hold has another law: u + compliance * impulse = 0 along all three axes, unless |impulse| would exceed `most`.
// There the impulse has that size and is against u + compliance * impulse.
module;

#include <abut/abut.h>

#include <array>
#include <cstdint>
#include <vector>

export module abut.response:problem;
import :cone;
import :vector;

export namespace abut::response {

// In the place of a body: what no impulse moves.
inline constexpr std::uint32_t no_body = ~std::uint32_t{0};

using Row = std::array<double, 6>;  // by the linear and the angular velocity of a body, world axes

struct BodyMass {
  double mass;
  Matrix inertia;  // symmetric, world axes, about the centre of mass
};

// A part of what moves a point: a point of a body, by a weight. Those of a have negative weights, those of b positive
// ones. A point of a rigid body is held by one, and the mean of particles by one of each, whose arm is zero.
struct Holder {
  std::uint32_t body;
  double weight;
  abut_vec3 arm;  // to the point, from the centre of mass
};

// Where a contact lies, and what rubs there.
struct ContactPlace {
  std::vector<Holder> holders;      // of different bodies; what no impulse moves has none
  std::array<abut_vec3, 3> axes;    // t, s, n; units
  std::array<double, 2> frictions;  // along t and s
  abut_vec3 surface_velocity;       // of b less a, beyond that of the bodies
};

enum class Law : unsigned char { contact, hold };

// What a contact has of one body: its relative velocity along t, s, n by the velocity of the body. The same numbers
// bring impulses back, so that both ways are exact transposes.
struct BodyRows {
  std::uint32_t body;
  std::array<Row, 3> rows;
};

// The rows of t and s are scaled, so that the cone of friction is round.
struct ContactRows {
  std::vector<BodyRows> bodies;   // different ones
  Triple drift;                   // what it is where no body moves; the offset counts in the normal
  double offset;                  // the part of drift[2] that is a gap over a step
  double compliance;              // velocity per impulse
  double friction;                // of the round cone
  double weight;                  // mean of the diagonal of J M^-1 J^T
  std::array<abut_vec3, 3> axes;  // t, s, n; units
  std::array<double, 3> scales;   // of the axes
  Law law = Law::contact;
  double most = 0;  // largest impulse of a hold
};

// A spring or a tetrahedron between bodies that do not turn: they receive `impulse` less `change` times velocities.
struct Element {
  std::uint32_t count = 0;
  std::array<std::uint32_t, 4> bodies{};  // no_body where it is held
  std::array<double, 12> impulse{};
  std::array<double, 144> change{};  // 3 * count rows and columns: symmetric, positive semidefinite
  double size = 0;                   // of the numbers whose difference is the impulse
};

struct Problem {
  std::vector<BodyMass> bodies;
  std::vector<Row> free;  // velocities without contacts
  std::vector<ContactRows> contacts;
  std::vector<Element> elements{};
};

struct Solution {
  std::vector<Row> velocities;
  std::vector<Triple> impulses;  // on b along the rows of the contact
};

enum class Method : unsigned char { newton, sweeps };

struct SolverOptions {
  double tolerance = 1e-9;  // part of `speed`
  double speed = 0;         // 0: the largest of the free motion
  std::uint32_t most_rounds = 200;
  bool is_warm = false;  // whether the solution holds a start
  Method method = Method::newton;
};

// How far a solution is from the law.
struct Residuals {
  double contact = 0;      // velocity: what the natural map of a contact moves its impulse by, times its weight
  double motion = 0;       // velocity: the equation of motion of a body, by the norm of its mass
  double dissipation = 0;  // energy: impulse times shifted velocity, summed in size; 0 for a solution
  double excess = 0;       // the larger of contact and motion, each less what rounding alone makes of it
};

struct SolverReport {
  Residuals residuals;
  double speed = 0;  // that the tolerance is a part of
  std::uint32_t rounds = 0;
  std::uint32_t newton_steps = 0;
  bool is_converged = false;
  bool is_finite = true;
};

// Rigid and closed; the weight is still to come.
[[nodiscard]] ContactRows contact_rows(const ContactPlace& place);
// The impulse that the law allows nearest to `given`, where squares along tangents count `tangent`, and along the
// normal `normal`. A hold is asked with both equal.
[[nodiscard]] Triple allowed(const ContactRows& contact, const Triple& given, double tangent = 1, double normal = 1);
[[nodiscard]] ConePoint allowed_with_derivative(const ContactRows& contact, const Triple& given, double tangent,
                                                double normal);
// From impulses along the rows to those in the world, and back.
[[nodiscard]] abut_vec3 world_impulse(const ContactRows& contact, const Triple& impulse);
[[nodiscard]] Triple impulse_along(const ContactRows& contact, const abut_vec3& impulse);

// Relative velocity of a contact along its rows.
[[nodiscard]] Triple relative_velocity(const ContactRows& contact, const std::vector<Row>& velocities);
// Adds J^T impulse to the sums of bodies.
void add_impulse(const ContactRows& contact, const Triple& impulse, std::vector<Row>& sums);
// What an impulse (or the rest of the equation of motion) changes of the velocity of a body.
[[nodiscard]] Row velocity_of_impulse(const BodyMass& body, const Row& impulse);
// The diagonal of J M^-1 J^T of a contact whose rows are filled in, and its mean.
[[nodiscard]] Triple diagonal_of(const ContactRows& contact, const std::vector<BodyMass>& bodies);
[[nodiscard]] double weight_of(const ContactRows& contact, const std::vector<BodyMass>& bodies);

// What elements give to bodies at some velocities.
void add_elements(const Problem& problem, const std::vector<Row>& velocities, std::vector<Row>& sums);
// The sizes of all that is added up for each body: rounding leaves a part of them.
[[nodiscard]] std::vector<Row> sizes_of(const Problem& problem, const Solution& solution);

// Of v - free by impulses: velocities that keep the equation of motion. Of problems without elements.
[[nodiscard]] std::vector<Row> velocities_of(const Problem& problem, const std::vector<Triple>& impulses);

[[nodiscard]] Residuals residuals_of(const Problem& problem, const Solution& solution);

// Newton: proximal augmented Lagrangian, Newton's method inside. O(rounds * the factors of a sparse matrix of 6
// unknowns a body). Sweeps: contact after contact, O(rounds * contacts); problems with elements take Newton's method.
SolverReport solve(const Problem& problem, const SolverOptions& options, Solution& solution);
// The rounds of either method, from a start. `speed` is what the tolerance is a part of.
SolverReport rounds_of_newton(const Problem& problem, const SolverOptions& options, double speed, Solution& solution);
SolverReport sweeps_of(const Problem& problem, const SolverOptions& options, double speed, Solution& solution);

}  // namespace abut::response
