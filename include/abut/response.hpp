// SPDX-License-Identifier: Apache-2.0
// What contacts do to bodies: response.h for C++17 and newer. Link libabut_response as well.
#ifndef ABUT_RESPONSE_HPP
#define ABUT_RESPONSE_HPP

#include <abut/abut.hpp>
#include <abut/response.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace abut {

using Residuals = abut_residuals;
using MassProperties = abut_mass_properties;
using ResponseContact = abut_response_contact;
using ContactState = abut_contact_state_value;
using ResponseIsland = abut_response_island;
using Energy = abut_energy;
using ResponseObject = abut_response_object;
using ResponseSide = abut_response_side;
using ResponseFinding = abut_response_finding;
using ContactLaw = abut_contact_law;

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
  [[nodiscard]] SolverOptions with_solver(abut_solver value) const { return with(&C::solver, value); }
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

// Of a shape, in its own frame.
[[nodiscard]] inline Answer<MassProperties> mass_properties(const Shape& shape, double density) {
  MassProperties out{};
  return detail::answer(abut_shape_mass_properties(shape.get(), density, &out), out);
}

struct ResponseOptions : Defaulted<ResponseOptions, abut_response_options, abut_response_options_init> {
  using C = abut_response_options;
  [[nodiscard]] ResponseOptions with_gravity(const Vec3& value) const { return with(&C::gravity, value); }
  [[nodiscard]] ResponseOptions with_most_rounds(std::uint32_t value) const { return with(&C::most_rounds, value); }
  [[nodiscard]] ResponseOptions with_tolerance(double value) const { return with(&C::tolerance, value); }
  [[nodiscard]] ResponseOptions with_slop(double value) const { return with(&C::slop, value); }
  [[nodiscard]] ResponseOptions with_flags(abut_response_flags value) const { return with(&C::flags, value); }
  [[nodiscard]] ResponseOptions with_solver(abut_solver value) const { return with(&C::solver, value); }
  [[nodiscard]] ResponseOptions with_threads(std::uint32_t value) const { return with(&C::threads, value); }
};

struct BodyOptions : Defaulted<BodyOptions, abut_body_options, abut_body_options_init> {
  using C = abut_body_options;
  [[nodiscard]] BodyOptions with_integrator(abut_integrator value) const { return with(&C::integrator, value); }
  [[nodiscard]] BodyOptions with_density(double value) const { return with(&C::density, value); }
  [[nodiscard]] BodyOptions with_mass(const MassProperties& value) const { return with(&C::mass, value); }
};

struct ElasticOptions : Defaulted<ElasticOptions, abut_elastic_options, abut_elastic_options_init> {
  using C = abut_elastic_options;
  [[nodiscard]] ElasticOptions with_young(double value) const { return with(&C::young, value); }
  [[nodiscard]] ElasticOptions with_poisson(double value) const { return with(&C::poisson, value); }
  [[nodiscard]] ElasticOptions with_damping(double value) const { return with(&C::damping, value); }
};

struct LinkOptions : Defaulted<LinkOptions, abut_link_options, abut_link_options_init> {
  using C = abut_link_options;
  [[nodiscard]] LinkOptions with_a(PartId value) const { return with(&C::a, value); }
  [[nodiscard]] LinkOptions with_b(PartId value) const { return with(&C::b, value); }
  [[nodiscard]] LinkOptions with_point_a(const Vec3& value) const { return with(&C::point_a, value); }
  [[nodiscard]] LinkOptions with_point_b(const Vec3& value) const { return with(&C::point_b, value); }
  [[nodiscard]] LinkOptions with_stiffness(double value) const { return with(&C::stiffness, value); }
  [[nodiscard]] LinkOptions with_damping(double value) const { return with(&C::damping, value); }
  [[nodiscard]] LinkOptions with_most_force(double value) const { return with(&C::most_force, value); }
  [[nodiscard]] LinkOptions with_break_force(double value) const { return with(&C::break_force, value); }
};

// Bodies of a universe, which they keep.
class Response {
 public:
  [[nodiscard]] static Answer<Response> create(Universe& universe, const ResponseOptions& options = ResponseOptions()) {
    abut_response* out = nullptr;
    const abut_status status = abut_response_create(universe.get(), &options, &out);
    return detail::answer_with(status, [&] { return Response(out); });
  }
#ifndef ABUT_NO_EXCEPTIONS
  explicit Response(Universe& universe, const ResponseOptions& options = ResponseOptions())
      : Response(create(universe, options)) {}
#endif

  // Of the bytes of another one, on a universe with the same ids.
  [[nodiscard]] static Answer<Response> load(Universe& universe, Span<const std::uint8_t> bytes) {
    abut_response* out = nullptr;
    const abut_status status = abut_response_load(universe.get(), bytes.data(), bytes.size(), &out);
    return detail::answer_with(status, [&] { return Response(out); });
  }
  [[nodiscard]] Answer<std::vector<std::uint8_t>> save() const {
    return detail::collect<std::uint8_t>([this](std::uint8_t* data, std::size_t capacity, std::size_t* size) {
      return abut_response_save(get(), data, capacity, size);
    });
  }
  [[nodiscard]] Answer<std::uint64_t> hash() const {
    std::uint64_t out = 0;
    return detail::answer(abut_response_hash(get(), &out), out);
  }
  [[nodiscard]] Answer<std::string> explain() const {
    return detail::collect_text([this](char* text, std::size_t capacity, std::size_t* needed) {
      return abut_response_explain(get(), text, capacity, needed);
    });
  }
  [[nodiscard]] Answer<std::string> explain_json() const {
    return detail::collect_text([this](char* text, std::size_t capacity, std::size_t* needed) {
      return abut_response_explain_json(get(), text, capacity, needed);
    });
  }
  // What is odd; empty where nothing is.
  [[nodiscard]] Answer<std::vector<ResponseFinding>> validate() const {
    return detail::collect<ResponseFinding>([this](ResponseFinding* data, std::size_t capacity, std::size_t* count) {
      return abut_response_validate(get(), data, capacity, count);
    });
  }

  [[nodiscard]] abut_response* get() const noexcept { return handle_.get(); }

  Answer<void> set_options(const ResponseOptions& options) {
    return detail::answer(abut_response_set_options(get(), &options));
  }
  Answer<void> add_bodies(Span<const PartId> parts, const BodyOptions& options = BodyOptions()) {
    return detail::answer(abut_response_add_bodies(get(), parts.data(), parts.size(), &options));
  }
  Answer<void> add_body(PartId part, const BodyOptions& options = BodyOptions()) {
    return detail::answer(abut_response_add_bodies(get(), &part, 1, &options));
  }
  Answer<void> remove_body(PartId part) { return detail::answer(abut_response_remove_body(get(), part)); }
  [[nodiscard]] Answer<MassProperties> body(PartId part) const {
    MassProperties out{};
    return detail::answer(abut_response_body(get(), part, &out), out);
  }

  // In the next step, through the centre of mass or at a point of the world.
  Answer<void> apply_force(PartId part, const Vec3& force) {
    return detail::answer(abut_response_apply_force(get(), part, &force, nullptr));
  }
  Answer<void> apply_force(PartId part, const Vec3& force, const Vec3& at) {
    return detail::answer(abut_response_apply_force(get(), part, &force, &at));
  }
  Answer<void> apply_torque(PartId part, const Vec3& torque) {
    return detail::answer(abut_response_apply_torque(get(), part, &torque));
  }

  // Edits what counts for a contact, from what its materials say; false leaves the contact out. What it throws comes
  // out of the step when that is over, without the contacts from there on.
  using Editor = std::function<bool(const Contact&, abut_contact_material&)>;
  // The response keeps the function; an empty one takes it away.
  Answer<void> set_contact_callback(Editor editor) {
    auto kept = editor ? std::make_unique<KeptEditor>(KeptEditor{std::move(editor), nullptr}) : nullptr;
    const abut_status status =
        abut_response_set_contact_callback(get(), kept ? &call_editor : nullptr, kept.get());
    if (status == ABUT_OK) editor_ = std::move(kept);
    return detail::answer(status);
  }

  // Particles of a geometry as bodies that do not turn; where they are in the world, three numbers each. Velocities may
  // be empty, for 0.
  Answer<void> add_particles(GeometryId geometry, Span<const double> masses, Span<const double> xyz,
                             Span<const double> velocities = {}) {
    abut_status status = detail::expect_as_many("xyz", xyz.size(), "masses, three times", 3 * masses.size());
    if (status == ABUT_OK && velocities.size() != 0)
      status = detail::expect_as_many("velocities", velocities.size(), "masses, three times", 3 * masses.size());
    if (status == ABUT_OK) {
      status = abut_response_add_particles(get(), geometry, masses.data(), xyz.data(), velocities.data(),
                                           masses.size());
    }
    return detail::answer(status);
  }
  // Springs between particles, two numbers each; without dampings there are none, without rest lengths they are at rest
  // now.
  Answer<void> add_springs(GeometryId geometry, Span<const std::uint32_t> pairs, Span<const double> stiffnesses,
                           Span<const double> dampings = {}, Span<const double> rest_lengths = {}) {
    const std::size_t count = stiffnesses.size();
    const abut_status sizes = detail::first_failure(
        detail::expect_as_many("pairs", pairs.size(), "stiffnesses, two times", 2 * count),
        detail::expect_as_many("dampings", dampings.empty() ? count : dampings.size(), "stiffnesses", count),
        detail::expect_as_many("rest_lengths", rest_lengths.empty() ? count : rest_lengths.size(), "stiffnesses",
                               count));
    return detail::answer(sizes != ABUT_OK ? sizes
                                           : abut_response_add_springs(get(), geometry, pairs.data(),
                                                                       stiffnesses.data(), dampings.data(),
                                                                       rest_lengths.data(), count));
  }
  // Tetrahedra of particles, four numbers each.
  Answer<void> add_tetrahedra(GeometryId geometry, Span<const std::uint32_t> tetrahedra,
                              const ElasticOptions& options = ElasticOptions()) {
    const std::size_t count = tetrahedra.size() / 4;
    const abut_status whole =
        detail::expect_as_many("tetrahedra", tetrahedra.size(), "their number, four times", 4 * count);
    return detail::answer(whole != ABUT_OK ? whole
                                           : abut_response_add_tetrahedra(get(), geometry, tetrahedra.data(), count,
                                                                          &options));
  }
  // Vertices of a mesh follow particles of the carrier: four numbers and weights each.
  Answer<void> map_vertices(GeometryId surface, GeometryId carrier, Span<const std::uint32_t> numbers,
                            Span<const double> weights) {
    const std::size_t count = numbers.size() / 4;
    const abut_status sizes = detail::first_failure(
        detail::expect_as_many("numbers", numbers.size(), "vertices, four times", 4 * count),
        detail::expect_as_many("weights", weights.size(), "numbers", numbers.size()));
    return detail::answer(sizes != ABUT_OK ? sizes
                                           : abut_response_map_vertices(get(), surface, carrier, numbers.data(),
                                                                        weights.data(), count));
  }
  Answer<void> remove_particles(GeometryId geometry) {
    return detail::answer(abut_response_remove_particles(get(), geometry));
  }
  // Borrowed until the next step: places, and velocities.
  [[nodiscard]] Answer<std::pair<Span<const double>, Span<const double>>> particles(GeometryId geometry) const {
    const double *xyz = nullptr, *velocities = nullptr;
    std::size_t count = 0;
    const abut_status status = abut_response_particles(get(), geometry, &xyz, &velocities, &count);
    return detail::answer_with(status, [&] {
      return std::pair(Span<const double>(xyz, 3 * count), Span<const double>(velocities, 3 * count));
    });
  }

  // A field of forces. Neither it nor the other callbacks below may throw.
  Answer<void> set_force_callback(abut_force_callback field, void* context) {
    return detail::answer(abut_response_set_force_callback(get(), field, context));
  }

  // Kinds and rules; parameters such as "mu=0.5&k=1e4".
  Answer<void> add_kind(const char* name, abut_contact_law_callback law, void* context) {
    return detail::answer(abut_response_add_kind(get(), name, law, context));
  }
  [[nodiscard]] Answer<std::vector<const char*>> kinds() const {
    return detail::collect<const char*>([this](const char** data, std::size_t capacity, std::size_t* count) {
      return abut_response_kinds(get(), data, capacity, count);
    });
  }
  // The number of the rule.
  Answer<std::uint32_t> add_rule(const ResponseSide& a, const ResponseSide& b, const char* kind,
                                 const char* parameters = "") {
    std::uint32_t out = 0;
    return detail::answer(abut_response_add_rule(get(), &a, &b, kind, parameters, &out), out);
  }
  Answer<void> set_rule_parameters(std::uint32_t rule, const char* parameters) {
    return detail::answer(abut_response_set_rule_parameters(get(), rule, parameters));
  }
  Answer<void> clear_rules() { return detail::answer(abut_response_clear_rules(get())); }
  Answer<void> set_variable(const char* name, const char* value) {
    return detail::answer(abut_response_set_variable(get(), name, value));
  }
  // A null kind takes it away.
  Answer<void> set_geometry_kind(GeometryId geometry, const char* kind, const char* parameters = "") {
    return detail::answer(abut_response_set_geometry_kind(get(), geometry, kind, parameters));
  }
  [[nodiscard]] Answer<std::string> rule_between(GeometryId a, GeometryId b) const {
    return detail::collect_text([&](char* text, std::size_t capacity, std::size_t* needed) {
      return abut_response_rule_between(get(), a, b, text, capacity, needed);
    });
  }

  // The number of the link.
  Answer<std::uint64_t> add_link(const LinkOptions& options) {
    std::uint64_t out = 0;
    return detail::answer(abut_response_add_link(get(), &options, &out), out);
  }
  Answer<void> move_link(std::uint64_t link, const Vec3& point_a) {
    return detail::answer(abut_response_move_link(get(), link, &point_a));
  }
  [[nodiscard]] Answer<Vec3> link_force(std::uint64_t link) const {
    Vec3 out{};
    return detail::answer(abut_response_link_force(get(), link, &out), out);
  }
  Answer<void> remove_link(std::uint64_t link) { return detail::answer(abut_response_remove_link(get(), link)); }
  // Ends bonds of the kind stick.
  Answer<void> release(GeometryId a, GeometryId b) { return detail::answer(abut_response_release(get(), a, b)); }

  Answer<void> set_listener(abut_response_listener listener, void* context) {
    return detail::answer(abut_response_set_listener(get(), listener, context));
  }

  Answer<void> step(double dt) {
    const abut_status status = abut_response_step(get(), dt);
#ifndef ABUT_NO_EXCEPTIONS
    if (editor_ && editor_->failure && status == ABUT_OK)
      std::rethrow_exception(std::exchange(editor_->failure, nullptr));
#endif
    return detail::answer(status);
  }

  // Of the last step; borrowed until the next one.
  [[nodiscard]] Answer<Span<const ResponseContact>> contacts() const {
    const ResponseContact* first = nullptr;
    std::size_t count = 0;
    const abut_status status = abut_response_contacts(get(), &first, &count);
    return detail::answer_with(status, [&] { return Span<const ResponseContact>(first, count); });
  }
  [[nodiscard]] Answer<Span<const ResponseObject>> objects() const {
    const ResponseObject* first = nullptr;
    std::size_t count = 0;
    const abut_status status = abut_response_objects(get(), &first, &count);
    return detail::answer_with(status, [&] { return Span<const ResponseObject>(first, count); });
  }
  [[nodiscard]] Answer<Span<const ResponseIsland>> islands() const {
    const ResponseIsland* first = nullptr;
    std::size_t count = 0;
    const abut_status status = abut_response_islands(get(), &first, &count);
    return detail::answer_with(status, [&] { return Span<const ResponseIsland>(first, count); });
  }
  [[nodiscard]] Answer<Energy> energy() const {
    Energy out{};
    return detail::answer(abut_response_energy(get(), &out), out);
  }

 private:
  explicit Response(abut_response* handle) noexcept : handle_(handle) {}

  struct KeptEditor {
    Editor editor;
    std::exception_ptr failure;
  };

  // No exception crosses the C interface.
  static std::uint32_t call_editor(void* context, const abut_contact* contact, abut_contact_material* material) {
    auto* const kept = static_cast<KeptEditor*>(context);
#ifdef ABUT_NO_EXCEPTIONS
    return kept->editor(*contact, *material) ? 1 : 0;
#else
    try {
      return !kept->failure && kept->editor(*contact, *material) ? 1 : 0;
    } catch (...) {
      kept->failure = std::current_exception();
      return 0;
    }
#endif
  }

  struct Destroy {
    void operator()(abut_response* response) const noexcept { abut_response_destroy(response); }
  };
  std::unique_ptr<KeptEditor> editor_;
  std::unique_ptr<abut_response, Destroy> handle_;
};

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
