// A file of the project as plain text: a panel, texts or alarms that could not be understood, with the line marked that
// is wrong. Owned by the tabs; GUI thread.
#pragma once
#include "hmi/station/disk_state.h"

#include <QWidget>

class QLabel;
class QsciScintilla;

namespace plc::app {

class TextPage : public QWidget {
    Q_OBJECT
public:
    explicit TextPage(const QString& path, QWidget* parent = nullptr);
    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] QsciScintilla& text() { return *m_text; }
    [[nodiscard]] bool isModified() const;
    /// What is wrong, above the text; line from 1, 0 = nowhere.
    void showProblem(const QString& message, int line);
    [[nodiscard]] QString shownProblem() const;
    Result<void> save();

signals:
    void modifiedChanged(bool modified);
    void saved();

private:
    QString m_path;
    hmi::DiskState m_disk;
    QLabel* m_problem;
    QsciScintilla* m_text;
};

} // namespace plc::app
