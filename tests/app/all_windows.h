// Opens every kind of document, dialog, menu and list of the studio on a small project, one after the other, and shows
// each to the one who looks. For the tests of what all windows have in common: their words, letters and names.
#pragma once
#include "tests/app/studio_fixture.h"

#include <vector>

namespace plc::app {

/// A window or dialog, named by what was done to open it.
using Look = std::function<void(QWidget& window, const QString& name)>;

/// Its programs, chart, diagram, panel with one element of each kind, alarms, texts, trace and test.
void writeProjectOfAllKinds(const QString& folder);
void lookAtAllDocuments(MainWindow& window, const Look& look);
void lookAtAllDialogs(MainWindow& window, const Look& look);
/// Those of the panels, their texts, recipes and users.
void lookAtDesignDialogs(MainWindow& window, const Look& look);
/// What `open` shows, which runs until the one who looked is done.
void lookAtDialog(const Look& look, const QString& name, const std::function<void()>& open);
/// Those of the menu bar, and the ones that open with the right button.
void lookAtAllMenus(MainWindow& window, const Look& look);

/// The window and all that is in it.
[[nodiscard]] std::vector<QWidget*> widgetsOf(QWidget& window);

class AllWindowsTest : public StudioTest {
protected:
    void SetUp() override {} // in the language of the test
    void open() {
        writeProjectOfAllKinds(folder.path());
        StudioTest::SetUp();
    }
    void lookAtAll(const Look& look) {
        lookAtAllDocuments(*window, look);
        lookAtAllMenus(*window, look);
        lookAtAllDialogs(*window, look);
    }
};

} // namespace plc::app
