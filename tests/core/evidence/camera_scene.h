#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/evidence/photographs/camera_match.h"
#include "tests/core/analysis/random_numbers.h"

namespace rubble {

/// A camera that looks at a collapsed bridge, and points on it.
class CameraScene {
public:
    CameraModel camera;
    CameraKnowledge known;
    std::vector<PointPair> pairs;

    /// @param spread  px, of each coordinate of a click
    CameraScene(std::uint64_t seed, std::size_t points, double spread) : m_random(seed) {
        known.width = 4000;
        known.height = 3000;
        camera.principal = {2000.0, 1500.0};
        camera.focal = m_random.between(2800.0, 5000.0);
        const double bearing = m_random.between(-0.8, 0.8);
        camera.place = Vec3(-60.0 * std::sin(bearing), -60.0 * std::cos(bearing), m_random.between(2.0, 25.0));
        look(Vec3(m_random.between(-3.0, 3.0), 0.0, m_random.between(3.0, 7.0)), m_random.between(-0.05, 0.05));
        known.focal = camera.focal;
        while (pairs.size() < points) {
            const Vec3 point(m_random.between(-18.0, 18.0), m_random.between(-6.0, 6.0), m_random.between(0.0, 14.0));
            const auto place = camera.project(point);
            if (place && place->x() > 0.0 && place->x() < 4000.0 && place->y() > 0.0 && place->y() < 3000.0) {
                pairs.push_back({"P" + std::to_string(pairs.size() + 1), *place + noise(spread), point});
            }
        }
    }
    Eigen::Vector2d noise(double spread) { return {spread * m_random.normal(), spread * m_random.normal()}; }
    /// Takes the pictures of all points anew, by the camera as it is now.
    void retake(double spread) {
        for (PointPair& pair : pairs) {
            pair.picture = *camera.project(pair.model) + noise(spread);
        }
    }
    void look(const Vec3& at, double roll) {
        const Vec3 ahead = (at - camera.place).normalized();
        const Vec3 right = ahead.cross(Vec3::UnitZ()).normalized();
        Mat3 axes;
        axes.row(0) = right;
        axes.row(1) = ahead.cross(right);
        axes.row(2) = ahead;
        camera.toCamera = Quat(Eigen::AngleAxisd(roll, Vec3::UnitZ())) * Quat(axes);
    }
    CameraMatch match() const { return matchCamera(pairs, known, Execution()); }
    RandomNumbers& random() { return m_random; }

private:
    RandomNumbers m_random;
};

}  // namespace rubble
