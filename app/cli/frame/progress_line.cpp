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
    m_stream << wipe << englishText(progress.stage) << "  " << static_cast<int>(fraction * 100.0) << " %";
    if (const double left = m_left.after(progress); std::isfinite(left)) {
        m_stream << "  " << durationText(left) << " left";
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
