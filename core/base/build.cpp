#include "core/base/build.h"

#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

#include <Eigen/Core>
#include <string>

#ifdef RUBBLE_SOURCE_DIGEST_FILE
#include RUBBLE_SOURCE_DIGEST_FILE
#else
#define RUBBLE_SOURCE_DIGEST "unknown"
#endif

#define RUBBLE_TEXT_(x) #x
#define RUBBLE_TEXT(x) RUBBLE_TEXT_(x)

namespace rubble {

namespace {

std::string libraryText() {
#ifdef __GLIBC__
    return gnu_get_libc_version();
#else
    return "unknown";
#endif
}

bool fusedOperations() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("fma") != 0;
#elif defined(__aarch64__)
    return true;
#else
    return false;
#endif
}

}  // namespace

std::string_view versionText() {
    return RUBBLE_VERSION;
}

std::string_view buildText() {
    // Trajectories take no sines and powers of the C library, but readings of results and Bullet do: it chooses them by the
    // processor, and with fused operations they round otherwise.
    static const std::string text = "Rubble " RUBBLE_VERSION ", sources " RUBBLE_SOURCE_DIGEST ", g++ " __VERSION__
                                    ", " RUBBLE_BUILD_TYPE ", Eigen " RUBBLE_TEXT(EIGEN_WORLD_VERSION) "." RUBBLE_TEXT(
                                        EIGEN_MAJOR_VERSION) "." RUBBLE_TEXT(EIGEN_MINOR_VERSION) ", C library " +
                                    libraryText() + (fusedOperations() ? " with" : " without") + " fused operations";
    return text;
}

std::string_view shortBuild(std::string_view build) {
    const std::size_t first = build.find(',');
    return build.substr(0, first == std::string_view::npos ? first : build.find(',', first + 1));
}

}  // namespace rubble
