#include "widgets/render/basics/view.h"

namespace rubble::render {

std::size_t cameraIndex(const View& view, PaneContent content) {
    const PaneContent seenAs = content == PaneContent::Other ? PaneContent::Fragments : content;
    return view.camerasLinked && seenAs != PaneContent::Plan ? 0 : static_cast<std::size_t>(seenAs);
}

const Camera& cameraOf(const View& view, PaneContent content) {
    return view.cameras[cameraIndex(view, content)];
}

Camera& cameraOf(View& view, PaneContent content) {
    return view.cameras[cameraIndex(view, content)];
}

}  // namespace rubble::render
