# LibLZF for Flatpak: its own makefile installs a static library that CMake does not find.
cmake_minimum_required(VERSION 3.25)
project(liblzf VERSION 3.6 LANGUAGES C)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
add_library(liblzf SHARED lzf_c.c lzf_d.c)
set_target_properties(liblzf PROPERTIES OUTPUT_NAME lzf SOVERSION 1)
install(TARGETS liblzf EXPORT liblzf LIBRARY)
install(FILES lzf.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/liblzf)
install(EXPORT liblzf FILE liblzf-config.cmake NAMESPACE liblzf::
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/liblzf)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/liblzf-config-version.cmake
  COMPATIBILITY AnyNewerVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/liblzf-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/liblzf)
