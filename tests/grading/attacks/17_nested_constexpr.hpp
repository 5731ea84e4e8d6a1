// SPDX-License-Identifier: MIT
#pragma once
// Each evaluation stays within the compiler's own limit; together they never end.
#include "only_wrong.hpp"

constexpr unsigned long some(unsigned long start) {
    unsigned long n = start;
    for (unsigned long i = 0; i < 200000; ++i) n = n * 31 + i;
    return n;
}
template <unsigned N>
struct each : each<N - 1> {
    static constexpr unsigned long value = some(N);
    static_assert(value != 1);
};
template <>
struct each<0> {};
inline each<800> all;
