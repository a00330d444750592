#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>

#include "core/fe/fe_result.h"

namespace rubble {

/// The states between which a moving picture is drawn. While it moves, states come from a thread that reads ahead, so that no
/// picture waits for a file; where the file cannot keep up, states are left out evenly and the interval gets wider, up to `widest`.
/// May be called from several threads that show the same times.
class StateReadAhead {
public:
    /// Two states around a time, and one before them where one is at hand.
    struct Interval {
        std::size_t from = 0;
        std::size_t to = 0;      ///< equal to `from` where there is no later state
        std::size_t before = 0;  ///< equal to `from` where none is at hand
        std::shared_ptr<const FeState> atFrom;
        std::shared_ptr<const FeState> atTo;      ///< null where `to` is `from`
        std::shared_ptr<const FeState> atBefore;  ///< null where `before` is `from`
    };

    static constexpr double widest = 0.5;  ///< s of the collapse that an interval spans at most, unless states lie further apart
    static constexpr double readingShare = 0.15;  ///< of the wall time that reading ahead may take

    explicit StateReadAhead(std::shared_ptr<const FeResult> fe);
    /// Waits for a reading that has begun; one that has not is dropped.
    ~StateReadAhead();
    StateReadAhead(const StateReadAhead&) = delete;
    StateReadAhead& operator=(const StateReadAhead&) = delete;

    const std::shared_ptr<const FeResult>& fe() const { return m_fe; }
    /// Last state at or before a time, 0 before the first.
    std::size_t stateAt(double time) const;
    /// The states next to a time, read if need be; lets go of those that were read ahead. Throws what the state source throws.
    Interval next(double time);
    /// The nearest states around a time that are at hand, and has those read that will be needed if time goes on as it did since
    /// the last call. After a jump, and where reading fell behind, it waits for a state. Throws what the state source throws.
    Interval nearest(double time);

    /// States kept at most, the interval included, whether or not the FE result still keeps them too.
    static constexpr std::size_t kept = 5;
    /// States at hand now.
    std::size_t atHand() const;
    /// Blocks until nothing is being read.
    void settle() const;

private:
    struct Reader;
    void notePace(double time);
    double gap() const;
    Interval read(double time) const;
    std::optional<Interval> around(std::size_t state) const;
    Interval waitFor(double time, std::size_t state);
    void ask(const Interval& interval);

    std::shared_ptr<const FeResult> m_fe;
    mutable std::mutex m_calls;  ///< held by whoever asks for the nearest states
    double m_time = 0.0;         ///< s, of the last call
    double m_calledAt = -1.0;    ///< s of the wall clock; negative: never
    double m_pace = 0.0;         ///< seconds of the collapse in one of the wall clock; negative backwards
    std::unique_ptr<Reader> m_reader;
};

}  // namespace rubble
