#include "app/cli/frame/picture_options.h"

#include <QString>

#include <algorithm>
#include <iostream>
#include <string_view>

#include "app/cli/frame/option_value.h"

namespace rubble::cli {

namespace {

constexpr int smallestPixels = 100;
constexpr int largestPixels = 8000;

void passOnQtMessage(QtMsgType, const QMessageLogContext&, const QString& text) {
    if (!text.contains("XDG_RUNTIME_DIR")) {
        std::cerr << text.toStdString() << '\n';
    }
}

}  // namespace

QSize parsePictureSize(const std::string& text) {
    const std::size_t cross = text.find('x');
    int width = 0;
    int height = 0;
    const bool parsed = cross != std::string::npos && parseNumber(std::string_view(text).substr(0, cross), width) &&
                        parseNumber(std::string_view(text).substr(cross + 1), height);
    if (!parsed || std::min(width, height) < smallestPixels || std::max(width, height) > largestPixels) {
        throw wrongValue("--size", text, "WIDTHxHEIGHT in pixels, each from 100 to 8000");
    }
    return {width, height};
}

void quietQt() {
    qInstallMessageHandler(passOnQtMessage);
}

}  // namespace rubble::cli
