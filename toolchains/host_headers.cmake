# Libraries that are headers alone serve every target, but their packages name /usr/include,
# which holds the host's C library too, or a library of the host. Here they are links to
# those headers, in a folder of their own.
set(host_headers ${CMAKE_BINARY_DIR}/host-headers)
file(MAKE_DIRECTORY ${host_headers})
function(take_headers package target header)
  if(EXISTS /usr/include/${header})
    file(CREATE_LINK /usr/include/${header} ${host_headers}/${header} SYMBOLIC)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/host-packages/${package}Config.cmake CONTENT
         "add_library(@target@ INTERFACE IMPORTED)
set_target_properties(@target@ PROPERTIES INTERFACE_INCLUDE_DIRECTORIES @host_headers@)
" @ONLY)
    set(${package}_DIR ${CMAKE_BINARY_DIR}/host-packages CACHE PATH "" FORCE)
  endif()
endfunction()
take_headers(CLI11 CLI11::CLI11 CLI)
take_headers(nlohmann_json nlohmann_json::nlohmann_json nlohmann)
take_headers(tomlplusplus tomlplusplus::tomlplusplus toml++)
take_headers(httplib httplib::httplib httplib.h)
