#include "app/cli/frame/progress_line.h"

#include <algorithm>
#include <cmath>

#include "core/base/message.h"
#include "core/simulation/run/checkpoint.h"

namespace rubble::cli {

namespace {

constexpr std::string_view wipe = "\r\x1b[K";

std::string durationText(double seconds) {
    const auto whole = static_cast<std::int64_t>(std::ceil(seconds));
    if (whole < 120) {
        return std::to_string(whole) + " s";
    }
    return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

}  // namespace

void ProgressLine::show(const Progress& progress) {
    say(progress.stage);
    if (!m_on) {
        return;
    }
    const std::lock_guard lock(m_mutex);
    const double fraction = std::clamp(progress.fraction, 0.0, 1.0);
    if (progress.stage.id != m_stage || fraction < m_firstFraction) {
        m_stage = progress.stage.id;
        m_firstFraction = fraction;
        m_stageStart = Clock::now();
    }
    m_stream << wipe << englishText(progress.stage) << "  " << static_cast<int>(fraction * 100.0) << " %";
    // An estimate from the first moments would only jump about.
    const double elapsed = std::chrono::duration<double>(Clock::now() - m_stageStart).count();
    const double done = fraction - m_firstFraction;
    if (elapsed > 0.5 && done > 0.01 && fraction < 1.0) {
        m_stream << "  " << durationText(elapsed * (1.0 - fraction) / done) << " left";
    }
    m_stream << std::flush;
    m_shown = true;
}

void ProgressLine::say(const Message& stage) {
    if (stage.id != resumedStage && stage.id != worldsResumedStage) {
        return;
    }
    const std::string text = englishText(stage);
    const std::lock_guard lock(m_mutex);
    if (text != m_said) {
        m_stream << (m_shown ? wipe : "") << text << std::endl;
        m_shown = false;
        m_said = text;
    }
}

void ProgressLine::clear() {
    const std::lock_guard lock(m_mutex);
    if (m_shown) {
        m_stream << wipe << std::flush;
        m_shown = false;
    }
}

}  // namespace rubble::cli
