#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/simulation/health/health.h"

namespace rubble {

/// Up to where a passed limit keeps its milder grade. What lies on one of them is still the milder.
struct HealthGradeLimits {
    double energyFinding = 0.01;      ///< of the work of gravity
    double penetrationNotice = 1.0;   ///< of the smallest side
    double crowdFinding = 0.02;       ///< share of the bodies
    double speedFinding = 1.25;       ///< of what birth and fall allow
    double belowGroundFinding = 0.5;  ///< m
    double asleepNotice = 0.80;       ///< share of the bodies that stay at rest
    double bulkingLeast = 1.05;       ///< a pile cannot be smaller than its material
    double bulkingMost = 2.5;         ///< of the material
};

/// "notice", "finding", "tainted".
std::string_view healthGradeName(HealthGrade grade);
/// The grade of a breach, by how far beyond its limit it is.
HealthGrade gradeOf(const HealthBreach& breach, const HealthGradeLimits& limits = {});
/// Why it has that grade: what it does to the debris.
Message gradeReason(const HealthBreach& breach, const HealthGradeLimits& limits = {});

/// A limit that was passed, once however often: command line, report, window and JSON list these.
struct PassedLimit {
    HealthCheck check{};
    HealthGrade grade{};                ///< of its worst breach
    std::size_t worst = 0;              ///< which breach of the report is the worst
    std::vector<std::size_t> breaches;  ///< of the report, in the order in which they began
};
/// In the order in which they were first passed. Bodies inside each other have two limits: of one body, and of many.
std::vector<PassedLimit> passedLimits(std::span<const HealthBreach> breaches);
/// The gravest grade of all; Notice if nothing was passed.
HealthGrade gravestGrade(std::span<const HealthBreach> breaches);
/// s, how long a limit was passed in all.
double heldFor(const PassedLimit& limit, std::span<const HealthBreach> breaches);

/// A value of a check for people, with its unit: "31 %", "4.7 times", "2.5 m".
Message healthMeasure(HealthCheck check, double value);
/// Why a bulking factor outside its limits is no breach: the debris is too thin to be a pile. Unset where it lies within them, was
/// told as a breach, or is not a number.
std::optional<Message> thinPile(double bulking, std::span<const HealthBreach> breaches, const HealthLimits& limits = {});
/// "1 body", "17 bodies", as a text that the window translates.
std::string bodiesText(std::int64_t count);

}  // namespace rubble
