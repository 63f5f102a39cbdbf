#include "projects/tuning/loop_report.h"

#include "projects/tuning/model/errors.h"
#include "runtime/base/xml_text.h"

#include <algorithm>
#include <cmath>

namespace plc::tuning {

namespace {

double rounded(double value, int digits) { return std::strtod(numberText(value, digits).c_str(), nullptr); }

Message words(const Bound& bound) {
    const double value = rounded(bound.value, 4);
    // what noise does not say is not better than the search for it
    const double width = rounded(std::max(bound.halfWidth, 1e-4 * std::abs(bound.value)), 2);
    if (bound.name == "gain") return errors::BoundGain(value, width);
    if (bound.name == "frequency") return errors::BoundFrequency(value, width);
    if (bound.name == "damping") return errors::BoundDamping(value, width);
    if (bound.name == "zero") return errors::BoundZero(value, width);
    if (bound.name == "dead time") return errors::BoundDeadTime(value, width);
    return errors::BoundLag(value, width);
}

using Row = std::vector<std::string>;

/// Text to HTML; the first row is the head.
std::string table(const std::vector<Row>& rows, bool hasHead = true) {
    std::string out = "<table>\n";
    for (size_t i = 0; i < rows.size(); ++i) {
        const bool isHead = hasHead && i == 0;
        out += "<tr>";
        for (size_t k = 0; k < rows[i].size(); ++k)
            out += std::string(isHead   ? "<th align=\"left\">"
                               : k == 0 ? "<td style=\"white-space:nowrap\">"
                                        : "<td>") +
                   xmlText(rows[i][k]) + (isHead ? "</th>" : "</td>");
        out += "</tr>\n";
    }
    return out + "</table>\n";
}

class Page {
public:
    Page(const LoopReport& report, const ReportWords& words) : m_report(report), m_words(words) {}
    [[nodiscard]] std::string html() const {
        std::string out = head() + health();
        if (!m_report.study.steps.empty()) out += changes();
        if (!m_report.study.models.empty())
            out += model() + settings() + charts();
        else if (!m_report.whyNoModel.isEmpty())
            out += paragraph(errors::PageNoModel(m_report.whyNoModel));
        return out + "</body></html>\n";
    }

private:
    [[nodiscard]] std::string said(const Message& message) const { return m_words.sentence(message); }
    [[nodiscard]] std::string paragraph(const Message& message) const {
        return "<p>" + xmlText(said(message)) + "</p>\n";
    }
    [[nodiscard]] std::string heading(const Message& message, bool isOnNewPage = false) const {
        return std::string(isOnNewPage ? "<h2 style=\"page-break-before:always\">" : "<h2>") + xmlText(said(message)) +
               "</h2>\n";
    }
    [[nodiscard]] std::string drawing(std::vector<waveform::Chart> charts, const std::string& title) const {
        waveform::ChartPage page;
        page.title = title;
        page.charts = std::move(charts);
        return svgOf(page);
    }
    [[nodiscard]] std::string head() const;
    [[nodiscard]] std::string health() const;
    [[nodiscard]] std::string changes() const;
    [[nodiscard]] std::string model() const;
    [[nodiscard]] std::string settings() const;
    [[nodiscard]] std::string charts() const {
        return drawing(modelCharts(m_report, m_words), said(errors::PageCharts()));
    }
    [[nodiscard]] Row settingsRow(const std::string& name, const Assessment& one) const;

    const LoopReport& m_report;
    const ReportWords& m_words;
};

std::string Page::head() const {
    return "<!DOCTYPE html>\n<html lang=\"" + m_words.language + "\"><head><meta charset=\"utf-8\"><title>" +
           xmlText(m_report.name) +
           "</title>\n<style>:root{color-scheme:light}body{font-family:\"Noto Sans\",sans-serif;margin:0;"
           "padding:24px;max-width:1160px;color:#202124;background:#ffffff;overflow-wrap:break-word}"
           "table{border-collapse:collapse}td,th{padding:2px 10px 2px 0;text-align:left;vertical-align:top}"
           "th{border-bottom:1px solid "
           "#9aa0a6;font-size:80%;vertical-align:bottom}svg{max-width:100%;height:auto}</style></head>"
           "<body>\n<h1>" +
           xmlText(m_report.name) + "</h1>\n" + paragraph(errors::PageSignals(m_report.measured, m_report.input));
}

std::string Page::health() const {
    std::string out = heading(errors::PageHealth());
    for (const Message& sentence : wordsOf(m_report.health)) out += paragraph(sentence);
    std::vector<Row> rows;
    for (const auto& [what, value] : healthRows(m_report.health)) rows.push_back({said(what), value});
    return out + table(rows, false) + drawing(recordedCharts(m_report, m_words), "");
}

std::string Page::changes() const {
    const Study& study = m_report.study;
    std::string out =
        heading(errors::PageChanges()) + paragraph(errors::PageChangesUsed(study.steps.size(), study.used.size()));
    std::vector<Row> rows{{"", said(errors::ColumnAt()), said(errors::ColumnMoved()), said(errors::ColumnFrom()),
                           said(errors::ColumnTo()), said(errors::ColumnVerdict())}};
    constexpr size_t kMost = 40;
    for (size_t i = 0; i < std::min(study.steps.size(), kMost); ++i) {
        const FoundStep& step = study.steps[i];
        const bool isUsed = std::find(study.used.begin(), study.used.end(), i) != study.used.end();
        rows.push_back({std::to_string(i + 1) + (isUsed ? " ✓" : ""), numberText(m_report.series.time[step.step], 7),
                        said(movedWord(step.moved)), numberText(step.from, 5), numberText(step.to, 5),
                        said(step.reason)});
    }
    out += table(rows);
    return study.steps.size() > kMost ? out + paragraph(errors::PageMoreChanges(study.steps.size() - kMost)) : out;
}

std::string Page::model() const {
    const Identified& best = m_report.best();
    std::string out = heading(errors::PageModel(), true);
    out += paragraph(errors::PageExplains(m_words.title(title(best.structure)), rounded(best.fit, 4)));
    if (best.validation) out += paragraph(errors::PageValidated(rounded(*best.validation, 4)));
    out += "<p><b>" + xmlText(formula(best.model)) + "</b></p>\n";
    std::string bounds;
    for (const Message& words : boundWords(best)) bounds += (bounds.empty() ? "" : ", ") + said(words);
    if (!bounds.empty()) out += "<p>" + xmlText(bounds) + "</p>\n";
    for (const Message& words : gainWords(best)) out += paragraph(words);
    return out;
}

Row Page::settingsRow(const std::string& name, const Assessment& one) const {
    const bool isStable = one.figures.isStable;
    const auto number = [](double value, bool isThere = true) {
        return isThere && std::isfinite(value) ? numberText(value, 3) : std::string("–");
    };
    return {name,
            numberText(one.gains.gain),
            number(one.gains.integralTime, one.gains.integralTime > 0),
            number(one.gains.derivativeTime, one.gains.derivativeTime > 0),
            isStable ? number(one.figures.sensitivity) : said(errors::CellUnstable()),
            number(one.figures.gainMargin, isStable),
            isStable && std::isfinite(one.figures.phaseMargin) ? numberText(std::round(one.figures.phaseMargin)) + "°"
                                                               : "–",
            isStable ? numberText(std::round(one.setPoint.overshoot)) + " %" : "–",
            number(one.setPoint.settlingTime, isStable && one.setPoint.settlingTime > 0),
            number(one.load.integratedError, isStable)};
}

std::string Page::settings() const {
    std::vector<Row> rows{{"", said(errors::ColumnGain()), said(errors::ColumnIntegral()),
                           said(errors::ColumnDerivative()), "Ms", said(errors::ColumnGainMargin()),
                           said(errors::ColumnPhaseMargin()), said(errors::ColumnOvershoot()),
                           said(errors::ColumnSettling()), said(errors::ColumnLoadError())}};
    if (m_report.now) rows.push_back(settingsRow(said(errors::CellNow()), *m_report.now));
    for (const ReportedSettings& one : m_report.settings)
        rows.push_back(
            settingsRow(m_words.title(title(one.rule)) + (one.rule == m_report.rule ? " ✓" : ""), one.assessment));
    std::string out = heading(errors::PageSettings()) + table(rows);
    const Assessment* chosen = m_report.chosen();
    if (!chosen) return out + paragraph(errors::RuleHasNoAnswer(m_words.title(title(m_report.rule))));
    out += paragraph(robustnessWords(*chosen)) + paragraph(overshootWords(*chosen));
    if (const Message caution = cautionOf(m_report.rule); !caution.isEmpty()) out += paragraph(caution);
    if (m_report.parameters.empty()) return out;
    rows.clear();
    for (const auto& [pin, value] : m_report.parameters) rows.push_back({pin, value});
    return out + paragraph(errors::PageParameters(m_words.title(title(m_report.rule)))) + table(rows, false);
}

} // namespace

std::vector<Message> boundWords(const Identified& model) {
    std::vector<Message> out;
    for (const Bound& bound : model.bounds) out.push_back(words(bound));
    return out;
}

std::vector<Message> gainWords(const Identified& model) {
    std::vector<Message> out;
    const auto brief = [](double value) { return rounded(value, 3); };
    if (model.gainUp && model.gainDown)
        out.push_back(errors::GainByDirection(brief(*model.gainUp), brief(*model.gainDown), brief(model.model.gain)));
    if (model.gainsAt.size() >= 2) {
        const GainAt &low = model.gainsAt.front(), &high = model.gainsAt.back();
        out.push_back(errors::GainByPoint(brief(low.gain), brief(low.level), brief(high.gain), brief(high.level),
                                          brief(model.model.gain)));
    }
    return out;
}

namespace {

/// As a reader writes it: no power of ten for what has a few digits.
std::string plainText(double value) {
    constexpr double kMany = 1000, kTooMany = 1e9;
    const double size = std::abs(value);
    return size >= kMany && size < kTooMany ? numberText(std::round(value), 10) : numberText(value);
}

} // namespace

std::vector<std::pair<Message, std::string>> healthRows(const Health& health) {
    return {{errors::RowDuration(), plainText(health.duration) + " s"},
            {errors::RowAtLimit(), numberText(health.timeAtLimit * 100, 3) + " %"},
            {errors::RowMeanError(), plainText(health.meanError)},
            {errors::RowIntegratedError(), plainText(health.integratedError)},
            {errors::RowEffort(), plainText(health.effort)},
            {errors::RowNoise(), numberText(health.noise, 3)}};
}

Message movedWord(Moved moved) {
    switch (moved) {
    case Moved::Input:
        return errors::MovedInput();
    case Moved::SetPoint:
        return errors::MovedSetPoint();
    case Moved::Load:
        return errors::MovedLoad();
    }
    return {};
}

std::string htmlOf(const LoopReport& report, const ReportWords& words) { return Page(report, words).html(); }

} // namespace plc::tuning
