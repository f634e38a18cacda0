// SPDX-License-Identifier: Apache-2.0
module;
#include <new>
module abut.core.memory.spare_blocks;
import abut.core.standard;

namespace abut {
namespace {

// Larger ones are mostly what a tree is made of, once. All that is spare is bounded as well.
constexpr std::size_t most_of_block = std::size_t{1} << 16, most_of_all = std::size_t{1} << 24;
constexpr std::size_t unit = 16;  // of sizes, so that a kind has place for an alignment

constinit thread_local SpareBlocks::Use* present_use = nullptr;

// Nothing for blocks that are not kept.
std::uint32_t kind_of(std::size_t size, std::size_t alignment) noexcept {
  const auto steps = static_cast<std::size_t>(std::countr_zero(alignment / unit));
  return size <= most_of_block && steps < unit ? static_cast<std::uint32_t>(size + steps) : 0;
}
std::size_t size_of(std::uint32_t kind) noexcept { return kind / unit * unit; }
std::size_t alignment_of(std::uint32_t kind) noexcept { return unit << kind % unit; }
bool is_usual(std::uint32_t kind) noexcept { return alignment_of(kind) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__; }

void* ask_for(std::uint32_t kind) {
  return is_usual(kind) ? ::operator new(size_of(kind))
                        : ::operator new(size_of(kind), std::align_val_t{alignment_of(kind)});
}
void give_back(void* block, std::uint32_t kind) noexcept {
  if (is_usual(kind)) {
    ::operator delete(block, size_of(kind));
  } else {
    ::operator delete(block, size_of(kind), std::align_val_t{alignment_of(kind)});
  }
}

}  // namespace

SpareBlocks::List* SpareBlocks::Lists::of(std::uint32_t kind) noexcept {
  constexpr std::uint32_t mixing = 0x9e3779b1;  // the golden ratio, as in Knuth's multiplicative hashing
  std::size_t place = kind * mixing >> (32 - std::countr_zero(places));
  while (lists_[place].kind != kind && lists_[place].kind != 0) {
    place = (place + 1) % places;
  }
  if (lists_[place].kind == 0) {
    if (used_ == most_used) {
      return nullptr;
    }
    ++used_;
    lists_[place].kind = kind;
  }
  return &lists_[place];
}

void SpareBlocks::put(List& list, void* block) noexcept {
  list.first = new (block) Block{list.first};
  ++list.count;
}

void* SpareBlocks::pop(List& list) noexcept {
  Block* const block = list.first;
  list.first = block->next;
  --list.count;
  return block;
}

void SpareBlocks::release_all(Lists& lists) noexcept {
  for (List& list : lists.all()) {
    while (list.count > 0) {
      give_back(pop(list), list.kind);
    }
  }
}

SpareBlocks::~SpareBlocks() { release_all(lists_); }

void* SpareBlocks::take(std::size_t size, std::size_t alignment) noexcept {
  Use* const use = present_use;
  const std::uint32_t kind = use == nullptr ? 0 : kind_of(size, alignment);
  if (kind == 0) {
    return nullptr;
  }
  if (List* const own = use->own_.of(kind); own != nullptr && own->count > 0) {
    return pop(*own);
  }
  SpareBlocks& spare = *use->spare_;
  const std::scoped_lock lock(spare.mutex_);
  List* const list = spare.lists_.of(kind);
  if (list == nullptr || list->count == 0) {
    return nullptr;
  }
  spare.bytes_ -= size;
  return pop(*list);
}

bool SpareBlocks::keep(void* block, std::size_t size, std::size_t alignment) noexcept {
  Use* const use = present_use;
  const std::uint32_t kind = use == nullptr ? 0 : kind_of(size, alignment);
  List* const own = kind == 0 ? nullptr : use->own_.of(kind);
  if (own != nullptr) {
    put(*own, block);
  }
  return own != nullptr;
}

void SpareBlocks::take_in(Lists& given) noexcept {
  const std::scoped_lock lock(mutex_);
  for (List& its : given.all()) {
    List* const list = its.count == 0 ? nullptr : lists_.of(its.kind);
    while (list != nullptr && its.count > 0 && bytes_ + size_of(its.kind) <= most_of_all) {
      put(*list, pop(its));
      bytes_ += size_of(its.kind);
    }
  }
}

void SpareBlocks::note_needed(Lists& by_task) noexcept {
  const std::scoped_lock lock(mutex_);
  for (const List& its : by_task.all()) {
    List* const needed = its.count == 0 ? nullptr : needed_.of(its.kind);
    if (needed != nullptr) {
      needed->count = std::max(needed->count, its.count);
    }
  }
}

// However tasks fall onto threads next time, each of them finds what it had. Without memory they ask for it again.
void SpareBlocks::top_up(std::uint32_t threads) noexcept {
  for (const List& needed : needed_.all()) {
    List* const list = needed.count == 0 ? nullptr : lists_.of(needed.kind);
    const std::size_t size = size_of(needed.kind), wanted = std::size_t{threads} * needed.count;
    while (list != nullptr && list->count < wanted && bytes_ + size <= most_of_all) {
      try {
        put(*list, ask_for(needed.kind));
      } catch (const std::bad_alloc&) {
        return;
      }
      bytes_ += size;
    }
  }
}

void SpareBlocks::forget() noexcept {
  release_all(lists_);
  lists_ = {};
  needed_ = {};
  bytes_ = 0;
}

SpareBlocks::Use::Use(SpareBlocks& spare, std::uint32_t threads) noexcept
    : spare_(&spare), before_(std::exchange(present_use, nullptr)), threads_(threads) {
  present_use = this;
}

SpareBlocks::Use::Use(Use& of_caller) noexcept
    : spare_(of_caller.spare_), before_(std::exchange(present_use, nullptr)), threads_(0) {
  present_use = this;
}

SpareBlocks::Use::~Use() {
  present_use = nullptr;
  if (threads_ == 0) {
    spare_->note_needed(own_);
  } else {
    spare_->top_up(threads_);
    // Kinds of lists that have grown since would take all places in time.
    if (spare_->lists_.is_full() || spare_->needed_.is_full()) {
      spare_->forget();
    }
  }
  spare_->take_in(own_);
  release_all(own_);
  present_use = before_;
}

SpareBlocks::Use* SpareBlocks::Use::present() noexcept { return present_use; }

}  // namespace abut
