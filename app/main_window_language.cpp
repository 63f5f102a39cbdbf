// The window in another language: it is built anew around the project and the controller, which go on meanwhile.
#include "app/main_window.h"

#include "app/frame/kept_size.h"
#include "app/pages/editor_tabs.h"
#include "app/panels/design_findings.h"
#include "app/panels/living.h"
#include "app/settings/translation.h"
#include "app/testing/test_runner.h"
#include "hmi/designer/panel_designer.h"

#include <QApplication>

#include <algorithm>

namespace plc::app {

void MainWindow::changeLanguage() {
    m_changesLanguage = true;
    if (m_testRunner->isRunning()) return say(tr("The language changes when the tests have ended"));
    emit rebuildRequested();
}

Living MainWindow::release() {
    Living living;
    living.geometry = saveGeometry();
    if (m_workspace->isOpen()) saveProjectState();
    for (int i = 0; i < m_tabs->count(); ++i) {
        if (auto* page = qobject_cast<StPage*>(m_tabs->widget(i))) {
            living.texts.push_back(std::make_unique<editor::StEditor>());
            living.texts.back()->shareDocumentOf(page->first());
        } else if (auto* designer = qobject_cast<hmi::PanelDesigner*>(m_tabs->widget(i));
                   designer && designer->isModified()) {
            living.changedPanels << designer->panelName();
        }
    }
    living.watches = m_watch->kept();
    living.watchFormat = m_watch->format();
    living.log = m_log->release();
    m_workspace->disconnect(); // no part of this window hears of it any more
    m_control->disconnect();
    living.views = m_live->release();
    m_control->followWorkspace();
    m_workspace->setParent(nullptr);
    m_control->setParent(nullptr);
    living.workspace.reset(m_workspace);
    living.control.reset(std::exchange(m_control, nullptr));
    return living;
}

void MainWindow::restoreLiving(Living living) {
    restoreGeometry(living.geometry);
    m_log->restore(std::move(living.log));
    if (m_workspace->isOpen()) {
        m_live->restore(std::move(living.views));
        showProject();
        for (const auto& text : living.texts)
            if (StPage* page = m_tabs->pageOf(text->file())) {
                const uint32_t at = page->first().cursorOffset();
                page->first().shareDocumentOf(*text);
                page->first().setSavedText(m_workspace->savedText(text->file()));
                page->first().goTo(at);
            }
        for (const QString& panel : living.changedPanels)
            if (auto* designer = qobject_cast<hmi::PanelDesigner*>(m_tabs->pageByKey("panel:" + panel)))
                designer->document().undoStack().resetClean();
        m_watch->setFormat(living.watchFormat);
        m_watch->restore(std::move(living.watches));
        m_findings->schedule();
    }
    updateActions();
    m_workspace->announce();
    m_control->announce();
}

std::unique_ptr<MainWindow> inOtherLanguage(std::unique_ptr<MainWindow> window, QApplication& application,
                                            const QString& tag) {
    const bool quits = QApplication::quitOnLastWindowClosed();
    QApplication::setQuitOnLastWindowClosed(false); // between the two there is none
    const QSize size = window->size();
    Living living = window->release();
    window.reset();
    installTranslation(application, tag);
    window = std::make_unique<MainWindow>(std::move(living));
    window->show();
    KeptSize::keep(*window, size); // all docks at once took more while it was made
    QApplication::setQuitOnLastWindowClosed(quits);
    return window;
}

} // namespace plc::app
