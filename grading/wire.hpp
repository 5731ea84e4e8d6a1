// SPDX-License-Identifier: MIT
#pragma once
// Values of a contract as bytes, and back. What is read may come from a hostile program: every bool, index and length
// is checked before it is used, and nothing is read or allocated beyond bounds. Both ends run on one machine, compiled by
// one compiler, so numbers travel as they lie in memory.

#include <contract.hpp>

#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace lantern {
struct timed_ray;
}

namespace contract::wire {

inline constexpr std::size_t largest_message = 32u << 20;    // bytes
inline constexpr std::size_t largest_decoding = 128u << 20;  // bytes of memory that one message may become
inline constexpr int deepest_value = 64;                     // sequences within sequences

/// What was read is not what was asked for. No std::exception: no suite may take it for the student's.
struct violation {
    std::string what;
};

class encoder {
public:
    void raw(const void* from, std::size_t size) {
        if (size > largest_message - bytes_.size()) throw std::length_error("the value is larger than 32 MiB");
        bytes_.append(static_cast<const char*>(from), size);
    }
    void length(std::size_t n) {
        const std::uint64_t sent = n;
        raw(&sent, sizeof sent);
    }
    [[nodiscard]] std::string_view bytes() const { return bytes_; }

private:
    std::string bytes_;
};

class decoder {
public:
    explicit decoder(std::string_view bytes) : rest_(bytes) {}

    void raw(void* to, std::size_t size) {
        if (size > rest_.size()) throw violation{"a value that ends too early"};
        std::memcpy(to, rest_.data(), size);
        rest_.remove_prefix(size);
    }
    template <class T>
    T number() {
        T value;
        raw(&value, sizeof value);
        return value;
    }
    /// The length of a sequence whose elements take `bytes` each in the message at least, and `memory` each once read.
    std::size_t length(std::size_t bytes, std::size_t memory) {
        const auto n = number<std::uint64_t>();
        if (bytes != 0 && n > rest_.size() / bytes) throw violation{"a sequence longer than its message"};
        if (n > (largest_decoding - allocated_) / memory) throw violation{"a value too large to be read"};
        allocated_ += std::size_t(n) * memory;
        return std::size_t(n);
    }
    void finish() const {
        if (!rest_.empty()) throw violation{"bytes behind the value"};
    }

    /// Counts how deep sequences stand in one another.
    class level {
    public:
        explicit level(decoder& in) : in_(in) {
            if (++in_.depth_ > deepest_value) throw violation{"a value nested too deeply"};
        }
        ~level() { --in_.depth_; }
        level(const level&) = delete;
        level& operator=(const level&) = delete;

    private:
        decoder& in_;
    };

private:
    std::string_view rest_;
    std::size_t allocated_ = 0;
    int depth_ = 0;
};

// ---- What kinds of values there are --------------------------------------------------------------------------------

template <class T, template <class...> class Template>
inline constexpr bool is_a = false;
template <template <class...> class Template, class... A>
inline constexpr bool is_a<Template<A...>, Template> = true;

template <class T>
inline constexpr bool is_glm = false;
template <glm::length_t L, class T, glm::qualifier Q>
inline constexpr bool is_glm<glm::vec<L, T, Q>> = true;
template <glm::length_t C, glm::length_t R, class T, glm::qualifier Q>
inline constexpr bool is_glm<glm::mat<C, R, T, Q>> = true;

template <class T>
inline constexpr bool is_std_array = false;
template <class T, std::size_t N>
inline constexpr bool is_std_array<std::array<T, N>> = true;

template <class T>
inline constexpr bool is_span = false;
template <class T, std::size_t N>
inline constexpr bool is_span<std::span<T, N>> = true;

template <class T>
inline constexpr bool is_number = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;

template <class T>
inline constexpr bool is_flat = is_number<T>;  ///< any bytes are a value
template <glm::length_t L, class T, glm::qualifier Q>
inline constexpr bool is_flat<glm::vec<L, T, Q>> = is_number<T>;
template <glm::length_t C, glm::length_t R, class T, glm::qualifier Q>
inline constexpr bool is_flat<glm::mat<C, R, T, Q>> = is_number<T>;

/// Calls `use` with all members of an aggregate, in their order. An aggregate with a base class needs a line of its own.
template <class T, class Use>
void with_members(T& value, Use use) {
    using A = std::remove_const_t<T>;
    static_assert(std::is_aggregate_v<A>, "A VALUE OF THIS TYPE CANNOT TRAVEL: take numbers, GLM, aggregates and what holds them");
    if constexpr (std::is_empty_v<A>) use();
    else if constexpr (std::is_same_v<A, lantern::timed_ray>) use(value.origin, value.direction, value.time);
    else if constexpr (requires { A{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; })
        static_assert(sizeof(A) == 0, "an aggregate of more than 12 members: split it, or write some more lines here");
    else if constexpr (requires { A{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
        auto& [a, b, c, d, e, f, g, h, i, j, k, l] = value;
        use(a, b, c, d, e, f, g, h, i, j, k, l);
    } else if constexpr (requires { A{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
        auto& [a, b, c, d, e, f, g, h, i, j, k] = value;
        use(a, b, c, d, e, f, g, h, i, j, k);
    } else if constexpr (requires { A{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
        auto& [a, b, c, d, e, f, g, h, i, j] = value;
        use(a, b, c, d, e, f, g, h, i, j);
    } else if constexpr (requires { A{{}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
        auto& [a, b, c, d, e, f, g, h, i] = value;
        use(a, b, c, d, e, f, g, h, i);
    } else if constexpr (requires { A{{}, {}, {}, {}, {}, {}, {}, {}}; }) {
        auto& [a, b, c, d, e, f, g, h] = value;
        use(a, b, c, d, e, f, g, h);
    } else if constexpr (requires { A{{}, {}, {}, {}, {}, {}, {}}; }) {
        auto& [a, b, c, d, e, f, g] = value;
        use(a, b, c, d, e, f, g);
    } else if constexpr (requires { A{{}, {}, {}, {}, {}, {}}; }) {
        auto& [a, b, c, d, e, f] = value;
        use(a, b, c, d, e, f);
    } else if constexpr (requires { A{{}, {}, {}, {}, {}}; }) {
        auto& [a, b, c, d, e] = value;
        use(a, b, c, d, e);
    } else if constexpr (requires { A{{}, {}, {}, {}}; }) {
        auto& [a, b, c, d] = value;
        use(a, b, c, d);
    } else if constexpr (requires { A{{}, {}, {}}; }) {
        auto& [a, b, c] = value;
        use(a, b, c);
    } else if constexpr (requires { A{{}, {}}; }) {
        auto& [a, b] = value;
        use(a, b);
    } else {
        auto& [a] = value;
        use(a);
    }
}

// ---- Writing -------------------------------------------------------------------------------------------------------

template <class T>
void write(encoder& out, const T& value);

template <class Range>
void write_sequence(encoder& out, const Range& range) {
    using element = std::remove_cvref_t<decltype(*std::begin(range))>;
    out.length(std::size(range));
    if constexpr (is_flat<element>) out.raw(std::data(range), std::size(range) * sizeof(element));
    else
        for (const element& each : range) write(out, each);
}

template <class T>
void write(encoder& out, const T& value) {
    static_assert(!std::is_pointer_v<T> && !std::is_reference_v<T> && !is_a<T, std::function>,
                  "A VALUE OF THIS TYPE CANNOT TRAVEL: no pointers; functions as arguments only");
    if constexpr (is_flat<T>) out.raw(&value, sizeof value);
    else if constexpr (std::is_same_v<T, bool>) write(out, std::uint8_t(value));
    else if constexpr (std::is_enum_v<T>) {
        static_assert(requires { T{std::underlying_type_t<T>{}}; }, "AN ENUM THAT TRAVELS NAMES ITS UNDERLYING TYPE");
        write(out, std::underlying_type_t<T>(value));
    }
    else if constexpr (std::is_same_v<T, std::vector<bool>>) {
        out.length(value.size());
        for (const bool each : value) write(out, each);
    } else if constexpr (is_a<T, std::vector> || is_a<T, std::basic_string> || is_a<T, std::basic_string_view> || is_span<T>)
        write_sequence(out, value);
    else if constexpr (is_std_array<T>)
        for (const auto& each : value) write(out, each);
    else if constexpr (is_glm<T>)  // of bools
        for (glm::length_t i = 0; i < T::length(); ++i) write(out, value[i]);
    else if constexpr (is_a<T, std::optional>) {
        write(out, value.has_value());
        if (value) write(out, *value);
    } else if constexpr (is_a<T, std::pair> || is_a<T, std::tuple>)
        std::apply([&](const auto&... each) { (write(out, each), ...); }, value);
    else if constexpr (is_a<T, std::variant>) {
        write(out, std::uint8_t(value.index()));
        std::visit([&](const auto& each) { write(out, each); }, value);
    } else if constexpr (!std::is_same_v<T, std::monostate>)
        with_members(value, [&](const auto&... each) { (write(out, each), ...); });
}

// ---- Reading -------------------------------------------------------------------------------------------------------

/// The fewest bytes that a value takes in a message.
template <class T>
constexpr std::size_t fewest_bytes() {
    if constexpr (is_flat<T>) return sizeof(T);
    else return std::is_empty_v<T> ? 0 : 1;
}

template <class T>
void read(decoder& in, T& value) {
    if constexpr (is_flat<T>) in.raw(&value, sizeof value);
    else if constexpr (std::is_same_v<T, bool>) {
        const auto byte = in.number<std::uint8_t>();
        if (byte > 1) throw violation{"a bool that is neither true nor false"};
        value = byte == 1;
    } else if constexpr (std::is_enum_v<T>) value = T(in.number<std::underlying_type_t<T>>());
    else if constexpr (std::is_same_v<T, std::vector<bool>>) {
        value.resize(in.length(1, 1));
        for (std::size_t i = 0; i < value.size(); ++i) {
            bool each = false;
            read(in, each);
            value[i] = each;
        }
    } else if constexpr (is_a<T, std::vector> || is_a<T, std::basic_string>) {
        using element = typename T::value_type;
        const decoder::level deeper(in);
        value.resize(in.length(fewest_bytes<element>(), sizeof(element)));
        if constexpr (is_flat<element>) in.raw(value.data(), value.size() * sizeof(element));
        else
            for (element& each : value) read(in, each);
    } else if constexpr (is_std_array<T>)
        for (auto& each : value) read(in, each);
    else if constexpr (is_glm<T>)
        for (glm::length_t i = 0; i < T::length(); ++i) read(in, value[i]);
    else if constexpr (is_a<T, std::optional>) {
        bool there = false;
        read(in, there);
        value.reset();
        if (there) read(in, value.emplace());
    } else if constexpr (is_a<T, std::pair> || is_a<T, std::tuple>)
        std::apply([&](auto&... each) { (read(in, each), ...); }, value);
    else if constexpr (is_a<T, std::variant>) {
        const std::size_t index = in.number<std::uint8_t>();
        if (index >= std::variant_size_v<T>) throw violation{"a variant of none of its types"};
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            ((I == index ? read(in, value.template emplace<I>()) : void()), ...);
        }(std::make_index_sequence<std::variant_size_v<T>>());
    } else if constexpr (!std::is_same_v<T, std::monostate>)
        with_members(value, [&](auto&... each) { (read(in, each), ...); });
}

template <class T>
[[nodiscard]] T read(decoder& in) {
    if constexpr (is_number<T>) return in.number<T>();
    else {
        T value{};
        read(in, value);
        return value;
    }
}

// ---- Parameters ----------------------------------------------------------------------------------------------------

/// What a parameter is kept as while the function runs: views need something to look at.
template <class T>
struct kept {
    using type = T;
};
template <class T>
struct kept<std::span<T>> {
    using type = std::vector<std::remove_const_t<T>>;
    static_assert(std::is_const_v<T>, "A SPAN THAT IS WRITTEN TO CANNOT TRAVEL: return the values instead");
};
template <>
struct kept<std::string_view> {
    using type = std::string;
};
template <class T>
using kept_as = typename kept<std::remove_cvref_t<T>>::type;

// ---- Messages ------------------------------------------------------------------------------------------------------

enum class kind : std::uint32_t { question = 1, answer, exception, callback, reply, stopped };

struct header {
    std::uint32_t size;  // of what follows
    kind what;
    std::uint64_t serial;
};

/// A student's exception, by its type.
enum class thrown : std::uint8_t {
    other, unfinished, exception, bad_alloc, bad_optional_access, bad_variant_access, bad_function_call,
    logic_error, invalid_argument, domain_error, length_error, out_of_range,
    runtime_error, range_error, overflow_error, underflow_error
};

}  // namespace contract::wire
