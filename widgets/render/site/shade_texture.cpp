#include "widgets/render/site/shade_texture.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble::render {
namespace {

/// Cells from one bump of the ground to the next, coarse and fine.
constexpr double coarseBumps = 23.0;
constexpr double fineBumps = 5.0;

/// A number of [0, 1] for each pair of whole numbers, without order.
float scattered(std::int32_t i, std::int32_t j) {
    auto h = static_cast<std::uint32_t>(i) * 0x9e3779b1U ^ (static_cast<std::uint32_t>(j) + 0x7f4a7c15U) * 0x85ebca77U;
    h = (h ^ (h >> 15U)) * 0xc2b2ae3dU;
    h ^= h >> 13U;
    return static_cast<float>(h & 0xffffU) / 65535.0F;
}

float bumps(double x, double y) {
    const auto i = static_cast<std::int32_t>(std::floor(x));
    const auto j = static_cast<std::int32_t>(std::floor(y));
    const auto eased = [](double t) { return static_cast<float>(t * t * (3.0 - 2.0 * t)); };
    const float u = eased(x - i);
    const float v = eased(y - j);
    return std::lerp(std::lerp(scattered(i, j), scattered(i + 1, j), u), std::lerp(scattered(i, j + 1), scattered(i + 1, j + 1), u),
                     v);
}

/// Share of a cell's unevenness that is left: none at the rim, so that the ground beyond goes on as it is.
double leftAt(double column, double row, double columns, double rows) {
    const auto inwards = [](double at, double count) { return 2.0 * std::min(at, count - 1.0 - at) / count; };
    return std::clamp(2.5 * std::min(inwards(column, columns), inwards(row, rows)), 0.0, 1.0);
}

}  // namespace

ShadeTexture::ShadeTexture(Kind kind)
    : m_kind(kind), m_image(vtkSmartPointer<vtkImageData>::New()), m_texture(vtkSmartPointer<vtkTexture>::New()) {
    m_texture->InterpolateOn();
    m_texture->SetWrap(vtkTexture::ClampToEdge);
    m_texture->SetInputData(m_image);
}

ShadeTexture::~ShadeTexture() = default;

vtkTexture* ShadeTexture::texture() const {
    return m_texture;
}

void ShadeTexture::makeTexture(const GroundShade& shade) {
    m_image->SetDimensions(static_cast<int>(shade.columns()), static_cast<int>(shade.rows()), 1);
    m_image->AllocateScalars(VTK_UNSIGNED_CHAR, m_kind == Kind::Veil ? 4 : 3);
    m_uneven.assign(shade.shade().size(), 0.0F);
    for (std::size_t j = 0; m_kind == Kind::Light && j < shade.rows(); ++j) {
        for (std::size_t i = 0; i < shade.columns(); ++i) {
            const auto x = static_cast<double>(i);
            const auto y = static_cast<double>(j);
            const auto left =
                static_cast<float>(leftAt(x, y, static_cast<double>(shade.columns()), static_cast<double>(shade.rows())));
            const float both = 0.6F * bumps(x / coarseBumps, y / coarseBumps) + 0.4F * bumps(x / fineBumps, y / fineBumps);
            m_uneven[j * shade.columns() + i] = left * both;
        }
    }
}

void ShadeTexture::follow(const GroundShade& shade, const SceneColours& colours) {
    if (m_followed == &shade && m_version == shade.version() && m_depth == colours.shadow && m_roughness == colours.groundTexture) {
        return;
    }
    const int* held = m_image->GetDimensions();
    if (m_followed != &shade || m_uneven.size() != shade.shade().size() || held[0] != static_cast<int>(shade.columns())) {
        makeTexture(shade);
    }
    m_followed = &shade;
    m_version = shade.version();
    m_depth = colours.shadow;
    m_roughness = colours.groundTexture;
    const auto depth = static_cast<float>(m_depth);
    const auto roughness = static_cast<float>(m_roughness);
    auto* out = static_cast<std::uint8_t*>(m_image->GetScalarPointer());
    const std::size_t columns = shade.columns();
    if (columns == 0) {
        return;
    }
    for (std::size_t c = 0; c < m_uneven.size(); ++c) {
        // What lies beyond takes the colour of the rim, which is in full light.
        const bool rim = c < columns || c + columns >= m_uneven.size() || c % columns == 0 || c % columns == columns - 1;
        const float dark = rim ? 0.0F : depth * shade.shade()[c];
        if (m_kind == Kind::Veil) {
            out[0] = out[1] = out[2] = 0;
            out[3] = static_cast<std::uint8_t>(255.0F * dark);
            out += 4;
            continue;
        }
        out[0] = out[1] = out[2] =
            static_cast<std::uint8_t>(std::lround(255.0F * (1.0F - dark) * (1.0F - roughness * m_uneven[c])));
        out += 3;
    }
    m_image->Modified();
}

void ShadeTexture::lay(vtkPolyData& surface, const GroundShade& shade) {
    vtkNew<vtkFloatArray> places;
    places->SetNumberOfComponents(2);
    for (vtkIdType p = 0; p < surface.GetNumberOfPoints(); ++p) {
        std::array<double, 3> at{};
        surface.GetPoint(p, at.data());
        places->InsertNextTuple2((at[0] - shade.left()) / shade.width(), (at[1] - shade.bottom()) / shade.height());
    }
    surface.GetPointData()->SetTCoords(places);
    surface.Modified();
}

}  // namespace rubble::render
