#include "io/site/meshes/gltf_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "io/base/base64.h"
#include "io/base/file_words.h"
#include "io/base/files.h"
#include "io/fe/meshes/raw_mesh.h"
#include "io/fe/vtk/stored_numbers.h"

namespace rubble::io {

namespace {

constexpr std::string_view cutRemedy = "The file may be cut short: copy it again from where it came.";
/// Numbers of one accessor at most: positions of the most points.
constexpr std::size_t numbersMax = 3 * meshPointsMax;

std::string wholeFile(const std::string& path) {
    std::optional<std::string> content = contentOf(path);
    if (!content) {
        throw WorldError({"surroundings.missing_buffer", "The numbers of the glTF, {0}, cannot be read", {path}},
                         {"surroundings.missing_buffer.remedy", "Put the file beside the glTF, or export it as one .glb.", {}});
    }
    return std::move(*content);
}

std::uint32_t wordAt(std::string_view bytes, std::size_t place) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + place, sizeof(word));
    return word;
}

/// The document of a file, and the bytes behind it where it is binary.
std::string documentOf(const std::string& path, std::string content, std::string& binary) {
    if (!content.starts_with("glTF")) {
        return content;
    }
    constexpr std::size_t heading = 12;
    constexpr std::size_t chunkHeading = 8;
    if (content.size() < heading + chunkHeading) {
        refuseContent({"surroundings.glb_cut", "{0} ends before what it promises", {path}}, cutRemedy);
    }
    if (const std::uint32_t version = wordAt(content, 4); version != 2) {
        refuseContent({"surroundings.gltf_version", "{0} is glTF {1}; version 2.0 is read", {path, std::to_string(version)}},
                      "Export the mesh anew as glTF 2.0, OBJ or PLY.");
    }
    std::string document;
    std::size_t place = heading;
    for (int chunk = 0; chunk < 2 && place + chunkHeading <= content.size(); ++chunk) {
        const std::size_t length = wordAt(content, place);
        if (length > content.size() - place - chunkHeading) {
            refuseContent({"surroundings.glb_cut", "{0} ends before what it promises", {path}}, cutRemedy);
        }
        (chunk == 0 ? document : binary) = content.substr(place + chunkHeading, length);
        place += chunkHeading + length;
    }
    return document;
}

/// A path in a URI, its "%20" and the like as characters.
std::string pathIn(std::string_view uri) {
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const std::string digits(uri.substr(std::min(i + 1, uri.size()), 2));
        if (uri[i] == '%' && digits.size() == 2 && std::isxdigit(static_cast<unsigned char>(digits[0])) != 0 &&
            std::isxdigit(static_cast<unsigned char>(digits[1])) != 0) {
            path.push_back(static_cast<char>(std::stoi(digits, nullptr, 16)));
            i += 2;
        } else {
            path.push_back(uri[i]);
        }
    }
    return path;
}

std::string fileInUri(const std::string& uri, const std::string& path) {
    return (std::filesystem::path(path).parent_path() / pathIn(uri)).string();
}

std::string bytesOfBuffer(const JsonCursor& buffer, const std::string& path) {
    const std::string uri = buffer["uri"].text();
    if (!uri.starts_with("data:")) {
        return wholeFile(fileInUri(uri, path));
    }
    const std::size_t comma = uri.find(',');
    std::string bytes;
    if (comma == std::string::npos || uri.substr(0, comma).find(";base64") == std::string::npos ||
        !decodeBase64(std::string_view(uri).substr(comma + 1), bytes)) {
        buffer["uri"].fail("numbers in base64");
    }
    return bytes;
}

std::size_t sizeAt(const JsonCursor& object, std::string_view key, std::size_t otherwise) {
    if (!object.has(key)) {
        return otherwise;
    }
    const std::int64_t size = object[key].integer();
    if (size < 0) {
        object[key].fail("a number from 0 on");
    }
    return static_cast<std::size_t>(size);
}

NumberType typeOf(const JsonCursor& component) {
    using Kind = NumberType::Kind;
    switch (component.integer()) {
        case 5120:
            return {Kind::Signed, 1};
        case 5121:
            return {Kind::Unsigned, 1};
        case 5122:
            return {Kind::Signed, 2};
        case 5123:
            return {Kind::Unsigned, 2};
        case 5125:
            return {Kind::Unsigned, 4};
        case 5126:
            return {Kind::Real, 4};
        default:
            component.fail("5120, 5121, 5122, 5123, 5125 or 5126");
    }
}

/// Whole numbers that stand for fractions from 0 or -1 to 1.
void normalise(std::vector<double>& values, NumberType type) {
    const double bits = static_cast<double>(8 * type.bytes) - (type.kind == NumberType::Kind::Signed ? 1.0 : 0.0);
    const double most = std::ldexp(1.0, static_cast<int>(bits)) - 1.0;
    for (double& value : values) {
        value = std::max(value / most, -1.0);
    }
}

}  // namespace

GltfFile::GltfFile(const std::string& path) : m_path(path) {
    std::string binary;
    const std::string document = documentOf(path, wholeFile(path), binary);
    m_document = std::make_unique<nlohmann::json>(parseJson(document, path));
    const JsonCursor asset = top()["asset"];
    for (const std::string_view key : {"version", "minVersion"}) {
        const std::string version = asset.has(key) ? asset[key].text() : "2.0";
        if (!version.starts_with("2.") || (key == "minVersion" && version != "2.0")) {
            refuseContent({"surroundings.gltf_version", "{0} is glTF {1}; version 2.0 is read", {path, version}},
                          "Export the mesh anew as glTF 2.0, OBJ or PLY.");
        }
    }
    readBuffers(path, std::move(binary));
}

GltfFile::~GltfFile() = default;

void GltfFile::readBuffers(const std::string& path, std::string binary) {
    if (!top().has("buffers")) {
        return;
    }
    for (const JsonCursor& buffer : top()["buffers"].elements()) {
        const bool own = m_buffers.empty() && !buffer.has("uri");
        std::string bytes = own ? std::exchange(binary, {}) : bytesOfBuffer(buffer, path);
        const std::size_t length = sizeAt(buffer, "byteLength", 0);
        if (length > bytes.size()) {
            refuseContent({"surroundings.buffer_cut",
                           "{0}: a buffer promises {1} bytes and holds {2}",
                           {path, static_cast<std::int64_t>(length), static_cast<std::int64_t>(bytes.size())}},
                          cutRemedy);
        }
        m_buffers.push_back(std::move(bytes));
    }
}

std::vector<std::string> buffersOfGltf(const std::string& path) {
    std::string binary;
    const nlohmann::json document = parseJson(documentOf(path, wholeFile(path), binary), path);
    const JsonCursor top(document, path);
    std::vector<std::string> files;
    for (const JsonCursor& buffer : top.has("buffers") ? top["buffers"].elements() : std::vector<JsonCursor>()) {
        const std::string uri = buffer.has("uri") ? buffer["uri"].text() : "data:";
        if (!uri.starts_with("data:")) {
            files.push_back(fileInUri(uri, path));
        }
    }
    return files;
}

JsonCursor GltfFile::top() const {
    return {*m_document, m_path};
}

JsonCursor GltfFile::entry(std::string_view list, const JsonCursor& index) const {
    const std::int64_t number = index.integer();
    const JsonCursor entries = top()[list];
    if (!entries.value().is_array() || number < 0 || static_cast<std::size_t>(number) >= entries.value().size()) {
        index.fail("the number of an entry of " + std::string(list));
    }
    const auto place = static_cast<std::size_t>(number);
    return {entries.value()[place], m_path, "/" + std::string(list) + "/" + std::to_string(place)};
}

std::string_view GltfFile::view(const JsonCursor& index) const {
    const JsonCursor view = entry("bufferViews", index);
    entry("buffers", view["buffer"]);
    const std::string_view buffer = m_buffers[static_cast<std::size_t>(view["buffer"].integer())];
    const std::size_t offset = sizeAt(view, "byteOffset", 0);
    const std::size_t length = sizeAt(view, "byteLength", 0);
    if (offset > buffer.size() || length > buffer.size() - offset) {
        view["byteLength"].refuse("it reaches beyond the end of its buffer", cutRemedy);
    }
    return buffer.substr(offset, length);
}

/// @param place  what names the view and the offset in it: the accessor, or a part of a sparse one
std::vector<double> GltfFile::stored(const JsonCursor& accessor, const JsonCursor& place, std::size_t width,
                                     std::size_t count) const {
    const NumberType type = typeOf((place.has("componentType") ? place : accessor)["componentType"]);
    const std::string_view bytes = view(place["bufferView"]);
    const std::size_t offset = sizeAt(place, "byteOffset", 0);
    const std::size_t row = type.bytes * width;
    const std::size_t step = std::max(sizeAt(entry("bufferViews", place["bufferView"]), "byteStride", row), std::size_t{1});
    if (count > 0 && (step < row || offset > bytes.size() || bytes.size() - offset < row ||
                      (count - 1) > (bytes.size() - offset - row) / step)) {
        place["bufferView"].refuse("it holds fewer numbers than are asked of it", cutRemedy);
    }
    std::vector<double> values;
    values.reserve(width * count);
    for (std::size_t k = 0; k < count; ++k) {
        const std::vector<double> numbers = realsIn(bytes.substr(offset + k * step, row), type, false);
        values.insert(values.end(), numbers.begin(), numbers.end());
    }
    return values;
}

void GltfFile::replaceSparse(const JsonCursor& accessor, Numbers& numbers, std::size_t count) const {
    const JsonCursor sparse = accessor["sparse"];
    const std::size_t replaced = sizeAt(sparse, "count", 0);
    if (replaced > count) {
        sparse["count"].fail("no more than the accessor has");
    }
    const std::vector<double> places = stored(accessor, sparse["indices"], 1, replaced);
    const std::vector<double> values = stored(accessor, sparse["values"], numbers.width, replaced);
    for (std::size_t k = 0; k < replaced; ++k) {
        if (!(places[k] >= 0.0 && places[k] < static_cast<double>(count))) {
            sparse["indices"].refuse("it names a number that the accessor does not have", cutRemedy);
        }
        const auto at = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(places[k]) * numbers.width);
        const auto from = values.begin() + static_cast<std::ptrdiff_t>(k * numbers.width);
        std::copy_n(from, numbers.width, numbers.values.begin() + at);
    }
}

GltfFile::Numbers GltfFile::numbers(const JsonCursor& index) const {
    const JsonCursor accessor = entry("accessors", index);
    const std::string type = accessor["type"].text();
    Numbers numbers;
    numbers.width = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
    const std::size_t count = sizeAt(accessor, "count", 0);
    if (numbers.width == 0 || count > numbersMax / numbers.width) {
        accessor.refuse(numbers.width == 0 ? "it is no list of numbers or places" : "it has more numbers than can be read",
                        "Make the mesh simpler, or cut it to the site.");
    }
    const NumberType component = typeOf(accessor["componentType"]);
    numbers.single = component.kind == NumberType::Kind::Real;
    if (accessor.has("bufferView")) {
        numbers.values = stored(accessor, accessor, numbers.width, count);
    } else {
        numbers.values.assign(numbers.width * count, 0.0);
    }
    if (accessor.has("sparse")) {
        replaceSparse(accessor, numbers, count);
    }
    if (accessor.has("normalized") && accessor["normalized"].flag() && !numbers.single) {
        normalise(numbers.values, component);
    }
    return numbers;
}

}  // namespace rubble::io
