// SPDX-License-Identifier: Apache-2.0
// Room in lists for what must not fail later.
export module abut.scene.room;
import abut.core.standard;

export namespace abut {

// So that the next `count` values are added without asking for memory. Takes constant time per value on average, which
// vector::reserve does not when it is called again and again.
template <class T>
void make_room(std::vector<T>& list, std::size_t count) {
  if (list.capacity() - list.size() < count) {
    list.reserve(std::max(list.size() + count, 2 * list.capacity()));
  }
}

}  // namespace abut
