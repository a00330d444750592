#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/fe/material.h"

namespace rubble::render {

struct Rgb {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;

    friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// Colours of a scene, given from outside (the palette of figures): render decides none.
struct SceneColours {
    Rgb skyTop, skyHorizon;
    Rgb ground, grid;
    Rgb earth;  ///< takes the place of ground in the presentation style
    Rgb water;
    Rgb divider;                                 ///< between panes
    Rgb fragment;                                ///< plain highlight
    Rgb selection;                               ///< accent
    Rgb outline;                                 ///< of the intact structure
    Rgb released;                                ///< islands of live structure after their release
    std::vector<Rgb> structure;                  ///< stone greys, taken in turn by component
    std::vector<Rgb> categories;                 ///< by component or cluster, taken in turn
    std::array<Rgb, 256> birthRamp{};            ///< first birth .. last birth
    std::array<Rgb, 256> speedRamp{};            ///< 0 .. Scene::speedTop()
    std::array<Rgb, 256> errorRamp{};            ///< the smallest error .. the largest
    std::array<Rgb, materialCount> materials{};  ///< by Material, of the presentation style
    Rgb unknown;                                 ///< a fragment that the reference does not have at this time
    double ambient = 0.4;                        ///< share of light that comes from everywhere
    double shadow = 0.8;                         ///< share of a shadow's depth that is drawn
    double groundTexture = 0.0;                  ///< share of light that the unevenness of ground takes at most
    double brightest = 1.0;                      ///< share of white that a picture of the ground reaches at most

    friend bool operator==(const SceneColours&, const SceneColours&) = default;
};

}  // namespace rubble::render
