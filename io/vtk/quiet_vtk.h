#pragma once

#include <mutex>
#include <string>
#include <thread>

#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include "io/native_lock.h"

namespace rubble::io {

/// Takes what VTK would print on this thread, for as long as it lives; holds the lock of the native libraries. What other threads
/// print still goes its way.
class QuietVtk {
public:
    QuietVtk();
    ~QuietVtk();
    QuietVtk(const QuietVtk&) = delete;
    QuietVtk& operator=(const QuietVtk&) = delete;

    /// The first error since then; empty if there was none. One line, without VTK's own places.
    std::string error() const;
    /// The first warning, the same way.
    std::string warning() const;

private:
    std::unique_lock<std::recursive_mutex> m_lock;
    vtkSmartPointer<vtkOutputWindow> m_before;
    vtkSmartPointer<vtkOutputWindow> m_window;
    int m_verbosity = 0;
};

}  // namespace rubble::io
