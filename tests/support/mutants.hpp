// SPDX-License-Identifier: MIT
#pragma once
// Many mutants of a lab in one program, which answers as the one that the environment's LANTERN_MUTANT names.

#include "contract.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace mutants {

inline std::string_view chosen() {
    const char* const name = std::getenv("LANTERN_MUTANT");
    return name ? name : "";
}

/// `contract::bind` as a mutant's binding finds it: only that of the chosen one binds.
template <auto Function, class Code>
contract::binding bind(std::string_view name, Code code) {
    if (name == chosen()) return contract::bind<Function>(std::move(code));
    return {};
}

/// Ends a program that none of its mutants is chosen of: unbound functions fail every test, and that must not look like a mutant that is caught.
struct only {
    only(std::initializer_list<std::string_view> names) {
        if (std::find(names.begin(), names.end(), chosen()) != names.end()) return;
        std::fprintf(stderr, "LANTERN_MUTANT is \"%s\", which is none of this lab's mutants\n", std::string(chosen()).c_str());
        std::_Exit(2);
    }
};

}  // namespace mutants
