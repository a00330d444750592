#include "widgets/figures/offscreen_view.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include "widgets/figures/palette.h"
#include "widgets/figures/x_display.h"
#include "widgets/render/basics/camera.h"

namespace rubble::figures {

namespace {

constexpr double turnEachFrame = 0.002;  // radians
constexpr std::int64_t framesOfATurn = 50;

}  // namespace

struct OffscreenView::Impl {
    vtkNew<vtkRenderWindow> window;
    render::Scene scene;
    render::View view;
    render::Camera home;
    int width = 0;
    int height = 0;
    std::int64_t frame = 0;
};

OffscreenView::OffscreenView(const render::SceneData& data, int width, int height) {
    requireDisplay();
    m_impl = std::make_unique<Impl>();
    m_impl->width = width;
    m_impl->height = height;
    m_impl->window->SetOffScreenRendering(1);
    m_impl->window->SetMultiSamples(0);
    m_impl->window->SetSize(width, height);
    m_impl->scene.attach(*m_impl->window);
    m_impl->scene.setData(data);
    m_impl->scene.setColours(sceneColours(render::Theme::Light));
    m_impl->view = render::defaultView(data, width, height);
    m_impl->home = m_impl->view.cameras[0];
}

OffscreenView::~OffscreenView() = default;

void OffscreenView::draw(double time) {
    m_impl->view.time = time;
    m_impl->view.cameras[0] =
        render::orbit(m_impl->home, turnEachFrame * static_cast<double>(++m_impl->frame % framesOfATurn), 0.0);
    m_impl->scene.update(m_impl->view, m_impl->width, m_impl->height);
    m_impl->window->Render();
    m_impl->window->WaitForCompletion();
}

const render::PaneStatus& OffscreenView::status(render::PaneContent content) const {
    return m_impl->scene.status(content);
}

std::string OffscreenView::renderer() const {
    const char* capabilities = m_impl->window->ReportCapabilities();
    const std::string text = capabilities ? capabilities : "";
    const std::string label = "OpenGL renderer string:";
    const std::size_t from = text.find(label);
    if (from == std::string::npos) {
        return {};
    }
    const std::size_t begin = text.find_first_not_of(' ', from + label.size());
    return begin == std::string::npos ? std::string() : text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace rubble::figures
