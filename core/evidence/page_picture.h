#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/message.h"

namespace rubble {

/// What a picture of a page shows.
enum class PagePictureKind : std::uint8_t { Views, Map, Photograph, Ground };

/// px, of the longer side of the picture of the ground that a page carries.
inline constexpr int pageGroundPixels = 2048;

/// A picture that a page of a run carries: of the views at an instant, of the debris map, a photograph with what was drawn on it,
/// the orthophoto that its views lay on the ground.
struct PagePicture {
    PagePictureKind kind = PagePictureKind::Views;
    double time = 0.0;                ///< s, of the views
    std::string name;                 ///< of a photograph: its file
    std::string type;                 ///< "image/png"
    std::string bytes;                ///< of the file
    Message note;                     ///< beside a photograph: how far it agrees, or why it was not compared; empty: nothing to say
    std::vector<Message> cautions{};  ///< what must be known beside the note
};

}  // namespace rubble
