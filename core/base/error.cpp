#include "core/base/error.h"

namespace rubble {

Error::Error(Message what, Message remedy) : m_message(std::move(what)), m_remedy(std::move(remedy)) {
    m_text = englishText(m_message);
    if (!m_remedy.empty()) {
        m_text += "\n" + englishText(m_remedy);
    }
}

}  // namespace rubble
