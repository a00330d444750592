#include "widgets/render/site/site_layer.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "widgets/render/site/relief.h"

namespace rubble::render {
namespace {

/// The rectangle of a picture on level ground.
Relief levelRelief(const Orthophoto& picture, double height) {
    Relief relief;
    for (const double y : {picture.y0, picture.top()}) {
        for (const double x : {picture.x0, picture.right()}) {
            relief.points.emplace_back(x, y, height);
            relief.shade.push_back(1.0);
        }
    }
    relief.triangles = {{0, 1, 3}, {0, 3, 2}};
    return relief;
}

/// Whether a triangle reaches over the picture.
bool over(const Orthophoto& picture, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto apart = [](double x, double y, double z, double low, double high) {
        return std::max({x, y, z}) < low || std::min({x, y, z}) > high;
    };
    return !apart(a.x(), b.x(), c.x(), picture.x0, picture.right()) && !apart(a.y(), b.y(), c.y(), picture.y0, picture.top());
}

/// Brings the bright parts of a picture below a share of white, so that snow and roofs do not glare; the dark ones stay.
void dampen(std::span<std::uint8_t> rgba, double brightest) {
    const double knee = 0.6 * brightest;
    for (std::size_t p = 0; p + 3 < rgba.size() && brightest < 1.0; p += 4) {
        const double most = std::max({rgba[p], rgba[p + 1], rgba[p + 2]}) / 255.0;
        if (most <= knee) {
            continue;
        }
        const double factor = (knee + (brightest - knee) * (most - knee) / (1.0 - knee)) / most;
        for (std::size_t c = p; c < p + 3; ++c) {
            rgba[c] = static_cast<std::uint8_t>(std::lround(factor * rgba[c]));
        }
    }
}

/// Whether a picture from above shows a triangle: walls and cliffs would be smeared with the colours of their edges.
bool seenFromAbove(const Vec3& a, const Vec3& b, const Vec3& c) {
    constexpr double stretchMost = 2.0;  // of the picture along the slope: 60 degrees
    const Vec3 normal = (b - a).cross(c - a);
    return stretchMost * std::abs(normal.z()) >= normal.norm();
}

}  // namespace

SiteLayer::SiteLayer()
    : m_veil(vtkSmartPointer<vtkPolyData>::New()),
      m_veilActor(vtkSmartPointer<vtkActor>::New()),
      m_drape(vtkSmartPointer<vtkPolyData>::New()),
      m_texture(vtkSmartPointer<vtkTexture>::New()),
      m_meshes(vtkSmartPointer<vtkPolyData>::New()),
      m_drapeActor(vtkSmartPointer<vtkActor>::New()),
      m_meshActor(vtkSmartPointer<vtkActor>::New()) {
    vtkNew<vtkPolyDataMapper> drape;
    drape->SetInputData(m_drape);
    drape->SetColorModeToDirectScalars();
    // Before the ground, behind its grid and what lies on it.
    drape->SetResolveCoincidentTopologyToPolygonOffset();
    drape->SetRelativeCoincidentTopologyPolygonOffsetParameters(1.0, 1.0);
    m_texture->InterpolateOn();
    m_texture->MipmapOn();
    m_texture->SetWrap(vtkTexture::ClampToBorder);
    m_drapeActor->SetMapper(drape);
    m_drapeActor->SetTexture(m_texture);
    m_drapeActor->GetProperty()->LightingOff();
    m_drapeActor->GetProperty()->BackfaceCullingOn();
    m_drapeActor->PickableOff();
    vtkNew<vtkPolyDataMapper> veil;
    veil->SetInputData(m_veil);
    veil->ScalarVisibilityOff();
    veil->SetResolveCoincidentTopologyToPolygonOffset();
    veil->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.5, 0.5);
    m_veilActor->SetMapper(veil);
    m_veilActor->SetTexture(m_shade.texture());
    m_veilActor->GetProperty()->LightingOff();
    m_veilActor->GetProperty()->BackfaceCullingOn();
    m_veilActor->ForceTranslucentOn();
    m_veilActor->PickableOff();
    vtkNew<vtkPolyDataMapper> meshes;
    meshes->SetInputData(m_meshes);
    meshes->ScalarVisibilityOff();
    m_meshActor->SetMapper(meshes);
    m_meshActor->PickableOff();
    setVisible(false);
}

SiteLayer::~SiteLayer() = default;

void SiteLayer::addTo(vtkRenderer& renderer) {
    renderer.AddActor(m_meshActor);
    renderer.AddActor(m_drapeActor);
    renderer.AddActor(m_veilActor);
}

void SiteLayer::setShade(const GroundShade* shade, const SceneColours& colours) {
    m_shaded = shade && !shade->empty() && m_orthophoto != nullptr;
    if (m_shaded) {
        if (!m_shadeLaid) {
            m_veil->SetPoints(m_drape->GetPoints());
            m_veil->SetPolys(m_drape->GetPolys());
            ShadeTexture::lay(*m_veil, *shade);
            m_shadeLaid = true;
        }
        m_shade.follow(*shade, colours);
    }
    m_veilActor->SetVisibility(m_visible && m_shaded);
}

void SiteLayer::setVisible(bool visible) {
    m_visible = visible;
    m_veilActor->SetVisibility(visible && m_shaded);
    m_drapeActor->SetVisibility(visible && m_orthophoto != nullptr);
    m_meshActor->SetVisibility(visible && m_surroundings != nullptr);
}

void SiteLayer::set(const std::shared_ptr<const Orthophoto>& orthophoto,
                    const std::shared_ptr<const std::vector<SiteMesh>>& surroundings, const SiteSurface& ground, const Aabb& bounds,
                    double reach, const SceneColours& colours) {
    const bool sameGround = ground.terrain == m_ground.terrain && ground.levelHeight == m_ground.levelHeight && reach == m_reach;
    m_shadeLaid = false;
    if (orthophoto != nullptr && !(orthophoto == m_orthophoto && sameGround && colours.brightest == m_brightest)) {
        drape(*orthophoto, ground, bounds, reach, colours.brightest);
    }
    if (surroundings != nullptr && surroundings != m_surroundings) {
        build(*surroundings);
    }
    m_orthophoto = orthophoto;
    m_surroundings = surroundings;
    m_ground = ground;
    m_reach = reach;
    m_brightest = colours.brightest;
    // Between ground and structure: neither of what is analysed nor of what it falls on.
    const Rgb& c = colours.grid;
    m_meshActor->GetProperty()->SetColor(c.r / 255.0, c.g / 255.0, c.b / 255.0);
    m_meshActor->GetProperty()->SetAmbient(colours.ambient);
    m_meshActor->GetProperty()->SetDiffuse(1.0 - colours.ambient);
}

void SiteLayer::drape(const Orthophoto& picture, const SiteSurface& ground, const Aabb& bounds, double reach, double brightest) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(picture.width, picture.height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    std::copy(picture.rgba.begin(), picture.rgba.end(), static_cast<std::uint8_t*>(image->GetScalarPointer()));
    dampen({static_cast<std::uint8_t*>(image->GetScalarPointer()), picture.rgba.size()}, brightest);
    m_texture->SetInputData(image);
    const Relief relief = ground.terrain ? reliefOf(*ground.terrain, bounds, reach) : levelRelief(picture, ground.levelHeight);
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkFloatArray> places;
    vtkNew<vtkUnsignedCharArray> light;
    places->SetNumberOfComponents(2);
    light->SetNumberOfComponents(3);
    for (std::size_t i = 0; i < relief.points.size(); ++i) {
        const Vec3& p = relief.points[i];
        points->InsertNextPoint(p.data());
        places->InsertNextTuple2((p.x() - picture.x0) / (picture.right() - picture.x0),
                                 (p.y() - picture.y0) / (picture.top() - picture.y0));
        // A picture has its own light; slopes only show a little more.
        const double shade = 255.0 * std::clamp(0.6 + 0.4 * relief.shade[i], 0.0, 1.0);
        light->InsertNextTuple3(shade, shade, shade);
    }
    for (const auto& triangle : relief.triangles) {
        const auto at = [&](std::size_t k) -> const Vec3& { return relief.points[static_cast<std::size_t>(triangle[k])]; };
        if (over(picture, at(0), at(1), at(2)) && seenFromAbove(at(0), at(1), at(2))) {
            const std::array<vtkIdType, 3> ids{triangle[0], triangle[1], triangle[2]};
            cells->InsertNextCell(3, ids.data());
        }
    }
    m_drape->SetPoints(points);
    m_drape->SetPolys(cells);
    m_drape->GetPointData()->SetTCoords(places);
    m_drape->GetPointData()->SetScalars(light);
    m_drape->Modified();
}

void SiteLayer::build(const std::vector<SiteMesh>& surroundings) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    for (const SiteMesh& mesh : surroundings) {
        const vtkIdType first = points->GetNumberOfPoints();
        for (const Vec3& p : mesh.points) {
            points->InsertNextPoint(p.data());
        }
        for (const auto& triangle : mesh.triangles) {
            const std::array<vtkIdType, 3> ids{first + triangle[0], first + triangle[1], first + triangle[2]};
            cells->InsertNextCell(3, ids.data());
        }
    }
    m_meshes->SetPoints(points);
    m_meshes->SetPolys(cells);
    m_meshes->Modified();
}

}  // namespace rubble::render
