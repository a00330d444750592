#include "widgets/figures/movie.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QFontMetricsF>
#include <QPainter>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/base/error.h"
#include "widgets/figures/camera_path.h"
#include "widgets/figures/figure_sheet.h"
#include "widgets/figures/marks.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/translated.h"

namespace rubble::figures {
namespace {

constexpr std::size_t longest = 100000;
constexpr double movieTextPoints = 9.0;
constexpr int startTimeoutMs = 20000;
constexpr int writeTimeoutMs = 120000;   // an encoder that takes nothing for so long hangs
constexpr int finishTimeoutMs = 600000;  // as does one that is not done so long after the last picture
constexpr qsizetype saidMost = 4096;     // of what an encoder says, the end

WorldError movieError(const std::string& path, const QString& why) {
    return {{"movie.write", "{0}: the movie cannot be written: {1}", {path, why.trimmed().toStdString()}},
            {"movie.write.remedy", "Make room, choose another folder, or write a folder of pictures instead of an MP4.", {}}};
}

/// The folder that was asked for if it is empty or can be made; where a movie lies in it already, the next free one beside it.
/// Throws WorldError if it holds anything but pictures of a movie.
QDir freeFolder(const std::string& folder) {
    static const QRegularExpression ours(QStringLiteral("^frame-\\d{5,}\\.png$"));
    const QString asked = QDir::cleanPath(QString::fromStdString(folder));
    for (int number = 1;; ++number) {
        const QDir place(number == 1 ? asked : asked + u'-' + QString::number(number));
        const QStringList names = place.entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
        if (names.isEmpty() && (place.exists() || !QFileInfo::exists(place.path()))) {
            return place;
        }
        for (const QString& name : names) {
            if (number == 1 && !ours.match(name).hasMatch()) {
                throw WorldError(
                    {"movie.folder", "{0} holds something else than pictures of a movie: {1}", {folder, name.toStdString()}},
                    {"movie.folder.remedy", "Choose an empty folder, or a new one.", {}});
            }
        }
        if (number == 1 && names.isEmpty()) {
            throw movieError(folder, tr("a file has the name of the folder"));
        }
    }
}

/// Numbered PNG in a folder; those that it made are taken away again unless it was finished.
class PictureSequence : public MovieTarget {
public:
    PictureSequence(const std::string& folder, std::string metadata)
        : m_folder(freeFolder(folder)), m_metadata(std::move(metadata)) {
        m_made = !m_folder.exists();
        if (!m_folder.mkpath(QStringLiteral("."))) {
            throw movieError(folder, tr("the folder cannot be made"));
        }
    }
    ~PictureSequence() override {
        if (!m_finished) {
            for (std::size_t i = 1; i <= m_count; ++i) {
                m_folder.remove(name(i));
            }
            if (m_made) {
                QDir().rmdir(m_folder.path());
            }
        }
    }

    void add(const QImage& picture) override {
        const QString file = m_folder.filePath(name(m_count + 1));
        if (QFileInfo::exists(file)) {
            throw movieError(path(), tr("%1 is there already, and not of this movie").arg(name(m_count + 1)));
        }
        ++m_count;
        writePng(file.toStdString(), picture, m_metadata);
    }
    void finish() override { m_finished = true; }
    std::string path() const override { return m_folder.path().toStdString(); }

private:
    static QString name(std::size_t number) { return QStringLiteral("frame-%1.png").arg(number, 5, 10, QLatin1Char('0')); }

    QDir m_folder;
    std::string m_metadata;
    std::size_t m_count = 0;
    bool m_made = false;
    bool m_finished = false;
};

QString ffmpegPath() {
    return QStandardPaths::findExecutable(QStringLiteral("ffmpeg"));
}

bool hasH264(const QString& program) {
    QProcess asked;
    asked.start(program, {QStringLiteral("-hide_banner"), QStringLiteral("-encoders")});
    return asked.waitForFinished(startTimeoutMs) && asked.readAllStandardOutput().contains("libx264");
}

/// What an encoder said last, fit to be read: three lines of printable letters.
QString lastWords(const QByteArray& said) {
    QStringList lines;
    for (QString line : QString::fromLocal8Bit(said).split(QLatin1Char('\n'))) {
        std::replace_if(line.begin(), line.end(), [](QChar c) { return !c.isPrint() || c == QChar::ReplacementCharacter; }, u' ');
        if (line = line.simplified(); !line.isEmpty()) {
            constexpr int longestLine = 200;
            lines << line.left(longestLine);
        }
    }
    return lines.mid(std::max<qsizetype>(0, lines.size() - 3)).join(QStringLiteral("; "));
}

/// True if a file consists of whole boxes of an MP4, the index of its pictures among them.
bool wholeMp4(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return false;
    }
    bool index = false;
    qint64 at = 0;
    while (at < file.size()) {
        std::array<uchar, 16> head{};
        if (!file.seek(at) || file.read(reinterpret_cast<char*>(head.data()), 8) != 8) {
            return false;
        }
        quint64 length = qFromBigEndian<quint32>(head.data());
        if (length == 1) {
            if (file.read(reinterpret_cast<char*>(head.data() + 8), 8) != 8) {
                return false;
            }
            length = qFromBigEndian<quint64>(head.data() + 8);
        }
        if (length < 8 || length > static_cast<quint64>(file.size() - at)) {
            return false;
        }
        index = index || std::equal(head.begin() + 4, head.begin() + 8, "moov");
        at += static_cast<qint64>(length);
    }
    return index;
}

/// Pictures handed to ffmpeg through a pipe; the file is beside its place until it is whole.
class EncodedMovie : public MovieTarget {
public:
    EncodedMovie(const std::string& path, QSize pixels, double fps, const std::string& metadata)
        : m_path(path), m_part(QString::fromStdString(path) + QStringLiteral(".part")), m_pixels(pixels) {
        const QString program = ffmpegPath();
        if (program.isEmpty()) {
            throw WorldError({"movie.no_ffmpeg", "An MP4 needs the program ffmpeg, which is not installed", {}},
                             {"movie.no_ffmpeg.remedy",
                              "Install the package ffmpeg, or name a folder instead of an MP4: it gets the pictures, numbered.",
                              {}});
        }
        QFile room(m_part);
        if (!room.open(QIODevice::WriteOnly)) {
            throw movieError(path, room.errorString());
        }
        room.close();
        const QString size = QStringLiteral("%1x%2").arg(pixels.width()).arg(pixels.height());
        // Without -xerror a file whose end found no room counts as written.
        QStringList words{QStringLiteral("-xerror"),
                          QStringLiteral("-hide_banner"),
                          QStringLiteral("-loglevel"),
                          QStringLiteral("error"),
                          QStringLiteral("-y"),
                          QStringLiteral("-f"),
                          QStringLiteral("rawvideo"),
                          QStringLiteral("-pix_fmt"),
                          QStringLiteral("bgr0"),
                          QStringLiteral("-s"),
                          size,
                          QStringLiteral("-framerate"),
                          QString::number(fps, 'g', 10),
                          QStringLiteral("-i"),
                          QStringLiteral("pipe:0"),
                          QStringLiteral("-an"),
                          QStringLiteral("-pix_fmt"),
                          QStringLiteral("yuv420p")};
        words += hasH264(program)
                     ? QStringList{QStringLiteral("-c:v"),     QStringLiteral("libx264"), QStringLiteral("-preset"),
                                   QStringLiteral("veryfast"), QStringLiteral("-crf"),    QStringLiteral("18")}
                     : QStringList{QStringLiteral("-c:v"), QStringLiteral("mpeg4"), QStringLiteral("-q:v"), QStringLiteral("2")};
        words << QStringLiteral("-movflags") << QStringLiteral("+faststart");
        if (!metadata.empty()) {
            words << QStringLiteral("-metadata") << QStringLiteral("title=Rubble") << QStringLiteral("-metadata")
                  << QStringLiteral("comment=") + QString::fromStdString(metadata);
        }
        words << QStringLiteral("-f") << QStringLiteral("mp4") << m_part;
        m_encoder.start(program, words);
        if (!m_encoder.waitForStarted(startTimeoutMs)) {
            throw movieError(m_path, m_encoder.errorString());
        }
    }
    ~EncodedMovie() override {
        if (!m_finished) {
            m_encoder.kill();
            m_encoder.waitForFinished(startTimeoutMs);
            QFile::remove(m_part);
        }
    }

    void add(const QImage& picture) override {
        const QImage frame = picture.convertToFormat(QImage::Format_RGB32);
        if (frame.size() != m_pixels) {
            throw movieError(m_path, QStringLiteral("%1 x %2").arg(frame.width()).arg(frame.height()));
        }
        for (int y = 0; y < frame.height(); ++y) {
            m_encoder.write(reinterpret_cast<const char*>(frame.constScanLine(y)), qint64{4} * frame.width());
        }
        while (m_encoder.bytesToWrite() > 0) {
            if (m_encoder.state() != QProcess::Running || !m_encoder.waitForBytesWritten(writeTimeoutMs)) {
                fail();
            }
            listen();
        }
    }

    void finish() override {
        m_encoder.closeWriteChannel();
        if (!m_encoder.waitForFinished(finishTimeoutMs) || m_encoder.exitStatus() != QProcess::NormalExit ||
            m_encoder.exitCode() != 0 || !wholeMp4(m_part)) {
            fail();
        }
        std::error_code failed;
        std::filesystem::rename(m_part.toStdString(), m_path, failed);
        if (failed) {
            throw movieError(m_path, QString::fromStdString(failed.message()));
        }
        m_finished = true;
    }
    std::string path() const override { return m_path; }

private:
    /// Keeps the end of what it says: it may say the same for every picture.
    void listen() { m_said = (m_said + m_encoder.readAllStandardError()).right(saidMost); }

    [[noreturn]] void fail() {
        m_encoder.closeWriteChannel();
        const bool ended = m_encoder.state() == QProcess::NotRunning || m_encoder.waitForFinished(startTimeoutMs);
        listen();
        const QString words = lastWords(m_said);
        QString why = !ended                                          ? tr("ffmpeg does not answer")
                      : m_encoder.exitStatus() == QProcess::CrashExit ? tr("ffmpeg was killed, or crashed")
                      : m_encoder.exitCode() == 0                     ? tr("ffmpeg left no whole MP4")
                                                                      : tr("ffmpeg ended before the movie did");
        throw movieError(m_path, words.isEmpty() ? why : why + QStringLiteral(" (") + words + u')');
    }

    std::string m_path;
    QString m_part;
    QSize m_pixels;
    QProcess m_encoder;
    QByteArray m_said;
    bool m_finished = false;
};

/// "t = 5.76 s", and how fast the movie runs where that is not real time, at the upper right. @param besideAxes  the directions of
/// the axes stand in the corner
void printTime(QImage& picture, double time, double pace, render::Theme theme, double textHeight, bool besideAxes) {
    QString text = QStringLiteral("t = ") + timeText(time);
    if (std::abs(pace - 1.0) > 1e-9) {
        text += QStringLiteral(" · ") + (paceIsTime(pace) ? tr("%1 of collapse in a second").arg(timeText(pace))
                                         : pace < 1.0     ? tr("%1 times slower").arg(numberText(1.0 / pace))
                                                          : tr("%1 times faster").arg(numberText(pace)));
    }
    QFont font;
    font.setPixelSize(std::max(8, static_cast<int>(std::lround(1.4 * textHeight))));
    const QFontMetricsF metrics(font);
    const double pad = 0.5 * textHeight;
    const double width = metrics.horizontalAdvance(text) + 2.0 * pad;
    const double right = picture.width() - (besideAxes ? axesRoom(textHeight) : pad);
    const QRectF box(std::max(pad, right - width), pad, width, metrics.height() + 0.6 * pad);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette(theme).chip);
    painter.drawRoundedRect(box, 0.3 * pad, 0.3 * pad);
    painter.setFont(font);
    painter.setPen(palette(theme).chipText);
    painter.drawText(box, static_cast<int>(Qt::AlignCenter), text);
}

/// The picture above a strip with what must be known of the run. @param pixels  of both together
QImage withCautions(const QImage& picture, const QSize& pixels, const FigureStyle& style, render::Theme theme) {
    QImage whole(pixels, QImage::Format_RGB32);
    QPainter painter(&whole);
    painter.drawImage(0, 0, picture);
    paintCautions(painter, QRectF(0.0, picture.height(), pixels.width(), pixels.height() - picture.height()),
                  QString::fromStdString(style.cautions), movieTextPoints / 72.0 * style.dpi, theme);
    return whole;
}

}  // namespace

std::pair<double, double> movieSpan(const FeResult& fe, const TrajectoryReader* run) {
    const double first = fe.times().front();
    const bool ran = run != nullptr && run->frameCount() > 0;
    return {first, ran ? std::max(first, run->frameTime(run->frameCount() - 1)) : fe.times().back()};
}

std::size_t movieLength(const MovieSettings& settings) {
    const bool sound = settings.fps >= 1.0 && settings.fps <= 120.0 && settings.pace >= 1e-8 && settings.pace <= 1e3 &&
                       std::isfinite(settings.from) && settings.to > settings.from;
    const double pictures = sound ? std::floor((settings.to - settings.from) / settings.pace * settings.fps + 1e-6) + 1.0
                                  : std::numeric_limits<double>::infinity();
    if (!sound || pictures > static_cast<double>(longest)) {
        throw UsageError(
            {"movie.settings",
             "A movie from {0} to {1} with {2} pictures per second at {3} times the pace of the collapse cannot be made",
             {{settings.from, "s"}, {settings.to, "s"}, settings.fps, settings.pace}},
            {"movie.settings.remedy",
             "Ask for 1 to 120 pictures per second, a pace from 0.00000001 to 1000 and at most {0} pictures in all.",
             {longest}});
    }
    return static_cast<std::size_t>(pictures);
}

double movieTime(const MovieSettings& settings, std::size_t picture) {
    return std::min(settings.from + static_cast<double>(picture) * settings.pace / settings.fps, settings.to);
}

QSize evenSize(QSize pixels) {
    return {pixels.width() & ~1, pixels.height() & ~1};
}

bool ffmpegInstalled() {
    return !ffmpegPath().isEmpty();
}

std::unique_ptr<MovieTarget> pictureSequence(const std::string& folder, const std::string& metadata) {
    return std::make_unique<PictureSequence>(folder, metadata);
}

std::unique_ptr<MovieTarget> mp4Movie(const std::string& path, QSize pixels, double fps, const std::string& metadata) {
    return std::make_unique<EncodedMovie>(path, pixels, fps, metadata);
}

std::unique_ptr<MovieTarget> movieTarget(const std::string& path, QSize pixels, double fps, const std::string& metadata) {
    return QString::fromStdString(path).endsWith(QLatin1String(".mp4"), Qt::CaseInsensitive)
               ? mp4Movie(path, evenSize(pixels), fps, metadata)
               : pictureSequence(path, metadata);
}

void makeMovie(Studio& studio, render::View view, FigureStyle style, const MovieSettings& settings, MovieTarget& target,
               const Execution& execution) {
    const std::size_t pictures = movieLength(settings);
    style.framed = false;
    style.pixels = evenSize(style.pixels);
    style.provenance.clear();
    const QSize pixels = style.pixels;
    const double text = movieTextPoints / 72.0 * style.dpi;
    if (!style.cautions.empty()) {
        style.pixels.rheight() -= std::min(cautionHeight(text), pixels.height() / 4);
    }
    for (std::size_t i = 0; i < pictures; ++i) {
        execution.check();
        view.time = movieTime(settings, i);
        lookAlong(view, settings.cameras, view.time);
        QImage picture = studio.picture(view, style);
        printTime(picture, view.time - view.timeOrigin, settings.pace, view.theme, text, view.axes);
        target.add(style.cautions.empty() ? picture : withCautions(picture, pixels, style, view.theme));
        execution.report({"movie.drawing", "Drawing the movie: picture {0} of {1}", {i + 1, pictures}},
                         static_cast<double>(i + 1) / static_cast<double>(pictures));
    }
    target.finish();
}

}  // namespace rubble::figures
