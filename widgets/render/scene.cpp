#include "widgets/render/scene.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <limits>

#include "core/base/standard_gravity.h"
#include "core/clusters/grid_outline.h"
#include "widgets/render/basics/camera.h"
#include "widgets/render/pane_geometry.h"
#include "widgets/render/pane_renderer.h"
#include "widgets/render/shapes/intact_outline.h"
#include "widgets/render/site/ground_shade.h"
#include "widgets/render/site/relief.h"

namespace rubble::render {
namespace {

/// Geometries that panes show: the FE result, the fragments, the fragments of another scenario.
constexpr std::size_t geometryCount = 3;

/// Share of light that the unevenness of earth takes at most.
constexpr double earthTexture = 0.09;

std::size_t indexOf(PaneContent content) {
    return content == PaneContent::Fe ? 0 : content == PaneContent::Other ? 2 : 1;
}

std::size_t rendererOf(PaneContent content) {
    return static_cast<std::size_t>(content);
}

SiteSurface groundOf(const SceneData& data) {
    return {true, data.groundHeight, data.terrain};
}

/// Lowest ground below the model, m.
double lowestBelow(const SceneData& data, const Aabb& bounds) {
    const SiteSurface ground = groundOf(data);
    constexpr int samples = 32;
    double lowest = ground.height(bounds.min().x(), bounds.min().y());
    for (int i = 0; ground.terrain && i <= samples * samples; ++i) {
        const Vec3 share(static_cast<double>(i % samples) / (samples - 1), static_cast<double>(i / samples) / samples, 0.0);
        const Vec3 p = bounds.min() + share.cwiseProduct(bounds.sizes());
        lowest = std::min(lowest, ground.height(p.x(), p.y()));
    }
    return lowest;
}

/// The next of a row of round numbers, at least the value.
double roundedUp(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 10.0}) {
        if (value <= step * power) {
            return step * power;
        }
    }
    return 10.0 * power;
}

/// True if the FE pane looks the same with either.
bool sameStructure(const SceneData& a, const SceneData& b) {
    return a.fe == b.fe && a.components == b.components && a.loose == b.loose && a.groundHeight == b.groundHeight;
}

}  // namespace

Aabb boundsOf(const SceneData& data) {
    Aabb bounds;
    if (!data.fe) {
        return bounds;
    }
    for (const Vec3& node : data.fe->mesh().nodes) {
        bounds.extend(node);
    }
    if (!bounds.isEmpty()) {
        bounds.min().z() = std::min(bounds.min().z(), lowestBelow(data, bounds));
    }
    return bounds;
}

struct Scene::Impl {
    SceneData data;
    SceneData other;
    std::string otherScenario;
    bool allFaces = false;
    bool simplified = false;
    double resolution = 1.0;  ///< while simplified
    Aabb bounds;
    ColourScale scale;
    bool coloursChanged = true;
    vtkRenderWindow* window = nullptr;
    vtkSmartPointer<vtkRenderer> backdrop;             ///< colours what lies between the panes
    std::array<PaneRenderer, paneContents> renderers;  ///< by content
    std::shared_ptr<StateReadAhead> states;            ///< of the FE result, for all panes
    bool shownSimply = false;                          ///< the last update asked for less than full detail
    std::array<std::unique_ptr<PaneGeometry>, geometryCount> geometries;
    std::array<PaneStatus, geometryCount> statuses;
    std::array<GroundShade, geometryCount> shades;
    std::array<std::pair<std::uint64_t, std::uint64_t>, geometryCount> shadeOf{};  ///< versions of points and triangles
    SceneColours shownColours;                                                     ///< as the style has them
    std::optional<std::array<double, 3>> gridShown;
    std::vector<std::uint8_t> hidden;  ///< by element, or empty
    std::vector<std::string> hiddenComponents;
    std::vector<ElementIndex> hiddenElements;
    bool outlined = false;  ///< the intact structure's outline is made
    View view;
    int width = 1;
    int height = 1;

    void settleScale() {
        bounds = boundsOf(data);
        const double height_ = bounds.isEmpty() ? 0.0 : bounds.sizes().z();
        scale.speedTop = height_ > 0 ? roundedUp(std::sqrt(2.0 * standardGravity * height_)) : 1.0;
        scale.firstBirth = scale.lastBirth = 0.0;
        if (data.fragments && data.fragments->size() > 0) {
            const auto [first, last] =
                std::minmax_element(data.fragments->list.begin(), data.fragments->list.end(),
                                    [](const Fragment& a, const Fragment& b) { return a.birthTime < b.birthTime; });
            scale.firstBirth = first->birthTime;
            scale.lastBirth = last->birthTime;
        }
    }

    const SceneData& of(PaneContent content) const { return content == PaneContent::Other && other.fe ? other : data; }

    /// Colours with the ground of the style.
    SceneColours coloursOfStyle() const {
        SceneColours colours = scale.colours;
        if (view.style == Style::Presentation) {
            colours.ground = colours.earth;
            colours.groundTexture = std::max(colours.groundTexture, earthTexture);
        }
        return colours;
    }

    void applyColours() {
        shownColours = coloursOfStyle();
        for (std::size_t i = 0; i < geometryCount; ++i) {
            shades[i].set(bounds, groundOf(i == indexOf(PaneContent::Other) ? of(PaneContent::Other) : data));
            shadeOf[i] = {};
        }
        for (std::size_t i = 0; i < renderers.size(); ++i) {
            const SceneData& shown = of(static_cast<PaneContent>(i));
            const bool fragments = i != rendererOf(PaneContent::Fe);
            renderers[i].setColours(shownColours, bounds, groundOf(shown), fragments ? shown.waterLevel : std::nullopt);
            renderers[i].setSite(shown.orthophoto, shown.surroundings, groundOf(shown), bounds, shownColours);
        }
        const Rgb& c = scale.colours.divider;
        backdrop->SetBackground(c.r / 255.0, c.g / 255.0, c.b / 255.0);
        coloursChanged = false;
    }

    Ray rayAt(const Pane& pane, int x, int y) const {
        return rayThrough(cameraOf(view, pane.content), (x + 0.5 - pane.x) / pane.width, (y + 0.5 - pane.y) / pane.height,
                          pane.aspect());
    }

    /// Along a ray to the ground, m; negative behind it, not finite for a level ray.
    double groundDistance(const Ray& ray) const {
        if (!data.terrain) {
            return (data.groundHeight - ray.origin.z()) / ray.direction.z();
        }
        const double reach = (ray.origin - bounds.center()).norm() + 20.0 * bounds.sizes().norm();
        return meetTerrain(*data.terrain, ray, reach).value_or(std::numeric_limits<double>::infinity());
    }

    void drop(std::size_t geometry) {
        for (std::size_t i = 0; i < renderers.size(); ++i) {
            if (indexOf(static_cast<PaneContent>(i)) == geometry) {
                renderers[i].show(nullptr);
            }
        }
        geometries[geometry].reset();
        shades[geometry].clear();
        shadeOf[geometry] = {};
        statuses[geometry] = {};
    }

    /// Settles which elements are left out; resolving names takes place only when they have changed.
    void settleHidden() {
        if (view.hiddenComponents == hiddenComponents && view.hidden == hiddenElements) {
            return;
        }
        hiddenComponents = view.hiddenComponents;
        hiddenElements = view.hidden;
        resolveHidden();
        outlined = false;
    }

    void resolveHidden() {
        hidden.clear();
        if (!data.fe || (hiddenComponents.empty() && hiddenElements.empty())) {
            return;
        }
        hidden.assign(data.fe->mesh().elementCount(), 0);
        for (const ElementIndex element : hiddenElements) {
            if (at(element) < hidden.size()) {
                hidden[at(element)] = 1;
            }
        }
        for (std::size_t c = 0; data.components && c < data.components->list.size(); ++c) {
            const Component& component = data.components->list[c];
            if (std::find(hiddenComponents.begin(), hiddenComponents.end(), component.name) != hiddenComponents.end()) {
                for (const ElementIndex element : component.elements) {
                    hidden[at(element)] = 1;
                }
            }
        }
    }

    void showOutline() {
        if (!outlined && data.fe) {
            renderers[rendererOf(PaneContent::Overlay)].setOutline(intactOutline(*data.fe, hidden));
            outlined = true;
        }
    }

    /// The Basic Grid over the fragments, made anew only when it is another.
    void showGrid() {
        PaneRenderer& renderer = renderers[rendererOf(PaneContent::Fragments)];
        if (view.basicGrid != gridShown) {
            gridShown = view.basicGrid;
            const bool drawn = gridShown && data.fragments;
            renderer.setGrid(drawn ? gridOutline(*data.fragments, *gridShown) : std::vector<Eigen::Vector3f>());
        }
    }

    /// Brings the shade on the ground and on itself to what a geometry shows.
    void shade(std::size_t geometry) {
        const PaneGeometry& shown = *geometries[geometry];
        const std::pair versions(shown.pointsVersion(), shown.trianglesVersion());
        if (view.shadows && versions != shadeOf[geometry]) {
            shades[geometry].bake(shown.points(), shown.triangles());
            shadeOf[geometry] = versions;
        }
    }

    void update(bool simple);
    void updateGeometries(const std::vector<Pane>& panes, bool simple);

    /// Brings a picture that is simplified to full detail.
    void settle() {
        if (shownSimply) {
            update(false);
        }
    }

    PaneGeometry* geometryFor(PaneContent content, bool simple) {
        auto& geometry = geometries[indexOf(content)];
        const SceneData& shown = content == PaneContent::Other ? other : data;
        if (!geometry && shown.fe) {
            if (!states || states->fe() != shown.fe) {
                states = std::make_shared<StateReadAhead>(shown.fe);
            }
            geometry = std::make_unique<PaneGeometry>(indexOf(content) == 0 ? PaneContent::Fe : PaneContent::Fragments, shown,
                                                      allFaces, states);
        }
        if (geometry) {
            geometry->setHidden(hidden);
            geometry->setClip(view.clip);
            geometry->setFilter(view.filter);
            geometry->setSimplified(simple);
        }
        return geometry.get();
    }
};

Scene::Scene() : m_impl(std::make_unique<Impl>()) {
    m_impl->backdrop = vtkSmartPointer<vtkRenderer>::New();
}

Scene::~Scene() {
    if (m_impl->window) {
        detach();
    }
}

void Scene::attach(vtkRenderWindow& window) {
    if (m_impl->window) {
        detach();
    }
    m_impl->window = &window;
    window.AddRenderer(m_impl->backdrop);
    for (PaneRenderer& pane : m_impl->renderers) {
        window.AddRenderer(&pane.renderer());
    }
}

void Scene::detach() {
    if (!m_impl->window) {
        return;
    }
    for (PaneRenderer& pane : m_impl->renderers) {
        pane.renderer().ReleaseGraphicsResources(m_impl->window);
        m_impl->window->RemoveRenderer(&pane.renderer());
    }
    m_impl->backdrop->ReleaseGraphicsResources(m_impl->window);
    m_impl->window->RemoveRenderer(m_impl->backdrop);
    m_impl->window = nullptr;
}

void Scene::setData(const SceneData& data) {
    if (data == m_impl->data) {
        return;
    }
    SceneData other = m_impl->data;
    other.points = data.points;
    if (data == other) {
        m_impl->data = std::move(other);  // nothing else is made anew for them
        return;
    }
    if (!sameStructure(data, m_impl->data)) {
        m_impl->drop(0);
    }
    if (data.fe != m_impl->data.fe) {
        m_impl->states.reset();
        m_impl->drop(2);
        m_impl->other = {};
    }
    m_impl->drop(1);
    m_impl->gridShown.reset();
    m_impl->renderers[rendererOf(PaneContent::Fragments)].setGrid({});
    m_impl->renderers[rendererOf(PaneContent::Overlay)].setOutline({});
    m_impl->outlined = false;
    m_impl->data = data;
    m_impl->resolveHidden();
    m_impl->settleScale();
    m_impl->coloursChanged = true;
}

const SceneData& Scene::data() const {
    return m_impl->data;
}

void Scene::setOther(const SceneData& data, const std::string& scenario) {
    m_impl->otherScenario = scenario;
    if (!(data == m_impl->other)) {
        m_impl->drop(2);
        m_impl->other = data;
        m_impl->coloursChanged = true;
    }
}

const SceneData& Scene::dataOf(PaneContent content) const {
    return content == PaneContent::Other ? m_impl->other : m_impl->data;
}

const std::string& Scene::otherScenario() const {
    return m_impl->otherScenario;
}

void Scene::setColours(const SceneColours& colours) {
    if (!(colours == m_impl->scale.colours)) {
        m_impl->scale.colours = colours;
        m_impl->coloursChanged = true;
    }
}

void Scene::setAllFaces(bool all) {
    if (all != m_impl->allFaces) {
        m_impl->allFaces = all;
        for (std::size_t geometry = 0; geometry < geometryCount; ++geometry) {
            m_impl->drop(geometry);
        }
    }
}

void Scene::setSimplified(bool simplified, double resolution) {
    m_impl->simplified = simplified;
    m_impl->resolution = simplified ? resolution : 1.0;
}

double Scene::resolution() const {
    return m_impl->resolution;
}

void Scene::update(const View& view, int width, int height) {
    m_impl->view = view;
    m_impl->width = width;
    m_impl->height = height;
    m_impl->update(m_impl->simplified);
}

/// Brings what panes show to the view, each geometry on a thread of its own: they share nothing that changes but the states'
/// source.
void Scene::Impl::updateGeometries(const std::vector<Pane>& panes, bool simple) {
    std::array<PaneGeometry*, geometryCount> shown{};
    for (const Pane& pane : panes) {
        shown[indexOf(pane.content)] = geometryFor(pane.content, simple);
    }
    std::vector<std::future<void>> others;
    for (auto geometry = shown.begin(); geometry != shown.end(); ++geometry) {
        const auto bring = [&, own = *geometry, index = static_cast<std::size_t>(geometry - shown.begin())] {
            own->update(view.time, view.colourBy, scale, view.selection);
            shade(index);
        };
        const bool last = std::all_of(geometry + 1, shown.end(), [](const PaneGeometry* later) { return later == nullptr; });
        if (*geometry && !last) {
            others.push_back(std::async(std::launch::async, bring));
        } else if (*geometry) {
            bring();
        }
    }
    for (std::future<void>& brought : others) {
        brought.get();
    }
    for (std::size_t i = 0; i < geometryCount; ++i) {
        if (shown[i]) {
            statuses[i] = shown[i]->status();
            statuses[i].resolution = simple ? resolution : 1.0;
        }
    }
}

void Scene::Impl::update(bool simple) {
    shownSimply = simple;
    if (coloursChanged || view.style != scale.style) {
        applyColours();
    }
    scale.errorSteps = view.errorSteps;
    scale.style = view.style;
    scale.componentColours = view.componentColours;
    settleHidden();
    showGrid();
    for (PaneRenderer& renderer : renderers) {
        renderer.renderer().DrawOff();
    }
    const std::vector<Pane> panes = panesOf(view.layout, width, height);
    updateGeometries(panes, simple);
    for (const Pane& pane : panes) {
        PaneRenderer& renderer = renderers[rendererOf(pane.content)];
        const PaneGeometry* geometry = geometries[indexOf(pane.content)].get();
        renderer.renderer().DrawOn();
        renderer.show(geometry);
        if (pane.content == PaneContent::Overlay) {
            showOutline();
        }
        renderer.setClip(view.clip);
        renderer.setShading(view.shading);
        renderer.setShade(view.shadows && geometry ? &shades[indexOf(pane.content)] : nullptr, shownColours);
        renderer.setGround(view.ground && geometry, view.groundGrid);
        renderer.setPoints(data.points, !view.cloud.empty() && geometry != nullptr, simple);
        renderer.place(pane, width, height);
        renderer.look(cameraOf(view, pane.content), bounds);
    }
}

const PaneStatus& Scene::status(PaneContent content) const {
    return m_impl->statuses[indexOf(content)];
}

std::optional<Pick> Scene::pick(int x, int y) const {
    const auto pane = paneAt(m_impl->view.layout, m_impl->width, m_impl->height, x, y);
    if (!pane || !m_impl->geometries[indexOf(pane->content)]) {
        return std::nullopt;
    }
    m_impl->settle();
    const Ray ray = m_impl->rayAt(*pane, x, y);
    auto hit = m_impl->geometries[indexOf(pane->content)]->cast(ray);
    // Seen from above, the ground hides what lies below it.
    const double ground = m_impl->groundDistance(ray);
    if (hit && m_impl->view.ground && ray.direction.z() < 0 && ground > 0 && (hit->position - ray.origin).norm() > ground) {
        return std::nullopt;
    }
    if (hit) {
        hit->pane = pane->content;
    }
    return hit;
}

std::vector<ElementIndex> Scene::elementsIn(const Pane& pane, int left, int top, int right, int bottom) const {
    const Camera& camera = cameraOf(m_impl->view, pane.content);
    return elementsWhere(pane.content, [&](const Vec3& centre) {
        const auto place = project(camera, centre, pane.aspect());
        const double x = place ? pane.x + place->u * pane.width : -1.0;
        const double y = place ? pane.y + place->v * pane.height : -1.0;
        return place && pane.contains(static_cast<int>(x), static_cast<int>(y)) && left <= x && x <= right && top <= y &&
               y <= bottom;
    });
}

std::vector<ElementIndex> Scene::elementsWhere(PaneContent content, const std::function<bool(const Vec3&)>& inside) const {
    m_impl->settle();
    const auto& geometry = m_impl->geometries[indexOf(content)];
    return geometry ? geometry->elementsWhere(inside) : std::vector<ElementIndex>();
}

std::vector<Vec3> Scene::shownPoints(PaneContent content) const {
    m_impl->settle();
    const auto& geometry = m_impl->geometries[indexOf(content)];
    std::vector<Vec3> shown;
    if (geometry) {
        const std::vector<float>& points = geometry->points();
        std::vector<bool> drawn(points.size() / 3);
        for (const std::vector<std::int32_t>* corners : {&geometry->triangles(), &geometry->lines()}) {
            for (const std::int32_t corner : *corners) {
                const auto i = static_cast<std::size_t>(corner);
                if (!drawn[i]) {
                    drawn[i] = true;
                    shown.emplace_back(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
                }
            }
        }
    }
    return shown;
}

std::vector<bool> Scene::covered(const Pane& pane, std::span<const std::array<double, 4>> rectangles) const {
    std::vector<bool> found(rectangles.size(), false);
    m_impl->settle();
    const auto& geometry = m_impl->geometries[indexOf(pane.content)];
    if (!geometry) {
        return found;
    }
    const Camera& camera = cameraOf(m_impl->view, pane.content);
    const std::vector<float>& points = geometry->points();
    std::vector<std::optional<Projected>> places;
    for (std::size_t i = 0; 3 * i + 2 < points.size(); ++i) {
        places.push_back(project(camera, Vec3(points[3 * i], points[3 * i + 1], points[3 * i + 2]), pane.aspect()));
    }
    const auto take = [&](const std::vector<std::int32_t>& corners, std::size_t each) {
        for (std::size_t t = 0; t + each <= corners.size(); t += each) {
            Eigen::AlignedBox2d face;
            for (std::size_t k = 0; k < each; ++k) {
                if (const auto& place = places[static_cast<std::size_t>(corners[t + k])]) {
                    face.extend(Eigen::Vector2d(pane.x + place->u * pane.width, pane.y + place->v * pane.height));
                }
            }
            for (std::size_t r = 0; r < rectangles.size() && !face.isEmpty(); ++r) {
                const auto& [left, top, right, bottom] = rectangles[r];
                found[r] =
                    found[r] || face.intersects(Eigen::AlignedBox2d(Eigen::Vector2d(left, top), Eigen::Vector2d(right, bottom)));
            }
        }
    };
    take(geometry->triangles(), 3);
    take(geometry->lines(), 2);
    return found;
}

std::optional<Vec3> Scene::groundAt(int x, int y) const {
    const auto pane = paneAt(m_impl->view.layout, m_impl->width, m_impl->height, x, y);
    if (!pane || m_impl->bounds.isEmpty()) {
        return std::nullopt;
    }
    const Ray ray = m_impl->rayAt(*pane, x, y);
    const double distance = m_impl->groundDistance(ray);
    if (!std::isfinite(distance) || distance <= 0) {
        return std::nullopt;
    }
    return ray.origin + distance * ray.direction;
}

Aabb Scene::bounds() const {
    return m_impl->bounds;
}

double Scene::speedTop() const {
    return m_impl->scale.speedTop;
}

std::pair<double, double> Scene::birthSpan() const {
    return {m_impl->scale.firstBirth, m_impl->scale.lastBirth};
}

View defaultView(const SceneData& data, int width, int height, std::optional<Layout> layout) {
    View view;
    const Aabb bounds = boundsOf(data);
    view.layout = layout ? *layout : suggestLayout(bounds, width, height);
    const Pane pane = panesOf(view.layout, width, height).front();
    view.cameras.fill(fitCamera(bounds, pane.aspect()));
    cameraOf(view, PaneContent::Plan) =
        refit(withProjection(fitCamera(bounds, pane.aspect(), Preset::Top), true), bounds, pane.aspect());
    view.time = data.fe ? data.fe->times().front() : 0.0;
    return view;
}

}  // namespace rubble::render
