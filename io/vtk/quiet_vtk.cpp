#include "io/vtk/quiet_vtk.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>

namespace rubble::io {

namespace {

/// Keeps the first error of one thread and passes on what others say.
class KeptText : public vtkOutputWindow {
public:
    static KeptText* New();
    vtkTypeMacro(KeptText, vtkOutputWindow)

        void DisplayText(const char* text) override {
        take(text, false);
    }
    void DisplayErrorText(const char* text) override { take(text, true); }
    void DisplayWarningText(const char* text) override { warn(text); }
    void DisplayGenericWarningText(const char* text) override { warn(text); }
    void DisplayDebugText(const char* text) override { take(text, false); }

    std::string first;
    std::string firstWarning;
    vtkOutputWindow* others = nullptr;

private:
    void warn(const char* text) {
        if (std::this_thread::get_id() == m_thread && firstWarning.empty()) {
            firstWarning = text;
        }
        take(text, false);
    }

    void take(const char* text, bool error) {
        if (std::this_thread::get_id() != m_thread) {
            others->DisplayText(text);
        } else if (error && first.empty()) {
            first = text;
        }
    }

    std::thread::id m_thread = std::this_thread::get_id();
};

vtkStandardNewMacro(KeptText)

    // "ERROR: In file.cxx, line 12\nvtkThing (0x..): text" becomes "text".
    std::string shortened(const std::string& text) {
    const std::size_t place = text.find("): ");
    std::string line = place == std::string::npos ? text : text.substr(place + 3);
    line = line.substr(0, 200);
    for (char& c : line) {
        c = static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e ? ' ' : c;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line.empty() ? "VTK gives no reason" : line;
}

}  // namespace

QuietVtk::QuietVtk() : m_lock(nativeLibraries()), m_before(vtkOutputWindow::GetInstance()) {
    vtkNew<KeptText> window;
    window->others = m_before;
    m_window = window;
    vtkOutputWindow::SetInstance(m_window);
    // The same texts go to VTK's log as well, which writes to the terminal.
    m_verbosity = static_cast<int>(vtkLogger::GetCurrentVerbosityCutoff());
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

QuietVtk::~QuietVtk() {
    vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(m_verbosity));
    vtkOutputWindow::SetInstance(m_before);
}

std::string QuietVtk::error() const {
    const std::string& first = static_cast<const KeptText*>(m_window.Get())->first;
    return first.empty() ? "" : shortened(first);
}

std::string QuietVtk::warning() const {
    const std::string& first = static_cast<const KeptText*>(m_window.Get())->firstWarning;
    return first.empty() ? "" : shortened(first);
}

}  // namespace rubble::io
