#include "tests/core/fragments/element_scene.h"

namespace rubble::test {

namespace {

std::vector<Vec3> regularElement(ElementShape shape) {
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0), up(0, 0, 1);
    switch (shape) {
        case ElementShape::Hexahedron:
            return {a, b, c, d, a + up, b + up, c + up, d + up};
        case ElementShape::Wedge:
            return {a, b, d, a + up, b + up, d + up};
        case ElementShape::Pyramid:
            return {a, b, c, d, Vec3(0.5, 0.5, 1)};
        case ElementShape::Tetrahedron:
            return {a, b, d, up};
        case ElementShape::Quadrilateral:
            return {a, b, c, d};
        case ElementShape::Triangle:
            return {a, b, d};
        case ElementShape::Beam:
            return {a, b};
    }
    return {};
}

}  // namespace

std::vector<Vec3> randomElement(ElementShape shape, std::mt19937& random, double size, double distortion) {
    std::uniform_real_distribution<double> stretch(0.5, 1.5);
    const Vec3 scale = size * Vec3(stretch(random), stretch(random), stretch(random));
    const Mat3 turn = randomRotation(random);
    const Vec3 place = randomVector(random, 30.0);
    std::vector<Vec3> corners = regularElement(shape);
    for (Vec3& corner : corners) {
        corner = place + turn * scale.cwiseProduct(corner + randomVector(random, distortion * 0.5));
    }
    return corners;
}

Vec3 randomVector(std::mt19937& random, double length) {
    std::uniform_real_distribution<double> coordinate(-length, length);
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    return {x, y, z};
}

Mat3 randomRotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
    return Quat(w, x, y, z).normalized().toRotationMatrix();
}

FragmentSet fragmentsOf(const ElementScene& scene, const FragmentSettings& settings) {
    const auto fe = scene.result();
    return makeFragments(*fe, ElementScene::components(*fe), settings, Execution());
}

}  // namespace rubble::test
