# What nearly every source includes is compiled once for each set of flags: the standard library and Eigen, for windows Qt as well.
#
# rubble_headers(NAME libraries... HEADERS headers...): a set of precompiled headers, with the flags of the libraries. It has no definitions of
# its own: a target that uses it must have all that it was compiled with, and may have more.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cpp CONTENT "namespace rubble {}\n")
function(rubble_headers name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS")
    add_library(${name} OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/precompiled.cpp)
    target_link_libraries(${name} PRIVATE rubble_options Eigen3::Eigen ${arg_UNPARSED_ARGUMENTS})
    set_target_properties(${name} PROPERTIES AUTOMOC OFF)
    target_precompile_headers(${name} PRIVATE <Eigen/Dense> <algorithm> <array> <atomic> <cmath> <cstdint> <exception> <filesystem> <fstream>
        <functional> <limits> <map> <memory> <mutex> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <thread> <utility>
        <variant> <vector> ${arg_HEADERS})
endfunction()

# rubble_use_headers(NAME targets...): they are compiled with this set.
function(rubble_use_headers name)
    foreach(target ${ARGN})
        target_precompile_headers(${target} REUSE_FROM ${name})
    endforeach()
endfunction()
