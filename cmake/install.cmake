# The firmware kit: headers, archives, and the package that find_package(Stickband) finds.
# A bare board's build has both sets of sizes, a host's the usual one.
include(CMakePackageConfigHelpers)
set(kit stickband_ident stickband_wire stickband_c)
if(CMAKE_SYSTEM_NAME STREQUAL "Generic")
  set(small stickband_ident_small stickband_c_small stickband_ident_least stickband_c_least)
  list(APPEND kit ${small})
  set_target_properties(${small} PROPERTIES EXCLUDE_FROM_ALL FALSE)
endif()
foreach(target ${kit})
  string(REPLACE "stickband_" "" name ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
endforeach()
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Stickband)
install(TARGETS ${kit} EXPORT Stickband COMPONENT kit
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT Stickband NAMESPACE Stickband:: DESTINATION ${package} COMPONENT kit
        FILE StickbandTargets.cmake)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/lib/ident ${PROJECT_SOURCE_DIR}/lib/wire
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/stickband COMPONENT kit
        FILES_MATCHING PATTERN *.hpp)
install(FILES ${PROJECT_SOURCE_DIR}/lib/c/stickband.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT kit)
configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/StickbandConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/StickbandConfig.cmake INSTALL_DESTINATION ${package})
# Before 1.0.0 a minor version may change the interface.
write_basic_package_version_file(
  ${CMAKE_CURRENT_BINARY_DIR}/StickbandConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/StickbandConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/StickbandConfigVersion.cmake
        DESTINATION ${package} COMPONENT kit)
