#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/evidence/page_picture.h"
#include "core/evidence/report_facts.h"
#include "core/fe/orthophoto.h"
#include "core/scenario/case.h"
#include "widgets/figures/map_picture.h"
#include "widgets/render/basics/scene_data.h"

namespace rubble::figures {

/// What the pictures of a page are drawn from.
struct PageDrawing {
    std::vector<double> times;       ///< s, of the views
    const DebrisMap* map = nullptr;  ///< null: none
    MapPictureStyle mapStyle;        ///< place and coordinate system; cautions, of the views too
    std::span<const ReportPhoto> photographs;
};

/// Instants at which a page shows the views where a browser cannot: first and last one, end of the FE result, bookmarks; few.
std::vector<double> pageTimes(const render::SceneData& data, const std::vector<Bookmark>& bookmarks);

/// An orthophoto as a page carries it, north up, with fewer pixels where it has more than a page takes.
PagePicture groundPicture(const Orthophoto& orthophoto);

/// Draws them off screen. Call ensureGuiApplication() first. Throws what a Studio throws, and Cancelled.
std::vector<PagePicture> drawPagePictures(const render::SceneData& data, const PageDrawing& drawing, const Execution& execution);

}  // namespace rubble::figures
