// A project with one panel that is open in the designer, and real events for it. Shared by the designer's tests.
#pragma once
#include "hmi/designer/canvas/palette.h"
#include "hmi/designer/panel_designer.h"
#include "running.h"

#include "editor/kit/inputs/variable_picker.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QMimeData>

namespace plc::hmi {

struct Studio {
    PanelProject project = machineProject();
    driver::Built built = builtMachine();
    session::Session session{builtMachine()};
    std::unique_ptr<DesignContext> context;
    std::unique_ptr<PanelDesigner> designer;

    explicit Studio(const std::string& elements = {}) {
        project.panels.push_back({QStringLiteral("main"), panelOf(elements)});
        project.startPanel = QStringLiteral("main");
        context = std::make_unique<DesignContext>(project);
        context->setChecked(built.checked);
        context->setRun(&session);
        designer = std::make_unique<PanelDesigner>(*context, QStringLiteral("main"));
        designer->resize(1400, 900);
        designer->show();
        settle();
        designer->canvas().setZoom(1);
    }
    const Panel& panel() const { return designer->document().panel(); }
    QPoint at(double x, double y) const { return designer->canvas().toViewport(QPointF(x, y)).toPoint(); }
    QWidget* ground() const { return designer->canvas().viewport(); }
    void click(double x, double y, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(ground(), Qt::LeftButton, modifiers, at(x, y));
    }
    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(ground(), Qt::LeftButton, modifiers, from);
        for (int i = 1; i <= 5; ++i) {
            const QPoint point = from + (to - from) * i / 5;
            QMouseEvent move(QEvent::MouseMove, QPointF(point), ground()->mapToGlobal(QPointF(point)), Qt::NoButton,
                             Qt::LeftButton, modifiers);
            QApplication::sendEvent(ground(), &move);
        }
        QTest::mouseRelease(ground(), Qt::LeftButton, modifiers, to);
    }
    void drop(QMimeData* mime, double x, double y, Qt::KeyboardModifiers modifiers = {}) {
        const QPoint point = at(x, y);
        QDragEnterEvent enter(point, Qt::CopyAction, mime, Qt::LeftButton, modifiers);
        QApplication::sendEvent(ground(), &enter);
        QDropEvent event(QPointF(point), Qt::CopyAction, mime, Qt::LeftButton, modifiers);
        QApplication::sendEvent(ground(), &event);
        delete mime;
    }
    void dropElement(ElementKind kind, double x, double y) {
        auto* mime = new QMimeData;
        mime->setData(kElementMime, QByteArray::fromStdString(Json::array({newElementFields(kind)}).dump()));
        drop(mime, x, y);
    }
    void dropVariable(const char* path, double x, double y, Qt::KeyboardModifiers modifiers = {}) {
        drop(kit::makeVariableMime({QLatin1String(path)}), x, y, modifiers);
    }
    const Element& last() const { return panel().elements().back(); }
};

} // namespace plc::hmi
