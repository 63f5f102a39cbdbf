#include "editor/graph/graph_view.h"

#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/paper.h"
#include "editor/kit/post.h"
#include "editor/kit/texts.h"
#include "editor/kit/theme.h"

#include <QFileDialog>
#include <QGraphicsScene>
#include <QKeyEvent>
#include <QLabel>
#include <QPrintPreviewDialog>
#include <QPrinter>
#include <QScrollBar>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace plc::editor {

GraphView::GraphView(QGraphicsScene& scene, const QString& accessibleName, QWidget* parent) : QWidget(parent) {
    m_canvas = new kit::Canvas(this);
    m_canvas->setScene(&scene);
    m_canvas->setAccessibleName(accessibleName);
    m_canvas->setBackgroundBrush(kit::colors().base);
    m_canvas->viewport()->installEventFilter(this);
    m_canvas->installEventFilter(this);
    m_bar = new QToolBar(this);
    m_bar->setIconSize({16, 16});
    m_field = new kit::ExpressionEdit(m_canvas->viewport());
    m_field->hide();
    m_field->installEventFilter(this);
    m_field->setCompletionSource([this](const QString& text, int cursor) { return completions(text, cursor); });
    m_field->setCheck([this](const QString& text) { return complaintOf(text); });
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_bar);
    layout->addWidget(m_canvas);
    connect(m_canvas, &kit::Canvas::zoomChanged, this, [this] { updateMap(); });
    connect(&kit::Theme::current(), &kit::Theme::changed, this, [this] {
        m_canvas->setBackgroundBrush(kit::colors().base);
        themeChanged();
    });
}

QAction* GraphView::makeCommand(kit::Icon icon, const QString& text) { return m_bar->addAction(kit::icon(icon), text); }

void GraphView::addSheetCommands() {
    addCommand(kit::Icon::Fit, tr("Show all"), this, [this] { m_canvas->zoomToFit(); });
    addCommand(kit::Icon::Export, tr("Export as SVG, PNG or PDF…"), this, [this] {
        const QString path =
            QFileDialog::getSaveFileName(this, tr("Export the Drawing"), QString(m_unit).replace('.', '_') + ".svg",
                                         tr("SVG (*.svg);;PNG (*.png);;PDF (*.pdf)"));
        if (path.isEmpty()) return;
        bool good = false;
        if (path.endsWith(".pdf"))
            onPaper([&] { good = m_canvas->exportPdf(path); });
        else
            good = path.endsWith(".png") ? m_canvas->exportPng(path) : m_canvas->exportSvg(path);
        if (!good) emit failed(tr("%1 cannot be written; choose a variable of the program").arg(path));
    });
    addCommand(kit::Icon::Print, tr("Print…"), this, [this] {
        QPrinter printer;
        QPrintPreviewDialog preview(&printer, this);
        connect(&preview, &QPrintPreviewDialog::paintRequested, this, [this](QPrinter* paper) { print(*paper); });
        preview.exec();
    });
    m_state = new QLabel(this);
    m_state->setContentsMargins(8, 0, 8, 0);
    m_bar->addWidget(m_state);
}

void GraphView::onPaper(const std::function<void()>& draw) {
    {
        const kit::PaperColors paper;
        themeChanged();
        draw();
    }
    themeChanged();
}

void GraphView::print(QPrinter& printer) {
    onPaper([&] { m_canvas->print(printer, m_unit + "  " + m_file); });
}

void GraphView::setBreakpoints(const std::set<int>& lines, const std::set<int>& disabled) {
    m_breakpoints = lines;
    m_disabled = disabled;
    marksChanged();
}

void GraphView::setBookmarks(const std::set<int>& lines) {
    if (lines == m_bookmarks) return;
    m_bookmarks = lines;
    marksChanged();
}

void GraphView::setCoverage(CoverageSource source) {
    m_coverage = std::move(source);
    marksChanged();
}

std::vector<int> GraphView::linesOf(const std::vector<uint32_t>& places) const {
    std::vector<uint32_t> lineBegins{0};
    for (size_t i = 0; i < m_text.size(); ++i)
        if (m_text[i] == '\n') lineBegins.push_back(static_cast<uint32_t>(i) + 1);
    std::vector<int> out;
    for (const uint32_t place : places) {
        const auto behind = std::upper_bound(lineBegins.begin(), lineBegins.end(), place);
        out.push_back(static_cast<int>(behind - lineBegins.begin()));
    }
    return out;
}

std::vector<int> GraphView::breakpointsAt(const std::vector<uint32_t>& places) const {
    std::vector<int> out(places.size(), 0);
    if (m_breakpoints.empty()) return out;
    const std::vector<int> lines = linesOf(places);
    for (size_t i = 0; i < places.size(); ++i)
        if (m_breakpoints.contains(lines[i])) out[i] = m_disabled.contains(lines[i]) ? -1 : 1;
    return out;
}

std::vector<diagnostics::Diagnostic> GraphView::modelMessages() const {
    std::vector<diagnostics::Diagnostic> out;
    const auto id = m_model ? m_model->fileOf(m_file.toStdString()) : std::nullopt;
    if (!id || m_model->sources()[*id].text() != m_text) return out;
    for (const diagnostics::Diagnostic& d : m_model->diagnostics())
        if (d.range.file == *id && d.severity != diagnostics::Severity::Info) out.push_back(d);
    return out;
}

void GraphView::showStale(const QString& reason) {
    m_isStale = true;
    m_state->setText(reason);
    closeField(false);
}

void GraphView::showFresh() {
    m_isStale = false;
    m_state->clear();
}

void GraphView::request(const Result<Edits>& edits, const QString& selectAfter) {
    if (m_isStale) return emit failed(tr("Fix the text first: this is the last valid drawing"));
    if (!edits) return emit failed(kit::messageText(edits.error()));
    if (edits->empty()) return;
    m_selectAfter = selectAfter;
    const Edits wanted = *edits; // the drawing they come from goes with the text
    emit editsRequested(wanted);
}

void GraphView::showWhole() {
    kit::post(m_canvas, [this] {
        m_canvas->zoomToFit();
        if (m_canvas->zoom() > 1) m_canvas->setZoom(1);
        if (m_canvas->zoom() < 0.45) { // too long to be read as a whole: from the top
            m_canvas->setZoom(0.8);
            m_canvas->centerOn(m_canvas->sceneRect().center().x(), 0);
            m_canvas->verticalScrollBar()->setValue(m_canvas->verticalScrollBar()->minimum());
        }
        updateMap();
    });
}

void GraphView::updateMap() {
    // What is drawn, not the sheet around it.
    const QSizeF drawn = m_canvas->scene()->itemsBoundingRect().size() * m_canvas->zoom(),
                 view = m_canvas->maximumViewportSize();
    const bool isBig = hasDrawing() && (drawn.width() > view.width() * 1.3 || drawn.height() > view.height() * 1.3);
    if (isBig != m_canvas->isMapVisible()) m_canvas->setMapVisible(isBig);
}

void GraphView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (hasDrawing()) revealSelection();
    updateMap();
}

bool GraphView::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_field) return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape && !m_field->isCompletionShown()) return closeField(false), true;
        if ((key == Qt::Key_Return || key == Qt::Key_Enter) && !m_field->isCompletionShown())
            return closeField(true), true;
    }
    if (event->type() == QEvent::FocusOut && !m_field->isCompletionShown()) closeField(true);
    return false;
}

// ------------------------------------------------------------------ in place

void GraphView::openField(const QRectF& sceneRect, const QString& text, uint32_t at, MakeEdits make,
                          bool keepsSelection) {
    closeField(false);
    m_fieldAt = at;
    m_fieldBegin = text;
    m_canvas->ensureVisible(sceneRect, 10, 30);
    const QRect place = m_canvas->mapFromScene(sceneRect).boundingRect();
    m_field->setProperty("keepsSelection", keepsSelection);
    m_field->setGeometry(place.x(), place.y(), std::max(160, place.width()), std::max(26, place.height()));
    m_makeEdits = std::move(make);
    m_field->setText(text);
    m_field->selectAll();
    m_field->show();
    m_field->setFocus();
}

void GraphView::closeField(bool accept) {
    const MakeEdits make = std::exchange(m_makeEdits, {}); // hiding takes the focus, which comes here again
    if (!make) return;
    const QString text = m_field->text().trimmed();
    m_field->hide();
    m_canvas->setFocus();
    if (!accept || text.isEmpty() || text == m_fieldBegin) return;
    request(make(text), m_field->property("keepsSelection").toBool() ? text : QString());
}

std::vector<kit::Completion> GraphView::namesAt(const QString& text, int cursor,
                                                const std::function<bool(const QString& type)>& accepts) const {
    std::vector<kit::Completion> out;
    const auto id = m_model ? m_model->fileOf(m_file.toStdString()) : std::nullopt;
    if (!id) return out;
    // As if it stood in the text already: names resolve as they will there.
    const uint32_t at = std::min(m_fieldAt, static_cast<uint32_t>(m_text.size()));
    const std::string utf8 = text.toStdString();
    const std::string whole = m_text.substr(0, at) + utf8 + " ;" + m_text.substr(at);
    const analysis::Completion found =
        m_model->complete(*id, whole, at + static_cast<uint32_t>(text.left(cursor).toUtf8().size()));
    const int from = static_cast<int>(QString::fromStdString(whole.substr(at, found.replaceBegin - at)).size());
    for (const analysis::CompletionItem& item : found.items) {
        if (item.kind == analysis::ItemKind::Snippet || item.kind == analysis::ItemKind::Keyword ||
            item.kind == analysis::ItemKind::Type)
            continue;
        if (!accepts(QString::fromStdString(item.detail))) continue;
        kit::Completion completion{QString::fromStdString(item.text), QString::fromStdString(item.detail)};
        completion.replaceFrom = from;
        out.push_back(std::move(completion));
        if (out.size() > 150) break;
    }
    return out;
}

} // namespace plc::editor
