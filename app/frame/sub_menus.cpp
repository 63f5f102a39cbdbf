#include "app/frame/sub_menus.h"

#include <QCoreApplication>
#include <QMenu>

#include <algorithm>
#include <string_view>
#include <vector>

namespace plc::app {

namespace {

struct SubMenu {
    const char* title;
    std::vector<std::string_view> actions;
};

const std::vector<SubMenu>& subMenus() {
    static const std::vector<SubMenu> all = {
        {QT_TRANSLATE_NOOP("plc::app::Menu", "Find"),
         {"edit.find", "edit.replace", "edit.findNext", "edit.findPrevious", "edit.findAll"}},
        {QT_TRANSLATE_NOOP("plc::app::Menu", "Go To"),
         {"edit.goToLine", "edit.definition", "edit.matching", "edit.nextProblem", "edit.previousProblem", "edit.back",
          "edit.forward"}},
        {QT_TRANSLATE_NOOP("plc::app::Menu", "Bookmarks"),
         {"edit.bookmark", "edit.nextBookmark", "edit.previousBookmark"}},
        {QT_TRANSLATE_NOOP("plc::app::Menu", "Folding"), {"edit.fold", "edit.foldAll"}},
        {QT_TRANSLATE_NOOP("plc::app::Menu", "Reset"), {"run.resetWarm", "run.resetCold", "run.resetOrigin"}},
        {QT_TRANSLATE_NOOP("plc::app::Menu", "Recording"), {"run.history", "run.saveRecording", "run.openRecording"}},
        {QT_TRANSLATE_NOOP("plc::app::Menu", "Theme"), {"view.light", "view.dark", "view.contrast", "view.system"}},
        {QT_TRANSLATE_NOOP("plc::app::Menu", "Layout"),
         {"view.editing", "view.debugging", "view.panelDesign", "view.maximise", "view.reset"}},
        {QT_TRANSLATE_NOOP("plc::app::Menu", "Panes"),
         {"view.nextPane", "view.previousPane", "view.wider", "view.narrower", "view.taller", "view.shorter",
          "view.hideDock", "view.moveDock", "view.floatDock", "view.tabLeft", "view.tabRight", "view.columns"}},
    };
    return all;
}

QMenu& called(const char* title, QMenu& menu) {
    const QString name = QStringLiteral("menu.") + QLatin1String(title); // its letter in Chinese is of the English one
    for (QAction* each : menu.actions())
        if (each->menu() && each->objectName() == name) return *each->menu();
    QMenu* made = menu.addMenu(QCoreApplication::translate("plc::app::Menu", title));
    made->menuAction()->setObjectName(name);
    return *made;
}

} // namespace

QMenu& subMenuFor(const QString& action, QMenu& menu) {
    const std::string id = action.toStdString();
    for (const SubMenu& each : subMenus())
        if (std::find(each.actions.begin(), each.actions.end(), id) != each.actions.end())
            return called(each.title, menu);
    return menu;
}

QMenu& subMenuOfDocks(QMenu& view) { return called(QT_TRANSLATE_NOOP("plc::app::Menu", "Docks"), view); }

} // namespace plc::app
