#include "core/evidence/maps/mark_distances.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double far = 1e20;

/// Squared distances along a row to the nearest zero of f + distance squared (lower envelope of parabolas).
void distanceAlong(std::vector<double>& f, std::vector<double>& out, std::vector<std::size_t>& v, std::vector<double>& z) {
    const std::size_t n = f.size();
    std::size_t k = 0;
    v[0] = 0;
    z[0] = -far;
    z[1] = far;
    const auto meets = [&](std::size_t q, std::size_t p) {
        const auto a = static_cast<double>(q);
        const auto b = static_cast<double>(p);
        return ((f[q] + a * a) - (f[p] + b * b)) / (2.0 * (a - b));
    };
    for (std::size_t q = 1; q < n; ++q) {
        double s = meets(q, v[k]);
        while (k > 0 && s <= z[k]) {
            s = meets(q, v[--k]);
        }
        v[++k] = q;
        z[k] = s;
        z[k + 1] = far;
    }
    k = 0;
    for (std::size_t q = 0; q < n; ++q) {
        while (z[k + 1] < static_cast<double>(q)) {
            ++k;
        }
        const double d = static_cast<double>(q) - static_cast<double>(v[k]);
        out[q] = d * d + f[v[k]];
    }
}

}  // namespace

std::vector<double> distancesTo(const std::vector<std::uint8_t>& marked, int width, int height) {
    const auto w = static_cast<std::size_t>(width);
    const auto h = static_cast<std::size_t>(height);
    std::vector<double> squares(w * h);
    std::transform(marked.begin(), marked.end(), squares.begin(), [](std::uint8_t is) { return is != 0 ? 0.0 : far; });
    const std::size_t longest = std::max(w, h);
    std::vector<std::size_t> v(longest);
    std::vector<double> z(longest + 1);
    std::vector<double> column(h);
    std::vector<double> out(h);
    for (std::size_t x = 0; x < w; ++x) {
        for (std::size_t y = 0; y < h; ++y) {
            column[y] = squares[y * w + x];
        }
        distanceAlong(column, out, v, z);
        for (std::size_t y = 0; y < h; ++y) {
            squares[y * w + x] = out[y];
        }
    }
    std::vector<double> row(w);
    out.resize(w);
    for (std::size_t y = 0; y < h; ++y) {
        const auto first = squares.begin() + static_cast<std::ptrdiff_t>(y * w);
        std::copy_n(first, w, row.begin());
        distanceAlong(row, out, v, z);
        std::transform(out.begin(), out.end(), first, [](double square) { return std::sqrt(square); });
    }
    return squares;
}

}  // namespace rubble
