#include "io/fe/d3plot/d3plot_titles.h"

#include "io/fe/d3plot/d3plot_geometry.h"
#include "io/fe/exodus/exodus_names.h"

namespace rubble::io {

namespace {

enum Section : std::int64_t {
    HEAD = 90000,
    PARTS = 90001,
    CONTACTS = 90002,
    SLIDING = 90020,
    PARTS_AGAIN = 90021,
    KEYWORDS = 90100,
    KEYWORDS_TOO = 900100
};

constexpr std::int64_t titleBytes = 72, lineBytes = 80;

}  // namespace

std::vector<std::string> readD3plotTitles(const D3plotFamily& family, std::int64_t word, std::vector<std::int64_t>& ids) {
    std::vector<std::string> titles;
    const std::int64_t width = family.format().bytes;
    const std::int64_t last = family.firstWord(family.fileOf(word - 1) + 1);
    const auto holds = [&](std::int64_t words) { return words >= 0 && words <= last - word; };
    while (holds(2)) {
        const std::int64_t section = family.readInteger(word);
        const std::int64_t rows = family.readInteger(word + 1);
        std::int64_t row = 0;
        switch (section) {
            case HEAD:
                word += 1 + titleBytes / width;
                continue;
            case PARTS:
            case PARTS_AGAIN:
            case CONTACTS:
            case SLIDING:
                row = 1 + titleBytes / width;
                break;
            case KEYWORDS:
            case KEYWORDS_TOO:
                row = lineBytes / width;
                break;
            default:
                return titles;
        }
        word += 2;
        if (rows < 0 || rows > (last - word) / row) {
            return titles;
        }
        if ((section == PARTS || section == PARTS_AGAIN) && titles.empty()) {
            for (std::int64_t i = 0; i < rows; ++i) {
                ids.push_back(family.readInteger(word + i * row));
                titles.push_back(shownName(family.readText(word + i * row + 1, row - 1)));
            }
        }
        word += rows * row;
    }
    return titles;
}

}  // namespace rubble::io
