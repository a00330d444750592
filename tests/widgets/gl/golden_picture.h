#pragma once

#include <QImage>

#include <string>

namespace rubble::figures {

/// How a picture departs from its reference. A pixel is off when one of its colours lies more than 40 of 255 outside the range of
/// the pixel of the reference there and the eight that touch it, or the other way round: an edge that is rasterised or smoothed
/// otherwise moves by less than a pixel and is never off, while a line, a letter or a patch of colour too many or too few is.
struct PictureDifference {
    bool sameSize = false;
    double share = 1.0;  ///< of all pixels, that are off
    QImage marked;       ///< the picture pale, with what is off in red
};
PictureDifference differenceOf(const QImage& actual, const QImage& expected);

/// The share of pixels that may be off: 60 of a figure of 640 x 400, less than one word, one square of a legend or one arrow.
inline constexpr double mostOff = 60.0 / (640.0 * 400.0);

/// Holds a picture against tests/widgets/gl/golden/NAME.png. Where they differ the picture is written to golden/NAME.actual.png in
/// the build folder, with what is off in NAME.off.png. With RUBBLE_RENEW_GOLDEN set the picture becomes the reference instead.
void expectGolden(const QImage& actual, const std::string& name);

}  // namespace rubble::figures
