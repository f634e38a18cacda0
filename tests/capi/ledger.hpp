// SPDX-License-Identifier: Apache-2.0
// An allocator of the host that writes down what it gives, and checks what it takes back. While one lives, abut has its
// memory from it.
#pragma once

#include "support.hpp"

#include <iterator>
#include <map>
#include <memory_resource>
#include <mutex>

namespace abut_test {

class Ledger {
 public:
  Ledger() { require(abut_set_allocator(give, take, this)); }
  ~Ledger() {
    EXPECT_TRUE(held_.empty()) << held_.size() << " blocks were not given back";
    require(abut_set_allocator(nullptr, nullptr, nullptr));
  }
  Ledger(const Ledger&) = delete;
  Ledger& operator=(const Ledger&) = delete;

  // The request that comes after so many others is refused.
  void refuse_after(std::size_t granted) { refused_ = asked_ + granted; }
  void shift_addresses(bool are_shifted) { are_shifted_ = are_shifted; }

  std::size_t asked() const { return asked_; }
  std::size_t given_back() const { return given_back_; }
  std::size_t blocks() const { return held_.size(); }
  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& [memory, block] : held_) sum += block.size;
    return sum;
  }

 private:
  struct Block {
    std::size_t size, alignment;
    void* whole;
  };
  static constexpr std::size_t shift = 8;

  static void* give(void* context, std::size_t size, std::size_t alignment) {
    Ledger& its = *static_cast<Ledger*>(context);
    const std::scoped_lock lock(its.mutex_);
    EXPECT_GE(size, 1U);
    EXPECT_GE(alignment, 16U);
    EXPECT_TRUE(std::has_single_bit(alignment)) << alignment;
    if (its.asked_++ == its.refused_) return nullptr;
    void* const whole = std::pmr::new_delete_resource()->allocate(size + shift, alignment);
    void* const memory =
        std::next(static_cast<unsigned char*>(whole), static_cast<std::ptrdiff_t>(its.are_shifted_ ? shift : 0));
    its.held_[memory] = {size, alignment, whole};
    return memory;
  }

  static void take(void* context, void* memory, std::size_t size, std::size_t alignment) {
    Ledger& its = *static_cast<Ledger*>(context);
    const std::scoped_lock lock(its.mutex_);
    const auto found = its.held_.find(memory);
    ASSERT_NE(found, its.held_.end()) << "a block that was not given";
    EXPECT_EQ(found->second.size, size);
    EXPECT_EQ(found->second.alignment, alignment);
    std::pmr::new_delete_resource()->deallocate(found->second.whole, size + shift, alignment);
    its.held_.erase(found);
    ++its.given_back_;
  }

  std::mutex mutex_;
  std::map<void*, Block> held_;
  std::size_t asked_ = 0, given_back_ = 0, refused_ = ~std::size_t{0};
  bool are_shifted_ = false;
};

}  // namespace abut_test
