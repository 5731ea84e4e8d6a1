# SPDX-License-Identifier: MIT
# What Lantern stands on: the system's packages first, else sources pinned to one commit.

include(FetchContent)
find_package(Threads REQUIRED)

find_package(glm QUIET)
if(NOT TARGET glm::glm)
  message(STATUS "GLM is not installed; fetching it")
  FetchContent_Declare(glm SYSTEM
    GIT_REPOSITORY https://github.com/g-truc/glm.git
    GIT_TAG 0af55ccecd98d4e5a8d1fad7de25ba429d60e863)  # 1.0.1
  FetchContent_MakeAvailable(glm)
endif()

find_path(LANTERN_STB_INCLUDE_DIR stb_image_write.h PATH_SUFFIXES stb DOC "Where stb_image_write.h is")
if(NOT LANTERN_STB_INCLUDE_DIR)
  message(STATUS "stb is not installed; fetching it")
  FetchContent_Declare(stb
    GIT_REPOSITORY https://github.com/nothings/stb.git
    GIT_TAG 5736b15f7ea0ffb08dd38af21067c314d6a3aae9)  # 2023-01-30
  FetchContent_MakeAvailable(stb)
  set(LANTERN_STB_INCLUDE_DIR "${stb_SOURCE_DIR}")
endif()

# Optional: without it there is no lantern::obj.
find_package(tinyobjloader QUIET)

# Makes the target lantern_catch: Catch2 3 where the system has it, else 2.13, else a pinned Catch2 3.
macro(lantern_find_catch)
  find_package(Catch2 3 QUIET)
  if(NOT Catch2_FOUND)
    find_package(Catch2 2.13 QUIET)
  endif()
  if(NOT Catch2_FOUND)
    message(STATUS "Catch2 is not installed; fetching it")
    FetchContent_Declare(Catch2 SYSTEM
      GIT_REPOSITORY https://github.com/catchorg/Catch2.git
      GIT_TAG 05e10dfccc28c7f973727c54f850237d07d5e10f)  # 3.5.2
    FetchContent_MakeAvailable(Catch2)
  endif()
endmacro()
