#include "core/scenario/registration.h"

namespace rubble {

namespace {

Vec3 turnOf(const Mat3& rotation) {
    const Eigen::AngleAxisd turn(rotation);
    return turn.angle() * turn.axis();
}

}  // namespace

Mat3 Registration::rotation() const {
    const double angle = turn.norm();
    return angle > 0.0 ? Mat3(Eigen::AngleAxisd(angle, turn / angle)) : Mat3(Mat3::Identity());
}

Registration movedOn(const Registration& first, const Mat3& turn, const Vec3& about, const Vec3& shift) {
    Registration both = first;
    const Vec3 moved = first(first.about);
    both.turn = turnOf(turn * first.rotation());
    both.shift = about + shift + turn * (moved - about) - first.about;
    return both;
}

Aabb boxBack(const Registration& registration, const Aabb& box) {
    Aabb around;
    for (int corner = 0; corner < 8 && !box.isEmpty(); ++corner) {
        around.extend(registration.back(box.corner(static_cast<Aabb::CornerType>(corner))));
    }
    return around;
}

}  // namespace rubble
