#include "io/fe/med/med_fields.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/nearest_names.h"
#include "io/fe/exodus/exodus_names.h"

namespace rubble::io {

namespace {

constexpr std::size_t resultWidth = 8;  // code_aster fills names of results up to this with underscores

bool ofCodeAster(const std::string& name) {
    return name.size() > resultWidth && name.find('_') != std::string::npos && name.find(' ') == std::string::npos;
}

// "DEPL" of RESU____DEPL; the whole name elsewhere.
std::string shortName(const std::string& name) {
    return ofCodeAster(name) ? name.substr(resultWidth) : name;
}

// Fields of one result of code_aster share the beginning of their names.
bool ofOneResult(const MedField& a, const MedField& b) {
    const bool named = ofCodeAster(a.name) && ofCodeAster(b.name) && a.name[resultWidth - 1] == '_';
    return a.mesh == b.mesh && (!named || a.name.substr(0, resultWidth) == b.name.substr(0, resultWidth));
}

bool stands(const MedFile& file, const MedField& field, MedPlace place) {
    return std::any_of(field.steps.begin(), field.steps.end(),
                       [&](const MedStep& step) { return !file.values(field, step, place, false).empty(); });
}

std::array<int, 3> axesOf(const MedField& field) {
    std::array<int, 3> axis{-1, -1, -1};
    for (std::size_t a = 0; a < 3; ++a) {
        const std::string letter(1, static_cast<char>('x' + a));
        axis[a] = findAny(field.components, {"d" + letter, letter, "u" + letter, "v" + letter});
    }
    const bool named = axis[0] >= 0 && axis[1] >= 0;
    for (std::size_t a = 0; a < 3 && !named; ++a) {
        axis[a] = a < field.components.size() ? static_cast<int>(a) : -1;
    }
    return axis;
}

std::vector<std::string> namesOf(const std::vector<MedField>& fields) {
    std::vector<std::string> names;
    for (const MedField& field : fields) {
        names.push_back(shownName(field.name));
    }
    return names;
}

bool isNamed(const MedField& field, const std::vector<std::string_view>& known) {
    return findAny({field.name}, known) == 0 || findAny({shortName(field.name)}, known) == 0;
}

[[noreturn]] void failDisplacement(const std::string& path, const std::vector<MedField>& fields, const std::string& asked) {
    const Message remedy{"med.no_displacement.remedy",
                         "Name it: --set displacement=NAME; displacement=none if the nodes do not move. Fields in the file: {0}",
                         {quotedList(namesOf(fields), 100)}};
    if (!asked.empty()) {
        throw UsageError({"med.unknown_displacement", "{0} has no field \"{1}\" of vectors on nodes", {path, asked}}, remedy);
    }
    throw ParseError({"med.no_displacement", "{0} has no displacement of the nodes under a known name", {path}}, remedy);
}

std::optional<MedVector> chooseMedDisplacement(const MedFile& file, const std::vector<MedField>& fields,
                                               const ImportSettings& settings, Findings& findings) {
    if (settings.displacement == "none") {
        return std::nullopt;
    }
    const MedField* best = nullptr;
    std::vector<const MedField*> others;
    for (const MedField& field : fields) {
        const bool wanted = settings.displacement.empty()
                                ? isNamed(field, {"depl", "displacement", "displacements", "displ", "disp", "u"})
                                : field.name == settings.displacement || shortName(field.name) == settings.displacement;
        if (!wanted || field.components.size() < 2 || !stands(file, field, MedPlace::Nodes)) {
            continue;
        }
        if (!best || field.steps.size() > best->steps.size()) {
            std::swap(best, others.emplace_back(&field));
        } else {
            others.push_back(&field);
        }
    }
    if (!best) {
        failDisplacement(file.path(), fields, settings.displacement);
    }
    for (const MedField* other : others) {
        if (other) {
            findings.add({"med.results", "The file holds further results, which were not read", {}},
                         {"med.results.remedy", "Name the displacement of the one that you want: --set displacement=NAME.", {}},
                         shownName(other->name));
        }
    }
    return MedVector{*best, axesOf(*best)};
}

void chooseFlag(MedResult& result, const ImportSettings& settings, const std::string& path) {
    std::vector<MedFlag> flags;
    std::vector<std::string> shortNames;
    for (const auto& [field, place] : result.onCells) {
        for (std::size_t c = 0; c < field.components.size(); ++c) {
            const std::string component = field.components.size() > 1 ? "." + field.components[c] : "";
            flags.push_back({field, place, c, shownName(field.name) + component, {}});
            shortNames.push_back(shortName(shownName(field.name)) + component);
            result.choices.push_back(flags.back().name);
        }
    }
    for (const auto& names : {result.choices, shortNames}) {
        if (const auto status = findStatus(names, settings.statusVariable); status && !result.flag) {
            result.flag = flags[static_cast<std::size_t>(status->index)];
            result.flag->activeByName = status->activeByName;
        }
    }
    if (!result.flag && !settings.statusVariable.empty()) {
        throw UsageError({"med.unknown_status", "{0} has no field \"{1}\" on elements", {path, settings.statusVariable}},
                         {"med.unknown_status.remedy", "Fields on elements: {0}", {quotedList(result.choices, 100)}});
    }
}

}  // namespace

MedResult chooseMedResult(const MedFile& file, const ImportSettings& settings, Findings& findings) {
    MedResult result;
    const std::vector<MedField> fields = file.fields();
    result.displacement = chooseMedDisplacement(file, fields, settings, findings);
    const MedField* leader = result.displacement ? &result.displacement->field : nullptr;
    for (const MedField& field : fields) {
        if (!result.displacement && (!leader || field.steps.size() > leader->steps.size())) {
            leader = &field;
        }
    }
    for (const MedField& field : fields) {
        if (!leader || !ofOneResult(*leader, field)) {
            continue;
        }
        for (const MedPlace place : {MedPlace::Cells, MedPlace::CellNodes}) {
            if (stands(file, field, place)) {
                result.onCells.emplace_back(field, place);
            }
        }
        if (result.displacement && !result.velocity && field.components.size() > 1 &&
            isNamed(field, {"vite", "velocity", "velocities", "vel", "v"}) && stands(file, field, MedPlace::Nodes)) {
            result.velocity = MedVector{field, axesOf(field)};
        }
    }
    const std::vector<std::string> meshes = file.meshNames();
    result.mesh = leader ? leader->mesh : meshes.empty() ? "" : meshes.front();
    result.steps = leader ? leader->steps : std::vector<MedStep>{};
    if (std::find(meshes.begin(), meshes.end(), result.mesh) == meshes.end()) {
        throw ParseError({"med.no_mesh", "{0} has no mesh \"{1}\"", {file.path(), shownName(result.mesh)}},
                         {"med.no_mesh.remedy", "Let the analysis write mesh and fields into one file.", {}});
    }
    chooseFlag(result, settings, file.path());
    return result;
}

}  // namespace rubble::io
