#include "app/cli/run/validation_pictures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "core/base/geometry.h"
#include "core/base/message.h"
#include "io/base/files.h"
#include "widgets/figures/round_step.h"

namespace rubble::cli {

namespace {

constexpr double pictureWidth = 640.0;
constexpr double pictureHeight = 420.0;
constexpr double pictureMargin = 56.0;
constexpr const char* measuredColour = "#1b1b1b";
constexpr const char* simulatedColour = "#c8501e";

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        safe += c == '&' ? std::string("&amp;") : c == '<' ? std::string("&lt;") : std::string(1, c);
    }
    return safe;
}

/// Round numbers along an axis, about five.
std::vector<double> roundPlaces(double low, double high) {
    constexpr double most = 6.0;
    const double step = figures::roundStep(high - low, most);
    std::vector<double> all;
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
        all.push_back(k == 0.0 ? 0.0 : k * step);  // no minus before zero
    }
    return all;
}

/// A frame with two axes, into which points of a rectangle of numbers are drawn.
class ValidationPlot {
public:
    ValidationPlot(const Aabb& range, const std::string& title, const std::string& alongX, const std::string& alongY)
        : m_range(range) {
        m_out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << pictureWidth << ' ' << pictureHeight
              << "\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
        text(pictureMargin, 22.0, title, "start");
        text(0.5 * pictureWidth, pictureHeight - 8.0, alongX, "middle");
        text(8.0, 40.0, alongY, "start");
        m_out << "<rect x=\"" << pictureMargin << "\" y=\"" << pictureMargin << "\" width=\"" << pictureWidth - 2 * pictureMargin
              << "\" height=\"" << pictureHeight - 2 * pictureMargin << "\" fill=\"none\" stroke=\"#999\"/>\n";
        for (const double at : roundPlaces(m_range.min().x(), m_range.max().x())) {
            line(x(at), pictureHeight - pictureMargin, x(at), pictureHeight - pictureMargin + 4.0);
            text(x(at), pictureHeight - pictureMargin + 18.0, englishNumber(at), "middle");
        }
        for (const double at : roundPlaces(m_range.min().y(), m_range.max().y())) {
            line(pictureMargin - 4.0, y(at), pictureMargin, y(at));
            text(pictureMargin - 7.0, y(at) + 4.0, englishNumber(at), "end");
        }
        text(pictureWidth - pictureMargin, 22.0, "measured", "end", measuredColour);
        text(pictureWidth - pictureMargin, 40.0, "simulated", "end", simulatedColour);
    }

    void curve(std::vector<double> values, const char* colour) {
        std::erase_if(values, [](double value) { return !std::isfinite(value); });
        std::sort(values.begin(), values.end());
        m_out << "<polyline fill=\"none\" stroke-width=\"1.8\" stroke=\"" << colour << "\" points=\"";
        for (std::size_t i = 0; i < values.size(); ++i) {
            for (const std::size_t below : {i, i + 1}) {
                m_out << x(values[i]) << ',' << y(static_cast<double>(below) / static_cast<double>(values.size())) << ' ';
            }
        }
        m_out << "\"/>\n";
    }

    void dot(const Vec3& place, const char* colour, double radius, double opacity) {
        m_out << "<circle cx=\"" << x(place.x()) << "\" cy=\"" << y(place.y()) << "\" r=\"" << radius << "\" fill=\"" << colour
              << "\" fill-opacity=\"" << opacity << "\"/>\n";
    }

    void write(const std::string& path) {
        m_out << "</svg>\n";
        io::writeIn(path, m_out.str());
    }

private:
    double x(double value) const {
        return pictureMargin + (value - m_range.min().x()) / m_range.sizes().x() * (pictureWidth - 2 * pictureMargin);
    }
    double y(double value) const {
        return pictureHeight - pictureMargin -
               (value - m_range.min().y()) / m_range.sizes().y() * (pictureHeight - 2 * pictureMargin);
    }
    void line(double fromX, double fromY, double toX, double toY) {
        m_out << "<line x1=\"" << fromX << "\" y1=\"" << fromY << "\" x2=\"" << toX << "\" y2=\"" << toY
              << "\" stroke=\"#999\"/>\n";
    }
    void text(double atX, double atY, const std::string& words, const char* anchor, const char* colour = measuredColour) {
        m_out << "<text x=\"" << atX << "\" y=\"" << atY << "\" text-anchor=\"" << anchor << "\" fill=\"" << colour << "\">"
              << escaped(words) << "</text>\n";
    }

    Aabb m_range;
    std::ostringstream m_out;
};

std::vector<double> allSimulated(const QuantityComparison& quantity) {
    std::vector<double> all;
    for (const std::vector<double>& repeats : quantity.values.simulated) {
        all.insert(all.end(), repeats.begin(), repeats.end());
    }
    return all;
}

void drawCurves(const QuantityComparison& quantity, const std::string& title, const std::string& path) {
    const std::vector<double> simulated = allSimulated(quantity);
    Aabb range;
    for (const std::vector<double>* values : {&quantity.values.measured, &simulated}) {
        for (const double value : *values) {
            if (std::isfinite(value)) {
                range.extend(Vec3(value, 0.0, 0.0));
                range.extend(Vec3(value, 1.0, 0.0));
            }
        }
    }
    if (range.isEmpty() || !(range.sizes().x() > 0.0)) {
        return;
    }
    ValidationPlot plot(range, title, quantity.title + " [" + quantity.unit + "]", "share of the bodies");
    plot.curve(quantity.values.measured, measuredColour);
    plot.curve(simulated, simulatedColour);
    plot.write(path);
}

/// One metre is as long along both axes.
void drawMap(const VariantResult& variant, const std::string& title, const std::string& path) {
    Aabb range;
    for (const Deposit& deposit : variant.deposits) {
        range.extend(deposit.measured);
        for (const Vec3& place : deposit.simulated) {
            range.extend(place);
        }
    }
    if (range.isEmpty()) {
        return;
    }
    const double aspect = (pictureWidth - 2 * pictureMargin) / (pictureHeight - 2 * pictureMargin);
    const double high = std::max({range.sizes().y(), range.sizes().x() / aspect, 1e-9});
    const Vec3 half(0.5 * aspect * high, 0.5 * high, 0.0);
    const Vec3 middle = range.center();
    ValidationPlot plot(Aabb((middle - half).eval(), (middle + half).eval()), title, "x [m]", "y [m]");
    std::size_t dots = 0;
    for (const Deposit& deposit : variant.deposits) {
        dots += deposit.simulated.size();
    }
    // Many dots are fainter, so that one sees where they lie densest.
    const double opacity = std::clamp(500.0 / static_cast<double>(std::max<std::size_t>(1, dots)), 0.1, 0.6);
    for (const Deposit& deposit : variant.deposits) {
        for (const Vec3& place : deposit.simulated) {
            plot.dot(place, simulatedColour, 2.0, opacity);
        }
    }
    for (const Deposit& deposit : variant.deposits) {
        plot.dot(deposit.measured, measuredColour, 3.0, 0.8);
    }
    plot.write(path);
}

}  // namespace

std::vector<std::string> drawValidation(const std::vector<SetResult>& results, const std::string& folder) {
    std::vector<std::string> written;
    for (const SetResult& result : results) {
        for (const VariantResult& variant : result.variants) {
            const std::string title = result.set->id + ", " + variant.variant.name;
            const auto pathOf = [&](const std::string& what) {
                std::string name = result.set->id + "-" + variant.variant.name + "-" + what + ".svg";
                std::replace_if(name.begin(), name.end(), [](char c) { return c == ' ' || c == '/' || c == ','; }, '_');
                return (std::filesystem::path(folder) / name).string();
            };
            const auto note = [&](const std::string& path) {
                if (std::filesystem::exists(path)) {
                    written.push_back(path);
                }
            };
            for (const QuantityComparison& quantity : variant.quantities) {
                if (quantity.key.find('[') == std::string::npos) {
                    drawCurves(quantity, title, pathOf(quantity.key));
                    note(pathOf(quantity.key));
                }
            }
            drawMap(variant, title, pathOf("map"));
            note(pathOf("map"));
        }
    }
    return written;
}

}  // namespace rubble::cli
