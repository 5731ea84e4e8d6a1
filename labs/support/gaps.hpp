// SPDX-License-Identifier: MIT
#pragma once
// What a student has not written yet, as a lab's program finds out.

#include "test_card.hpp"

#include <lantern/todo.hpp>

#include <iostream>
#include <set>
#include <string>

namespace support {

class gaps {
public:
    /// Calls something of the student's; false, and noted, when that is still to be written.
    template <class Call>
    bool is_written(Call call) {
        try {
            (void)call();
            return true;
        } catch (const lantern::unfinished& gap) {
            note(gap);
            return false;
        }
    }

    void note(const lantern::unfinished& gap) { missing_.insert(gap.what()); }

    [[nodiscard]] bool none() const { return missing_.empty(); }
    [[nodiscard]] int next_step() const { return none() ? 0 : step_number(*missing_.begin()); }

    /// The last lines that a lab's program prints.
    void tell() const {
        for (const std::string& gap : missing_) std::cout << "still to do: " << gap << '\n';
    }

private:
    std::set<std::string> missing_;  // in the order of the steps, as each begins with its number
};

}  // namespace support
