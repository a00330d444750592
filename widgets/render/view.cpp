#include "widgets/render/view.h"

namespace rubble::render {

std::size_t cameraIndex(const View& view, PaneContent content) {
    return view.camerasLinked && content != PaneContent::Plan ? 0 : static_cast<std::size_t>(content);
}

const Camera& cameraOf(const View& view, PaneContent content) {
    return view.cameras[cameraIndex(view, content)];
}

Camera& cameraOf(View& view, PaneContent content) {
    return view.cameras[cameraIndex(view, content)];
}

}  // namespace rubble::render
