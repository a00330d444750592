#include "io/fe/series/part_membership.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/error.h"
#include "core/base/nearest_names.h"
#include "io/fe/series/byte_window.h"

namespace rubble::io {

namespace {

bool names(const std::string& wanted, const Part& part) {
    return upperCase(wanted) == upperCase(part.name) || wanted == std::to_string(part.fileId);
}

[[noreturn]] void failUnknownPart(const std::string& wanted, const std::vector<std::string>& known, const std::string& path) {
    throw UsageError({"fe.unknown_part", "{0} has no part \"{1}\"", {path, wanted}},
                     {"fe.unknown_part.remedy", "Name one of these in dead_parts: {0}.", {quotedList(known, 100)}});
}

std::string listOf(const std::vector<std::string>& list) {
    std::string text;
    for (const std::string& name : list) {
        text += (text.empty() ? "" : ", ") + name;
    }
    return text;
}

}  // namespace

std::vector<std::string> deadPartNames(const std::string& setting) {
    std::string text = setting;
    if (text.find(';') != std::string::npos) {
        std::replace(text.begin(), text.end(), ',', '\1');
        std::replace(text.begin(), text.end(), ';', ',');
    }
    std::vector<std::string> list;
    for (std::string name : fieldsOf(text)) {
        std::replace(name.begin(), name.end(), '\1', ',');
        if (!name.empty()) {
            list.push_back(std::move(name));
        }
    }
    return list;
}

void PartMembership::add(const Mesh& mesh, const MeshUnion& united, std::size_t state) {
    const MeshEpoch& epoch = united.epochs().back();
    std::vector<std::size_t> places;
    for (const Part& part : mesh.parts) {
        const auto found = std::find(m_known.begin(), m_known.end(), part.name);
        places.push_back(static_cast<std::size_t>(found - m_known.begin()));
        if (found == m_known.end()) {
            m_known.push_back(part.name);
        }
    }
    m_found.resize(m_wanted.size(), false);
    for (std::size_t w = 0; w < m_wanted.size(); ++w) {
        const bool here =
            std::any_of(mesh.parts.begin(), mesh.parts.end(), [&](const Part& part) { return names(m_wanted[w], part); });
        m_found[w] = m_found[w] || here;
    }
    constexpr std::size_t notKnown = ~std::size_t{0};
    m_first.resize(united.elementCount(), notKnown);
    m_moved.resize(united.elementCount(), false);
    m_dead.assign(united.elementCount(), false);
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        const std::size_t e = epoch.element(i);
        if (m_first[e] == notKnown) {
            m_first[e] = places[mesh.part[i]];
        }
        const bool moved = places[mesh.part[i]] != m_first[e];
        if (moved && !m_moved[e]) {
            m_moved[e] = true;
            if (m_changed++ == 0) {
                m_example = "element " + englishInteger(united.elementNumber(e)) + " from \"" + m_known[m_first[e]] + "\" to \"" +
                            mesh.parts[mesh.part[i]].name + "\" at state " + englishInteger(static_cast<std::int64_t>(state));
            }
        }
        m_dead[e] = isDead(mesh.parts[mesh.part[i]], moved);
    }
}

bool PartMembership::isDead(const Part& part, bool moved) {
    if (!m_wanted.empty()) {
        return std::any_of(m_wanted.begin(), m_wanted.end(), [&](const std::string& wanted) { return names(wanted, part); });
    }
    constexpr std::array<std::string_view, 8> words{"DEAD",   "INACTIVE", "DEACTIVATED", "DELETED",
                                                    "KILLED", "REMOVED",  "ERODED",      "FAILED"};
    if (!moved || std::find(words.begin(), words.end(), upperCase(part.name)) == words.end()) {
        return false;
    }
    if (std::find(m_byName.begin(), m_byName.end(), part.name) == m_byName.end()) {
        m_byName.push_back(part.name);
    }
    return true;
}

std::string PartMembership::decidedBy() const {
    const std::vector<std::string>& list = m_wanted.empty() ? m_byName : m_wanted;
    return list.empty() ? ""
                        : "elements are dead in the parts " + listOf(list) + (m_wanted.empty() ? " (by their names)" : " (as set)");
}

void PartMembership::note(Findings& findings, const std::string& path) const {
    for (std::size_t w = 0; w < m_found.size(); ++w) {
        if (!m_found[w]) {
            failUnknownPart(m_wanted[w], m_known, path);
        }
    }
    if (m_changed > 0) {
        findings.add({"fe.part_changed", "Elements change their part from state to state", {}},
                     {"fe.part_changed.remedy",
                      "If they die so, name the parts of the dead: --set dead_parts=NAME. Their first part counts otherwise.",
                      {}},
                     m_example, m_changed);
    }
}

void killParts(const std::string& setting, const Mesh& mesh, Activity& activity, std::string& activityFrom,
               const std::string& path) {
    const std::vector<std::string> wanted = deadPartNames(setting);
    std::vector<bool> dead(mesh.parts.size(), false);
    for (const std::string& name : wanted) {
        bool found = false;
        std::vector<std::string> known;
        for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
            known.push_back(mesh.parts[p].name);
            const bool same = names(name, mesh.parts[p]);
            dead[p] = dead[p] || same;
            found = found || same;
        }
        if (!found) {
            failUnknownPart(name, known, path);
        }
    }
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        for (std::size_t k = 0; dead[mesh.part[e]] && k < activity.states(); ++k) {
            activity.set(k, idAt<ElementIndex>(e), false);
        }
    }
    if (!wanted.empty()) {
        activityFrom += "; elements are dead in the parts " + listOf(wanted) + " (as set)";
    }
}

}  // namespace rubble::io
