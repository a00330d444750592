#pragma once

#include <QImage>
#include <QSize>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/execution.h"
#include "core/scenario/case.h"
#include "widgets/figures/figure_file.h"

namespace rubble::figures {

/// Which instants a movie shows and how fast.
struct MovieSettings {
    double from = 0.0;  ///< s, on the file's clock
    double to = 0.0;    ///< s
    double fps = 25.0;  ///< pictures per second of the movie
    double pace = 1.0;  ///< seconds of the collapse in a second of the movie: 1 is real time, 0.25 four times slower
    std::vector<CameraKey> cameras = {};  ///< along which it looks; empty: the cameras of the view
};

/// First and last instant that a movie may show, s: as far as the run has come, without one as far as the FE result goes.
/// @param run  null: none, or its fragments are not shown
std::pair<double, double> movieSpan(const FeResult& fe, const TrajectoryReader* run);

/// How many pictures it has: the first at `from`, the last at `to` or less than a picture before it.
/// Throws UsageError for a rate or pace out of range, an empty span, and for more than 100,000 pictures.
std::size_t movieLength(const MovieSettings& settings);
/// s, on the file's clock.
double movieTime(const MovieSettings& settings, std::size_t picture);

/// Takes the pictures of a movie one after the other. One that is not finished leaves nothing behind.
class MovieTarget {
public:
    virtual ~MovieTarget() = default;
    /// Throws WorldError (disk full, the encoder has ended).
    virtual void add(const QImage& picture) = 0;
    /// The movie is whole and gets its name.
    virtual void finish() = 0;
    /// Where it lies, or will.
    virtual std::string path() const = 0;
};

/// Numbered pictures in a folder, frame-00001.png and on; made if it is not there. Beside one that holds pictures of an earlier
/// movie a new one is made: FOLDER-2, FOLDER-3 and so on, as path() tells. Nothing is removed or replaced that it has not written.
/// @param metadata  of every picture
/// Throws WorldError if the folder holds anything else or cannot be made.
std::unique_ptr<MovieTarget> pictureSequence(const std::string& folder, const std::string& metadata);

/// An MP4 (H.264, or MPEG-4 where the encoder lacks it) through the program ffmpeg, which is found by PATH.
/// @param pixels  of the pictures, even numbers
/// Throws WorldError if ffmpeg is not installed or does not start.
std::unique_ptr<MovieTarget> mp4Movie(const std::string& path, QSize pixels, double fps, const std::string& metadata);
/// Whether a program of the name ffmpeg is installed.
bool ffmpegInstalled();

/// The target that a path asks for: an MP4 if it ends in .mp4, else a folder of pictures.
std::unique_ptr<MovieTarget> movieTarget(const std::string& path, QSize pixels, double fps, const std::string& metadata);
/// Pictures of a movie have sides of even numbers.
QSize evenSize(QSize pixels);

/// Draws a movie picture by picture, time and pace printed on each, and the cautions of its style below. Throws what drawing and
/// the target throw, and Cancelled.
/// @param style  unframed; its size is made even
void makeMovie(Studio& studio, render::View view, FigureStyle style, const MovieSettings& settings, MovieTarget& target,
               const Execution& execution);

}  // namespace rubble::figures
