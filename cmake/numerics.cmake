# SPDX-License-Identifier: MIT
# Compiler options without which the numbers come out wrong. Also installed: a program that uses the library checks its
# own compiler.

set(LANTERN_ROUNDING_CANARY "${CMAKE_CURRENT_LIST_DIR}/rounding_canary.cpp")

# GCC 12 at -O2 forgets the rounding in double(float(x)) when it vectorises straight-line code; the library's exactness
# rests on that rounding. Where the compiler shows the fault, or cannot be tried, that one optimisation is turned off.
function(lantern_find_lost_rounding result)
  set(${result} FALSE PARENT_SCOPE)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    return()
  endif()
  if(CMAKE_CROSSCOMPILING)
    set(${result} TRUE PARENT_SCOPE)
    return()
  endif()
  if(NOT DEFINED LANTERN_ROUNDING_LOST)
    try_run(status compiled "${CMAKE_CURRENT_BINARY_DIR}/rounding_canary" "${LANTERN_ROUNDING_CANARY}"
      COMPILE_DEFINITIONS -O2)
    if(compiled AND status STREQUAL "0")
      set(lost FALSE)
    else()
      set(lost TRUE)
    endif()
    unset(status CACHE)
    unset(compiled CACHE)
    set(LANTERN_ROUNDING_LOST ${lost} CACHE INTERNAL "Whether this compiler forgets to round at -O2")
    message(STATUS "The compiler loses a rounding at -O2: ${lost}")
  endif()
  set(${result} ${LANTERN_ROUNDING_LOST} PARENT_SCOPE)
endfunction()

# lantern_keep_rounding(target [BUILD_INTERFACE]): for a library of headers, whoever uses it; else the target itself.
function(lantern_keep_rounding target)
  set(options)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND NOT LANTERN_ALLOW_FP_CONTRACT)
    # Whether a*b+c is fused depends on the processor that is compiled for. Unfused, a pixel has the same bits everywhere.
    list(APPEND options -ffp-contract=off)
  endif()
  lantern_find_lost_rounding(lost)
  if(lost)
    list(APPEND options -fno-tree-slp-vectorize)
  endif()
  set(options "$<$<COMPILE_LANGUAGE:CXX>:${options}>")
  get_target_property(type ${target} TYPE)
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    target_compile_options(${target} PRIVATE ${options})
  elseif(ARGN STREQUAL "BUILD_INTERFACE")
    target_compile_options(${target} INTERFACE "$<BUILD_INTERFACE:${options}>")
  else()
    target_compile_options(${target} INTERFACE ${options})
  endif()
endfunction()
