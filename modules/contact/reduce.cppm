// Reduces a manifold to the few points that hold a body as well as all of them.
module;
#include <cstddef>
#include <cstdint>
#include <span>
export module abut.contact.reduce;
import abut.math;
import abut.shape;

export namespace abut {

// Reorders contacts so that the ones to keep come first, deepest first, and returns how many. Points
// whose normals agree (cosine at least 0.98) form a patch; each patch keeps at most `most` points: the
// deepest one, and those that span the largest area with it. 0 keeps all and only sorts.
[[nodiscard]] std::size_t reduce(std::span<ContactPoint> contacts, std::size_t most);

}  // namespace abut
