#include "widgets/render/shapes/intact_outline.h"

#include <gtest/gtest.h>

#include "tests/scenes/fe_scenes.h"

namespace rubble::render {
namespace {

double lengthOf(const std::vector<Eigen::Vector3f>& ends) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        sum += static_cast<double>((ends[i + 1] - ends[i]).norm());
    }
    return sum;
}

TEST(IntactOutline, OfABoxIsItsTwelveEdgesHoweverFineItsMesh) {
    for (const int cells : {1, 3}) {
        scenes::Block box;
        box.size = Vec3(4, 2, 3);
        box.cells = {4 * cells, 2 * cells, 3 * cells};
        const auto fe = scenes::makeScene({box}, 3, 0.1);
        EXPECT_NEAR(lengthOf(intactOutline(*fe, {})), 4.0 * (4 + 2 + 3), 1e-4);
    }
}

TEST(IntactOutline, LeavesOutWhatIsHiddenAndKeepsWhatDies) {
    scenes::Block dies;
    dies.deathState = [](std::size_t) { return std::size_t{1}; };
    scenes::Block stays;
    stays.name = "stays";
    stays.low = Vec3(10, 0, 0);
    const auto fe = scenes::makeScene({dies, stays}, 3, 0.1);
    EXPECT_NEAR(lengthOf(intactOutline(*fe, {})), 24.0, 1e-4);
    EXPECT_NEAR(lengthOf(intactOutline(*fe, {0, 1})), 12.0, 1e-4);
}

}  // namespace
}  // namespace rubble::render
