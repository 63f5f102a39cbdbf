#include "app/project/problems_view.h"

#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "editor/kit/theme.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QLineEdit>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace plc::app {

using diagnostics::Severity;

ProblemsView::ProblemsView(editor::Workspace& workspace, QWidget* parent) : QWidget(parent), m_workspace(workspace) {
    m_list = new QTreeWidget(this);
    m_list->setHeaderLabels({tr("Message"), tr("Code"), tr("Place")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAlternatingRowColors(true);
    m_list->setAccessibleName(tr("Problems"));
    m_list->header()->setStretchLastSection(true);
    m_list->setColumnWidth(0, 560);
    m_list->setColumnWidth(1, 70);
    auto* bar = new QToolBar(this);
    bar->setIconSize({16, 16});
    const auto toggle = [&](kit::Icon icon, const QString& tip, bool on) {
        auto* button = new QToolButton(bar);
        button->setIcon(kit::icon(icon));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setToolTip(tip);
        button->setAccessibleName(tip);
        button->setCheckable(true);
        button->setChecked(on);
        button->setAutoRaise(true);
        bar->addWidget(button);
        connect(button, &QToolButton::toggled, this, &ProblemsView::reload);
        return button;
    };
    m_showErrors = toggle(kit::Icon::Error, tr("Show errors"), true);
    m_showWarnings = toggle(kit::Icon::Warning, tr("Show warnings"), true);
    m_showInfos = toggle(kit::Icon::Information, tr("Show notes"), false);
    m_filter = new QLineEdit(bar);
    m_filter->setPlaceholderText(tr("Filter"));
    m_filter->setClearButtonEnabled(true);
    m_filter->setAccessibleName(tr("Filter of the problem list"));
    bar->addWidget(m_filter);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(m_list);
    connect(m_filter, &QLineEdit::textChanged, this, &ProblemsView::reload);
    connect(&workspace, &editor::Workspace::analysed, this, &ProblemsView::reload);
    connect(&workspace, &editor::Workspace::closed, this, &ProblemsView::reload);
    connect(m_list, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        if (!item->data(1, Qt::UserRole).toString().isEmpty())
            return emit elementRequested(item->data(1, Qt::UserRole).toString(),
                                         item->data(2, Qt::UserRole).toString());
        emit placeRequested(item->data(0, Qt::UserRole).toString(), item->data(0, Qt::UserRole + 1).toUInt());
    });
    connect(m_list, &QTreeWidget::itemClicked, m_list, &QTreeWidget::itemActivated);
}

void ProblemsView::setOtherProblems(std::vector<OtherProblem> problems) {
    m_others = std::move(problems);
    reload();
}

void ProblemsView::setDeviceProblems(std::vector<OtherProblem> problems) {
    m_devices = std::move(problems);
    reload();
}

void ProblemsView::reload() {
    m_list->clear();
    m_errors = m_warnings = 0;
    int infos = 0;
    const auto add = [&](Severity severity, const QString& message, const QString& code,
                         const QString& place) -> QTreeWidgetItem* {
        int& count = severity == Severity::Error ? m_errors : severity == Severity::Warning ? m_warnings : infos;
        ++count;
        const bool shown = severity == Severity::Error     ? m_showErrors->isChecked()
                           : severity == Severity::Warning ? m_showWarnings->isChecked()
                                                           : m_showInfos->isChecked();
        if (!shown || !(m_filter->text().isEmpty() ||
                        (message + " " + code + " " + place).contains(m_filter->text(), Qt::CaseInsensitive)))
            return nullptr;
        auto* item = new QTreeWidgetItem(m_list, {message, code, place});
        item->setIcon(0, kit::icon(severity == Severity::Error     ? kit::Icon::Error
                                   : severity == Severity::Warning ? kit::Icon::Warning
                                                                   : kit::Icon::Information));
        item->setForeground(1, kit::colors().muted);
        item->setForeground(2, kit::colors().muted);
        return item;
    };
    if (m_workspace.isOpen() && m_workspace.model()) {
        const auto& model = *m_workspace.model();
        for (const Severity wanted : {Severity::Error, Severity::Warning, Severity::Info})
            for (const diagnostics::Diagnostic& d : model.diagnostics()) {
                if (d.severity != wanted) continue;
                QString file, place;
                if (d.range.file.isValid()) {
                    const SourceText& source = model.sources()[d.range.file];
                    file = QString::fromStdString(source.path());
                    if (file.startsWith("library/") && d.severity != Severity::Error) continue;
                    place = QString("%1:%2").arg(file).arg(source.lineColumn(d.range.begin).line);
                }
                const auto code = diagnostics::codeOf(d.kind);
                if (QTreeWidgetItem* item = add(d.severity, kit::messageText(d.message), kit::fromView(code), place)) {
                    item->setData(0, Qt::UserRole, file);
                    item->setData(0, Qt::UserRole + 1, d.range.begin);
                }
                if (m_list->topLevelItemCount() > 2000) break;
            }
    }
    for (const std::vector<OtherProblem>* list : {&m_others, &m_devices})
        for (const OtherProblem& other : *list)
            if (QTreeWidgetItem* item =
                    add(other.isError ? Severity::Error : Severity::Warning, other.message, other.code, other.place)) {
                item->setData(1, Qt::UserRole, other.panel);
                item->setData(2, Qt::UserRole, other.element);
                item->setToolTip(0, other.why);
            }
    m_showErrors->setText(QString::number(m_errors));
    m_showWarnings->setText(QString::number(m_warnings));
    m_showInfos->setText(QString::number(infos));
    emit countsChanged();
}

QString ProblemsView::currentCode() const {
    const QTreeWidgetItem* item = m_list->currentItem();
    return item ? item->text(1) : QString();
}

void ProblemsView::goToNext(int direction) {
    const int count = m_list->topLevelItemCount();
    if (count == 0) return;
    const int now = m_list->indexOfTopLevelItem(m_list->currentItem());
    const int next = now < 0 ? (direction > 0 ? 0 : count - 1) : (now + direction + count) % count;
    m_list->setCurrentItem(m_list->topLevelItem(next));
    emit m_list->itemActivated(m_list->currentItem(), 0);
}

} // namespace plc::app
