#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "app/gui/session/worker.h"

namespace rubble {

/// Answers to questions about the open case, found in the background and kept as long as they are asked. A question holds all that
/// its answer depends on, so that an answer never goes stale. Lives on the GUI thread.
template <typename Question, typename Answer>
class BackgroundAnswers {
public:
    using Find = std::function<Answer(const Question&, const Execution&)>;

    /// @param find   an answer, on a thread of its own; throws Cancelled only
    /// @param found  on the GUI thread, once more is known
    BackgroundAnswers(Find find, std::function<void()> found) : m_find(std::move(find)), m_found(std::move(found)) {}

    /// Finds the answers of these, and forgets all others.
    void ask(const std::vector<Question>& questions) {
        std::vector<Known> still;
        std::vector<Question> wanted;
        for (const Question& question : questions) {
            if (const Known* known = find(question); known != nullptr) {
                still.push_back(*known);
            } else {
                wanted.push_back(question);
            }
        }
        m_known = std::move(still);
        if (wanted == m_wanted) {
            return;
        }
        m_wanted = std::move(wanted);
        if (m_wanted.empty()) {
            m_worker.cancel();
            return;
        }
        auto made = std::make_shared<std::vector<Known>>();
        m_worker.start({Worker::Kind::Study,
                        [made, asked = m_wanted, answer = m_find](const Execution& execution) {
                            for (const Question& question : asked) {
                                made->push_back({question, answer(question, execution)});
                            }
                        },
                        [this, made, asked = m_wanted](const std::exception_ptr& thrown) {
                            if (thrown == nullptr && asked == m_wanted) {
                                m_wanted.clear();
                                m_known.insert(m_known.end(), made->begin(), made->end());
                                m_found();
                            }
                        }});
    }
    /// An answer as far as it is known; null: not asked, or not found yet.
    const Answer* of(const Question& question) const {
        const Known* known = find(question);
        return known != nullptr ? &known->answer : nullptr;
    }
    bool busy() const { return m_worker.busy(); }

private:
    struct Known {
        Question question;
        Answer answer;
    };
    const Known* find(const Question& question) const {
        const auto found =
            std::find_if(m_known.begin(), m_known.end(), [&](const Known& each) { return each.question == question; });
        return found != m_known.end() ? &*found : nullptr;
    }

    Find m_find;
    std::function<void()> m_found;
    std::vector<Known> m_known;
    std::vector<Question> m_wanted;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
