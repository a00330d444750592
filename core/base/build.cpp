#include "core/base/build.h"

#include <Eigen/Core>

#define RUBBLE_TEXT_(x) #x
#define RUBBLE_TEXT(x) RUBBLE_TEXT_(x)

namespace rubble {

std::string_view versionText() {
    return RUBBLE_VERSION;
}

std::string_view buildText() {
    // EIGEN_MAX_ALIGN_BYTES tells which vector width the code was compiled for; it decides the order of sums.
    return "Rubble " RUBBLE_VERSION ", g++ " __VERSION__ ", " RUBBLE_BUILD_TYPE
           ", Eigen " RUBBLE_TEXT(EIGEN_WORLD_VERSION) "." RUBBLE_TEXT(EIGEN_MAJOR_VERSION) "." RUBBLE_TEXT(
               EIGEN_MINOR_VERSION) ", vectors of " RUBBLE_TEXT(EIGEN_MAX_ALIGN_BYTES) " bytes";
}

}  // namespace rubble
