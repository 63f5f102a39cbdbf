#include "app/testing/test_view.h"

#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "editor/kit/theme.h"

#include <QAction>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QToolBar>
#include <QVBoxLayout>

namespace plc::app {

namespace {
constexpr int kFile = Qt::UserRole, kLine = Qt::UserRole + 1, kTitle = Qt::UserRole + 2, kRecording = Qt::UserRole + 3;
} // namespace

TestView::TestView(editor::Workspace& workspace, TestRunner& runner, QWidget* parent)
    : QWidget(parent), m_workspace(workspace), m_runner(runner), m_tree(new QTreeWidget(this)),
      m_summary(new QLabel(this)) {
    auto* bar = new QToolBar(this);
    bar->setIconSize({16, 16});
    m_runAll = bar->addAction(kit::icon(kit::Icon::Test), tr("Run all tests"), this, &TestView::runAll);
    m_runSelected =
        bar->addAction(kit::icon(kit::Icon::Run), tr("Run the selected tests"), this, &TestView::runSelected);
    m_runFailed = bar->addAction(kit::icon(kit::Icon::Reset), tr("Run the failed tests"), this, &TestView::runFailed);
    QAction* covers = bar->addAction(kit::icon(kit::Icon::Layers), tr("Show what the tests cover"));
    covers->setObjectName("testCoverage");
    covers->setCheckable(true);
    connect(covers, &QAction::toggled, &m_runner, &TestRunner::setCovers);
    m_summary->setContentsMargins(10, 0, 0, 0);
    bar->addWidget(m_summary);
    m_tree->setHeaderLabels({tr("Test"), tr("Result"), tr("Time")});
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setAlternatingRowColors(true);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->setAccessibleName(tr("Tests"));
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(Title, QHeaderView::Stretch); // so that the time stays in sight
    m_tree->setColumnWidth(State, 300);
    m_tree->header()->setSectionResizeMode(Time, QHeaderView::ResizeToContents);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(m_tree);
    connect(m_tree, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        if (const QString file = item->data(0, kFile).toString(); !file.isEmpty())
            emit placeRequested(file, item->data(0, kLine).toInt());
    });
    connect(m_tree, &QTreeWidget::customContextMenuRequested, this, &TestView::showMenu);
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &TestView::updateActions);
    connect(&workspace, &editor::Workspace::analysed, this, &TestView::reload);
    connect(&workspace, &editor::Workspace::closed, this, [this] {
        m_results.clear();
        reload();
    });
    connect(&runner, &TestRunner::started, this, &TestView::updateActions);
    connect(&runner, &TestRunner::testEnded, this, &TestView::take);
    connect(&runner, &TestRunner::workEnded, this, &TestView::updateActions);
    updateActions();
}

void TestView::runAll() { m_runner.run(); }
void TestView::runFailed() { m_runner.run(failedTitles()); }

void TestView::runSelected() {
    std::vector<std::string> titles;
    const auto add = [&](auto&& self, const QTreeWidgetItem* item) -> void {
        if (const QString title = item->data(0, kTitle).toString(); !title.isEmpty())
            titles.push_back(title.toStdString());
        for (int i = 0; i < item->childCount(); ++i) self(self, item->child(i));
    };
    for (const QTreeWidgetItem* item : m_tree->selectedItems()) add(add, item);
    if (!titles.empty()) m_runner.run(titles);
}

std::vector<std::string> TestView::failedTitles() const {
    std::vector<std::string> out;
    for (const auto& [title, result] : m_results)
        if (result && !result->passed()) out.push_back(title);
    return out;
}

QString TestView::summary() const {
    const size_t failed = failedTitles().size();
    return m_results.empty() ? QString() : tr("%1 passed, %2 failed").arg(m_results.size() - failed).arg(failed);
}

/// The tests as they are written now; what is known of them stays.
void TestView::reload() {
    struct Test {
        QString file;
        int line = 0;
        std::string title;
    };
    std::vector<Test> tests;
    QString shape;
    const auto model = m_workspace.isOpen() ? m_workspace.model() : nullptr;
    for (const QString& file : model ? m_workspace.files() : QStringList()) {
        const auto id = model->fileOf(file.toStdString());
        if (!id) continue;
        for (const analysis::OutlineItem& item : model->outline(*id)) {
            if (!item.isTest) continue;
            const int line = static_cast<int>(model->sources()[*id].lineColumn(item.nameRange.begin).line);
            tests.push_back({file, line, item.name});
            shape += QString("%1|%2|%3\n").arg(file).arg(line).arg(kit::fromView(item.name));
        }
    }
    if (shape == m_shape && !shape.isEmpty()) return;
    m_shape = shape;
    m_tree->clear();
    m_items.clear();
    QTreeWidgetItem* file = nullptr;
    for (const Test& test : tests) {
        if (!file || file->data(0, kFile).toString() != test.file) {
            file = new QTreeWidgetItem(m_tree, {test.file});
            file->setIcon(0, kit::icon(kit::Icon::File));
            file->setData(0, kFile, test.file);
            file->setData(0, kLine, 1);
            file->setExpanded(true);
        }
        auto* item = new QTreeWidgetItem(file, {kit::fromView(test.title)});
        item->setData(0, kFile, test.file);
        item->setData(0, kLine, test.line);
        item->setData(0, kTitle, kit::fromView(test.title));
        m_items[test.title] = item;
        const auto known = m_results.find(test.title);
        showResult(item, known == m_results.end() ? nullptr : known->second);
    }
    std::erase_if(m_results, [this](const auto& each) { return !m_items.contains(each.first); });
    updateActions();
}

void TestView::take(const Known& result) {
    m_results[result->title] = result;
    if (const auto found = m_items.find(result->title); found != m_items.end()) {
        showResult(found->second, result);
        if (!result->passed()) m_tree->scrollToItem(found->second);
    }
    m_summary->setText(summary());
}

void TestView::showResult(QTreeWidgetItem* item, const Known& result) {
    qDeleteAll(item->takeChildren());
    const kit::ThemeColors& c = kit::colors();
    if (!result) {
        item->setIcon(0, kit::icon(kit::Icon::Test));
        item->setText(State, tr("not run yet"));
        item->setForeground(State, c.muted);
        return;
    }
    item->setIcon(0, kit::icon(result->passed() ? kit::Icon::Good : kit::Icon::Error));
    item->setText(State, result->passed() ? tr("passed") : tr("failed"));
    item->setForeground(State, result->passed() ? c.good : c.bad);
    item->setText(Time, tr("%1 ms").arg(QLocale().toString(result->wallMs, 'f', 1)));
    for (const testing::Failure& failure : result->failures) {
        auto* row = new QTreeWidgetItem(item, {kit::messageText(failure.message), kit::messageText(failure.detail)});
        row->setData(0, kFile, kit::fromView(failure.file));
        row->setData(0, kLine, static_cast<int>(failure.line));
        row->setData(0, kRecording, kit::fromView(result->failures.back().recording)); // one for the whole test
        row->setToolTip(0, row->text(0));
        row->setToolTip(1, row->text(1));
    }
    item->setExpanded(!result->passed());
}

void TestView::showMenu(const QPoint& position) {
    const QTreeWidgetItem* item = m_tree->itemAt(position);
    QMenu menu(this);
    menu.addActions({m_runSelected, m_runFailed, m_runAll});
    QString recording = item ? item->data(0, kRecording).toString() : QString();
    if (item && recording.isEmpty() && item->childCount()) recording = item->child(0)->data(0, kRecording).toString();
    if (!recording.isEmpty()) {
        menu.addSeparator();
        menu.addAction(kit::icon(kit::Icon::Record), tr("Show the Recording of the Failure"), this,
                       [this, recording] { emit recordingRequested(recording); });
    }
    menu.exec(m_tree->viewport()->mapToGlobal(position));
}

void TestView::updateActions() {
    const bool isFree = !m_runner.isRunning();
    m_runAll->setEnabled(isFree && !m_items.empty());
    m_runSelected->setEnabled(isFree && !m_tree->selectedItems().isEmpty());
    m_runFailed->setEnabled(isFree && !failedTitles().empty());
    m_summary->setText(summary());
}

} // namespace plc::app
