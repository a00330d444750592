#include "io/run/run_json.h"

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>

#include "io/json/findings_json.h"
#include "io/json/scenario_json.h"
#include "io/json/site_json.h"
#include "io/run/run_members.h"

namespace rubble::io {

using nlohmann::json;

namespace {

// Choices that have names are written by name.
template <class T>
struct Names;
template <>
struct Names<ClampedBy> {
    static constexpr int count = 4;
    static std::string_view of(ClampedBy choice) { return clampedByName(choice); }
};
template <>
struct Names<StoppedBy> {
    static constexpr int count = 3;
    static std::string_view of(StoppedBy choice) { return stoppedByName(choice); }
};
template <>
struct Names<HealthCheck> {
    static constexpr int count = static_cast<int>(healthCheckCount);
    static std::string_view of(HealthCheck choice) { return healthCheckName(choice); }
};
template <>
struct Names<EffectKind> {
    static constexpr int count = static_cast<int>(effectCount);
    static std::string_view of(EffectKind choice) { return effectName(choice); }
};
template <>
struct Names<EffectSwitch> {
    static constexpr int count = 3;
    static std::string_view of(EffectSwitch choice) {
        static constexpr std::array<std::string_view, count> names{"off", "on", "auto"};
        return names[static_cast<std::size_t>(choice)];
    }
};

template <class Choice>
Choice choiceFrom(const JsonCursor& cursor) {
    for (int i = 0; i < Names<Choice>::count; ++i) {
        if (Names<Choice>::of(static_cast<Choice>(i)) == cursor.text()) {
            return static_cast<Choice>(i);
        }
    }
    cursor.fail("one of the known names");
}

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsList : std::false_type {};
template <class T>
struct IsList<std::vector<T>> : std::true_type {};

struct JsonWriter {
    json object = json::object();

    template <class T>
    void operator()(const char* name, const T& member) {
        if constexpr (std::is_same_v<T, double>) {
            object[name] = jsonNumber(member);
        } else if constexpr (std::is_integral_v<T>) {
            object[name] = member;
        } else if constexpr (std::is_enum_v<T>) {
            object[name] = Names<T>::of(member);
        } else if constexpr (IsOptional<T>::value) {
            object[name] = member ? json(at(*member)) : json(nullptr);
        } else if constexpr (std::is_same_v<T, Digest>) {
            object[name] = member.hex();
        } else if constexpr (std::is_same_v<T, Findings>) {
            object[name] = findingsJson(member);
        } else if constexpr (std::is_same_v<T, Message>) {
            object[name] = messageJson(member);
        } else if constexpr (std::is_same_v<T, Vec3>) {
            object[name] = jsonVector(member);
        } else if constexpr (IsList<T>::value) {
            object[name] = json::array();
            for (const auto& entry : member) {
                object[name].push_back(ofMembers(entry));
            }
        } else {
            object[name] = ofMembers(member);
        }
    }
    template <class T>
    void added(const char* name, const T& member) {
        (*this)(name, member);
    }
    template <class T>
    static json ofMembers(const T& value) {
        JsonWriter inner;
        Members<T>::each(inner, value);
        return std::move(inner.object);
    }
};

struct JsonReader {
    const JsonCursor& object;

    template <class T>
    void operator()(const char* name, T& member) {
        const JsonCursor cursor = object[name];
        if constexpr (std::is_same_v<T, double>) {
            member = cursor.anyNumber();
        } else if constexpr (std::is_same_v<T, bool>) {
            member = cursor.flag();
        } else if constexpr (std::is_integral_v<T>) {
            member = static_cast<T>(cursor.integer());
        } else if constexpr (std::is_enum_v<T>) {
            member = choiceFrom<T>(cursor);
        } else if constexpr (IsOptional<T>::value) {
            member.reset();
            if (!cursor.value().is_null()) {
                member = idAt<typename T::value_type>(static_cast<std::size_t>(cursor.integer()));
            }
        } else if constexpr (std::is_same_v<T, Digest>) {
            member = digestFromJson(cursor);
        } else if constexpr (std::is_same_v<T, Findings>) {
            member = findingsFromJson(cursor);
        } else if constexpr (std::is_same_v<T, Message>) {
            member = messageFromJson(cursor);
        } else if constexpr (std::is_same_v<T, Vec3>) {
            member = cursor.vector();
        } else if constexpr (IsList<T>::value) {
            member.clear();
            for (const JsonCursor& entry : cursor.elements()) {
                JsonReader inner{entry};
                Members<typename T::value_type>::each(inner, member.emplace_back());
            }
        } else {
            JsonReader inner{cursor};
            Members<T>::each(inner, member);
        }
    }
    template <class T>
    void added(const char* name, T& member) {
        if (object.has(name)) {
            (*this)(name, member);
        }
    }
};

template <class T>
json membersJson(const T& value) {
    return JsonWriter::ofMembers(value);
}

template <class T>
T membersFromJson(const JsonCursor& object) {
    T value{};
    JsonReader reader{object};
    Members<T>::each(reader, value);
    return value;
}

}  // namespace

Digest digestFromJson(const JsonCursor& cursor) {
    const std::string hex = cursor.text();
    Digest digest;
    if (hex.size() != 2 * digest.bytes.size() || hex.find_first_not_of("0123456789abcdef") != std::string::npos) {
        cursor.fail("a digest of 32 hexadecimal digits");
    }
    for (std::size_t i = 0; i < digest.bytes.size(); ++i) {
        digest.bytes[i] = static_cast<std::uint8_t>(std::stoul(hex.substr(2 * i, 2), nullptr, 16));
    }
    return digest;
}

json sizingJson(const Sizing& sizing) {
    return membersJson(sizing);
}

Sizing sizingFromJson(const JsonCursor& object) {
    return membersFromJson<Sizing>(object);
}

json resultJson(const SimulationResult& result) {
    return membersJson(result);
}

SimulationResult resultFromJson(const JsonCursor& object) {
    return membersFromJson<SimulationResult>(object);
}

json breachJson(const HealthBreach& breach) {
    return membersJson(breach);
}

HealthBreach breachFromJson(const JsonCursor& object) {
    return membersFromJson<HealthBreach>(object);
}

json clusteringJson(const Clustering& clustering) {
    return membersJson(clustering);
}

Clustering clusteringFromJson(const JsonCursor& object) {
    return membersFromJson<Clustering>(object);
}

json originJson(const RunOrigin& origin) {
    json object = scenarioJson(origin.scenario);
    object["fe_path"] = origin.fePath;
    object["fe_sha256"] = origin.feSha256;
    if (!origin.terrainPath.empty()) {
        object["terrain_path"] = origin.terrainPath;
        object["terrain_sha256"] = origin.terrainSha256;
        putCloudRequest(object, origin.terrainRead, "terrain_");
    }
    if (!(origin.site == Site())) {
        object["site"] = siteJson(origin.site);
    }
    for (const RecordedInput& mesh : origin.surroundings) {
        object["surroundings"].push_back({{"path", mesh.path}, {"sha256", mesh.sha256}});
        if (mesh.offset != Vec3::Zero()) {
            object["surroundings"].back()["offset_m"] = jsonVector(mesh.offset);
        }
        putCloudRequest(object["surroundings"].back(), mesh.read);
    }
    object["frame"] = frameJson(origin.frame);
    object["scenario_name"] = origin.scenarioName;
    object["build"] = origin.build;
    object["fingerprint"] = origin.fingerprint.hex();
    if (!origin.unsaidUnits.empty()) {
        object["units_fit_as_well"] = origin.unsaidUnits;
    }
    for (const Message& doubt : origin.placeDoubts) {
        object["place_doubts"].push_back(messageJson(doubt));
    }
    return object;
}

RunOrigin originFromJson(const JsonCursor& object) {
    RunOrigin origin;
    origin.scenario = scenarioFromJson(object);
    origin.fePath = object["fe_path"].text();
    origin.feSha256 = object["fe_sha256"].text();
    if (object.has("terrain_path")) {
        origin.terrainPath = object["terrain_path"].text();
        origin.terrainSha256 = object["terrain_sha256"].text();
        origin.terrainRead = cloudRequestFromJson(object, "terrain_");
    }
    if (object.has("site")) {
        origin.site = siteFromJson(object["site"]);
    }
    if (object.has("surroundings")) {
        for (const JsonCursor& mesh : object["surroundings"].elements()) {
            origin.surroundings.push_back({mesh["path"].text(), mesh["sha256"].text()});
            if (mesh.has("offset_m")) {
                origin.surroundings.back().offset = mesh["offset_m"].vector();
            }
            origin.surroundings.back().read = cloudRequestFromJson(mesh);
        }
    }
    origin.frame = frameFromJson(object["frame"]);
    origin.scenarioName = object["scenario_name"].text();
    origin.build = object["build"].text();
    origin.fingerprint = digestFromJson(object["fingerprint"]);
    if (object.has("units_fit_as_well")) {
        origin.unsaidUnits = object["units_fit_as_well"].text();
    }
    if (object.has("place_doubts")) {
        for (const JsonCursor& doubt : object["place_doubts"].elements()) {
            origin.placeDoubts.push_back(messageFromJson(doubt));
        }
    }
    return origin;
}

nlohmann::json cautionsJson(const std::vector<Caution>& cautions) {
    nlohmann::json list = nlohmann::json::array();
    for (const Caution& caution : cautions) {
        list.push_back({{"key", caution.key}, {"grade", healthGradeName(caution.grade)}, {"text", englishText(caution.what)}});
    }
    return list;
}

}  // namespace rubble::io
