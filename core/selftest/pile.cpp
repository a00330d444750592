#include "core/selftest/pile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble::selftest {

BodyId Pile::add(const Vec3& centre, const Vec3& size, const Quat& turn, const Vec3& velocity) {
    m_sizes.push_back(size);
    return m_scene.box(centre, size, velocity, turn);
}

void Pile::addCloud(Sequence& random, const Vec3& corner, const std::array<int, 3>& counts, const Vec3& size, double spacing) {
    for (int k = 0; k < counts[2]; ++k) {
        for (int j = 0; j < counts[1]; ++j) {
            for (int i = 0; i < counts[0]; ++i) {
                add(corner + spacing * Vec3(i + 0.5, j + 0.5, k + 0.5), size, random.turn());
            }
        }
    }
}

double Pile::meanHeight() const {
    double mass = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < m_sizes.size(); ++i) {
        const BodyId id = idAt<BodyId>(i);
        if (m_scene.world().state(id) != BodyState::Removed) {
            mass += m_scene.world().mass(id);
            moment += m_scene.world().mass(id) * m_scene.place(id).z();
        }
    }
    return mass > 0.0 ? moment / mass : 0.0;
}

double Pile::spread() const {
    double mass = 0.0, square = 0.0;
    Vec3 moment = Vec3::Zero();
    for (std::size_t i = 0; i < m_sizes.size(); ++i) {
        const double m = m_scene.world().mass(idAt<BodyId>(i));
        const Vec3 p = m_scene.place(idAt<BodyId>(i));
        mass += m;
        moment += m * p;
        square += m * p.head<2>().squaredNorm();
    }
    return std::sqrt(std::max(0.0, square / mass - (moment / mass).head<2>().squaredNorm()));
}

double Pile::volume() const {
    double volume = 0.0;
    for (const Vec3& size : m_sizes) {
        volume += size.prod();
    }
    return volume;
}

std::int64_t Pile::centresBelow(double height) const {
    std::int64_t count = 0;
    for (std::size_t i = 0; i < m_sizes.size(); ++i) {
        count += !(m_scene.place(idAt<BodyId>(i)).z() >= height);
    }
    return count;
}

std::vector<Vec3> Pile::places() const {
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < m_sizes.size(); ++i) {
        places.push_back(m_scene.place(idAt<BodyId>(i)));
    }
    return places;
}

double Pile::largestMove(const std::vector<Vec3>& from) const {
    double most = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const double move = (m_scene.place(idAt<BodyId>(i)) - from[i]).norm();
        if (!(move <= most)) {
            most = move;
        }
    }
    return most;
}

}  // namespace rubble::selftest
