// SPDX-License-Identifier: MIT
// The body under a coat must answer lights; a mirror does not.
// must say: reflects_light

#include <lantern/coated.hpp>
#include <lantern/diffuse.hpp>
#include <lantern/mirror.hpp>

#ifdef FIXED
using body = lantern::diffuse;
#else
using body = lantern::mirror;
#endif

const lantern::coated<body, lantern::mirror> varnished{};
