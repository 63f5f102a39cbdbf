// All diagnostics of the project, by severity and text; panels' findings come in beside the compiler's. F4 goes to the
// next. Owned by its dock; GUI thread.
#pragma once
#include "editor/workspace/workspace.h"

#include <QTreeWidget>
#include <QWidget>

class QLineEdit;
class QToolButton;

namespace plc::app {

/// A finding that is not the compiler's: panel, text, alarm.
struct OtherProblem {
    QString code, message, place;
    bool isError = false;
    QString panel, element; // to select it
    QString why;            // an explanation, or nothing
};

class ProblemsView : public QWidget {
    Q_OBJECT
public:
    explicit ProblemsView(editor::Workspace& workspace, QWidget* parent = nullptr);
    void setOtherProblems(std::vector<OtherProblem> problems);
    void setDeviceProblems(std::vector<OtherProblem> problems); // of devices.json
    void goToNext(int direction);
    [[nodiscard]] int errorCount() const { return m_errors; }
    [[nodiscard]] int warningCount() const { return m_warnings; }
    [[nodiscard]] QTreeWidget& list() { return *m_list; }
    [[nodiscard]] QString currentCode() const; // "P2001"; "" when no row is current

signals:
    void placeRequested(const QString& file, uint32_t offset);
    void elementRequested(const QString& panel, const QString& element);
    void countsChanged();

private:
    void reload();

    editor::Workspace& m_workspace;
    QTreeWidget* m_list;
    QLineEdit* m_filter;
    QToolButton *m_showErrors, *m_showWarnings, *m_showInfos;
    std::vector<OtherProblem> m_others, m_devices;
    int m_errors = 0, m_warnings = 0;
};

} // namespace plc::app
