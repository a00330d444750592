#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "app/gui/session/worker.h"
#include "widgets/views/stage_rail.h"

namespace rubble {

/// What is made on request and shown until something else is made. Knows what was asked for, whether it is being made, what came of
/// it, and whether that still answers what would be asked for now.
/// @tparam Order  says what is asked for; equal orders have equal answers
template <class Order, class Result>
class Answer {
public:
    /// Something is being made from now on; what is there stays until it comes.
    void ask(Order order) {
        m_asked = std::move(order);
        m_running = true;
        m_failure.reset();
    }
    /// Something came of what was asked for. May come more than once, each time more complete.
    void take(std::shared_ptr<const Result> result) {
        m_result = std::move(result);
        m_answered = m_asked;
    }
    /// Nothing more comes. @param failure  null: nothing went wrong
    void end(const Failure* failure = nullptr) {
        m_running = false;
        m_failure.reset();
        if (failure != nullptr) {
            m_failure = *failure;
        }
    }
    /// What is there is not shown any more.
    void drop() {
        m_result = nullptr;
        m_failure.reset();
    }

    bool running() const { return m_running; }
    /// What went wrong when it was made last.
    const std::optional<Failure>& failure() const { return m_failure; }
    /// What it was made of, or is being made of.
    const Order& asked() const { return m_asked; }
    /// Null: nothing came yet.
    const std::shared_ptr<const Result>& result() const { return m_result; }
    /// What the result was made of.
    const Order& answered() const { return m_answered; }
    /// The result answers something else than what would be asked for now.
    bool stale(const Order& now) const { return m_result != nullptr && !(m_answered == now); }

private:
    Order m_asked{};
    Order m_answered{};
    bool m_running = false;
    std::optional<Failure> m_failure;
    std::shared_ptr<const Result> m_result;
};

/// How the rail shows an answer.
inline widgets::StageState answerState(bool running, bool made, bool stale) {
    if (running) {
        return widgets::StageState::Running;
    }
    if (!made) {
        return widgets::StageState::NotYet;
    }
    return stale ? widgets::StageState::Stale : widgets::StageState::UpToDate;
}

}  // namespace rubble
