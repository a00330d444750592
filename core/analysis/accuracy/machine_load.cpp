#include "core/analysis/accuracy/machine_load.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>

#include "core/base/unknown.h"

namespace rubble {

namespace {

/// s of wall clock below which the ticks of the system's clock say nothing.
constexpr double shortest = 0.1;

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

MachineLoad::MachineLoad() : m_start(read()) {}

MachineLoad::Counters MachineLoad::read() {
    std::ifstream stream("/proc/stat");
    std::string name;
    // user, nice, system, idle, waiting, interrupts, soft interrupts, stolen: proc(5).
    double ticks[8]{};
    stream >> name;
    for (double& tick : ticks) {
        stream >> tick;
    }
    rusage usage{};
    if (!stream || name != "cpu" || getrusage(RUSAGE_SELF, &usage) != 0) {
        return {unknown, unknown, unknown};
    }
    const double perSecond = static_cast<double>(sysconf(_SC_CLK_TCK));
    const double idle = (ticks[3] + ticks[4]) / perSecond;
    double all = 0.0;
    for (const double tick : ticks) {
        all += tick / perSecond;
    }
    return {all - idle, all, seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

double MachineLoad::othersShare() const {
    const Counters now = read();
    const double all = now.all - m_start.all;
    const double processors = static_cast<double>(std::max(1u, std::thread::hardware_concurrency()));
    if (!(all >= shortest * processors)) {
        return unknown;
    }
    return std::clamp((now.busy - m_start.busy - (now.own - m_start.own)) / all, 0.0, 1.0);
}

}  // namespace rubble
