# What nearly every source includes is compiled once for each set of flags: the standard library and Eigen, for windows Qt as well.
set(RUBBLE_COMMON_HEADERS <Eigen/Dense> <algorithm> <array> <atomic> <cmath> <cstdint> <exception> <filesystem> <fstream> <functional> <limits>
    <map> <memory> <mutex> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <thread> <utility> <variant> <vector>)

# rubble_precompile(TARGET headers...): the common headers and these. rubble_precompile(TARGET LIKE OWNER): what OWNER has, whose flags are the same.
function(rubble_precompile target)
    if("${ARGV1}" STREQUAL LIKE)
        target_precompile_headers(${target} REUSE_FROM ${ARGV2})
    else()
        target_precompile_headers(${target} PRIVATE ${RUBBLE_COMMON_HEADERS} ${ARGN})
    endif()
endfunction()
