// SPDX-License-Identifier: Apache-2.0
// Values as bytes and back. Numbers begin with their lowest byte, whatever the machine.
//
// A plain struct is its fields, one after the other; a class says in `transfer` what it is made of. One function serves
// both directions, so that they cannot differ.
export module abut.core.archive;
import abut.core.error;
import abut.core.id;
import abut.core.standard;

namespace abut {

// Converts to whatever a field is.
struct AnyField {
  template <class T>
  operator T() const;
};

template <class T, class... Fields>
consteval std::size_t count_fields() {
  if constexpr (requires { T{Fields{}..., AnyField{}}; }) {
    return count_fields<T, Fields..., AnyField>();
  } else {
    return sizeof...(Fields);
  }
}

// Hands the fields of a plain struct to the archive.
template <class Archive, class T>
void transfer_fields(Archive& archive, T& value) {
  constexpr std::size_t count = count_fields<std::remove_const_t<T>>();
  static_assert(count >= 1 && count <= 14);
  if constexpr (count == 1) {
    auto& [a] = value;
    archive(a);
  } else if constexpr (count == 2) {
    auto& [a, b] = value;
    archive(a, b);
  } else if constexpr (count == 3) {
    auto& [a, b, c] = value;
    archive(a, b, c);
  } else if constexpr (count == 4) {
    auto& [a, b, c, d] = value;
    archive(a, b, c, d);
  } else if constexpr (count == 5) {
    auto& [a, b, c, d, e] = value;
    archive(a, b, c, d, e);
  } else if constexpr (count == 6) {
    auto& [a, b, c, d, e, f] = value;
    archive(a, b, c, d, e, f);
  } else if constexpr (count == 7) {
    auto& [a, b, c, d, e, f, g] = value;
    archive(a, b, c, d, e, f, g);
  } else if constexpr (count == 8) {
    auto& [a, b, c, d, e, f, g, h] = value;
    archive(a, b, c, d, e, f, g, h);
  } else if constexpr (count == 9) {
    auto& [a, b, c, d, e, f, g, h, i] = value;
    archive(a, b, c, d, e, f, g, h, i);
  } else if constexpr (count == 10) {
    auto& [a, b, c, d, e, f, g, h, i, j] = value;
    archive(a, b, c, d, e, f, g, h, i, j);
  } else if constexpr (count == 11) {
    auto& [a, b, c, d, e, f, g, h, i, j, k] = value;
    archive(a, b, c, d, e, f, g, h, i, j, k);
  } else if constexpr (count == 12) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l] = value;
    archive(a, b, c, d, e, f, g, h, i, j, k, l);
  } else if constexpr (count == 13) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = value;
    archive(a, b, c, d, e, f, g, h, i, j, k, l, m);
  } else {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = value;
    archive(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
  }
}

// As many bits as the number has.
template <std::size_t Size>
struct UnsignedOf;
template <>
struct UnsignedOf<1> {
  using Type = std::uint8_t;
};
template <>
struct UnsignedOf<2> {
  using Type = std::uint16_t;
};
template <>
struct UnsignedOf<4> {
  using Type = std::uint32_t;
};
template <>
struct UnsignedOf<8> {
  using Type = std::uint64_t;
};

template <class T>
inline constexpr bool is_number = std::numeric_limits<T>::is_specialized;

}  // namespace abut

export namespace abut {

class ByteWriter {
 public:
  static constexpr bool is_reading = false;

  template <class... Values>
  void operator()(const Values&... values) {
    (write(values), ...);
  }
  [[nodiscard]] std::span<const std::uint8_t> bytes() const [[clang::lifetimebound]] { return bytes_; }

 private:
  template <class T>
  void write(const T& value) {
    if constexpr (requires { T::transfer(*this, value); }) {
      T::transfer(*this, value);
    } else if constexpr (std::is_enum_v<T>) {
      write(static_cast<std::underlying_type_t<T>>(value));
    } else if constexpr (is_number<T>) {
      write_number(value);
    } else {
      transfer_fields(*this, value);
    }
  }
  template <class Tag>
  void write(const Id<Tag>& id) {
    (*this)(id.slot, id.generation);
  }
  template <class T>
  void write(const std::optional<T>& value) {
    write(value.has_value());
    if (value) {
      write(*value);
    }
  }
  template <class T>
  void write(const std::vector<T>& values) {
    write(std::uint64_t{values.size()});
    for (const T& value : values) {
      write(value);
    }
  }
  template <class Key, class Value>
  void write(const std::map<Key, Value>& values) {
    write(std::uint64_t{values.size()});
    for (const auto& [key, value] : values) {
      (*this)(key, value);
    }
  }
  template <class T, std::size_t Count>
  void write(const std::array<T, Count>& values) {
    for (const T& value : values) {
      write(value);
    }
  }
  template <class T>
  void write_number(T number) {
    const auto bits = std::bit_cast<typename UnsignedOf<sizeof(T)>::Type>(number);
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      bytes_.push_back(static_cast<std::uint8_t>(bits >> (8 * i) & 0xffu));
    }
  }

  std::vector<std::uint8_t> bytes_;
};

// Reads what a ByteWriter has written. After the first fault it reads zeros and keeps the fault, which is looked at
// once in the end. Nothing is asked for memory that the bytes cannot fill.
class ByteReader {
 public:
  static constexpr bool is_reading = true;

  explicit ByteReader(std::span<const std::uint8_t> bytes) : rest_(bytes.begin(), bytes.end()) {}

  template <class... Values>
  void operator()(Values&... values) {
    (read(values), ...);
  }
  // Keeps the first thing that is wrong.
  void require(bool is_right, std::string_view what_is_wrong) {
    if (!is_right && !fault_) {
      fault_ = Error{Errc::invalid_argument, std::string(what_is_wrong)};
    }
  }
  void fail(const Error& error) { fault_ = fault_ ? fault_ : error; }
  [[nodiscard]] const std::optional<Error>& fault() const [[clang::lifetimebound]] { return fault_; }
  [[nodiscard]] bool has_failed() const { return fault_.has_value(); }
  [[nodiscard]] bool is_at_end() const { return at_ == rest_.size(); }

 private:
  template <class T>
  void read(T& value) {
    if constexpr (requires { T::transfer(*this, value); }) {
      T::transfer(*this, value);
    } else if constexpr (std::is_enum_v<T>) {
      std::underlying_type_t<T> number{};
      read(number);
      value = static_cast<T>(number);
    } else if constexpr (std::is_same_v<T, bool>) {
      std::uint8_t number = 0;
      read(number);
      require(number <= 1, "what is yes or no is neither");
      value = number == 1;
    } else if constexpr (is_number<T>) {
      value = read_number<T>();
    } else {
      transfer_fields(*this, value);
    }
  }
  template <class Tag>
  void read(Id<Tag>& id) {
    (*this)(id.slot, id.generation);
  }
  template <class T>
  void read(std::optional<T>& value) {
    bool has_value = false;
    read(has_value);
    value.reset();
    if (has_value && !fault_) {
      read(value.emplace(T{}));
    }
  }
  template <class T>
  void read(std::vector<T>& values) {
    values.clear();
    for (std::uint64_t left = read_count(); left > 0 && !fault_; --left) {
      values.push_back(T{});
      read(values.back());
    }
  }
  template <class Key, class Value>
  void read(std::map<Key, Value>& values) {
    values.clear();
    for (std::uint64_t left = read_count(); left > 0 && !fault_; --left) {
      Key key{};
      Value value{};
      (*this)(key, value);
      require(values.try_emplace(key, value).second, "a row of a table is there twice");
    }
  }
  template <class T, std::size_t Count>
  void read(std::array<T, Count>& values) {
    for (T& value : values) {
      read(value);
    }
  }
  // Each value has a byte at least.
  [[nodiscard]] std::uint64_t read_count() {
    const auto count = read_number<std::uint64_t>();
    require(count <= rest_.size() - at_, "a list is longer than the bytes");
    return count;
  }
  template <class T>
  [[nodiscard]] T read_number() {
    using Bits = typename UnsignedOf<sizeof(T)>::Type;
    require(rest_.size() - at_ >= sizeof(T), "the bytes end within a value");
    if (fault_) {
      return T{};
    }
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      bits |= std::uint64_t{rest_[at_ + i]} << (8 * i);
    }
    at_ += sizeof(T);
    return std::bit_cast<T>(static_cast<Bits>(bits));
  }

  std::vector<std::uint8_t> rest_;
  std::size_t at_ = 0;
  std::optional<Error> fault_;
};

// CRC-32C (Castagnoli 1993), a table of 256 entries.
[[nodiscard]] inline std::uint32_t checksum_of(std::span<const std::uint8_t> bytes) {
  static constexpr auto table = [] {
    constexpr std::uint32_t polynomial = 0x82f63b78;
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t i = 0; i < entries.size(); ++i) {
      std::uint32_t entry = i;
      for (int bit = 0; bit < 8; ++bit) {
        entry = (entry & 1u) != 0 ? entry >> 1 ^ polynomial : entry >> 1;
      }
      entries[i] = entry;
    }
    return entries;
  }();
  std::uint32_t sum = ~std::uint32_t{0};
  for (const std::uint8_t byte : bytes) {
    sum = table[(sum ^ byte) & 0xffu] ^ sum >> 8;
  }
  return ~sum;
}

}  // namespace abut
