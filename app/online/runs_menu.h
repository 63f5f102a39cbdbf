// The menu of the runs that have ended, the newest first: each opens as a recording. Owned by the Run menu; GUI thread.
#pragma once
#include "editor/debug/run_archive.h"

#include <QMenu>

namespace plc::app {

class RunsMenu : public QMenu {
    Q_OBJECT
public:
    RunsMenu(const editor::RunArchive& archive, QWidget* parent);

signals:
    void runChosen(const QString& path);

private:
    void fill();
    const editor::RunArchive& m_archive;
};

} // namespace plc::app
