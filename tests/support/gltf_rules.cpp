#include "tests/support/gltf_rules.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace rubble::io {

namespace {

using Json = nlohmann::json;

std::uint32_t wordAt(const std::string& bytes, std::size_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}

std::size_t componentsOf(const std::string& type) {
    static const std::map<std::string, std::size_t> table{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
    const auto found = table.find(type);
    return found == table.end() ? 0 : found->second;
}

std::size_t bytesOf(int componentType) {
    static const std::map<int, std::size_t> table{{5120, 1}, {5121, 1}, {5122, 2}, {5123, 2}, {5125, 4}, {5126, 4}};
    const auto found = table.find(componentType);
    return found == table.end() ? 0 : found->second;
}

/// Goes through a file from outside in; a broken rule is told and the rest looked at as far as it can be.
class Rules {
public:
    explicit Rules(CheckedGlb& file) : m_file(file), m_json(file.asset) {}

    void check() {
        require(m_json.value("/asset/version"_json_pointer, "") == "2.0", "asset.version is not 2.0");
        checkBuffers();
        for (std::size_t a = 0; a < count("accessors"); ++a) {
            checkAccessor(a);
        }
        for (std::size_t m = 0; m < count("meshes"); ++m) {
            checkMesh(m);
        }
        checkNodes();
        for (std::size_t a = 0; a < count("animations"); ++a) {
            checkAnimation(m_json["animations"][a]);
        }
    }

private:
    bool require(bool holds, const std::string& what) {
        if (!holds) {
            m_file.broken.push_back(what);
        }
        return holds;
    }
    std::size_t count(const char* list) const { return m_json.contains(list) ? m_json[list].size() : 0; }
    bool refers(const Json& owner, const char* key, const char* list, const std::string& who) {
        return require(owner.contains(key) && owner[key].is_number_unsigned() && owner[key].get<std::size_t>() < count(list),
                       who + ": " + key + " names nothing in " + list);
    }

    void checkBuffers() {
        for (const char* list : {"accessors", "bufferViews", "buffers", "nodes", "meshes", "scenes"}) {
            require(!m_json.contains(list) || !m_json[list].empty(), std::string(list) + " is there and empty");
        }
        require(count("buffers") == 1, "not one buffer");
        const std::size_t length = m_json.value("/buffers/0/byteLength"_json_pointer, std::size_t{0});
        require(length <= m_file.binary.size() && m_file.binary.size() - length < 4,
                "the binary chunk is not as long as its buffer");
        for (std::size_t v = 0; v < count("bufferViews"); ++v) {
            const Json& view = m_json["bufferViews"][v];
            require(view.value("byteLength", std::size_t{0}) > 0, "a buffer view is empty");
            require(view.value("byteOffset", std::size_t{0}) + view.value("byteLength", std::size_t{0}) <= length,
                    "a buffer view reaches beyond its buffer");
        }
    }

    void checkAccessor(std::size_t index) {
        const Json& accessor = m_json["accessors"][index];
        const std::string who = "accessor " + std::to_string(index);
        if (!refers(accessor, "bufferView", "bufferViews", who)) {
            return;
        }
        const Json& view = m_json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        const std::size_t component = bytesOf(accessor.value("componentType", 0));
        const std::size_t width = component * componentsOf(accessor.value("type", ""));
        const std::size_t rows = accessor.value("count", std::size_t{0});
        const std::size_t offset = accessor.value("byteOffset", std::size_t{0});
        if (!require(width > 0 && rows > 0, who + " has no type or no rows")) {
            return;
        }
        require(offset % component == 0 && (offset + view.value("byteOffset", std::size_t{0})) % component == 0,
                who + " is not aligned");
        const std::size_t stride = view.value("byteStride", width);
        require(!view.contains("byteStride") || (stride >= 4 && stride <= 252 && stride % component == 0), who + ": stride");
        require(offset + stride * (rows - 1) + width <= view.value("byteLength", std::size_t{0}), who + " reaches beyond its view");
        checkExtremes(accessor, index, who);
    }

    void checkExtremes(const Json& accessor, std::size_t index, const std::string& who) {
        if (!m_file.broken.empty() || accessor["componentType"] != 5126) {
            return;
        }
        const std::vector<float> values = m_file.floats(index);
        require(std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); }),
                who + " holds what is no number");
        if (!accessor.contains("min")) {
            return;
        }
        const std::size_t width = componentsOf(accessor["type"]);
        for (std::size_t c = 0; c < width; ++c) {
            float least = values[c];
            float most = values[c];
            for (std::size_t i = c; i < values.size(); i += width) {
                least = std::min(least, values[i]);
                most = std::max(most, values[i]);
            }
            require(accessor["min"][c].get<float>() == least && accessor["max"][c].get<float>() == most,
                    who + ": min or max is wrong");
        }
    }

    void checkMesh(std::size_t index) {
        const std::string who = "mesh " + std::to_string(index);
        for (const Json& primitive : m_json["meshes"][index]["primitives"]) {
            if (!refers(primitive["attributes"], "POSITION", "accessors", who) || !refers(primitive, "indices", "accessors", who)) {
                continue;
            }
            refers(primitive, "material", "materials", who);
            const Json& positions = m_json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
            const Json& corners = m_json["accessors"][primitive["indices"].get<std::size_t>()];
            require(positions.contains("min") && positions.contains("max"), who + ": POSITION needs min and max");
            require(positions["type"] == "VEC3" && positions["componentType"] == 5126, who + ": POSITION is no VEC3 of floats");
            require(targetOf(positions) == 34962 && targetOf(corners) == 34963, who + ": a view has the wrong target");
            require(corners["type"] == "SCALAR" && corners["count"].get<std::size_t>() % 3 == 0, who + ": no whole triangles");
            if (m_file.broken.empty()) {
                const auto indices = m_file.indices(primitive["indices"].get<std::size_t>());
                require(*std::max_element(indices.begin(), indices.end()) < positions["count"].get<std::size_t>(),
                        who + ": an index names no vertex");
            }
        }
    }

    int targetOf(const Json& accessor) {
        return m_json["bufferViews"][accessor["bufferView"].get<std::size_t>()].value("target", 0);
    }

    void checkNodes() {
        std::vector<int> parents(count("nodes"), 0);
        for (std::size_t n = 0; n < count("nodes"); ++n) {
            const Json& node = m_json["nodes"][n];
            const std::string who = "node " + std::to_string(n);
            if (node.contains("mesh")) {
                refers(node, "mesh", "meshes", who);
            }
            if (node.contains("rotation")) {
                double square = 0.0;
                for (const Json& value : node["rotation"]) {
                    square += value.get<double>() * value.get<double>();
                }
                require(node["rotation"].size() == 4 && std::abs(square - 1.0) < 1e-4,
                        who + ": its rotation is no unit quaternion");
            }
            for (const Json& child : node.value("children", Json::array())) {
                if (require(child.get<std::size_t>() < parents.size() && child.get<std::size_t>() != n,
                            who + ": a child that is none")) {
                    ++parents[child.get<std::size_t>()];
                }
            }
        }
        require(std::all_of(parents.begin(), parents.end(), [](int p) { return p <= 1; }), "a node has two parents");
        for (const Json& scene : m_json.value("scenes", Json::array())) {
            for (const Json& root : scene.value("nodes", Json::array())) {
                require(root.get<std::size_t>() < parents.size() && parents[root.get<std::size_t>()] == 0, "a scene names no root");
            }
        }
    }

    void checkAnimation(const Json& animation) {
        std::set<std::pair<std::size_t, std::string>> targets;
        const std::size_t samplers = animation["samplers"].size();
        require(!animation["channels"].empty() && samplers > 0, "an animation without channels");
        for (const Json& channel : animation["channels"]) {
            const std::string path = channel["target"]["path"];
            refers(channel["target"], "node", "nodes", "channel");
            require(targets.emplace(channel["target"]["node"].get<std::size_t>(), path).second, "two channels move the same");
            if (require(channel["sampler"].get<std::size_t>() < samplers, "a channel without sampler")) {
                checkSampler(animation["samplers"][channel["sampler"].get<std::size_t>()], path);
            }
        }
    }

    void checkSampler(const Json& sampler, const std::string& path) {
        if (!refers(sampler, "input", "accessors", "sampler") || !refers(sampler, "output", "accessors", "sampler") ||
            !m_file.broken.empty()) {
            return;
        }
        const Json& input = m_json["accessors"][sampler["input"].get<std::size_t>()];
        const Json& output = m_json["accessors"][sampler["output"].get<std::size_t>()];
        require(input["type"] == "SCALAR" && input["componentType"] == 5126 && input.contains("min") && input.contains("max"),
                "times are no floats with min and max");
        const std::vector<float> times = m_file.floats(sampler["input"].get<std::size_t>());
        require(times.front() >= 0.0f, "a time is below zero");
        require(std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end(), "times do not ascend");
        require(output["count"] == input["count"], "not a value for each time");
        require(output["type"] == (path == "rotation" ? "VEC4" : "VEC3"), "values of the wrong width");
        const std::string interpolation = sampler.value("interpolation", "LINEAR");
        require(interpolation == "LINEAR" || interpolation == "STEP", "an interpolation that is none");
        if (path != "rotation") {
            return;
        }
        const std::vector<float> turns = m_file.floats(sampler["output"].get<std::size_t>());
        for (std::size_t i = 0; i + 3 < turns.size(); i += 4) {
            const float square =
                turns[i] * turns[i] + turns[i + 1] * turns[i + 1] + turns[i + 2] * turns[i + 2] + turns[i + 3] * turns[i + 3];
            require(std::abs(square - 1.0f) < 1e-4f, "a rotation is no unit quaternion");
        }
    }

    CheckedGlb& m_file;
    const Json& m_json;
};

}  // namespace

std::vector<float> CheckedGlb::floats(std::size_t accessor) const {
    const Json& row = asset["accessors"][accessor];
    const Json& view = asset["bufferViews"][row["bufferView"].get<std::size_t>()];
    std::vector<float> values(row["count"].get<std::size_t>() * componentsOf(row["type"]));
    std::memcpy(values.data(), binary.data() + view.value("byteOffset", std::size_t{0}) + row.value("byteOffset", std::size_t{0}),
                values.size() * sizeof(float));
    return values;
}

std::vector<std::uint32_t> CheckedGlb::indices(std::size_t accessor) const {
    const Json& row = asset["accessors"][accessor];
    const Json& view = asset["bufferViews"][row["bufferView"].get<std::size_t>()];
    std::vector<std::uint32_t> values(row["count"].get<std::size_t>());
    std::memcpy(values.data(), binary.data() + view.value("byteOffset", std::size_t{0}) + row.value("byteOffset", std::size_t{0}),
                values.size() * sizeof(std::uint32_t));
    return values;
}

CheckedGlb checkGlb(const std::string& bytes) {
    CheckedGlb file;
    if (bytes.size() < 28 || bytes.substr(0, 4) != "glTF" || wordAt(bytes, 4) != 2 || wordAt(bytes, 8) != bytes.size()) {
        file.broken.emplace_back("no GLB header of version 2 with the length of the file");
        return file;
    }
    const std::size_t json = wordAt(bytes, 12);
    if (bytes.substr(16, 4) != "JSON" || json % 4 != 0 || 28 + json > bytes.size()) {
        file.broken.emplace_back("the first chunk is not JSON at a multiple of four");
        return file;
    }
    const std::size_t binary = wordAt(bytes, 20 + json);
    if (bytes.substr(24 + json, 4) != std::string("BIN\0", 4) || binary % 4 != 0 || 28 + json + binary != bytes.size()) {
        file.broken.emplace_back("the second chunk is not the binary one to the end");
        return file;
    }
    file.asset = Json::parse(bytes.substr(20, json), nullptr, false);
    file.binary = bytes.substr(28 + json);
    if (file.asset.is_discarded()) {
        file.broken.emplace_back("the JSON cannot be read");
        return file;
    }
    Rules(file).check();
    return file;
}

}  // namespace rubble::io
