// Questions about two shapes. The way to the kernel and back allocates nothing and builds no text
// unless something is wrong.
#include "convert.hpp"
#include "guard.hpp"
#include "options.hpp"
#include "shape_handle.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.manifold;
import abut.pairs.any_shape;
import abut.pairs.registry;

using namespace abut::capi;

namespace {

constexpr abut_query_options default_options{sizeof(abut_query_options), ABUT_ALGORITHM_AUTO, 0, 0, 4, 0};

constexpr std::array<std::string_view, 6> algorithm_names{"ABUT_ALGORITHM_AUTO",       "ABUT_ALGORITHM_ANALYTIC",
                                                          "ABUT_ALGORITHM_SAT",        "ABUT_ALGORITHM_GJK_EPA",
                                                          "ABUT_ALGORITHM_LIBCCD_GJK", "ABUT_ALGORITHM_LIBCCD_MPR"};

struct Query {
  abut::QuerySettings settings;
  std::uint32_t max_contacts = default_options.max_contacts;
  std::uint32_t max_pair_contacts = default_options.max_pair_contacts;
};

abut_status read_given_options(const abut_query_options& options, Query& query) {
  if (const abut_status status = check_struct_size({"options"}, options); status != ABUT_OK) {
    return status;
  }
  if (const abut_status status = check_value({"options"}, ".algorithm", options.algorithm, ABUT_ALGORITHM_LIBCCD_MPR);
      status != ABUT_OK) {
    return status;
  }
  if (!(options.error_bound >= 0 && options.error_bound <= abut::largest_coordinate)) {
    return to_status(abut::check_not_negative("options.error_bound", options.error_bound));
  }
  if (!is_coordinate(options.margin)) {
    return to_status(abut::check_finite("options.margin", options.margin));
  }
  query.settings.algorithm = static_cast<abut::Algorithm>(options.algorithm);
  if (options.error_bound > 0) {
    query.settings.error_bound = options.error_bound;
  }
  query.settings.margin = options.margin;
  query.max_contacts = options.max_contacts;
  query.max_pair_contacts = options.max_pair_contacts;
  return ABUT_OK;
}

inline abut_status read_options(const abut_query_options* options, Query& query) {
  return options == nullptr ? static_cast<abut_status>(ABUT_OK) : read_given_options(*options, query);
}

[[gnu::always_inline]] inline abut_status check_poses(const abut_pose& pose_a, const abut_pose& pose_b) {
  const abut_status status = check_pose({"pose_a"}, pose_a);
  return status != ABUT_OK ? status : check_pose({"pose_b"}, pose_b);
}

[[gnu::cold]] abut_status refuse_outcome(abut::Outcome outcome, const abut::AnyShape& a, const abut::AnyShape& b,
                                         abut::Algorithm algorithm) {
  const std::string pair = std::string(abut::kind_name(a.index())) + " and " + std::string(abut::kind_name(b.index()));
  const std::string with(algorithm_names[static_cast<std::size_t>(algorithm)]);
  if (outcome == abut::Outcome::unsupported && algorithm == abut::Algorithm::automatic) {
    return refuse(ABUT_UNSUPPORTED, "there is no algorithm for " + pair);
  }
  switch (outcome) {
    case abut::Outcome::apart:
      return refuse(ABUT_UNSUPPORTED, "options.algorithm is " + with +
                                          ", which only tells how deep shapes overlap; this " + pair + " are apart");
    case abut::Outcome::unsupported:
      return refuse(ABUT_UNSUPPORTED, "options.algorithm is " + with + "; there is no such way for " + pair);
    case abut::Outcome::not_converged: return refuse(ABUT_NOT_CONVERGED, with + " gave up on " + pair);
    case abut::Outcome::ok: break;
  }
  return ABUT_OK;
}

static_assert(offsetof(abut::Distance, lower) == offsetof(abut_distance, lower));
static_assert(offsetof(abut::Distance, upper) == offsetof(abut_distance, upper));
static_assert(offsetof(abut::Distance, point_a) == offsetof(abut_distance, point_a));
static_assert(offsetof(abut::Distance, point_b) == offsetof(abut_distance, point_b));
static_assert(offsetof(abut::Distance, normal) == offsetof(abut_distance, normal));
static_assert(offsetof(abut::Distance, algorithm) == offsetof(abut_distance, algorithm));
static_assert(offsetof(abut::Distance, iterations) == offsetof(abut_distance, iterations));

// For poses that were checked. The kernel writes to the struct of the caller: a copy would wait for what it has
// written.
[[gnu::always_inline]] inline abut_status find_distance(const abut::AnyShape& a, const abut_pose& given_a,
                                                        const abut::AnyShape& b, const abut_pose& given_b,
                                                        const abut::QuerySettings& settings, abut_distance& out) {
  const abut::Outcome outcome =
      abut::pair_distance(a, b, to_pose(given_a), to_pose(given_b), settings, written_as<abut::Distance>(out));
  return outcome == abut::Outcome::ok ? static_cast<abut_status>(ABUT_OK)
                                      : refuse_outcome(outcome, a, b, settings.algorithm);
}

abut_status distance(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b, const abut_pose& pose_b,
                     const abut_query_options* options, abut_distance* out) {
  if (const abut_status status = check_poses(pose_a, pose_b); status != ABUT_OK) {
    return status;
  }
  Query query;
  if (const abut_status status = read_options(options, query); status != ABUT_OK) {
    return status;
  }
  return find_distance(shape_of(a), pose_a, shape_of(b), pose_b, query.settings, *out);
}

struct PoseBatch {
  std::span<const abut_pose> a, b;
};

abut_status check_batch(const PoseBatch& poses) {
  for (std::size_t i = 0; i < poses.a.size(); ++i) {
    if (const abut_status status = check_pose({"poses_a", i}, poses.a[i]); status != ABUT_OK) {
      return status;
    }
    if (const abut_status status = check_pose({"poses_b", i}, poses.b[i]); status != ABUT_OK) {
      return status;
    }
  }
  return ABUT_OK;
}

abut_status distances(const abut_shape* a, const abut_shape* b, const PoseBatch& poses,
                      const abut_query_options* options, std::span<abut_distance> out) {
  if (const abut_status status = check_batch(poses); status != ABUT_OK) {
    return status;
  }
  Query query;
  if (const abut_status status = read_options(options, query); status != ABUT_OK) {
    return status;
  }
  // A kernel may fail at the last pair, and then nothing must have been written.
  std::vector<abut_distance> found;
  found.reserve(out.size());
  for (std::size_t i = 0; i < poses.a.size(); ++i) {
    [[clang::uninitialized]] abut_distance one;
    if (const abut_status status = find_distance(shape_of(a), poses.a[i], shape_of(b), poses.b[i], query.settings, one);
        status != ABUT_OK) {
      set_message("pair " + std::to_string(i) + ": " + abut_last_error_message());
      return status;
    }
    found.push_back(one);
  }
  std::copy(found.begin(), found.end(), out.begin());
  return ABUT_OK;
}

// Room for the contacts of most pairs, made at once: growing would cost more than many a pair takes. Allocators keep
// blocks of up to a kilobyte at hand for each thread; larger ones take as long as a pair of balls.
constexpr std::size_t usual_points = 8;
static_assert(usual_points * sizeof(abut::ContactPoint) <= 1024);

abut_status contacts(const abut_shape* a, const abut_pose& given_a, const abut_shape* b, const abut_pose& given_b,
                     const abut_query_options* options, std::span<abut_contact> out, std::size_t* count) {
  if (const abut_status status = check_poses(given_a, given_b); status != ABUT_OK) {
    return status;
  }
  Query query;
  if (const abut_status status = read_options(options, query); status != ABUT_OK) {
    return status;
  }
  abut::Manifold found;
  found.reserve(usual_points);
  const abut::Outcome outcome =
      abut::pair_contacts(shape_of(a), shape_of(b), to_pose(given_a), to_pose(given_b), query.settings, found);
  if (outcome != abut::Outcome::ok) [[unlikely]] {
    return refuse_outcome(outcome, shape_of(a), shape_of(b), query.settings.algorithm);
  }
  // Most pairs have nothing to choose from.
  std::size_t kept = found.size() < 2 ? found.size() : abut::reduce_children(found, query.max_contacts);
  kept = abut::cap(std::span(found).first(kept), query.max_pair_contacts);
  fill(std::span<const abut::ContactPoint>(found).first(kept), out,
       [](const abut::ContactPoint& contact) { return from_contact(contact); });
  *count = kept;
  return ABUT_OK;
}

}  // namespace

void abut_query_options_init(abut_query_options* options, uint32_t struct_size) {
  fill_defaults(default_options, struct_size, options);
}

abut_status abut_pair_distance(const abut_shape* a, const abut_pose* pose_a, const abut_shape* b,
                               const abut_pose* pose_b, const abut_query_options* options, abut_distance* out) {
  return guard([&] {
    const abut_status status =
        check_none_null<5>({{{"a", a}, {"pose_a", pose_a}, {"b", b}, {"pose_b", pose_b}, {"out", out}}});
    return status != ABUT_OK ? status : distance(a, *pose_a, b, *pose_b, options, out);
  });
}

abut_status abut_pairs_distance(const abut_shape* a, const abut_pose* poses_a, const abut_shape* b,
                                const abut_pose* poses_b, size_t count, const abut_query_options* options,
                                abut_distance* out) {
  return guard([&] {
    PoseBatch poses;
    std::span<abut_distance> results;
    abut_status status = check_none_null<2>({{{"a", a}, {"b", b}}});
    status = status != ABUT_OK ? status : read_span("poses_a", poses_a, "count", count, poses.a);
    status = status != ABUT_OK ? status : read_span("poses_b", poses_b, "count", count, poses.b);
    status = status != ABUT_OK ? status : read_span("out", out, "count", count, results);
    return status != ABUT_OK ? status : distances(a, b, poses, options, results);
  });
}

abut_status abut_pair_contacts(const abut_shape* a, const abut_pose* pose_a, const abut_shape* b,
                               const abut_pose* pose_b, const abut_query_options* options, abut_contact* contacts_out,
                               size_t capacity, size_t* count) {
  return guard([&] {
    std::span<abut_contact> results;
    abut_status status =
        check_none_null<5>({{{"a", a}, {"pose_a", pose_a}, {"b", b}, {"pose_b", pose_b}, {"count", count}}});
    status = status != ABUT_OK ? status : read_span("contacts", contacts_out, "capacity", capacity, results);
    return status != ABUT_OK ? status : contacts(a, *pose_a, b, *pose_b, options, results, count);
  });
}
