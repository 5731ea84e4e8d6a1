// SPDX-License-Identifier: MIT
// Does a conversion to float and back round? Exit code 0 when it does. Compiled by numerics.cmake at -O2.
// GCC 12's SLP vectoriser turns the two pairs of conversions of x and y into nothing.

struct float3 {
    float x, y, z;
};
struct double3 {
    double x, y, z;
};

__attribute__((noinline)) double3 rounded(double3 v) {
    const float3 f{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    return {f.x, f.y, f.z};
}

int main() {
    volatile double tenth = 0.1;  // is not a float
    const double3 r = rounded({tenth, tenth, tenth});
    return r.x == tenth || r.y == tenth || r.z == tenth;
}
