// What a trace shows besides curves over time: figures, remarks, channels of other files.
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/trace/curves/trace_figure.h"
#include "editor/trace/figure_pane.h"
#include "editor/trace/recording/run_recording.h"
#include "editor/trace/trace_view.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QKeyEvent>
#include <QMenu>

namespace plc::trace {

namespace {

struct FigureKey {
    FigureKind kind;
    Qt::Key key;
    const char* shown;
};
constexpr FigureKey kFigures[] = {{FigureKind::None, Qt::Key_T, "T"},
                                  {FigureKind::Xy, Qt::Key_X, "X"},
                                  {FigureKind::Spectrum, Qt::Key_S, "S"},
                                  {FigureKind::Response, Qt::Key_B, "B"},
                                  {FigureKind::Runs, Qt::Key_R, "R"}};

} // namespace

void TraceView::showFigure(FigureKind kind) {
    const bool hasHorizontal = kind == FigureKind::Xy || kind == FigureKind::Response;
    const bool mustChoose = hasHorizontal && m_setup.figure.x.empty();
    const std::string horizontal = mustChoose ? firstMoving(m_setup, m_plot->model()) : m_setup.figure.x;
    change(titleOf(kind), [kind, horizontal](TraceSetup& s) {
        s.figure.kind = kind;
        s.figure.x = horizontal;
    });
}

void TraceView::addFigureActions(QMenu& menu) {
    for (const FigureKey& figure : kFigures) {
        QAction* action = menu.addAction(titleOf(figure.kind) + QLatin1Char('\t') + QLatin1String(figure.shown), this,
                                         [this, kind = figure.kind] { showFigure(kind); });
        action->setCheckable(true);
        action->setChecked(m_setup.figure.kind == figure.kind);
    }
    menu.addSeparator();
    QAction* measure = menu.addAction(tr("Measure between Points") + QStringLiteral("\tM"), this, [this] {
        const bool measures = m_plot->tool() == plot::PlotTool::Ruler;
        m_plot->setTool(measures ? plot::PlotTool::ZoomBox : plot::PlotTool::Ruler);
    });
    measure->setCheckable(true);
    measure->setChecked(m_plot->tool() == plot::PlotTool::Ruler);
}

void TraceView::keyPressEvent(QKeyEvent* event) {
    if (event->modifiers() == Qt::NoModifier) {
        for (const FigureKey& figure : kFigures)
            if (event->key() == figure.key) return showFigure(figure.kind);
        if (event->key() == Qt::Key_N) return askNote(m_plot->mapToGlobal(m_plot->rect().center()));
    }
    QWidget::keyPressEvent(event);
}

void TraceView::drawFigure() {
    m_figure->showSetup(m_setup);
    m_figureShown = figureStamp();
    if (m_setup.figure.kind != FigureKind::None) m_figure->draw(figureJob(m_setup, m_plot->model(), m_feed.get()));
}

/// Grows or differs whenever the figure would.
std::vector<uint64_t> TraceView::figureStamp() const {
    const plot::PlotModel& model = m_plot->model();
    std::vector<uint64_t> out{static_cast<uint64_t>(m_setup.figure.kind)};
    if (m_setup.figure.kind == FigureKind::None) return out;
    for (const int64_t time : {model.cursorA.value_or(-1), model.cursorB.value_or(-1), model.from, model.to})
        out.push_back(static_cast<uint64_t>(time));
    for (const plot::PlotCurve& curve : model.curves)
        if (curve.source && curve.isVisible) out.push_back(curve.source->revision());
    return out;
}

void TraceView::followFigure() {
    if (m_setup.figure.kind == FigureKind::None || m_figure->isBusy() || figureStamp() == m_figureShown) return;
    drawFigure();
}

// ------------------------------------------------------------------ remarks

void TraceView::addNote(int64_t time, std::optional<double> value, int chart, const QString& text) {
    if (text.trimmed().isEmpty()) return;
    change(tr("Add note"), [&](TraceSetup& s) {
        s.notes.push_back({time, value, chart, text.trimmed().toStdString(), {}});
    });
}

void TraceView::askNote(const QPoint& global) {
    const plot::PlotRuler at = m_plot->renderer().rulerAt(m_plot->model(), QPointF(m_plot->mapFromGlobal(global)), 14);
    bool isGood = false;
    const QString text = QInputDialog::getText(this, tr("Add Note"), tr("Note:"), QLineEdit::Normal, {}, &isGood);
    if (!isGood) return;
    // other axes than the first have their own scale: the remark keeps to its time there
    addNote(at.fromTime, at.axis == 0 ? std::optional(at.fromValue) : std::nullopt, at.chart, text);
}

void TraceView::editNote(size_t note) {
    bool isGood = false;
    const QString text = QInputDialog::getText(this, tr("Edit Note"), tr("Note:"), QLineEdit::Normal,
                                               QString::fromStdString(m_setup.notes[note].text), &isGood);
    if (isGood && !text.trimmed().isEmpty())
        change(tr("Edit note"), [&](TraceSetup& s) { s.notes[note].text = text.trimmed().toStdString(); });
}

void TraceView::removeNote(size_t note) {
    change(tr("Remove note"),
           [note](TraceSetup& s) { s.notes.erase(s.notes.begin() + static_cast<std::ptrdiff_t>(note)); });
}

void TraceView::addNoteActions(QMenu& menu, const QPoint& global) {
    const auto note = m_plot->renderer().noteAt(QPointF(m_plot->mapFromGlobal(global)));
    if (note && static_cast<size_t>(*note) < m_setup.notes.size()) {
        const auto index = static_cast<size_t>(*note);
        menu.addAction(tr("Edit Note…"), this, [this, index] { editNote(index); });
        menu.addAction(kit::icon(kit::Icon::Delete), tr("Remove Note"), this, [this, index] { removeNote(index); });
    }
    menu.addAction(kit::icon(kit::Icon::Marker), tr("Add Note…") + QStringLiteral("\tN"), this,
                   [this, global] { askNote(global); });
}

// ------------------------------------------------------------------ channels of other files

Result<void> TraceView::addChannelsFrom(const QString& path) {
    auto opened = readFile(path);
    if (!opened) return opened.error();
    if (!*opened || !(*opened)->program()) return {};
    ProgramVariables variables;
    variables.setProgram((*opened)->program());
    const QString file = m_folder.isEmpty() ? path : QDir(inProject({})).relativeFilePath(path);
    const auto chosen = kit::pickVariable(variables, {}, this);
    if (chosen) addChannelOf(file, *chosen);
    return {};
}

void TraceView::addChannelOf(const QString& file, const QString& expression) {
    change(tr("Add channel"), [&](TraceSetup& s) {
        ChannelSetup channel;
        channel.expression = expression.trimmed().toStdString();
        channel.recording = file.toStdString();
        channel.label =
            QStringLiteral("%1 (%2)").arg(expression.trimmed(), QFileInfo(file).completeBaseName()).toStdString();
        s.channels.push_back(std::move(channel));
    });
}

void TraceView::askChannelsFrom() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("File to add a channel of"), inProject({}),
                                     tr("Recordings and tables (*.rec *.csv *.tsv *.txt *.trace);;All files (*)"));
    if (!path.isEmpty()) report(addChannelsFrom(path));
}

} // namespace plc::trace
