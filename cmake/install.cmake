# SPDX-License-Identifier: MIT
# find_package(lantern) gives lantern::lantern, lantern::png where stb is found, and lantern::obj where tinyobjloader is.

include(CMakePackageConfigHelpers)
set(destination "${CMAKE_INSTALL_DATADIR}/cmake/lantern")

install(TARGETS lantern lantern_png EXPORT lantern FILE_SET HEADERS)
if(TARGET lantern_obj)
  install(TARGETS lantern_obj EXPORT lantern_obj FILE_SET HEADERS)
  install(EXPORT lantern_obj FILE obj-targets.cmake NAMESPACE lantern:: DESTINATION "${destination}")
endif()
install(EXPORT lantern FILE targets.cmake NAMESPACE lantern:: DESTINATION "${destination}")
configure_package_config_file(cmake/lantern-config.cmake.in lantern-config.cmake INSTALL_DESTINATION "${destination}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(lantern-config-version.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES
  "${CMAKE_CURRENT_BINARY_DIR}/lantern-config.cmake"
  "${CMAKE_CURRENT_BINARY_DIR}/lantern-config-version.cmake"
  "${CMAKE_CURRENT_SOURCE_DIR}/cmake/numerics.cmake"
  "${CMAKE_CURRENT_SOURCE_DIR}/cmake/rounding_canary.cpp"
  DESTINATION "${destination}")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")
