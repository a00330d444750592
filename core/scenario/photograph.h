#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// A point of the model, the terrain or a survey, and where the picture shows it.
struct PointPair {
    std::string name;
    Eigen::Vector2d picture = Eigen::Vector2d::Zero();  ///< px, from the upper left corner
    Vec3 model = Vec3::Zero();                          ///< m
    friend bool operator==(const PointPair&, const PointPair&) = default;
};

/// What is known of the camera.
struct CameraKnowledge {
    int width = 0;  ///< px, of the picture
    int height = 0;
    std::optional<double> focal;               ///< px; unset: to be found
    std::optional<Eigen::Vector2d> principal;  ///< px; unset: the middle of the picture
    bool freePrincipal = false;                ///< it is to be found, from there
    std::optional<int> radialTerms;    ///< to be found, 0 to 2; unset: both, as far as the points tell them from real lenses
    Eigen::Vector2d radial{0.0, 0.0};  ///< known terms, or where the search begins
    friend bool operator==(const CameraKnowledge&, const CameraKnowledge&) = default;
};

/// What a part of a picture is said to show.
enum class MaskClass : std::uint8_t {
    Debris,     ///< the outline of the debris: what a silhouette is held against
    Moved,      ///< what rescuers moved: left out
    Hidden,     ///< something stands before the site: left out
    NotDebris,  ///< looks like debris and is none
};
inline constexpr std::array maskClasses{MaskClass::Debris, MaskClass::Moved, MaskClass::Hidden, MaskClass::NotDebris};

/// A polygon drawn on a photograph.
struct PhotoMask {
    MaskClass kind = MaskClass::Debris;
    std::vector<Eigen::Vector2d> corners;  ///< px, from the upper left corner; the last joined to the first
    friend bool operator==(const PhotoMask&, const PhotoMask&) = default;
};

/// What the file of a photograph says of itself.
struct PhotoFacts {
    int width = 0;  ///< px, upright
    int height = 0;
    int orientation = 1;  ///< as in EXIF: 1 upright, 3 upside down, 6 and 8 on a side, even mirrored or turned
    std::optional<std::array<int, 2>> recorded;  ///< px, upright, what the camera recorded; other than the size: cropped or resized
    std::optional<double> focalLength;           ///< mm
    std::optional<double> focalLength35;         ///< mm, on a frame of 36 x 24 mm
    std::string camera;                          ///< maker and model
    std::string taken;  ///< by the clock of the camera, see clockTime(); older cases have the colons of EXIF; empty: unknown
    std::optional<std::array<double, 2>> position;  ///< degrees north and east, WGS 84
    std::optional<double> altitude;                 ///< m
    friend bool operator==(const PhotoFacts&, const PhotoFacts&) = default;
};

/// A photograph of a case. Its file is the input of the same id; it is never changed. Pixels are those of the upright picture.
struct Photograph {
    std::string input;  ///< id of its file
    std::string note;
    PhotoFacts facts;
    std::optional<double> time;    ///< s, on the clock of the FE result; unset: when all lay at rest
    double timeUncertainty = 0.0;  ///< s, as much before as after
    CameraKnowledge camera;
    std::vector<PointPair> pairs;
    std::vector<PhotoMask> masks;
    friend bool operator==(const Photograph&, const Photograph&) = default;
};

/// True if the picture is a part of what the camera recorded: its middle is then not where the camera looked.
bool cropped(const PhotoFacts& facts);
/// Focal length in pixels that the file of a photograph tells by its equivalent on a frame of 36 x 24 mm; nothing if it does not. A
/// cropped picture is taken to have the pixels of what was recorded, any other to show all of it.
std::optional<double> focalFrom(const PhotoFacts& facts);

/// "2026-03-14 17:05:12" of a time as EXIF writes it, "2026:03:14 17:05:12", or as it is written here; empty if that is no time
/// that there was, as "0000:00:00 00:00:00" of a camera whose clock was never set.
std::string clockTime(std::string_view text);

/// "debris", "moved", "hidden", "not_debris": names of the classes in files.
std::string_view maskName(MaskClass kind);

}  // namespace rubble
