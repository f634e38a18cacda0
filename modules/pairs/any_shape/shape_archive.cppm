// SPDX-License-Identifier: Apache-2.0
// Shapes as bytes and back, bit by bit, each once however many hold it.
export module abut.pairs.any_shape.shape_archive;
import abut.core.archive;
import abut.core.standard;
import abut.math;
import abut.pairs.any_shape;

export namespace abut {

// Whether a pose that was read is one: finite, and a turn within rounding.
[[nodiscard]] bool is_rigid(const Pose& pose);

class ShapeList {
 public:
  // Children of composites come before these.
  void add(const ShapeHandle& shape);
  // Of a shape that was added.
  [[nodiscard]] std::uint32_t number_of(const ShapeHandle& shape) const { return numbers_.at(address_of(shape)); }
  [[nodiscard]] std::span<const ShapeHandle> all() const [[clang::lifetimebound]] { return shapes_; }

  void write(ByteWriter& out) const;
  void read(ByteReader& in);

 private:
  [[nodiscard]] static std::uint64_t address_of(const ShapeHandle& shape) {
    return std::bit_cast<std::uint64_t>(&*shape);
  }

  std::vector<ShapeHandle> shapes_;
  std::map<std::uint64_t, std::uint32_t> numbers_;  // by where shapes lie
};

}  // namespace abut
