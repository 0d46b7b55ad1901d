# What `cmake --install` puts in place: the program with its files and pages, and the library as the CMake package `Erg`.
include(CMakePackageConfigHelpers)

install(TARGETS erg RUNTIME DESTINATION bin)
# One folder with the layout of the source tree, so that what the pages link to is there.
set(share share/erg)
install(DIRECTORY cfg shaders docs examples DESTINATION ${share})
install(FILES README.md CHANGELOG.md CONTRIBUTING.md LICENSE DESTINATION ${share})
install(FILES scripts/packages.txt DESTINATION ${share}/scripts)

# The layers without pictures in OpenGL and without the window: a program that computes needs neither.
set(library_layers core process picture forcing compute kernels cuda models sim analysis
                   io/files io/config io/formats io/checkpoint)
set(library_targets erg_options erg_io)
foreach(layer IN LISTS library_layers)
  string(REPLACE "/" "_" name ${layer})
  set_target_properties(erg_${name} PROPERTIES EXPORT_NAME ${name})
  list(APPEND library_targets erg_${name})
  install(DIRECTORY src/${layer}/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/erg/${layer}" FILES_MATCHING PATTERN "*.h"
          PATTERN "*.def" PATTERN "*.k" PATTERN stub EXCLUDE)
endforeach()
set_target_properties(erg_options PROPERTIES EXPORT_NAME options)
set_target_properties(erg_io PROPERTIES EXPORT_NAME io)
if(ERG_HAS_CUDA)
  set_target_properties(erg_cuda_api PROPERTIES EXPORT_NAME cuda_api)
  set_target_properties(erg_cuda_entries PROPERTIES EXPORT_NAME cuda_entries)
  list(APPEND library_targets erg_cuda_api erg_cuda_entries)
endif()
install(TARGETS ${library_targets} EXPORT ErgTargets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/Erg")
install(EXPORT ErgTargets NAMESPACE Erg:: DESTINATION "${package}")
configure_package_config_file(cmake/ErgConfig.cmake.in ErgConfig.cmake INSTALL_DESTINATION "${package}")
# Before 1.0 a new minor version may change anything.
write_basic_package_version_file(ErgConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/ErgConfig.cmake" "${PROJECT_BINARY_DIR}/ErgConfigVersion.cmake"
        DESTINATION "${package}")
