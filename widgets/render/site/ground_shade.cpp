#include "widgets/render/site/ground_shade.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/render/basics/sun.h"

namespace rubble::render {
namespace {

/// Model lengths around the model over which debris may spread.
constexpr double spread = 0.2;
/// Model lengths above the ground within which things darken it.
constexpr double nearHeight = 0.02;
/// Shares of the light that the sun's shadow and the nearness of things take.
constexpr float castShare = 0.62F;
constexpr float contactShare = 0.5F;
/// Things so many cells above the ground darken it at most by their nearness.
constexpr float leastCells = 2.0F;
constexpr float astray = 1e6F;  // cells
/// Shares of the light that the model takes from itself: by the sun's shadow, and by what stands about a hollow.
constexpr float selfCastShare = 0.45F;
constexpr float hollowShare = 0.3F;
/// Rays as near as so many cells are one: what is nearer to its neighbour throws no shadow on it.
constexpr float sameRay = 1.5F;
constexpr std::size_t crowdRadius = 2;  // cells
constexpr float nothing = -1e9F;        // m

struct Corner {
    float x;
    float y;
    float value;
};

/// Raises a field to the value of a triangle in each cell whose centre it covers, and in those of its corners.
class Filling {
public:
    Filling(std::vector<float>& field, std::size_t columns, std::size_t rows)
        : m_field(field), m_columns(static_cast<int>(columns)), m_rows(static_cast<int>(rows)) {}

    void operator()(const std::array<Corner, 3>& c) {
        const float lowX = std::min({c[0].x, c[1].x, c[2].x});
        const float highX = std::max({c[0].x, c[1].x, c[2].x});
        const float lowY = std::min({c[0].y, c[1].y, c[2].y});
        const float highY = std::max({c[0].y, c[1].y, c[2].y});
        if (!(highX > 0.0F && highY > 0.0F && lowX < static_cast<float>(m_columns) && lowY < static_cast<float>(m_rows))) {
            return;
        }
        for (const Corner& corner : c) {
            raise(static_cast<int>(std::floor(corner.x)), static_cast<int>(std::floor(corner.y)), corner.value);
        }
        if (highX - lowX > 1.0F || highY - lowY > 1.0F) {
            fill(c, {lowX, highX, lowY, highY});
        }
    }

private:
    void raise(int column, int row, float value) {
        if (column >= 0 && column < m_columns && row >= 0 && row < m_rows) {
            float& held =
                m_field[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) + static_cast<std::size_t>(column)];
            held = std::max(held, value);
        }
    }

    void fill(const std::array<Corner, 3>& c, const std::array<float, 4>& box) {
        const float area = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y);
        if (std::abs(area) < 1e-6F) {
            return;
        }
        const int firstRow = std::max(0, static_cast<int>(std::floor(box[2])));
        const int lastRow = std::min(m_rows - 1, static_cast<int>(std::floor(box[3])));
        const int firstColumn = std::max(0, static_cast<int>(std::floor(box[0])));
        const int lastColumn = std::min(m_columns - 1, static_cast<int>(std::floor(box[1])));
        for (int row = firstRow; row <= lastRow; ++row) {
            const float y = static_cast<float>(row) + 0.5F;
            for (int column = firstColumn; column <= lastColumn; ++column) {
                const float x = static_cast<float>(column) + 0.5F;
                const float b = ((x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (y - c[0].y)) / area;
                const float d = ((c[1].x - c[0].x) * (y - c[0].y) - (x - c[0].x) * (c[1].y - c[0].y)) / area;
                if (b >= 0.0F && d >= 0.0F && b + d <= 1.0F) {
                    raise(column, row, c[0].value + b * (c[1].value - c[0].value) + d * (c[2].value - c[0].value));
                }
            }
        }
    }

    std::vector<float>& m_field;
    int m_columns;
    int m_rows;
};

}  // namespace

void GroundShade::set(const Aabb& bounds, const SiteSurface& ground) {
    m_columns = m_rows = 0;
    m_ground.clear();
    m_pointShade.clear();
    ++m_version;
    m_clear = true;
    if (bounds.isEmpty() || !ground.present()) {
        m_shade.clear();
        return;
    }
    const double size = std::max(bounds.sizes().norm(), 1e-3);
    const double tall = bounds.sizes().z();
    Aabb around(bounds.min() - Vec3::Constant(spread * size), bounds.max() + Vec3::Constant(spread * size));
    around.extend(Vec3(around.max() - tall / sun.z() * Vec3(sun.x(), sun.y(), 0.0)));
    const double longer = std::max(around.sizes().x(), around.sizes().y());
    m_cell = longer / static_cast<double>(cellsAlong);
    m_columns = std::max<std::size_t>(4, static_cast<std::size_t>(std::ceil(around.sizes().x() / m_cell)));
    m_rows = std::max<std::size_t>(4, static_cast<std::size_t>(std::ceil(around.sizes().y() / m_cell)));
    m_cellsInMetre = static_cast<float>(1.0 / m_cell);
    m_east = static_cast<float>(-sun.x() / sun.z() / m_cell);
    m_north = static_cast<float>(-sun.y() / sun.z() / m_cell);
    m_left = around.min().x();
    m_bottom = around.min().y();
    m_near = std::max(nearHeight * size, static_cast<double>(leastCells) * m_cell);
    m_level = static_cast<float>(ground.levelHeight);
    if (ground.terrain) {
        m_ground.resize(m_columns * m_rows);
        for (std::size_t j = 0; j < m_rows; ++j) {
            for (std::size_t i = 0; i < m_columns; ++i) {
                m_ground[j * m_columns + i] = static_cast<float>(ground.height(m_left + m_cell * (static_cast<double>(i) + 0.5),
                                                                               m_bottom + m_cell * (static_cast<double>(j) + 0.5)));
            }
        }
    }
    m_shade.assign(m_columns * m_rows, 0.0F);
}

void GroundShade::clear() {
    if (!m_clear) {
        m_clear = true;
        std::fill(m_shade.begin(), m_shade.end(), 0.0F);
        m_pointShade.clear();
        ++m_version;
    }
}

float GroundShade::groundUnder(float x, float y) const {
    if (m_ground.empty()) {
        return m_level;
    }
    const float column = std::clamp(x, 0.0F, static_cast<float>(m_columns - 1));
    const float row = std::clamp(y, 0.0F, static_cast<float>(m_rows - 1));
    return m_ground[static_cast<std::size_t>(row) * m_columns + static_cast<std::size_t>(column)];
}

GroundShade::Cast GroundShade::castOf(const float* point) const {
    // What has gone astray, or is nowhere, lies far beyond the raster.
    const auto cells = [](float at) { return at > -astray && at < astray ? at : -astray; };
    Cast cast;
    cast.x = cells((point[0] - static_cast<float>(m_left)) * m_cellsInMetre);
    cast.y = cells((point[1] - static_cast<float>(m_bottom)) * m_cellsInMetre);
    cast.height = std::isfinite(point[2]) ? point[2] : 0.0F;
    cast.above = std::max(0.0F, point[2] - groundUnder(cast.x, cast.y));
    // On a slope the shadow falls until it meets the ground there; two steps come close enough for a shadow.
    const float most = astray / m_cellsInMetre;
    float fall = std::min(cast.above, most);
    for (int step = 0; step < (m_ground.empty() ? 0 : 2); ++step) {
        fall = std::min(most, std::max(0.0F, point[2] - groundUnder(cast.x + fall * m_east, cast.y + fall * m_north)));
    }
    cast.u = cast.x + fall * m_east;
    cast.v = cast.y + fall * m_north;
    return cast;
}

/// Means over squares of cells: first along rows, then along columns.
void GroundShade::blurred(std::vector<float>& field, std::size_t radius) {
    m_passing.resize(field.size());
    const auto r = static_cast<std::ptrdiff_t>(radius);
    const auto columns = static_cast<std::ptrdiff_t>(m_columns);
    const auto rows = static_cast<std::ptrdiff_t>(m_rows);
    const float share = 1.0F / static_cast<float>(2 * radius + 1);
    for (std::ptrdiff_t j = 0; j < rows; ++j) {
        const float* from = field.data() + j * columns;
        float* to = m_passing.data() + j * columns;
        float sum = 0.0F;
        for (std::ptrdiff_t i = -r; i < columns; ++i) {
            sum += i + r < columns ? from[i + r] : 0.0F;
            sum -= i - r - 1 >= 0 ? from[i - r - 1] : 0.0F;
            if (i >= 0) {
                to[i] = std::max(0.0F, sum) * share;
            }
        }
    }
    // Row after row, so that memory is read in its order.
    std::vector<float> sums(m_columns, 0.0F);
    for (std::ptrdiff_t j = -r; j < rows; ++j) {
        const float* enters = j + r < rows ? m_passing.data() + (j + r) * columns : nullptr;
        const float* leaves = j - r - 1 >= 0 ? m_passing.data() + (j - r - 1) * columns : nullptr;
        float* to = j >= 0 ? field.data() + j * columns : nullptr;
        for (std::ptrdiff_t i = 0; i < columns; ++i) {
            float& sum = sums[static_cast<std::size_t>(i)];
            sum += (enters ? enters[i] : 0.0F) - (leaves ? leaves[i] : 0.0F);
            if (to) {
                to[i] = std::max(0.0F, sum) * share;
            }
        }
    }
}

void GroundShade::bake(const std::vector<float>& points, const std::vector<std::int32_t>& triangles) {
    if (empty()) {
        return;
    }
    m_casts.resize(points.size() / 3);
    for (std::size_t p = 0; p < m_casts.size(); ++p) {
        m_casts[p] = castOf(points.data() + 3 * p);
    }
    m_top.assign(m_shade.size(), nothing);
    m_contact.assign(m_shade.size(), 0.0F);
    Filling cast(m_top, m_columns, m_rows);
    Filling contact(m_contact, m_columns, m_rows);
    const auto close = static_cast<float>(m_near);
    const auto nearness = [close](const Cast& c) { return std::max(0.0F, 1.0F - c.above / close); };
    for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
        const std::array<const Cast*, 3> c{&m_casts[static_cast<std::size_t>(triangles[t])],
                                           &m_casts[static_cast<std::size_t>(triangles[t + 1])],
                                           &m_casts[static_cast<std::size_t>(triangles[t + 2])]};
        // Of a body that is closed the side towards the sun throws the whole shadow: there corners go round anticlockwise.
        const float turn = (c[1]->u - c[0]->u) * (c[2]->v - c[0]->v) - (c[2]->u - c[0]->u) * (c[1]->v - c[0]->v);
        if (turn > 0.0F) {
            cast({Corner{c[0]->u, c[0]->v, c[0]->height}, Corner{c[1]->u, c[1]->v, c[1]->height},
                  Corner{c[2]->u, c[2]->v, c[2]->height}});
            continue;
        }
        // Below it ends with sides that lie away from the sun.
        if (std::min({c[0]->above, c[1]->above, c[2]->above}) < close) {
            contact({Corner{c[0]->x, c[0]->y, nearness(*c[0])}, Corner{c[1]->x, c[1]->y, nearness(*c[1])},
                     Corner{c[2]->x, c[2]->y, nearness(*c[2])}});
        }
    }
    shadePoints();
    m_cast.resize(m_top.size());
    std::transform(m_top.begin(), m_top.end(), m_cast.begin(), [](float top) { return top > nothing ? 1.0F : 0.0F; });
    blurred(m_cast, 1);
    const auto radius = static_cast<std::size_t>(std::clamp(std::lround(0.5 * m_near / m_cell), 2L, 6L));
    blurred(m_contact, radius);
    for (std::size_t i = 0; i < m_shade.size(); ++i) {
        m_shade[i] = 1.0F - (1.0F - castShare * m_cast[i]) * (1.0F - contactShare * std::min(1.0F, m_contact[i]));
    }
    m_clear = false;
    ++m_version;
}

/// By the heights at which rays of the sun meet the model: who lies below is in the shade, and who lies below the mean about them
/// is in a hollow. Sides that lie away from the sun are dark by themselves.
void GroundShade::shadePoints() {
    m_crowd.resize(m_top.size());
    for (std::size_t j = 0; j < m_rows; ++j) {
        for (std::size_t i = 0; i < m_columns; ++i) {
            const float top = m_top[j * m_columns + i];
            m_crowd[j * m_columns + i] = top > nothing ? top : groundUnder(static_cast<float>(i), static_cast<float>(j));
        }
    }
    // Heights are told from the lowest ground, since means of squares are not below zero.
    const float low = m_ground.empty() ? m_level : *std::min_element(m_ground.begin(), m_ground.end());
    for (float& height : m_crowd) {
        height = std::max(0.0F, height - low);
    }
    blurred(m_crowd, crowdRadius);
    const float apart = sameRay / std::max(std::hypot(m_east, m_north), 1e-6F);  // m of height between rays a cell apart
    m_pointShade.resize(m_casts.size());
    for (std::size_t p = 0; p < m_casts.size(); ++p) {
        const Cast& cast = m_casts[p];
        const bool within =
            cast.u >= 0.0F && cast.v >= 0.0F && cast.u < static_cast<float>(m_columns) && cast.v < static_cast<float>(m_rows);
        if (!within) {
            m_pointShade[p] = 0.0F;
            continue;
        }
        const std::size_t cell = static_cast<std::size_t>(cast.v) * m_columns + static_cast<std::size_t>(cast.u);
        const float shadow = std::clamp((m_top[cell] - cast.height - apart) / apart, 0.0F, 1.0F);
        const float hollow = std::clamp((m_crowd[cell] - (cast.height - low)) / (2.0F * apart), 0.0F, 1.0F);
        m_pointShade[p] = 1.0F - (1.0F - selfCastShare * shadow) * (1.0F - hollowShare * hollow);
    }
}

double GroundShade::shadeAt(double x, double y) const {
    const double column = std::floor((x - m_left) / m_cell);
    const double row = std::floor((y - m_bottom) / m_cell);
    if (column < 0.0 || row < 0.0 || column >= static_cast<double>(m_columns) || row >= static_cast<double>(m_rows)) {
        return 0.0;
    }
    return static_cast<double>(m_shade[static_cast<std::size_t>(row) * m_columns + static_cast<std::size_t>(column)]);
}

}  // namespace rubble::render
