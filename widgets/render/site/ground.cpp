#include "widgets/render/site/ground.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "widgets/render/site/disc.h"
#include "widgets/render/site/relief.h"

namespace rubble::render {
namespace {

constexpr double planeReach = 14.0;  // model lengths until ground and sky are one
constexpr double gridReach = 1.1;    // model lengths until the grid has faded
constexpr double gridLift = 5e-4;    // model lengths above a terrain
constexpr double lightenMost = 0.1;  // share of white in slopes that face the light: more would glare like snow

vtkSmartPointer<vtkActor> flatActor(vtkPolyData* data) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetColorModeToDirectScalars();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    actor->ForceOpaqueOn();
    return actor;
}

Rgb mixed(const Rgb& a, const Rgb& b, double share) {
    const auto channel = [share](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>(std::lround((1 - share) * x + share * y));
    };
    return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
}

/// A colour in more or less light than level ground has.
Rgb shaded(const Rgb& colour, double light) {
    return light < 1.0 ? mixed({0, 0, 0}, colour, 0.55 + 0.45 * light)
                       : mixed(colour, {255, 255, 255}, std::min(lightenMost, light - 1.0));
}

/// Share of the horizon's colour in the ground at a distance, both in model lengths.
double haze(double distance) {
    return 1.0 - std::exp(-std::pow(distance / 4.5, 2));
}

std::array<std::uint8_t, 4> opaque(const Rgb& c) {
    return {c.r, c.g, c.b, 255};
}

void addColour(vtkUnsignedCharArray& colours, const Rgb& c) {
    colours.InsertNextTypedTuple(opaque(c).data());
}

}  // namespace

Ground::Ground()
    : m_sky(vtkSmartPointer<vtkPolyData>::New()),
      m_plane(vtkSmartPointer<vtkPolyData>::New()),
      m_grid(vtkSmartPointer<vtkPolyData>::New()),
      m_skyActor(flatActor(m_sky)),
      m_planeActor(flatActor(m_plane)),
      m_gridActor(flatActor(m_grid)) {
    m_planeActor->GetProperty()->BackfaceCullingOn();
    // In a parallel projection the near side of the sky stands between the camera and the model: it is seen from within alone.
    m_skyActor->GetProperty()->FrontfaceCullingOn();
    auto* mapper = m_planeActor->GetMapper();
    // The plane steps back so that the grid and what lies on the ground win.
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(stepBack, stepBack);
}

Ground::~Ground() = default;

void Ground::addTo(vtkRenderer& renderer) {
    renderer.AddActor(m_skyActor);
    renderer.AddActor(m_planeActor);
    renderer.AddActor(m_gridActor);
}

void Ground::setVisible(bool visible, bool grid) {
    m_skyActor->SetVisibility(visible);
    m_planeActor->SetVisibility(visible);
    m_gridActor->SetVisibility(visible && grid);
}

double Ground::spacing(const Aabb& bounds) {
    const double length = std::max(bounds.sizes().x(), bounds.sizes().y());
    if (!(length > 0)) {
        return 1.0;
    }
    const double power = std::pow(10.0, std::floor(std::log10(length / 10.0)));
    const double mantissa = length / 10.0 / power;
    return power * (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1);
}

void Ground::set(const Aabb& bounds, const SiteSurface& ground, const SceneColours& colours) {
    const Vec3 centre(bounds.center().x(), bounds.center().y(), ground.terrain ? ground.terrain->lowest() : ground.levelHeight);
    const double size = std::max(bounds.sizes().norm(), 1e-3);
    m_reach = planeReach * size;
    makeSky(centre, colours);
    if (ground.terrain) {
        makeRelief(*ground.terrain, bounds, colours);
    } else {
        makePlane(centre, colours);
    }
    makeGrid(ground, centre, size, spacing(bounds), colours);
    m_shadeLaid = false;
}

void Ground::setShade(const GroundShade* shade, const SceneColours& colours) {
    if (!shade || shade->empty()) {
        if (m_planeActor->GetTexture()) {
            m_planeActor->SetTexture(nullptr);
            // VTK makes the shader anew for what it is told of; a texture that goes is not among that.
            m_plane->GetPointData()->SetTCoords(nullptr);
            m_plane->Modified();
            m_planeActor->GetMapper()->Modified();
            m_shadeLaid = false;
        }
        return;
    }
    if (!m_shadeLaid) {
        ShadeTexture::lay(*m_plane, *shade);
        m_shadeLaid = true;
    }
    m_shade.follow(*shade, colours);
    m_planeActor->SetTexture(m_shade.texture());
}

void Ground::setGridOpacity(double opacity) {
    m_gridActor->GetProperty()->SetOpacity(opacity);
}

void Ground::makeSky(const Vec3& centre, const SceneColours& colours) {
    // A dome stands on the rim of the plane, so that ground and sky meet in one colour whatever the camera does.
    constexpr std::array<double, 6> rise{0.0, 0.06, 0.14, 0.3, 0.7, 1.4};  // rad above the horizon
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> rgba;
    rgba->SetNumberOfComponents(4);
    for (std::size_t r = 0; r < rise.size(); ++r) {
        const double share = 1.0 - std::exp(-rise[r] / 0.14);
        for (int s = 0; s < sectors; ++s) {
            const double angle = 2.0 * std::numbers::pi * s / sectors;
            points->InsertNextPoint(centre.x() + m_reach * std::cos(angle), centre.y() + m_reach * std::sin(angle),
                                    centre.z() + m_reach * std::tan(rise[r]));
            addColour(*rgba, mixed(colours.skyHorizon, colours.skyTop, share));
        }
    }
    for (std::size_t r = 0; r + 1 < rise.size(); ++r) {
        for (int s = 0; s < sectors; ++s) {
            const vtkIdType low = static_cast<vtkIdType>(r) * sectors;
            const vtkIdType next = (s + 1) % sectors;
            const std::array<vtkIdType, 4> quad{low + s, low + next, low + sectors + next, low + sectors + s};
            cells->InsertNextCell(4, quad.data());
        }
    }
    m_sky->SetPoints(points);
    m_sky->SetPolys(cells);
    m_sky->GetPointData()->SetScalars(rgba);
    m_sky->Modified();
}

void Ground::makePlane(const Vec3& centre, const SceneColours& colours) {
    constexpr std::array<double, 10> rings{0.6, 1.0, 1.6, 2.3, 3.2, 4.3, 5.6, 7.5, 10.0, planeReach};
    makeDisc(*m_plane, centre, m_reach / planeReach, rings, [&](double ring) {
        return opaque(ring == planeReach ? colours.skyHorizon : mixed(colours.ground, colours.skyHorizon, haze(ring)));
    });
}

void Ground::makeRelief(const TerrainGrid& terrain, const Aabb& bounds, const SceneColours& colours) {
    const Relief relief = reliefOf(terrain, bounds, m_reach);
    const double size = m_reach / planeReach;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> rgba;
    rgba->SetNumberOfComponents(4);
    for (std::size_t i = 0; i < relief.points.size(); ++i) {
        const Vec3& p = relief.points[i];
        points->InsertNextPoint(p.data());
        const double distance = std::hypot(p.x() - bounds.center().x(), p.y() - bounds.center().y()) / size;
        addColour(*rgba, mixed(shaded(colours.ground, relief.shade[i]), colours.skyHorizon, haze(distance)));
    }
    for (const auto& triangle : relief.triangles) {
        const std::array<vtkIdType, 3> ids{triangle[0], triangle[1], triangle[2]};
        cells->InsertNextCell(3, ids.data());
    }
    m_plane->SetPoints(points);
    m_plane->SetPolys(cells);
    m_plane->GetPointData()->SetScalars(rgba);
    m_plane->Modified();
}

void Ground::makeGrid(const SiteSurface& ground, const Vec3& centre, double size, double step, const SceneColours& colours) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkUnsignedCharArray> rgba;
    rgba->SetNumberOfComponents(4);
    const double reach = gridReach * size;
    const int count = static_cast<int>(std::ceil(reach / step));
    // On a terrain a line follows the slopes between its crossings, a little above what bulges between the ends of a piece.
    const int pieces = ground.terrain ? 8 : 1;
    const double lift = ground.terrain ? gridLift * size : 0.0;
    const auto line = [&](int axis, double across) {
        // Short pieces let the line fade with the distance from the model.
        for (int i = -count * pieces; i <= count * pieces; ++i) {
            Vec3 p(centre.x(), centre.y(), centre.z());
            p[1 - axis] = across;
            p[axis] = step * (std::round(centre[axis] / step) + static_cast<double>(i) / pieces);
            p.z() = ground.height(p.x(), p.y()) + lift;
            const double distance = std::hypot(p.x() - centre.x(), p.y() - centre.y());
            const double faded = std::clamp(std::pow(distance / reach, 2.0), 0.0, 1.0);
            const Rgb under = mixed(colours.ground, colours.skyHorizon, haze(distance / size));
            const vtkIdType id = points->InsertNextPoint(p.data());
            addColour(*rgba, mixed(colours.grid, under, faded));
            if (i > -count * pieces) {
                const std::array<vtkIdType, 2> piece{id - 1, id};
                lines->InsertNextCell(2, piece.data());
            }
        }
    };
    for (int axis = 0; axis < 2; ++axis) {
        for (int i = -count; i <= count; ++i) {
            line(axis, step * (std::round(centre[1 - axis] / step) + i));
        }
    }
    m_grid->SetPoints(points);
    m_grid->SetLines(lines);
    m_grid->GetPointData()->SetScalars(rgba);
    m_grid->Modified();
}

}  // namespace rubble::render
