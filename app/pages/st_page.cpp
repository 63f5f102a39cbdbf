#include "app/pages/st_page.h"

#include "app/pages/instance_bar.h"
#include "editor/kit/icons.h"
#include "projects/analysis/conversion.h"
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace plc::app {

using editor::StEditor;

StPage::StPage(const QString& file, QWidget* parent, Kind kind) : QWidget(parent), m_file(file), m_kind(kind) {
    m_notice = makeNotice();
    m_instances = new InstanceBar(this);
    m_sides = new QSplitter(Qt::Horizontal, this);
    m_splitter = new QSplitter(Qt::Vertical, m_sides);
    m_first = new StEditor(m_splitter);
    m_first->setFile(file);
    m_first->setReadOnly(isLibrary());
    m_first->installEventFilter(this);
    m_active = m_first;
    m_find = new editor::FindBar(*m_first, this);
    m_table = new editor::DeclarationTable(*m_first, m_splitter);
    m_splitter->addWidget(m_table);
    m_splitter->addWidget(m_first);
    m_splitter->setStretchFactor(1, 3);
    m_table->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_notice);
    layout->addWidget(m_instances);
    layout->addWidget(m_sides, 1);
    layout->addWidget(m_find);
    setFocusProxy(m_first);
}

QWidget* StPage::makeNotice() {
    auto* notice = new QWidget(this);
    notice->setObjectName("readOnlyNotice");
    auto* row = new QHBoxLayout(notice);
    row->setContentsMargins(8, 3, 8, 3);
    auto* icon = new QLabel(notice);
    icon->setPixmap(kit::icon(kit::Icon::Lock).pixmap(16, 16));
    auto* text = new QLabel(tr("This file is read-only on disk. Saving asks before it replaces it."), notice);
    text->setWordWrap(true);
    auto* change = new QPushButton(tr("Make Writable"), notice);
    connect(change, &QPushButton::clicked, this, [this] { emit writableRequested(m_file); });
    row->addWidget(icon);
    row->addWidget(text, 1);
    row->addWidget(change);
    notice->hide();
    return notice;
}

void StPage::showReadOnly(bool isReadOnly) { m_notice->setVisible(isReadOnly); }
bool StPage::saysReadOnly() const { return !m_notice->isHidden(); }

void StPage::setActive(StEditor& editor) {
    m_active = &editor;
    m_find->setEditor(editor);
}

bool StPage::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn)
        for (StEditor* each : editors())
            if (each == watched) setActive(*each);
    return QWidget::eventFilter(watched, event);
}

void StPage::toggleSplit() {
    if (m_second) {
        setActive(*m_first);
        m_second->deleteLater();
        m_second = nullptr;
        m_first->setFocus();
        return;
    }
    m_second = new StEditor(m_splitter);
    m_second->shareDocumentOf(*m_first);
    m_second->installEventFilter(this);
    m_splitter->addWidget(m_second);
    emit editorMade(m_second);
    setActive(*m_second);
    m_second->setFocus();
}

void StPage::showBeside(StPage* other) {
    delete m_besideFrame;
    if (!other || other == this) return;
    m_besideFrame = new QWidget(m_sides);
    auto* name = new QLabel(other->file(), m_besideFrame);
    name->setContentsMargins(8, 2, 8, 2);
    auto* close = new QToolButton(m_besideFrame);
    close->setIcon(kit::icon(kit::Icon::Close));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close this side"));
    close->setAccessibleName(close->toolTip());
    m_beside = new StEditor(m_besideFrame);
    m_beside->shareDocumentOf(other->first());
    auto* head = new QHBoxLayout;
    head->setContentsMargins(0, 0, 0, 0);
    head->addWidget(name, 1);
    head->addWidget(close);
    auto* layout = new QVBoxLayout(m_besideFrame);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(head);
    layout->addWidget(m_beside, 1);
    m_sides->addWidget(m_besideFrame);
    m_sides->setSizes(QList<int>(m_sides->count(), 500));
    connect(close, &QToolButton::clicked, this, [this] { showBeside(nullptr); });
    connect(other, &QObject::destroyed, m_besideFrame, [this] { showBeside(nullptr); });
    emit editorMade(m_beside);
    m_besideFrame->show();
    m_beside->setFocus();
}

void StPage::toggleTable() { m_table->setVisible(!m_table->isVisible()); }

editor::ChartView* StPage::showChart(const QString& unit) {
    if (unit.isEmpty() && m_chart && m_chart->isVisible()) {
        m_chart->hide();
        return nullptr;
    }
    if (!m_chart) {
        m_chart = new editor::ChartView(m_sides);
        m_sides->addWidget(m_chart);
        m_sides->setSizes({500, 500});
        emit chartMade(m_chart);
    }
    if (m_ladder) m_ladder->hide();
    if (!unit.isEmpty()) m_chart->setUnit(unit);
    m_chart->show();
    m_chart->setText(m_first->utf8());
    return m_chart;
}

editor::LadderView* StPage::showLadder(const QString& unit) {
    if (unit.isEmpty()) {
        if (m_ladder) m_ladder->hide();
        return nullptr;
    }
    if (!m_ladder) {
        m_ladder = new editor::LadderView(m_sides);
        m_sides->addWidget(m_ladder);
        m_sides->setSizes({500, 600});
        emit ladderMade(m_ladder);
    }
    if (m_chart) m_chart->hide();
    const std::string text = m_first->utf8();
    diagnostics::Sink sink;
    const auto file = parse::parseFile(FileId(size_t(0)), text, sink);
    const ladder::Unit found = ladder::findUnit(*file, unit.toStdString());
    m_ladder->setUnit(unit);
    m_ladder->setForm(equalsIgnoringCase(found.view, "fbd") ? ladder::Form::Blocks : ladder::Form::Ladder);
    m_ladder->show();
    m_ladder->setText(text);
    return m_ladder;
}

std::vector<editor::GraphView*> StPage::graphs() {
    std::vector<editor::GraphView*> out;
    if (m_chart) out.push_back(m_chart);
    if (m_ladder) out.push_back(m_ladder);
    return out;
}

/// The program or block of the file, where there is but one and nothing in it: a chart can begin there.
static QString emptyUnit(const syntax::SyntaxFile& file) {
    const syntax::Pou* only = nullptr;
    for (const syntax::Decl* decl : file.declarations) {
        if (!decl->pou) continue;
        if (only) return {};
        only = decl->pou;
    }
    const bool isUnit =
        only && (only->kind == syntax::PouKind::Program || only->kind == syntax::PouKind::FunctionBlock);
    const bool isEmpty = isUnit && only->body.statements.empty() && !only->body.chart;
    return isEmpty ? QString::fromStdString(std::string(only->name.text)) : QString();
}

void StPage::toggleGraph() {
    bool wasShown = false;
    for (editor::GraphView* graph : graphs()) {
        wasShown |= graph->isVisible();
        graph->hide();
    }
    if (wasShown) return;
    const std::string text = active().utf8();
    diagnostics::Sink sink;
    const auto file = parse::parseFile(FileId(size_t(0)), text, sink);
    const uint32_t at = active().cursorOffset();
    if (const std::string chart = editor::chartAt(*file, at); !chart.empty()) {
        showChart(QString::fromStdString(chart));
        return;
    }
    if (const QString empty = emptyUnit(*file); !empty.isEmpty()) {
        showChart(empty);
        return;
    }
    ladder::Unit unit = ladder::unitAt(*file, at);
    if (!unit.body) unit = ladder::findUnit(*file, {});
    if (unit.body) showLadder(QString::fromStdString(unit.name));
}

void StPage::showPreferred() {
    const std::string text = m_first->utf8();
    diagnostics::Sink sink;
    const auto file = parse::parseFile(FileId(size_t(0)), text, sink);
    for (const ladder::Unit& unit : ladder::unitsOf(*file))
        if (equalsIgnoringCase(unit.view, "ladder") || equalsIgnoringCase(unit.view, "fbd")) {
            showLadder(QString::fromStdString(unit.name));
            return;
        }
}

QString StPage::chartAtCursor() {
    const std::string text = active().utf8();
    const uint32_t at = active().cursorOffset();
    diagnostics::Sink sink;
    const auto file = parse::parseFile(FileId(size_t(0)), text, sink);
    const std::string around = editor::chartAt(*file, at);
    if (!around.empty()) return QString::fromStdString(around);
    for (const analysis::BodyPlace& place : analysis::bodiesOf(text))
        if (at >= place.range.begin && at <= place.range.end)
            return QString::fromStdString(place.unit).section('.', 0, 0);
    return {};
}

std::vector<StEditor*> StPage::editors() {
    std::vector<StEditor*> out{m_first};
    if (m_second) out.push_back(m_second);
    return out;
}

} // namespace plc::app
