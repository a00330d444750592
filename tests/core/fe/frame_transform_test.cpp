#include "core/fe/frame_transform.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace rubble {
namespace {

TEST(FrameTransform, UpBecomesZWithoutChangingTheHand) {
    for (const std::string axis : {"x", "y", "z", "-x", "-y", "-z"}) {
        Frame frame;
        frame.upAxis = axis;
        const FrameTransform transform(frame);
        const double sign = axis.front() == '-' ? -1.0 : 1.0;
        EXPECT_EQ(transform.vector(sign * Vec3::Unit(axis.back() - 'x')), Vec3::UnitZ()) << axis;
        const Vec3 a = transform.vector(Vec3::UnitX()), b = transform.vector(Vec3::UnitY()), c = transform.vector(Vec3::UnitZ());
        EXPECT_EQ(a.cross(b), c);
    }
}

TEST(FrameTransform, BackAndForthIsWhereItWas) {
    Frame frame;
    frame.upAxis = "y";
    frame.metresPerUnit = 0.3048;
    frame.origin = {500'000, -3, 4'649'776};
    const FrameTransform transform(frame);
    const Vec3 inFile(1.6e6, 12.5, 1.5e7);
    // Coordinates of 1e7 keep nine digits behind the point in double precision.
    EXPECT_LT((transform.pointInFile(transform.point(inFile)) - inFile).norm(), 1e-8);
    EXPECT_TRUE(transform.point(Vec3(500'000, -3, 4'649'776) / 0.3048).isZero(1e-9));
}

TEST(FrameTransform, NonsenseIsRefused) {
    for (const double unit : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        Frame frame;
        frame.metresPerUnit = unit;
        EXPECT_THROW(FrameTransform{frame}, UsageError);
    }
    Frame frame;
    frame.upAxis = "up";
    EXPECT_THROW(FrameTransform{frame}, UsageError);
}

}  // namespace
}  // namespace rubble
