#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/fe/frame.h"
#include "core/scenario/cloud_request.h"
#include "core/scenario/ensemble.h"
#include "core/scenario/evidence_settings.h"
#include "core/scenario/journal.h"
#include "core/scenario/photograph.h"
#include "core/scenario/registration.h"
#include "core/scenario/removal.h"
#include "core/scenario/scenario.h"
#include "core/scenario/site.h"
#include "core/scenario/survey_scope.h"

namespace rubble {

enum class InputRole { Fe, Terrain, Photograph, Survey, Orthophoto, Surroundings };

/// What a file of a survey holds. Points are those of a total station and lines of a drawing, which sections are held against.
enum class SurveyKind { Heights, Cloud, Outline, Points };
inline constexpr std::array<std::string_view, 4> surveyKindNames{"heights", "cloud", "outline", "points"};

/// What measured points are held to say: heights for sections, the edge of the debris in their order, or places of other evidence.
enum class PointsHeld { Section, Outline, Control };
inline constexpr std::array<std::string_view, 3> pointsHeldNames{"section", "outline", "control"};

/// A file that a case stands on, by relative path and SHA-256.
struct CaseInput {
    std::string id;  ///< "fe-1"
    InputRole role = InputRole::Fe;
    std::string path;    ///< relative to the case file, with forward slashes
    std::string sha256;  ///< hex; empty until first read
    /// Of a survey: whether it shows live structure that fell; unset: not known.
    std::optional<bool> showsFallen = std::nullopt;
    /// Of a mesh of the surroundings: m, added to its coordinates, as easting, northing and height; unset: as its own files say.
    std::optional<Vec3> offset = std::nullopt;
    SurveyScope scope = {};  ///< of a survey: what of it is compared
    /// Of a survey: standard deviation of its heights and of those of the ground, m; unset: not stated.
    std::optional<double> noise = std::nullopt;
    std::optional<double> groundNoise = std::nullopt;
    /// Of a survey: standard deviation of an offset that all its heights may have together, m; unset: not stated.
    std::optional<double> offsetError = std::nullopt;
    /// Of a survey: how it was moved to where it belongs; unset: it lies as its coordinates say.
    std::optional<Registration> registration = std::nullopt;
    std::string taken = {};  ///< of a survey: when, as clockTime() gives it; empty: not known
    bool before = false;     ///< of a survey: it was taken before the collapse and shows no debris
    /// Of a survey: s on the clock of the FE file, the instant of the collapse that it shows; unset: all lies at rest.
    std::optional<double> instant = std::nullopt;
    /// Of a terrain, surroundings or a survey that is a point cloud or a table: how it is read.
    CloudRequest read = {};
    /// Of a survey: what its file holds; unset: it was never looked at.
    std::optional<SurveyKind> kind = std::nullopt;
    /// Of measured points: what they are held to say.
    PointsHeld held = PointsHeld::Section;
    /// Of a survey that is a cloud: where its scanners stood, m, easting, northing and height; empty: as its file says.
    std::vector<Vec3> scanners = {};
    friend bool operator==(const CaseInput&, const CaseInput&) = default;
};

/// A named scenario of a case.
struct CaseScenario {
    std::string id;  ///< "scenario-1"
    std::string name;
    std::string note;
    std::string feInput;  ///< id of its FE input; empty: the first of the case
    Scenario scenario;
    friend bool operator==(const CaseScenario&, const CaseScenario&) = default;
};

/// An instant that somebody marked, and why.
struct Bookmark {
    double time = 0.0;  ///< s, as in the FE result
    std::string note;
    friend bool operator==(const Bookmark&, const Bookmark&) = default;
};

/// Where the camera of a movie stands at an instant. It moves smoothly from one key to the next.
struct CameraKey {
    double time = 0.0;                ///< s, as in the FE result
    Vec3 position = Vec3::Zero();     ///< m
    Vec3 focalPoint = Vec3::UnitX();  ///< m, what lies in the middle; not at the position
    Vec3 up = Vec3::UnitZ();          ///< upwards in the picture
    double viewAngle = 30.0;          ///< degrees, vertical
    bool parallel = false;            ///< parallel projection
    double parallelScale = 1.0;       ///< m, half the height of the picture then
    friend bool operator==(const CameraKey&, const CameraKey&) = default;
};

/// What a case file (*.rubble) holds.
struct Case {
    std::string title;
    Frame frame;
    std::vector<CaseInput> inputs;
    std::vector<CaseScenario> scenarios;
    std::string activeScenario;         ///< id
    std::vector<Bookmark> bookmarks;    ///< in the order of their times
    std::vector<CameraKey> cameraKeys;  ///< in the order of their times
    std::vector<Photograph> photographs;
    std::vector<Removal> removals;  ///< of debris, in the order of their times
    Site site;
    EnsembleSettings ensemble{usualVariations()};
    EvidenceSettings evidence;
    Journal journal;
    friend bool operator==(const Case&, const Case&) = default;
};

}  // namespace rubble
