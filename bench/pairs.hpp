// SPDX-License-Identifier: Apache-2.0
// One question about many placed pairs of solids, asked to one library.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "scene.hpp"

namespace bench {

// distance: of separated pairs. depth: signed distance of overlapping pairs. contacts: of both. cast: of separated
// pairs, the share of the motion of b at the first touch, 1 without one. overlap: yes or no. ray: as a cast, of a point
// that b stands for. impact: as a cast, of b that turns as well.
enum class Query : std::uint8_t { distance, depth, contacts, cast, overlap, ray, impact };

struct Case {
  std::size_t a = 0, b = 0;  // which of the solids
  Placement pose_a, pose_b;
  Point motion{};  // of b, for casts, rays and impacts
  Point turn{};    // of b on that way, for impacts: axis times angle, in the world
};

struct Cell {
  std::span<const Solid> solids_a, solids_b;
  std::span<const Case> cases;
};

struct Answer {
  double distance = 0;       // signed; of contacts: of the deepest one; of a cast: the share; of an overlap: -1, else 1
  std::uint32_t points = 0;  // contacts that overlap; 1 for the other queries, 0 where the library gave up
};

class Contender {
 public:
  Contender() = default;
  Contender(const Contender&) = delete;
  Contender& operator=(const Contender&) = delete;
  virtual ~Contender() = default;

  // The timed part: answers all cases of the cell that it was made for.
  virtual void answer(std::span<Answer> answers) = 0;
};

struct Maker {
  std::string_view name;
  std::unique_ptr<Contender> (*make)(Query query, const Cell& cell);
};

// Each makes what the library wants to have ready; null when it has no such query for the cell.
[[gnu::visibility("default")]] std::unique_ptr<Contender> make_bullet(Query query, const Cell& cell);
[[gnu::visibility("default")]] std::unique_ptr<Contender> make_fcl(Query query, const Cell& cell);
[[gnu::visibility("default")]] std::unique_ptr<Contender> make_libccd_gjk(Query query, const Cell& cell);
[[gnu::visibility("default")]] std::unique_ptr<Contender> make_libccd_mpr(Query query, const Cell& cell);
// Null for everything where the benchmark was built without ODE.
[[gnu::visibility("default")]] std::unique_ptr<Contender> make_ode(Query query, const Cell& cell);
// Null for everything where the benchmark was built without their sources (ABUT_PEERS).
[[gnu::visibility("default")]] std::unique_ptr<Contender> make_box3d(Query query, const Cell& cell);
[[gnu::visibility("default")]] std::unique_ptr<Contender> make_jolt(Query query, const Cell& cell);
[[gnu::visibility("default")]] std::unique_ptr<Contender> make_coal(Query query, const Cell& cell);
std::unique_ptr<Contender> make_abut(Query query, const Cell& cell);
std::unique_ptr<Contender> make_abut_c(Query query, const Cell& cell);
// With a memory for each pair, of which b sways by a thousandth of its size from call to call.
std::unique_ptr<Contender> make_abut_c_warm(Query query, const Cell& cell);
// abut's own routes through libccd.
std::unique_ptr<Contender> make_abut_ccd_gjk(Query query, const Cell& cell);
std::unique_ptr<Contender> make_abut_ccd_mpr(Query query, const Cell& cell);

// Replaces the points of a hull by its vertices and adds its surface.
void find_surface(Solid& hull);

}  // namespace bench
