#pragma once

#include <QDialog>
#include <QLabel>
#include <QSettings>
#include <string>

#include "io/seal/seal_addition.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/temporary_folder.h"

class QMessageBox;

namespace rubble {

/// The small collapse as a saved case, a key, and what is done with both in the window.
class SealedWorkbench : public FreshWorkbench {
protected:
    void SetUp() override;
    /// Opens the case and simulates it.
    void simulated();
    /// Writes a table of its run beside the case.
    void exportTable();
    /// What *Seal...* asks; null: nothing came.
    QDialog* askToSeal();
    /// Presses *Seal...* in it, names the bundle, and waits for what comes of it.
    QMessageBox* sealBy(QDialog& dialog);
    /// Seals the case without the window.
    void sealed(const std::vector<std::string>& leftHome = {}, bool stampRequest = false);
    /// Answers the next dialog for files from within its own event loop.
    static void chooseFile(const std::string& path);
    bool idle();
    /// What stands on a dialog can be read whole in the smallest window, and speaks the language of the window.
    /// RUBBLE_TAKE_SCREENS names a folder for pictures of it in both themes.
    void expectReadable(QWidget& dialog, const QString& name);
    /// A part of a dialog by its name, which must be there.
    template <typename Part>
    static Part& child(const QWidget& dialog, const char* name) {
        Part* found = dialog.findChild<Part*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    /// Types into a line of a dialog in place of what stands there.
    static void type(const QWidget& dialog, const char* name, const std::string& text);
    static void click(const QWidget& dialog, const char* name);
    std::string makeKey(const std::string& name);

    io::TemporaryFolder m_folder;
    std::string m_case = m_folder / "small.rubble";
    std::string m_bundle = m_folder / "small.rubblecase";
    std::string m_key;
};

}  // namespace rubble
