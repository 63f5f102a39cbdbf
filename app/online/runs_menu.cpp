#include "app/online/runs_menu.h"

#include "editor/kit/icons.h"
#include "editor/kit/mnemonics.h"

#include <QLocale>

namespace plc::app {

RunsMenu::RunsMenu(const editor::RunArchive& archive, QWidget* parent)
    : QMenu(tr("Earlier Runs"), parent), m_archive(archive) {
    setObjectName("earlierRuns");
    connect(this, &QMenu::aboutToShow, this, &RunsMenu::fill);
}

void RunsMenu::fill() {
    clear();
    const QLocale locale;
    for (const editor::RunArchive::Run& run : m_archive.runs()) {
        const QString ended = locale.toString(run.ended, QLocale::ShortFormat) + run.ended.toString(":ss");
        const QString size = locale.formattedDataSize(run.bytes, 1);
        QAction* made =
            addAction(kit::icon(run.isFault ? kit::Icon::Error : kit::Icon::Record),
                      run.isFault ? tr("%1, ended by a fault, %2").arg(ended, size) : tr("%1, %2").arg(ended, size));
        connect(made, &QAction::triggered, this, [this, path = run.path] { emit runChosen(path); });
    }
    kit::giveMnemonics(*this);
    if (!isEmpty()) return;
    addAction(m_archive.isWriting() ? tr("The last run is being written…") : tr("No run has ended yet"))
        ->setEnabled(false);
}

} // namespace plc::app
