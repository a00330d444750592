#include "tests/widgets/gl/golden_picture.h"
#include "tests/support/places.h"

#include <gtest/gtest.h>

#include <QDir>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace rubble::figures {
namespace {

constexpr int tolerance = 40;  // of 255

/// Whether a colour lies, channel by channel, between those of a picture at a place and its eight neighbours.
bool occurs(QRgb colour, const QImage& picture, int x, int y) {
    const std::array<int, 3> channels{qRed(colour), qGreen(colour), qBlue(colour)};
    std::array<int, 3> least{255, 255, 255}, most{0, 0, 0};
    for (int j = std::max(0, y - 1); j <= std::min(picture.height() - 1, y + 1); ++j) {
        for (int i = std::max(0, x - 1); i <= std::min(picture.width() - 1, x + 1); ++i) {
            const QRgb there = picture.pixel(i, j);
            const std::array<int, 3> of{qRed(there), qGreen(there), qBlue(there)};
            for (std::size_t c = 0; c < 3; ++c) {
                least[c] = std::min(least[c], of[c]);
                most[c] = std::max(most[c], of[c]);
            }
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        if (channels[c] < least[c] - tolerance || channels[c] > most[c] + tolerance) {
            return false;
        }
    }
    return true;
}

}  // namespace

PictureDifference differenceOf(const QImage& actual, const QImage& expected) {
    PictureDifference made;
    made.sameSize = actual.size() == expected.size();
    if (!made.sameSize) {
        return made;
    }
    made.marked = actual.convertToFormat(QImage::Format_RGB32);
    int off = 0;
    for (int y = 0; y < actual.height(); ++y) {
        for (int x = 0; x < actual.width(); ++x) {
            const bool same = occurs(actual.pixel(x, y), expected, x, y) && occurs(expected.pixel(x, y), actual, x, y);
            off += !same;
            const int pale = 170 + qGray(actual.pixel(x, y)) / 3;
            made.marked.setPixel(x, y, same ? qRgb(pale, pale, pale) : qRgb(220, 0, 0));
        }
    }
    made.share = static_cast<double>(off) / (static_cast<double>(actual.width()) * actual.height());
    return made;
}

void expectGolden(const QImage& actual, const std::string& name) {
    const QString expectedPath =
        QString::fromStdString(sourcePath("tests/widgets/gl/golden/%1.png")).arg(QString::fromStdString(name));
    if (std::getenv("RUBBLE_RENEW_GOLDEN") != nullptr) {
        ASSERT_TRUE(actual.convertToFormat(QImage::Format_RGB32).save(expectedPath, "PNG", 1)) << expectedPath.toStdString();
        return;
    }
    const QImage expected(expectedPath);
    const PictureDifference difference = differenceOf(actual, expected);
    if (difference.sameSize && difference.share <= mostOff) {
        return;
    }
    const QDir folder(QString::fromStdString(buildPath("golden")));
    folder.mkpath(QStringLiteral("."));
    const QString base = folder.filePath(QString::fromStdString(name));
    actual.save(base + QStringLiteral(".actual.png"));
    difference.marked.save(base + QStringLiteral(".off.png"));
    ADD_FAILURE() << name << ": " << 100.0 * difference.share << " % of the pixels are off, " << 100.0 * mostOff
                  << " % may be. Look at " << base.toStdString() << ".actual.png and .off.png beside " << expectedPath.toStdString()
                  << "; where the new picture is right, set RUBBLE_RENEW_GOLDEN=1 and run this test again.";
}

}  // namespace rubble::figures
