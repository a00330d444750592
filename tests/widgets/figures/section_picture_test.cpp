#include "widgets/figures/report/section_picture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "widgets/figures/figure_file.h"

namespace rubble::figures {
namespace {

/// A section with sets of so many points, evenly along 100 m.
SiteSection sectionOf(const std::vector<std::int64_t>& counts) {
    SiteSection section;
    section.steps.resize(2);
    section.steps[0].ground = section.steps[1].ground = 0.0;
    section.steps[1].along = 100.0;
    for (std::size_t source = 0; source < counts.size(); ++source) {
        section.sources.push_back({"set", {counts[source], 0}});
        for (std::int64_t k = 0; k < counts[source]; ++k) {
            const double along = 100.0 * static_cast<double>(k) / static_cast<double>(counts[source]);
            section.points.push_back({Vec3(along, 0.0, 5.0 + 5.0 * static_cast<double>(source)), along, 0.0});
            section.points.back().source = source;
        }
    }
    return section;
}

/// Pixels above the frame of the chart that are not of the paper: the key.
int inked(const QImage& picture) {
    int ink = 0;
    for (int y = 0; y < picture.height() / 10; ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            ink += qGray(picture.pixel(x, y)) < 200 ? 1 : 0;
        }
    }
    return ink;
}

TEST(SectionPicture, DrawsAllPointsOfASparseSetAndSaysOfADenseOneHowMany) {
    const SiteSection section = sectionOf({20'000, 12});
    EXPECT_EQ(drawnPoints(section, 0), 1'429U) << "each fourteenth";
    EXPECT_EQ(drawnPoints(section, 1), 12U);
    EXPECT_EQ(drawnPoints(sectionOf({1'000, 12}), 0), 1'000U);

    ensureGuiApplication();
    const SiteSection sparse = sectionOf({12, 12});
    EXPECT_GT(inked(sectionPicture(section, {})), inked(sectionPicture(sparse, {})) + 200) << "the key has more to say";
}

}  // namespace
}  // namespace rubble::figures
