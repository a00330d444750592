#include "widgets/render/view.h"

namespace rubble::render {

const Camera& cameraOf(const View& view, PaneContent content) {
    return view.cameras[view.camerasLinked || content == PaneContent::Fe ? 0 : 1];
}

Camera& cameraOf(View& view, PaneContent content) {
    return view.cameras[view.camerasLinked || content == PaneContent::Fe ? 0 : 1];
}

}  // namespace rubble::render
