// SPDX-License-Identifier: Apache-2.0
// Memory that a call has given back, for the next one like it. Searches of the narrow phase make lists that end with
// them. While a call uses spare blocks, what it gives back is kept for what it asks for next, on all of its threads.
export module abut.core.memory.spare_blocks;
import abut.core.standard;

export namespace abut {

class SpareBlocks {
 public:
  SpareBlocks() = default;
  SpareBlocks(const SpareBlocks&) = delete;
  SpareBlocks& operator=(const SpareBlocks&) = delete;
  ~SpareBlocks();

  // For whoever gives memory to all of the library: a block that is spare, of a size that is a multiple of 16, or
  // nothing; and whether one is kept that would be given back otherwise.
  [[nodiscard]] static void* take(std::size_t size, std::size_t alignment) noexcept;
  [[nodiscard]] static bool keep(void* block, std::size_t size, std::size_t alignment) noexcept;

  [[nodiscard]] std::size_t bytes() const noexcept { return bytes_; }

 private:
  struct [[gsl::Pointer]] Block {
    Block* next;
  };
  // Blocks of one kind, in no order. A kind is a size and an alignment in one number.
  struct [[gsl::Pointer]] List {
    std::uint32_t kind = 0, count = 0;
    Block* first = nullptr;
  };
  // Of at most so many kinds: a table that is open, of which one in four places stays free.
  class Lists {
   public:
    // Nothing where there is no place left.
    [[nodiscard]] List* of(std::uint32_t kind) noexcept;
    [[nodiscard]] bool is_full() const noexcept { return used_ == most_used; }
    [[nodiscard]] std::span<List> all() noexcept { return lists_; }

   private:
    static constexpr std::size_t places = 256, most_used = places / 4 * 3;
    std::array<List, places> lists_{};
    std::size_t used_ = 0;
  };

  static void put(List& list, void* block) noexcept;
  [[nodiscard]] static void* pop(List& list) noexcept;
  // What is left there goes back.
  static void release_all(Lists& lists) noexcept;
  // What a call or a task has given back, as far as there is room.
  void take_in(Lists& given) noexcept;
  void note_needed(Lists& by_task) noexcept;
  void top_up(std::uint32_t threads) noexcept;
  void forget() noexcept;

 public:
  // The blocks are in use on this thread while this lives. Tasks that run on several threads at once have a Use each,
  // of that of their caller.
  class [[gsl::Pointer]] Use {
   public:
    Use(SpareBlocks& spare, std::uint32_t threads) noexcept;
    // Of a task.
    explicit Use(Use& of_caller) noexcept;
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    ~Use();

    // None where this thread uses none.
    [[nodiscard]] static Use* present() noexcept;

   private:
    friend class SpareBlocks;
    SpareBlocks* spare_;
    Use* before_;
    std::uint32_t threads_;  // nothing for a task
    Lists own_;
  };

 private:
  std::mutex mutex_;
  Lists lists_;
  Lists needed_;  // only counts: what a task has had of each kind at once
  std::size_t bytes_ = 0;
};

}  // namespace abut
