#include "core/simulation/run/terrain_ends.h"

namespace rubble {

namespace {

/// Debris on ground of one source.
struct OnGuess {
    std::int64_t count = 0;
    Aabb box;
    std::size_t farthest = 0;
    double beyond = -1.0;  ///< m, from the window about the structure
};

}  // namespace

void addTerrainEnds(const TerrainGrid& terrain, std::span<const Vec3> places, const std::function<std::string(std::size_t)>& nameOf,
                    Findings& findings) {
    OnGuess ended;
    OnGuess unread;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Vec3& place = places[i];
        const TerrainGrid::Source source = place.allFinite() ? terrain.source(place.x(), place.y()) : TerrainGrid::Source::Raster;
        if (source == TerrainGrid::Source::Raster) {
            continue;
        }
        OnGuess& guess = source == TerrainGrid::Source::Ended ? ended : unread;
        ++guess.count;
        guess.box.extend(place);
        Aabb window = terrain.window();
        window.extend(Vec3(window.center().x(), window.center().y(), place.z()));
        const double beyond = window.exteriorDistance(place);
        if (beyond > guess.beyond) {
            guess.beyond = beyond;
            guess.farthest = i;
        }
    }
    const auto extentOf = [](const OnGuess& guess) {
        const Vec3 low = guess.box.min();
        const Vec3 high = guess.box.max();
        return std::vector<Argument>{low.x(), {high.x(), "m"}, low.y(), {high.y(), "m"}};
    };
    const auto exampleOf = [&](const OnGuess& guess) {
        const Vec3& place = places[guess.farthest];
        return nameOf(guess.farthest) + " at x = " + englishNumber(place.x()) + " m, y = " + englishNumber(place.y()) + " m";
    };
    if (ended.count > 0) {
        findings.add(
            {"simulation.terrain_ended",
             "{0} pieces of debris ran beyond the end of the terrain, where its raster has no heights: the ground there is "
             "a level guess",
             {ended.count}},
            {"simulation.terrain_ended.remedy", "give a larger raster, beyond x = {0} to {1}, y = {2} to {3} of the local frame",
             extentOf(ended)},
            exampleOf(ended), ended.count);
    }
    if (unread.count > 0) {
        findings.add(
            {"simulation.terrain_unread",
             "{0} pieces of debris ran beyond the part of the terrain that there was room for: the ground there is a level "
             "guess, though the raster goes on",
             {unread.count}},
            {"simulation.terrain_unread.remedy",
             "make the raster coarser, or cut it about x = {0} to {1}, y = {2} to {3} of the local frame", extentOf(unread)},
            exampleOf(unread), unread.count);
    }
}

void addWaterMissed(double level, std::span<const Vec3> places, const std::function<std::string(std::size_t)>& nameOf,
                    Findings& findings) {
    std::int64_t below = 0;
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const bool wet = places[i].z() < level;
        lowest = wet && (below == 0 || places[i].z() < places[lowest].z()) ? i : lowest;
        below += wet ? 1 : 0;
    }
    if (below > 0) {
        findings.add({"simulation.water_missed",
                      "{0} pieces of debris ran to below the level of the water, which acted on nothing: no flight leads there",
                      {below}},
                     {"simulation.water_missed.remedy", "set water=on and simulate again", {}},
                     nameOf(lowest) + " at z = " + englishNumber(places[lowest].z()) + " m", below);
    }
}

void addTerrainRoughness(const TerrainGrid* terrain, const EffectSettings& effects, Findings& findings) {
    if (!(effects.terrainRoughness > 0.0)) {
        return;
    }
    if (terrain == nullptr) {
        findings.add({"simulation.roughness_alone",
                      "terrain_roughness = {0} has no terrain to lie on: the level ground is smooth",
                      {{effects.terrainRoughness, "m"}}},
                     {"simulation.roughness_alone.remedy", "give a terrain, or set terrain_roughness to 0", {}});
        return;
    }
    const TerrainRoughness& rough = terrain->roughness();
    findings.add(
        {"simulation.terrain_rough",
         "the terrain was given obstacles of {0} on average, {1} apart, at random (seed {2}): nobody measured where they are",
         {{rough.height, "m"}, {rough.spacing, "m"}, static_cast<std::int64_t>(rough.seed)}},
        {"simulation.terrain_rough.remedy", "repeat with other seeds, or give a finer terrain and no terrain_roughness", {}});
}

}  // namespace rubble
