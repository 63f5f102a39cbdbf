#include "editor/trace/figure_pane.h"

#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/post.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

namespace plc::trace {

FigurePane::FigurePane(QWidget* parent) : QWidget(parent) {
    m_title = new QLabel(this);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_xLabel = new QLabel(this);
    m_x = new QComboBox(this);
    m_x->setObjectName("figureX");
    m_x->setAccessibleName(tr("Horizontal value"));
    m_x->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_x->setMinimumContentsLength(16);
    m_window = new QComboBox(this);
    m_window->setObjectName("figureWindow");
    m_window->setAccessibleName(tr("Window"));
    m_window->addItem(tr("Hann window"), static_cast<int>(FigureWindow::Hann));
    m_window->addItem(tr("Flat top: exact amplitudes"), static_cast<int>(FigureWindow::FlatTop));
    m_window->addItem(tr("No window"), static_cast<int>(FigureWindow::Rectangular));
    m_logarithmic = new QCheckBox(tr("Logarithmic"), this);
    m_logarithmic->setObjectName("figureLogarithmic");
    auto* close = new QToolButton(this);
    close->setIcon(kit::icon(kit::Icon::Delete));
    close->setAutoRaise(true);
    close->setToolTip(tr("Charts over time only"));
    close->setAccessibleName(tr("Charts over time only"));
    m_view = new plot::FigureView(this);
    m_view->setObjectName("figureView");
    m_text = new QLabel(this);
    m_text->setObjectName("figureText");
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_text->setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(6, 2, 2, 0);
    for (QWidget* part : {static_cast<QWidget*>(m_title), static_cast<QWidget*>(m_xLabel), static_cast<QWidget*>(m_x),
                          static_cast<QWidget*>(m_window), static_cast<QWidget*>(m_logarithmic)})
        row->addWidget(part);
    row->addStretch();
    row->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(row);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_text);
    layout->setAlignment(m_text, Qt::AlignTop);
    m_text->setContentsMargins(8, 0, 8, 4);

    connect(close, &QToolButton::clicked, this, [this] {
        emit changeRequested(titleOf(FigureKind::None), [](TraceSetup& s) { s.figure.kind = FigureKind::None; });
    });
    connect(m_x, &QComboBox::activated, this, [this](int index) {
        const std::string x = m_x->itemData(index).toString().toStdString();
        emit changeRequested(tr("Horizontal value"), [x](TraceSetup& s) { s.figure.x = x; });
    });
    connect(m_window, &QComboBox::activated, this, [this](int index) {
        const auto window = static_cast<FigureWindow>(m_window->itemData(index).toInt());
        emit changeRequested(tr("Window of the spectrum"), [window](TraceSetup& s) { s.figure.window = window; });
    });
    connect(m_logarithmic, &QCheckBox::clicked, this, [this](bool on) {
        emit changeRequested(tr("Logarithmic axes"), [on](TraceSetup& s) { s.figure.isLogarithmic = on; });
    });
    connect(m_view, &plot::FigureView::menuRequested, this, &FigurePane::menu);
    hide();
}

FigurePane::~FigurePane() {
    if (m_worker.joinable()) m_worker.join();
}

void FigurePane::showSetup(const TraceSetup& setup) {
    const FigureKind kind = setup.figure.kind;
    setVisible(kind != FigureKind::None);
    if (kind == FigureKind::None) return;
    m_title->setText(titleOf(kind));
    const bool hasX = kind == FigureKind::Xy || kind == FigureKind::Response;
    m_xLabel->setText(kind == FigureKind::Response ? tr("Input:") : tr("Horizontal:"));
    m_x->setAccessibleName(kind == FigureKind::Response ? tr("Input") : tr("Horizontal value"));
    m_xLabel->setVisible(hasX);
    m_x->setVisible(hasX);
    m_window->setVisible(kind == FigureKind::Spectrum);
    m_logarithmic->setVisible(kind == FigureKind::Spectrum);
    m_x->clear();
    for (const ChannelSetup& channel : setup.channels)
        m_x->addItem(QString::fromStdString(channel.label.empty() ? channel.expression : channel.label),
                     QString::fromStdString(channel.expression));
    m_x->setCurrentIndex(std::max(0, m_x->findData(QString::fromStdString(setup.figure.x))));
    m_window->setCurrentIndex(m_window->findData(static_cast<int>(setup.figure.window)));
    m_logarithmic->setChecked(setup.figure.isLogarithmic);
}

void FigurePane::draw(FigureJob job) {
    if (m_isBusy) {
        m_next = std::move(job);
        return;
    }
    constexpr size_t kAtOnce = 20'000; // quicker than to start a thread for
    if (job.samples() <= kAtOnce) return take(figureOf(job));
    start(std::move(job));
}

void FigurePane::start(FigureJob job) {
    if (m_worker.joinable()) m_worker.join();
    m_isBusy = true;
    m_worker = std::thread([this, job = std::move(job)] {
        FigureAnswer answer = figureOf(job);
        kit::post(this, [this, answer = std::move(answer)]() mutable {
            m_isBusy = false;
            take(std::move(answer));
            if (m_next) draw(*std::exchange(m_next, std::nullopt));
        });
    });
}

void FigurePane::take(FigureAnswer answer) {
    m_text->setText(answer.figure.isEmpty() ? QString() : answer.text);
    m_text->setVisible(!m_text->text().isEmpty());
    m_view->setFigure(std::move(answer.figure));
    emit drawn();
}

QString FigurePane::text() const { return m_text->text(); }

void FigurePane::copyPicture() {
    QApplication::clipboard()->setImage(plot::figurePicture(m_view->figure(), {m_view->size(), 2}, m_view->zoom()));
}

void FigurePane::save(const QString& suffix) {
    QString path = QFileDialog::getSaveFileName(this, tr("Save as %1").arg(suffix.toUpper()), {},
                                                QStringLiteral("*.%1").arg(suffix));
    if (path.isEmpty()) return;
    if (!path.endsWith(QLatin1Char('.') + suffix)) path += QLatin1Char('.') + suffix;
    const Result<void> done = suffix == QLatin1String("csv")
                                  ? plot::exportFigureCsv(m_view->figure(), path)
                                  : plot::exportFigure(m_view->figure(), path, {m_view->size(), 2}, m_view->zoom());
    if (!done) emit failed(kit::messageText(done.error()));
}

void FigurePane::menu(const QPoint& global) {
    QMenu menu(this);
    menu.addAction(kit::icon(kit::Icon::Fit), tr("Fit"), m_view, &plot::FigureView::fit);
    QAction* measure = menu.addAction(tr("Measure between Points"));
    measure->setCheckable(true);
    measure->setChecked(m_view->measures());
    connect(measure, &QAction::toggled, m_view, &plot::FigureView::setMeasures);
    menu.addAction(kit::icon(kit::Icon::Copy), tr("Copy as Picture"), this, &FigurePane::copyPicture);
    for (const char* suffix : {"png", "svg", "pdf", "csv"})
        menu.addAction(tr("Save as %1…").arg(QString(QLatin1String(suffix)).toUpper()), this,
                       [this, suffix] { save(QLatin1String(suffix)); });
    menu.exec(global);
}

} // namespace plc::trace
