#include "core/fe/state_read_ahead.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

namespace rubble {

namespace {

constexpr double sameTime = 1e-6;     // s; a view's time that went through text still hits its state
constexpr double longestPause = 1.0;  // s of the wall clock, and of the collapse, beyond which time has jumped
constexpr double smoothing = 0.3;     // of a new pace, or of a new duration of reading

double wallClock() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

/// The thread, and the states that it and its owner have brought.
struct StateReadAhead::Reader {
    using State = std::shared_ptr<const FeState>;

    explicit Reader(const FeResult& result) : fe(result), thread([this] { run(); }) {}

    ~Reader() {
        {
            const std::lock_guard lock(mutex);
            stopped = true;
            wanted.reset();
        }
        changed.notify_all();
        thread.join();
    }

    void run() {
        std::unique_lock lock(mutex);
        while (true) {
            changed.wait(lock, [&] { return stopped || wanted; });
            if (stopped) {
                return;
            }
            reading = wanted;
            wanted.reset();
            const std::size_t k = *reading;
            readingFor = jumps;
            lock.unlock();
            const double begun = wallClock();
            State state;
            try {
                state = fe.state(k);
            } catch (...) {  // who needs the state meets the error when it reads it
            }
            lock.lock();
            if (state && readingFor == jumps) {
                states[k] = std::move(state);
                const double took = wallClock() - begun;
                seconds = seconds > 0.0 ? (1.0 - smoothing) * seconds + smoothing * took : took;
            }
            reading.reset();
            changed.notify_all();
        }
    }

    /// What was read or asked for is of no use any more. Under the lock.
    void forget() {
        ++jumps;
        states.clear();
        wanted.reset();
    }
    /// A state that is still of use is to come. Under the lock.
    bool underWay() const { return wanted || (reading && readingFor == jumps); }

    const FeResult& fe;
    std::mutex mutex;
    std::condition_variable changed;
    std::map<std::size_t, State> states;
    std::optional<std::size_t> wanted;
    std::optional<std::size_t> reading;
    std::size_t jumps = 0;  ///< what was asked for before the last one is not kept
    std::size_t readingFor = 0;
    double seconds = 0.0;  ///< that reading a state takes
    bool stopped = false;
    std::thread thread;  // last: it uses all the others
};

StateReadAhead::StateReadAhead(std::shared_ptr<const FeResult> fe) : m_fe(std::move(fe)) {}

StateReadAhead::~StateReadAhead() = default;

std::size_t StateReadAhead::stateAt(double time) const {
    const std::vector<double>& times = m_fe->times();
    const auto after = std::upper_bound(times.begin(), times.end(), time + sameTime);
    return after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
}

StateReadAhead::Interval StateReadAhead::next(double time) {
    {
        const std::lock_guard calls(m_calls);
        if (m_reader) {
            const std::lock_guard lock(m_reader->mutex);
            m_reader->forget();
        }
    }
    return read(time);
}

StateReadAhead::Interval StateReadAhead::read(double time) const {
    const std::size_t k = stateAt(time);
    Interval interval{k, k, k, m_fe->state(k), nullptr, nullptr};
    if (k + 1 < m_fe->stateCount()) {
        interval.to = k + 1;
        interval.atTo = m_fe->state(k + 1);
        if (k > 0 && interval.atFrom->velocities.empty()) {
            interval.before = k - 1;
            interval.atBefore = m_fe->state(k - 1);
        }
    }
    return interval;
}

/// How fast time goes, from one call with another time to the next.
void StateReadAhead::notePace(double time) {
    const double now = wallClock();
    const double step = time - m_time;
    const double wall = now - m_calledAt;
    if (m_calledAt >= 0.0 && step == 0.0 && wall <= longestPause) {
        return;
    }
    const bool turned = m_pace * step < 0.0;
    if (m_calledAt < 0.0 || wall > longestPause || std::abs(step) > longestPause || turned) {
        m_pace = 0.0;
        const std::lock_guard lock(m_reader->mutex);
        m_reader->forget();
    } else {
        const double pace = step / std::max(wall, sameTime);
        m_pace = m_pace == 0.0 ? pace : (1.0 - smoothing) * m_pace + smoothing * pace;
    }
    m_time = time;
    m_calledAt = now;
}

/// How far apart states may lie for reading to keep up, s.
double StateReadAhead::gap() const {
    const std::lock_guard lock(m_reader->mutex);
    return std::min(std::abs(m_pace) * m_reader->seconds / readingShare, widest);
}

std::optional<StateReadAhead::Interval> StateReadAhead::around(std::size_t state) const {
    const std::lock_guard lock(m_reader->mutex);
    const auto& states = m_reader->states;
    const auto to = states.upper_bound(state);
    const bool lastState = state + 1 == m_fe->stateCount();
    if (to == states.begin() || (lastState ? std::prev(to)->first != state : to == states.end())) {
        return std::nullopt;
    }
    const auto from = std::prev(to);
    Interval interval{from->first, from->first, from->first, from->second, nullptr, nullptr};
    if (to != states.end()) {
        interval.to = to->first;
        interval.atTo = to->second;
    }
    if (from != states.begin()) {
        interval.before = std::prev(from)->first;
        interval.atBefore = std::prev(from)->second;
    }
    return interval;
}

/// Where reading is under way to a state that closes the interval, that is waited for; else the states next to the time are read.
StateReadAhead::Interval StateReadAhead::waitFor(double time, std::size_t state) {
    {
        std::unique_lock lock(m_reader->mutex);
        m_reader->changed.wait(lock, [&] { return !m_reader->underWay(); });
    }
    if (auto interval = around(state)) {
        return *interval;
    }
    const Interval interval = read(time);
    const std::lock_guard lock(m_reader->mutex);
    m_reader->states[interval.from] = interval.atFrom;
    if (interval.atTo) {
        m_reader->states[interval.to] = interval.atTo;
    }
    if (interval.atBefore) {
        m_reader->states[interval.before] = interval.atBefore;
    }
    return interval;
}

/// Asks for the state that the interval after this one will need, and lets go of what lies behind.
void StateReadAhead::ask(const Interval& interval) {
    const double apart = gap();
    const std::vector<double>& times = m_fe->times();
    const std::lock_guard lock(m_reader->mutex);
    auto& states = m_reader->states;
    std::optional<std::size_t> wanted;
    if (m_pace > 0.0 && interval.to + 1 < times.size()) {
        // The last one within the gap, and at least the next one.
        const auto beyond = std::upper_bound(times.begin(), times.end(), times[interval.to] + apart);
        wanted = std::max(interval.to + 1, static_cast<std::size_t>(beyond - times.begin()) - 1);
        const bool there = states.upper_bound(interval.to) != states.end();
        if (there) {
            wanted.reset();
        }
    } else if (m_pace < 0.0 && interval.from > 0) {
        const auto within = std::lower_bound(times.begin(), times.end(), times[interval.from] - apart);
        wanted = std::min(interval.from - 1, static_cast<std::size_t>(within - times.begin()));
        const bool there = states.lower_bound(interval.from) != states.begin();
        if (there) {
            wanted = std::nullopt;
        }
    }
    while (states.size() >= kept) {
        // One is to come, and one before the interval is of use.
        const bool ahead = m_pace >= 0.0 ? states.begin()->first < interval.from : states.rbegin()->first <= interval.to;
        states.erase(ahead ? states.begin() : std::prev(states.end()));
    }
    if (wanted && !m_reader->reading) {
        m_reader->wanted = wanted;
        m_reader->changed.notify_all();
    }
}

StateReadAhead::Interval StateReadAhead::nearest(double time) {
    const std::lock_guard calls(m_calls);
    if (!m_reader) {
        m_reader = std::make_unique<Reader>(*m_fe);
    }
    notePace(time);
    const std::size_t state = stateAt(time);
    const auto found = around(state);
    const Interval interval = found ? *found : waitFor(time, state);
    ask(interval);
    return interval;
}

std::size_t StateReadAhead::atHand() const {
    const std::lock_guard calls(m_calls);
    if (!m_reader) {
        return 0;
    }
    const std::lock_guard lock(m_reader->mutex);
    return m_reader->states.size();
}

void StateReadAhead::settle() const {
    const std::lock_guard calls(m_calls);
    if (m_reader) {
        std::unique_lock lock(m_reader->mutex);
        m_reader->changed.wait(lock, [&] { return !m_reader->reading && !m_reader->wanted; });
    }
}

}  // namespace rubble
