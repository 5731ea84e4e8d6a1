// SPDX-License-Identifier: MIT
// How Catch2 shows a step that is still to be written, and small numbers.

#include <catch.hpp>

#include <lantern/todo.hpp>

CATCH_TRANSLATE_EXCEPTION(const lantern::unfinished& gap) { return "still to do: " + gap.what(); }

namespace {

[[maybe_unused]] const int digits = Catch::StringMaker<float>::precision = Catch::StringMaker<double>::precision = 7;

}  // namespace
