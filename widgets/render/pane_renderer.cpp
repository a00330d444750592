#include "widgets/render/pane_renderer.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkCullerCollection.h>
#include <vtkDataObject.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkLightsPass.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderPass.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkShaderProperty.h>
#include <vtkTranslucentPass.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "widgets/render/basics/sun.h"
#include "widgets/render/edge_shading.h"
#include "widgets/render/grain_shader.h"

namespace rubble::render {
namespace {

/// Keeps the triangles on the graphics side while only points move. VTK sends them anew whenever a point does, because a triangle
/// of coinciding points may then be left out; here none ever is, and the list is most of what a frame sends.
class SteadyTriangleMapper : public vtkOpenGLPolyDataMapper {
public:
    using Superclass = vtkOpenGLPolyDataMapper;
    static SteadyTriangleMapper* New() { VTK_STANDARD_NEW_BODY(SteadyTriangleMapper); }
    void ReleaseGraphicsResources(vtkWindow* window) override {
        m_sent = {};
        Superclass::ReleaseGraphicsResources(window);
    }

protected:
    void BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* data) override {
        const std::array<vtkMTimeType, 2> present{data->GetPolys()->GetMTime(), data->GetLines()->GetMTime()};
        if (present != m_sent) {
            m_sent = present;
            Superclass::BuildIBO(renderer, actor, data);
        }
    }

private:
    std::array<vtkMTimeType, 2> m_sent{};
};

/// Leaves out of the shading of opaque, dull surfaces what changes no pixel of them. VTK drops fragments without opacity after it
/// has shaded them, so what lies behind others cannot be left out before; and it reckons highlights, a power for each pixel, which
/// then count nothing.
void leaveOutIdleShading(vtkActor& actor) {
    actor.GetShaderProperty()->AddFragmentShaderReplacement("discard;", true, "", false);
    actor.GetShaderProperty()->AddFragmentShaderReplacement("specular += (sf * lightColor0);", false, "", true);
    actor.GetShaderProperty()->AddFragmentShaderReplacement("specular += (sf * lightColor1);", false, "", true);
}

vtkSmartPointer<vtkActor> modelActor(vtkPolyData* data) {
    vtkNew<SteadyTriangleMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetColorModeToDirectScalars();
    // The local frame keeps coordinates small; a scan of all points every frame to shift them would cost as much as moving them.
    mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->ForceOpaqueOn();  // else every frame scans all colours for transparent ones
    actor->GetProperty()->SetInterpolationToFlat();
    actor->GetProperty()->BackfaceCullingOn();
    actor->GetProperty()->SetSpecular(0.0);
    leaveOutIdleShading(*actor);
    return actor;
}

vtkSmartPointer<vtkCellArray> cells(const std::vector<std::int32_t>& connectivity, int corners) {
    const auto count = static_cast<vtkIdType>(connectivity.size()) / corners;
    vtkNew<vtkTypeInt32Array> offsets;
    offsets->SetNumberOfValues(count + 1);
    for (vtkIdType i = 0; i <= count; ++i) {
        offsets->SetValue(i, static_cast<std::int32_t>(i * corners));
    }
    vtkNew<vtkTypeInt32Array> points;
    points->SetNumberOfValues(static_cast<vtkIdType>(connectivity.size()));
    std::copy(connectivity.begin(), connectivity.end(), points->GetPointer(0));
    auto array = vtkSmartPointer<vtkCellArray>::New();
    array->SetData(offsets, points);
    return array;
}

/// Lamp without sun; both together. Beside the sun the lamp only keeps faces in the shade apart.
constexpr double lampAlone = 1.25;
constexpr double lampBesideSun = 0.5;
constexpr double sunlight = 0.9;
/// From the other side than lamp and sun: what neither reaches, such as the far sides of piers, still shows its shape.
constexpr double fillBesideSun = 0.35;

double channel(std::uint8_t value) {
    return value / 255.0;
}

/// Panes share a shader, and VTK sends it the lights of a pane only where they changed after those that it has: without this a
/// pane that is drawn once more is lit as the one beside it, which looks from another direction.
void sendLights(vtkObject* /*renderer*/, unsigned long /*event*/, void* light, void* /*call*/) {
    static_cast<vtkLight*>(light)->Modified();
}

}  // namespace

PaneRenderer::PaneRenderer()
    : m_renderer(vtkSmartPointer<vtkRenderer>::New()),
      m_lamp(vtkSmartPointer<vtkLight>::New()),
      m_sun(vtkSmartPointer<vtkLight>::New()),
      m_fill(vtkSmartPointer<vtkLight>::New()),
      m_points(vtkSmartPointer<vtkPoints>::New()),
      m_coordinates(vtkSmartPointer<vtkFloatArray>::New()),
      m_rgba(vtkSmartPointer<vtkUnsignedCharArray>::New()),
      m_model(vtkSmartPointer<vtkPolyData>::New()),
      m_selection(vtkSmartPointer<vtkPolyData>::New()),
      m_clipPlane(vtkSmartPointer<vtkPlane>::New()),
      m_grain(vtkSmartPointer<vtkFloatArray>::New()),
      m_pointShade(vtkSmartPointer<vtkFloatArray>::New()),
      m_edges(vtkSmartPointer<EdgeShading>::New()) {
    makeActors();
    m_renderer->AddActor(m_modelActor);
    m_renderer->AddActor(m_selectionActor);
    m_ground.addTo(*m_renderer);  // last: what the model covers is not shaded again
    m_site.addTo(*m_renderer);
    m_cloud.addTo(*m_renderer);
    m_water.addTo(*m_renderer);
    m_grid.addTo(*m_renderer);
    m_outline.addTo(*m_renderer);
    m_renderer->GetCullers()->RemoveAllItems();  // they ask every frame for the bounds of all points
    m_renderer->AutomaticLightCreationOff();
    // One lamp behind the viewer's left shoulder shows the three faces of a block in three tones.
    m_lamp->SetLightTypeToCameraLight();
    m_lamp->SetPosition(-0.55, 0.85, 1.0);
    m_lamp->SetFocalPoint(0.0, 0.0, 0.0);
    m_lamp->SetIntensity(lampAlone);
    m_renderer->AddLight(m_lamp);
    m_sun->SetLightTypeToSceneLight();
    m_sun->SetPosition(sun.x(), sun.y(), sun.z());
    m_sun->SetFocalPoint(0.0, 0.0, 0.0);
    m_sun->SetIntensity(sunlight);
    m_sun->SwitchOff();
    m_renderer->AddLight(m_sun);
    m_fill->SetLightTypeToCameraLight();
    m_fill->SetPosition(1.0, 0.1, 0.15);
    m_fill->SetFocalPoint(0.0, 0.0, 0.0);
    m_fill->SetIntensity(fillBesideSun);
    m_fill->SwitchOff();
    m_renderer->AddLight(m_fill);
    const auto before = vtkSmartPointer<vtkCallbackCommand>::New();
    before->SetCallback(sendLights);
    before->SetClientData(m_lamp);
    m_renderer->AddObserver(vtkCommand::StartEvent, before);
}

PaneRenderer::~PaneRenderer() = default;

void PaneRenderer::makeActors() {
    m_coordinates->SetNumberOfComponents(3);
    m_rgba->SetNumberOfComponents(4);
    m_grain->SetNumberOfComponents(4);
    m_grain->SetName("grain");
    m_pointShade->SetNumberOfComponents(1);
    m_pointShade->SetName("shade");
    m_points->SetData(m_coordinates);
    m_model->SetPoints(m_points);
    m_model->GetPointData()->SetScalars(m_rgba);
    m_selection->SetPoints(m_points);
    m_modelActor = modelActor(m_model);
    m_selectionActor = modelActor(m_selection);
    m_selectionActor->GetMapper()->ScalarVisibilityOff();
    m_selectionActor->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
    m_selectionActor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2.0, -2.0);
    m_modelActor->GetProperty()->SetLineWidth(2.0f);
}

void PaneRenderer::setColours(const SceneColours& colours, const Aabb& bounds, const SiteSurface& ground,
                              std::optional<double> waterLevel) {
    const auto& low = colours.skyHorizon;
    m_renderer->SetBackground(channel(low.r), channel(low.g), channel(low.b));
    for (vtkActor* actor : {m_modelActor.Get(), m_selectionActor.Get()}) {
        actor->GetProperty()->SetAmbient(colours.ambient);
        actor->GetProperty()->SetDiffuse(1.0 - colours.ambient);
    }
    m_grid.setColour(colours.selection);
    m_outline.setColour(colours.outline);
    m_selectionActor->GetProperty()->SetColor(channel(colours.selection.r), channel(colours.selection.g),
                                              channel(colours.selection.b));
    if (!bounds.isEmpty()) {
        m_ground.set(bounds, ground, colours);
        m_water.set(waterLevel, bounds, m_ground.reach(), colours);
    }
}

void PaneRenderer::setSite(const std::shared_ptr<const Orthophoto>& orthophoto,
                           const std::shared_ptr<const std::vector<SiteMesh>>& surroundings, const SiteSurface& ground,
                           const Aabb& bounds, const SceneColours& colours) {
    if (!bounds.isEmpty()) {
        m_site.set(orthophoto, surroundings, ground, bounds, m_ground.reach(), colours);
        m_ground.setGridOpacity(orthophoto != nullptr ? 0.3 : 1.0);
    }
}

void PaneRenderer::setGround(bool visible, bool grid) {
    m_ground.setVisible(visible, grid);
    m_site.setVisible(visible);
    m_water.setVisible(visible);
}

void PaneRenderer::setPoints(const std::shared_ptr<const SitePoints>& points, bool visible, bool simple) {
    constexpr std::uint64_t whileMoving = 300'000;
    m_cloud.set(points);
    m_cloud.show(visible, simple ? whileMoving : std::numeric_limits<std::uint64_t>::max());
}

void PaneRenderer::setClip(const std::optional<ClipPlane>& clip) {
    if (clip) {
        // VTK keeps what lies on the side of its plane's normal.
        const Vec3 kept = -clip->normal;
        m_clipPlane->SetOrigin(clip->point.data());
        m_clipPlane->SetNormal(kept.data());
    }
    if (clip.has_value() == m_clipped) {
        return;
    }
    m_clipped = clip.has_value();
    m_cloud.setClip(m_clipped ? m_clipPlane.Get() : nullptr);
    for (vtkActor* actor : {m_modelActor.Get(), m_selectionActor.Get()}) {
        actor->GetMapper()->RemoveAllClippingPlanes();
        if (m_clipped) {
            actor->GetMapper()->AddClippingPlane(m_clipPlane);
        }
    }
}

void PaneRenderer::setShading(bool shaded) {
    if (shaded == m_shaded) {
        return;
    }
    m_shaded = shaded;
    if (!shaded) {
        m_renderer->GetPass()->ReleaseGraphicsResources(m_renderer->GetVTKWindow());
        m_renderer->SetPass(nullptr);
        return;
    }
    vtkNew<vtkLightsPass> lights;
    vtkNew<vtkOpaquePass> opaque;
    vtkNew<vtkTranslucentPass> translucent;
    vtkNew<vtkRenderPassCollection> passes;
    passes->AddItem(lights);
    passes->AddItem(opaque);
    passes->AddItem(translucent);
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    vtkNew<vtkCameraPass> camera;
    camera->SetDelegatePass(sequence);
    m_edges->SetDelegatePass(camera);
    m_renderer->SetPass(m_edges);
}

void PaneRenderer::setShade(const GroundShade* shade, const SceneColours& colours) {
    m_ground.setShade(shade, colours);
    m_site.setShade(shade, colours);
    setPointShade(shade);
    m_sun->SetSwitch(shade != nullptr);
    m_fill->SetSwitch(shade != nullptr);
    m_lamp->SetIntensity(shade ? lampBesideSun : lampAlone);
}

void PaneRenderer::setOutline(const std::vector<Eigen::Vector3f>& ends) {
    m_outline.set(ends);
    m_outline.setVisible(true);
}

/// The grain of the presentation style: noise over the place at rest, which each point carries along.
void PaneRenderer::setGrain(const std::vector<float>& grain) {
    auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(m_modelActor->GetMapper());
    vtkShaderProperty* shader = m_modelActor->GetShaderProperty();
    if (!grain.empty()) {
        // VTK only reads these arrays; its interface has no const.
        m_grain->SetArray(const_cast<float*>(grain.data()), static_cast<vtkIdType>(grain.size()), 1);
        m_grain->Modified();
        m_model->GetPointData()->AddArray(m_grain);
    }
    if (grain.empty() == !m_grained) {
        return;
    }
    m_grained = !grain.empty();
    if (!m_grained) {
        mapper->RemoveVertexAttributeMapping("grainMC");
        mapper->RemoveVertexAttributeMapping("shadeMC");
        shader->ClearAllShaderReplacements();
        leaveOutIdleShading(*m_modelActor);
        m_model->GetPointData()->RemoveArray(m_grain->GetName());
        m_model->GetPointData()->RemoveArray(m_pointShade->GetName());
        return;
    }
    mapper->MapDataArrayToVertexAttribute("grainMC", m_grain->GetName(), vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
    mapper->MapDataArrayToVertexAttribute("shadeMC", m_pointShade->GetName(), vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
    m_model->GetPointData()->AddArray(m_pointShade);
    shader->AddVertexShaderReplacement("//VTK::Color::Dec", true, grain_shader::vertexDeclaration, false);
    shader->AddVertexShaderReplacement("//VTK::Color::Impl", true, grain_shader::vertex, false);
    shader->AddFragmentShaderReplacement("//VTK::Color::Dec", true, grain_shader::fragmentDeclaration(), false);
    shader->AddFragmentShaderReplacement("//VTK::Color::Impl", true, grain_shader::fragment, false);
}

/// Of the points that are shown; they are in full light where it is that of others, as before the first shade.
void PaneRenderer::setPointShade(const GroundShade* shade) {
    const vtkIdType points = m_coordinates->GetNumberOfTuples();
    const std::uint64_t version = shade != nullptr ? shade->version() : 0;
    if (points == m_pointShade->GetNumberOfTuples() && shade == m_pointShadeOf && version == m_pointShadeVersion) {
        return;
    }
    m_pointShadeOf = shade;
    m_pointShadeVersion = version;
    m_pointShade->SetNumberOfTuples(points);
    if (shade != nullptr && static_cast<vtkIdType>(shade->pointShade().size()) == points) {
        std::copy(shade->pointShade().begin(), shade->pointShade().end(), m_pointShade->GetPointer(0));
    } else {
        m_pointShade->Fill(0.0);
    }
    m_pointShade->Modified();
    m_model->Modified();
}

void PaneRenderer::setGrid(const std::vector<Eigen::Vector3f>& ends) {
    m_grid.set(ends);
    m_grid.setVisible(true);
}

void PaneRenderer::setTriangles(const PaneGeometry& geometry) {
    m_model->SetPolys(cells(geometry.triangles(), 3));
    m_model->SetLines(cells(geometry.lines(), 2));
    m_trianglesVersion = geometry.trianglesVersion();
}

void PaneRenderer::show(const PaneGeometry* geometry) {
    const bool other = geometry != m_shown;
    m_shown = geometry;
    m_modelActor->SetVisibility(geometry != nullptr && !geometry->points().empty());
    m_selectionActor->SetVisibility(geometry != nullptr && !geometry->selected().empty());
    if (!geometry || geometry->points().empty()) {
        return;
    }
    if (other || geometry->pointsVersion() != m_pointsVersion) {
        m_pointsVersion = geometry->pointsVersion();
        // VTK only reads these arrays; its interface has no const.
        m_coordinates->SetArray(const_cast<float*>(geometry->points().data()), static_cast<vtkIdType>(geometry->points().size()),
                                1);
        m_coordinates->Modified();
        m_points->Modified();
        m_model->Modified();
    }
    if (other || geometry->coloursVersion() != m_coloursVersion) {
        m_coloursVersion = geometry->coloursVersion();
        m_rgba->SetArray(const_cast<std::uint8_t*>(geometry->colours().data()), static_cast<vtkIdType>(geometry->colours().size()),
                         1);
        m_rgba->Modified();
        setGrain(geometry->grain());
        m_model->Modified();
    }
    if (other || geometry->trianglesVersion() != m_trianglesVersion) {
        setTriangles(*geometry);
    }
    if (other || geometry->selectionVersion() != m_selectionVersion) {
        m_selectionVersion = geometry->selectionVersion();
        m_selection->SetPolys(cells(geometry->selected(), 3));
    }
    m_selection->Modified();
}

void PaneRenderer::place(const Pane& pane, int width, int height) {
    const double w = std::max(width, 1);
    const double h = std::max(height, 1);
    m_renderer->SetViewport(pane.x / w, 1.0 - (pane.y + pane.height) / h, (pane.x + pane.width) / w, 1.0 - pane.y / h);
}

namespace {

/// How far along the view level ground comes into the picture from below, m; infinite where it does not.
double groundBegins(const Camera& camera, double groundHeight) {
    const Vec3 ahead = (camera.focalPoint - camera.position).normalized();
    const Vec3 right = ahead.cross(camera.up);
    const Vec3 up = right.norm() > 0.0 ? Vec3(right.cross(ahead).normalized()) : camera.up;
    const double halfAngle = 0.5 * camera.viewAngle * std::numbers::pi / 180.0;
    const double fall = std::tan(halfAngle) * up.z() - ahead.z();
    const double height = camera.position.z() - groundHeight;
    return fall > 0.0 && height > 0.0 ? height / fall : std::numeric_limits<double>::infinity();
}

}  // namespace

void PaneRenderer::look(const Camera& camera, const Aabb& bounds) {
    vtkCamera* target = m_renderer->GetActiveCamera();
    target->SetPosition(camera.position.data());
    target->SetFocalPoint(camera.focalPoint.data());
    target->SetViewUp(camera.up.data());
    target->SetViewAngle(camera.viewAngle);
    target->SetParallelProjection(camera.parallel);
    target->SetParallelScale(camera.parallelScale);
    // Set by hand: asking VTK would scan all points every frame.
    const Vec3 centre = bounds.isEmpty() ? camera.focalPoint : bounds.center();
    const double size = bounds.isEmpty() ? 1.0 : bounds.sizes().norm();
    const double away = (centre - camera.position).norm();
    const double distance = (camera.focalPoint - camera.position).norm();
    const double far = 1.02 * away + std::max(7.0 * m_ground.reach(), 3.0 * size);
    // From far off ground begins before what stands on it: a tall picture would be cut there.
    const double begins = std::min(away - 2.0 * size, 0.9 * groundBegins(camera, bounds.isEmpty() ? 0.0 : bounds.min().z()));
    const double near = camera.parallel ? away - far : std::max({0.02 * distance, begins, 1e-4 * far});
    target->SetClippingRange(near, far);
    m_edges->setFading(away + 0.5 * size, away + 1.5 * size);
}

}  // namespace rubble::render
