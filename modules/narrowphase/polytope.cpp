module;
#include <array>
#include <cstddef>
#include <cstdint>
module abut.narrowphase.polytope;
import abut.math;
import abut.narrowphase.simplex;

namespace abut {

std::size_t Polytope::free_face(std::size_t& from) const {
  while (from < face_count_ && faces_[from].alive) {
    ++from;
  }
  return from;
}

bool Polytope::expand(std::size_t seed, const DifferenceVertex& vertex, Real noise) {
  if (vertex_count_ == vertex_limit) {
    return false;
  }
  // Faces that see the vertex, found by walking over neighbours from the seed, so that they are
  // connected; their open edges are the horizon.
  [[clang::uninitialized]] std::array<std::uint16_t, face_limit> visible;
  std::size_t visible_count = 0;
  const auto mark = [&](std::size_t face) {
    faces_[face].visible = true;
    visible[visible_count++] = static_cast<std::uint16_t>(face);
  };
  mark(seed);
  [[clang::uninitialized]] std::array<HorizonEdge, face_limit> horizon;
  std::size_t horizon_count = 0;
  for (std::size_t at = 0; at < visible_count; ++at) {
    const Face& face = faces_[visible[at]];
    for (std::size_t e = 0; e < 3; ++e) {
      const std::size_t beyond = face.neighbour[e];
      if (!faces_[beyond].visible && sees(faces_[beyond], vertex.w, noise)) {
        mark(beyond);
      }
    }
  }
  for (std::size_t at = 0; at < visible_count; ++at) {
    const Face& face = faces_[visible[at]];
    for (std::size_t e = 0; e < 3; ++e) {
      const std::uint16_t beyond = face.neighbour[e];
      if (!faces_[beyond].visible) {
        if (horizon_count == face_limit) {
          return false;
        }
        horizon[horizon_count++] = {face.corner[e], face.corner[(e + 1) % 3], beyond};
      }
    }
  }
  // One closed loop, put in order by joining ends to starts.
  for (std::size_t i = 1; i < horizon_count; ++i) {
    std::size_t next = i;
    while (next < horizon_count && horizon[next].from != horizon[i - 1].to) {
      ++next;
    }
    if (next == horizon_count) {
      return false;
    }
    const HorizonEdge joined = horizon[next];
    horizon[next] = horizon[i];
    horizon[i] = joined;
  }
  if (horizon_count < 3 || horizon[horizon_count - 1].to != horizon[0].from) {
    return false;
  }

  for (std::size_t i = 0; i < visible_count; ++i) {
    faces_[visible[i]].alive = false;
  }
  const auto apex = static_cast<std::uint16_t>(vertex_count_);
  vertices_[vertex_count_++] = vertex;
  std::size_t from = 0;
  std::size_t first = none, previous = none;
  for (std::size_t i = 0; i < horizon_count; ++i) {
    const std::size_t index = free_face(from);
    if (index == face_limit) {
      return false;
    }
    face_count_ = index == face_count_ ? face_count_ + 1 : face_count_;
    const HorizonEdge& edge = horizon[i];
    set_face(index, edge.from, edge.to, apex);
    faces_[index].neighbour[0] = edge.outside;
    Face& outside = faces_[edge.outside];
    for (std::size_t e = 0; e < 3; ++e) {
      if (outside.corner[e] == edge.to && outside.corner[(e + 1) % 3] == edge.from) {
        outside.neighbour[e] = static_cast<std::uint16_t>(index);
      }
    }
    if (previous != none) {
      faces_[previous].neighbour[1] = static_cast<std::uint16_t>(index);
      faces_[index].neighbour[2] = static_cast<std::uint16_t>(previous);
    } else {
      first = index;
    }
    previous = index;
  }
  faces_[previous].neighbour[1] = static_cast<std::uint16_t>(first);
  faces_[first].neighbour[2] = static_cast<std::uint16_t>(previous);
  return true;
}

}  // namespace abut
