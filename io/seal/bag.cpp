#include "io/seal/bag.h"

#include <algorithm>
#include <sstream>

#include "core/base/error.h"

namespace rubble::io {

namespace {

constexpr std::size_t digestFigures = 64;

bool isDigest(const std::string& text) {
    return text.size() == digestFigures &&
           std::all_of(text.begin(), text.end(), [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

// BagIt would write these in another way than sha256sum reads them.
bool isTaken(char c) {
    return static_cast<unsigned char>(c) >= 32 && c != '%' && c != '\\' && c != 127;
}

}  // namespace

std::string manifestText(const Manifest& manifest) {
    std::string text;
    for (const auto& [place, digest] : manifest) {
        text += digest + "  " + place + "\n";
    }
    return text;
}

std::optional<Manifest> manifestOf(const std::string& text) {
    Manifest manifest;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.size() < digestFigures + 3 || line.compare(digestFigures, 2, "  ") != 0) {
            return {};
        }
        const std::string digest = line.substr(0, digestFigures), place = line.substr(digestFigures + 2);
        if (!isDigest(digest) || !isBagPlace(place) || !manifest.emplace(place, digest).second) {
            return {};
        }
    }
    return manifest;
}

std::string bagDeclaration() {
    return std::string("BagIt-Version: ") + "1.0\n" + "Tag-File-Character-Encoding: " + "UTF-8\n";
}

bool isBagPlace(const std::string& place) {
    if (place.empty() || place.front() == '/' || !std::all_of(place.begin(), place.end(), isTaken)) {
        return false;
    }
    std::istringstream parts(place + "/");
    for (std::string part; std::getline(parts, part, '/');) {
        if (part.empty() || part == "." || part == "..") {
            return false;
        }
    }
    return true;
}

std::string bagName(const std::string& name) {
    std::string taken = name;
    std::replace_if(taken.begin(), taken.end(), [](char c) { return !isTaken(c) || c == '/'; }, '_');
    return taken.empty() || taken == "." || taken == ".." ? "_" : taken;
}

PackedBag::PackedBag(const std::string& path) : m_zip(path) {
    const auto& list = m_zip.entries();
    const std::string ending = std::string("/") + bag::declaration;
    const auto declared = std::find_if(list.begin(), list.end(), [&](const ZipReader::Entry& entry) {
        return entry.name.ends_with(ending) && entry.name.find('/') == entry.name.size() - ending.size();
    });
    if (declared == list.end()) {
        throw ParseError(
            Message{"io.seal.no_bag", "{0} is no sealed bundle: it holds no bag (bagit.txt in one folder)", {path}},
            Message{"io.seal.no_container.remedy", "Name a file that rubble-cli seal has written (*.rubblecase).", {}});
    }
    m_folder = declared->name.substr(0, declared->name.find('/') + 1);
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (const std::string place = placeOf(list[i]); !place.empty()) {
            m_places.emplace(place, i);
        }
    }
}

std::string PackedBag::placeOf(const ZipReader::Entry& entry) const {
    return entry.name.starts_with(m_folder) ? entry.name.substr(m_folder.size()) : std::string();
}

const ZipReader::Entry* PackedBag::find(const std::string& place) const {
    const auto found = m_places.find(place);
    return found == m_places.end() ? nullptr : &m_zip.entries()[found->second];
}

std::optional<std::string> PackedBag::text(const std::string& place) {
    const ZipReader::Entry* entry = find(place);
    if (entry == nullptr) {
        return {};
    }
    return m_zip.content(*entry);
}

}  // namespace rubble::io
