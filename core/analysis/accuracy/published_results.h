#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace rubble {

/// One case of the published method: Xu, Lu, Guan, Ren, Automation in Construction 35 (2013) 471-481, tables 1 and 2, on a GTX 480.
struct PublishedCase {
    std::string_view name;
    std::int64_t elements;
    std::int64_t fragments;
    double fpsWithout;  ///< a body per fragment
    std::int64_t clusters;
    double fpsWith;                       ///< with them
    std::array<double, 3> accuracyRates;  ///< within 0.1, 0.2, 0.3 m
};

inline constexpr std::array<PublishedCase, 2> publishedCases{{
    {"stone arch (published)", 60320, 51101, 0.8, 4086, 20.0, {0.9653, 0.9837, 0.9991}},
    {"RC arch (published)", 26375, 7233, 11.0, 1012, 62.0, {0.9732, 0.9993, 1.0}},
}};

/// A point of the published FPS against bodies: figure 7, and the four of table 1.
struct PublishedRate {
    std::int64_t bodies;
    double fps;
};
inline constexpr std::array<PublishedRate, 5> publishedRates{
    {{1012, 62.0}, {4086, 20.0}, {4500, 24.0}, {7233, 11.0}, {51101, 0.8}}};

}  // namespace rubble
