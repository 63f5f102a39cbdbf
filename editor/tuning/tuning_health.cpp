#include "editor/tuning/tuning_view.h"

#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "editor/kit/translation_tag.h"
#include "editor/plot/figure_view.h"
#include "editor/plot/page_pdf.h"
#include "editor/plot/plot_export.h"
#include "projects/tuning/loop_report.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSaveFile>
#include <QTreeWidget>
#include <QVBoxLayout>

// How the loop is doing, as a tab of the dock and as a page in a file.

namespace plc::editor {

namespace {

tuning::ReportWords studioWords() {
    tuning::ReportWords words;
    words.sentence = [](const Message& message) { return kit::messageText(message).toStdString(); };
    words.title = [](std::string_view text) {
        return QCoreApplication::translate("Tuning", std::string(text).c_str()).toStdString();
    };
    words.language = kit::translationTag(QLocale().name()).toStdString();
    return words;
}

Result<void> writePage(const QString& path, const std::string& page, const std::string& title) {
    if (path.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive))
        return plot::exportPage(page, title, path.toStdString());
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(page.data(), static_cast<qint64>(page.size())) < 0 ||
        !file.commit())
        return plot::cannotWrite(path, file.errorString());
    return {};
}

} // namespace

QWidget* TuningView::makeHealth() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 4, 0, 0);
    m_healthWords = new QLabel;
    m_healthWords->setObjectName("tuningHealthWords");
    m_healthWords->setWordWrap(true);
    m_healthWords->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_healthFigures = new QTreeWidget;
    m_healthFigures->setObjectName("tuningHealthFigures");
    m_healthFigures->setHeaderHidden(true);
    m_healthFigures->setColumnCount(2);
    m_healthFigures->setRootIsDecorated(false);
    m_healthFigures->setAlternatingRowColors(true);
    m_healthFigures->setAccessibleName(tr("Health in figures"));
    m_recorded = new plot::FigureView;
    m_recorded->setObjectName("tuningRecorded");
    m_recorded->setAccessibleName(tr("The whole recording"));
    column->addWidget(m_healthWords);
    column->addWidget(m_healthFigures, 2);
    column->addWidget(m_recorded, 3);
    return page;
}

void TuningView::showHealth() {
    QStringList words;
    m_healthFigures->clear();
    if (m_finding) {
        for (const Message& sentence : wordsOf(m_finding->health)) words << kit::messageText(sentence);
        for (const auto& [what, value] : healthRows(m_finding->health))
            new QTreeWidgetItem(m_healthFigures, {kit::messageText(what), kit::fromView(value)});
        m_healthFigures->resizeColumnToContents(0);
        m_recorded->setFigure({recordedCharts(report(), studioWords()), {}});
    }
    m_healthWords->setText(words.join(QLatin1Char('\n')));
}

tuning::LoopReport TuningView::report() const {
    const auto variable = [&](std::string_view pin) {
        const std::string source = loops::sourceOf(m_finding->loop, m_finding->program, pin);
        return source.empty() ? m_finding->loop.pin(pin) : source;
    };
    tuning::LoopReport out{m_finding->recorded.series, m_finding->study, m_finding->loop.name,
                           variable(m_finding->loop.form->output), m_finding->loop.pin(m_finding->loop.form->input)};
    out.health = m_finding->health;
    if (m_finding->problem) out.whyNoModel = m_finding->problem->message;
    if (m_finding->study.models.empty()) return out;
    out.model = modelIndex();
    out.cycle = m_finding->settings.cycle;
    out.now = m_now;
    out.rule = static_cast<tuning::Rule>(m_rule->currentData().toInt());
    const tuning::LoopConditions conditions{out.cycle, tuning::noiseOf(m_finding->recorded.series.output), 0};
    for (const tuning::Rule rule : tuning::allRules())
        if (const auto gains = tuning::tune(model(), rule, wish()))
            out.settings.push_back({rule, tuning::assess(model(), *gains, conditions)});
    for (const tuning::ParameterValue& value : m_parameters)
        out.parameters.emplace_back(m_finding->loop.pin(value.member), value.text);
    return out;
}

void TuningView::saveReport() {
    if (!m_finding) return;
    QString path = QFileDialog::getSaveFileName(this, tr("Save Report"), kit::fromView(m_finding->loop.name) + ".html",
                                                tr("Web pages (*.html);;PDF (*.pdf)"));
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".html");
    writeReport(path);
}

void TuningView::writeReport(const QString& path) {
    if (!m_finding) return;
    const auto written = writePage(path, htmlOf(report(), studioWords()), m_finding->loop.name);
    if (written)
        emit message(tr("Report written: %1").arg(path), false);
    else
        emit message(kit::messageText(written.error()), true);
}

} // namespace plc::editor
