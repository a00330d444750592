#include "io/fe/abaqus/deck_parts.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <unordered_map>

#include "core/base/unknown.h"
#include "io/fe/series/byte_window.h"

namespace rubble::io {

namespace {

std::uint32_t partNamed(const std::string& name, Mesh& mesh) {
    for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
        if (mesh.parts[p].name == name) {
            return static_cast<std::uint32_t>(p);
        }
    }
    mesh.parts.push_back({name, static_cast<std::int64_t>(mesh.parts.size()) + 1});
    return static_cast<std::uint32_t>(mesh.parts.size() - 1);
}

/// The smallest set that each element is in; the sets' size where it is in none.
std::vector<std::size_t> smallestSets(const std::vector<NamedSet>& sets, const Mesh& mesh) {
    std::unordered_map<std::int64_t, std::vector<std::size_t>> places;
    for (std::size_t e = 0; e < mesh.elementIds.size(); ++e) {
        places[mesh.elementIds[e]].push_back(e);
    }
    std::vector<std::size_t> order(sets.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return sets[a].members.size() > sets[b].members.size(); });
    std::vector<std::size_t> smallest(mesh.elementIds.size(), sets.size());
    for (const std::size_t s : order) {
        for (const std::int64_t member : sets[s].members) {
            if (const auto found = places.find(member); found != places.end()) {
                for (const std::size_t e : found->second) {
                    smallest[e] = s;
                }
            }
        }
    }
    return smallest;
}

// Results name the sets of instances ASSEMBLY_INSTANCE_SET.
const DeckSection* sectionNamed(const InputDeck& deck, const std::string& set) {
    const std::string name = upperCase(set);
    const auto found = std::find_if(deck.sections.begin(), deck.sections.end(), [&](const DeckSection& section) {
        return name == section.set || name.ends_with("_" + section.set);
    });
    return found == deck.sections.end() ? nullptr : &*found;
}

void applySection(const InputDeck& deck, const DeckSection& section, std::size_t e, Mesh& mesh) {
    mesh.density[e] = deck.densityOf(section).value_or(unknown);
    mesh.section[e] = isShell(mesh.shapes[e])                ? section.thickness.value_or(unknown)
                      : mesh.shapes[e] == ElementShape::Beam ? section.area.value_or(unknown)
                                                             : unknown;
}

}  // namespace

void assignParts(const InputDeck* deck, const std::vector<NamedSet>& sets, Mesh& mesh, Findings& findings) {
    const std::size_t elements = mesh.elementIds.size();
    mesh.parts.clear();
    mesh.part.assign(elements, 0);
    mesh.density.assign(elements, unknown);
    mesh.section.assign(elements, unknown);
    const std::vector<std::size_t> smallest = smallestSets(sets, mesh);
    std::map<const DeckSection*, std::uint32_t> known;
    for (std::size_t e = 0; e < elements; ++e) {
        const bool inSet = smallest[e] < sets.size();
        const DeckSection* section = deck && !deck->hasInstances ? deck->sectionOf(mesh.elementIds[e]) : nullptr;
        if (!section && deck && inSet) {
            section = sectionNamed(*deck, sets[smallest[e]].name);
        }
        if (section) {
            applySection(*deck, *section, e, mesh);
        }
        const std::string name = section && !deck->hasInstances ? section->set
                                 : inSet                        ? sets[smallest[e]].name
                                                                : std::string(shapeName(mesh.shapes[e])) + "s";
        const auto shortCut = section && !deck->hasInstances ? known.find(section) : known.end();
        mesh.part[e] = shortCut != known.end() ? shortCut->second : partNamed(name, mesh);
        if (section && !deck->hasInstances) {
            known[section] = mesh.part[e];
        }
    }
    if (deck) {
        findings.append(deck->findings);
        findings.add({"deck.used", "Densities and sections were taken from the input deck", {}},
                     {"deck.used.remedy", "Check that it is the deck of this result.", {}},
                     std::filesystem::path(deck->path).filename().string());
    }
}

}  // namespace rubble::io
