#include "app/cli/tune/tune_output.h"

#include "projects/waveform/chart.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace plc::cli {

namespace {

using tuning::numberText;
using Json = nlohmann::ordered_json;

/// A long one is set off from the next column all the same.
std::string padded(std::string text, size_t width) {
    text.resize(std::max(width, text.size() + 1), ' ');
    return text;
}

const char* word(tuning::ControllerKind kind) {
    switch (kind) {
    case tuning::ControllerKind::P:
        return "P";
    case tuning::ControllerKind::Pi:
        return "PI";
    case tuning::ControllerKind::Pid:
        return "PID";
    }
    return "";
}

std::string word(tuning::Moved moved) {
    switch (moved) {
    case tuning::Moved::Input:
        return "input";
    case tuning::Moved::SetPoint:
        return "set point";
    case tuning::Moved::Load:
        return "load";
    }
    return {};
}

bool isUsed(const TuneReport& report, size_t index) {
    return std::find(report.study.used.begin(), report.study.used.end(), index) != report.study.used.end();
}

std::string stepsText(const TuneReport& report) {
    const auto& steps = report.study.steps;
    std::string out = "Steps: " + std::to_string(steps.size()) + " found, " + std::to_string(report.study.used.size()) +
                      " used for the model\n";
    out += "       #  at           moved      from        to          output by   verdict\n";
    constexpr size_t kMost = 40;
    for (size_t i = 0; i < std::min(steps.size(), kMost); ++i) {
        const tuning::FoundStep& step = steps[i];
        std::string number = std::to_string(i + 1);
        number.insert(0, 6 - std::min<size_t>(number.size(), 6), ' ');
        out += "  " + number + (isUsed(report, i) ? "* " : "  ") +
               padded(numberText(report.series.time[step.step], 7) + " s", 12) + " " + padded(word(step.moved), 10) +
               " " + padded(numberText(step.from, 5), 11) + " " + padded(numberText(step.to, 5), 11) + " " +
               padded(numberText(step.outputChange, 4), 11) + " " + step.reason.english() + "\n";
    }
    if (steps.size() > kMost) out += "       … and " + std::to_string(steps.size() - kMost) + " more\n";
    return out;
}

std::string boundText(const tuning::Bound& bound) {
    const bool isExact = bound.halfWidth < 1e-4 * std::abs(bound.value);
    const char* unit = bound.name == "gain" || bound.name == "damping" ? ""
                       : bound.name == "frequency"                     ? " rad/s"
                                                                       : " s";
    const std::string width = isExact ? " (to 0.01 %)" : " ± " + numberText(bound.halfWidth, 2) + unit;
    return "  " + padded(bound.name, 11) + numberText(bound.value) + (isExact ? unit : "") + width + "\n";
}

std::string modelText(const TuneReport& report) {
    const tuning::Identified& model = report.best();
    std::string out =
        "\nModel: " + std::string(title(model.structure)) + ", explains " + numberText(model.fit, 4) + " %";
    if (model.validation) out += " (" + numberText(*model.validation, 4) + " % of steps it was not made from)";
    out += "\n  " + formula(model.model) + "\n";
    for (const tuning::Bound& bound : model.bounds) out += boundText(bound);
    for (const Message& words : gainWords(model)) out += "  " + words.english() + "\n";
    constexpr double kAll = 99.995; // then no other says more
    for (size_t i = 1; i < std::min<size_t>(report.study.models.size(), 3) && model.fit < kAll; ++i) {
        const tuning::Identified& other = report.study.models[i];
        out += std::string(i == 1 ? "  also: " : "        ") + formula(other.model) + ", " + numberText(other.fit, 4) +
               " %\n";
    }
    return out;
}

std::string gainsText(const tuning::ControllerGains& gains) {
    std::string out = "gain " + numberText(gains.gain);
    if (gains.integralTime > 0) out += ", integral time " + numberText(gains.integralTime) + " s";
    if (gains.derivativeTime > 0) out += ", derivative time " + numberText(gains.derivativeTime) + " s";
    return out;
}

std::string rowOf(const std::string& name, const tuning::Assessment& one) {
    const auto time = [](double seconds) { return seconds > 0 ? numberText(seconds, 3) + " s" : std::string("never"); };
    const auto margin = [](double value) { return std::isfinite(value) ? numberText(value, 3) : std::string("any"); };
    return "  " + padded(name, 22) + padded(numberText(one.gains.gain), 9) +
           padded(one.gains.integralTime > 0 ? numberText(one.gains.integralTime) : "-", 9) +
           padded(one.gains.derivativeTime > 0 ? numberText(one.gains.derivativeTime) : "-", 9) +
           padded(one.figures.isStable ? numberText(one.figures.sensitivity, 3) : "unstable", 9) +
           padded(margin(one.figures.gainMargin), 8) + padded(margin(one.figures.phaseMargin), 8) +
           padded(one.figures.isStable ? numberText(one.setPoint.overshoot, 3) + " %" : "-", 10) +
           padded(one.figures.isStable ? time(one.setPoint.settlingTime) : "-", 10) +
           (one.figures.isStable ? numberText(one.load.integratedError, 3) : "-") + "\n";
}

std::string settingsText(const TuneReport& report) {
    std::string out = std::string("\nSettings of a ") + word(report.kind) + " controller called every " +
                      numberText(report.cycle * 1000) + " ms\n  " + padded("", 22) +
                      "gain     Ti [s]   Td [s]   Ms       margin  phase   overshoot settles   load error\n";
    if (report.now) out += rowOf("now", *report.now);
    for (const RuleAnswer& answer : report.answers)
        out += rowOf(std::string(title(answer.rule)) + (answer.rule == report.rule ? " *" : ""), answer.assessment);
    return out;
}

std::vector<const loops::CallConstant*> constantsOf(const TuneReport& report, const std::string& member) {
    std::vector<const loops::CallConstant*> out;
    for (const loops::CallConstant& constant : report.constants)
        if (constant.member == member) out.push_back(&constant);
    return out;
}

std::string chosenText(const TuneReport& report) {
    const RuleAnswer* answer = report.answer();
    if (!answer) return "\nThe rule " + std::string(title(report.rule)) + " does not apply to this process.\n";
    std::string out = "\n" + std::string(title(answer->rule)) + ": " + gainsText(answer->assessment.gains) + "\n  " +
                      robustnessWords(answer->assessment).english() + "\n  " +
                      overshootWords(answer->assessment).english() + "\n";
    if (const Message caution = cautionOf(answer->rule); !caution.isEmpty()) out += "  " + caution.english() + "\n";
    if (!report.loop) return out;
    out += "\n" + std::string(report.loop->form->type) + " " + report.loop->name + "\n";
    for (size_t i = 0; i < report.parameters.size(); ++i) {
        const tuning::ParameterValue& value = report.parameters[i];
        const std::string& path = report.targets[i].path;
        if (!path.empty()) out += "  " + path + " := " + value.text + ";\n";
        const auto constants = constantsOf(report, value.member);
        for (const loops::CallConstant* constant : constants)
            out += "  // " + constant->file + ":" + std::to_string(constant->line) + ": " + value.member +
                   " := " + value.text + " in the place of " + constant->text + "\n";
        if (path.empty() && constants.empty())
            out += "  // " + value.member + " is computed in the call: should be " + value.text + "\n";
        if (value.isLimited) out += "  // limited to what the block takes\n";
    }
    return out;
}

} // namespace

const RuleAnswer* TuneReport::answer() const {
    const auto found =
        std::find_if(answers.begin(), answers.end(), [&](const RuleAnswer& a) { return a.rule == rule; });
    return found != answers.end() ? &*found : nullptr;
}

std::string textOf(const TuneReport& report) {
    return report.name + ": " + report.channels.output + " by " + report.channels.input + "\n" + stepsText(report) +
           modelText(report) + settingsText(report) + chosenText(report);
}

namespace {

Json modelJson(const tuning::Identified& one) {
    Json json{{"structure", std::string(title(one.structure))},
              {"formula", formula(one.model)},
              {"gain", one.model.gain},
              {"lags", one.model.lags},
              {"dead_time", one.model.deadTime},
              {"integrating", one.model.isIntegrating},
              {"fit", one.fit}};
    if (one.model.zero != 0) json["zero"] = one.model.zero;
    if (one.model.oscillation) {
        json["frequency"] = one.model.oscillation->frequency;
        json["damping"] = one.model.oscillation->damping;
    }
    if (one.validation) json["validation"] = *one.validation;
    if (one.gainUp) json["gain_up"] = *one.gainUp;
    if (one.gainDown) json["gain_down"] = *one.gainDown;
    for (const tuning::GainAt& at : one.gainsAt) json["gains_at"].push_back({{"output", at.level}, {"gain", at.gain}});
    if (!one.bounds.empty()) {
        Json bounds = Json::object();
        for (const tuning::Bound& bound : one.bounds) bounds[bound.name] = bound.halfWidth;
        json["confidence"] = std::move(bounds);
    }
    return json;
}

Json assessmentJson(const tuning::Assessment& one) {
    const auto finite = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
    return {{"gain", one.gains.gain},
            {"integral_time", one.gains.integralTime},
            {"derivative_time", one.gains.derivativeTime},
            {"filter_time", one.gains.filterTime},
            {"stable", one.figures.isStable},
            {"ms", one.figures.sensitivity},
            {"crossover", one.figures.phaseMarginAt},
            {"phase_crossover", one.figures.gainMarginAt},
            {"gain_margin", finite(one.figures.gainMargin)},
            {"phase_margin", finite(one.figures.phaseMargin)},
            {"overshoot", one.setPoint.overshoot},
            {"settling_time", one.setPoint.settlingTime},
            {"effort", one.setPoint.effort},
            {"greatest_rate", one.setPoint.greatestRate},
            {"load_error", one.load.integratedError},
            {"load_greatest", one.load.greatestError},
            {"input_noise", one.noise},
            {"words", robustnessWords(one).english()}};
}

} // namespace

std::string jsonOf(const TuneReport& report) {
    Json steps = Json::array();
    for (size_t i = 0; i < report.study.steps.size(); ++i) {
        const tuning::FoundStep& step = report.study.steps[i];
        steps.push_back({{"time_s", report.series.time[step.step]},
                         {"moved", word(step.moved)},
                         {"from", step.from},
                         {"to", step.to},
                         {"output_change", step.outputChange},
                         {"usable", step.isUsable()},
                         {"used", isUsed(report, i)},
                         {"reason", step.reason.english()}});
    }
    Json json{{"loop", report.name},     {"input", report.channels.input}, {"output", report.channels.output},
              {"cycle_s", report.cycle}, {"steps", std::move(steps)},      {"model", modelJson(report.best())}};
    Json others = Json::array();
    for (size_t i = 1; i < std::min<size_t>(report.study.models.size(), 5); ++i)
        others.push_back(modelJson(report.study.models[i]));
    json["others"] = std::move(others);
    if (report.now) json["now"] = assessmentJson(*report.now);
    Json answers = Json::object();
    for (const RuleAnswer& answer : report.answers)
        answers[std::string(tuning::word(answer.rule))] = assessmentJson(answer.assessment);
    json["kind"] = word(report.kind);
    json["rule"] = std::string(tuning::word(report.rule));
    json["settings"] = std::move(answers);
    if (report.loop) {
        Json writes = Json::array();
        for (size_t i = 0; i < report.parameters.size(); ++i) {
            writes.push_back({{"pin", report.parameters[i].member},
                              {"path", report.targets[i].path},
                              {"value", report.parameters[i].text},
                              {"limited", report.parameters[i].isLimited}});
            for (const loops::CallConstant* constant : constantsOf(report, report.parameters[i].member))
                writes.back()["constants"].push_back(
                    {{"file", constant->file}, {"line", constant->line}, {"text", constant->text}});
        }
        json["block"] = std::string(report.loop->form->type);
        json["writes"] = std::move(writes);
    }
    return json.dump(2) + "\n";
}

namespace {

tuning::LoopReport pageFor(const TuneReport& report) {
    tuning::LoopReport out{report.series, report.study, report.name, report.measuredName, report.inputName};
    out.health = report.health;
    out.whyNoModel = report.whyNoModel;
    out.cycle = report.cycle;
    out.now = report.now;
    out.settings = report.answers;
    out.rule = report.rule;
    for (size_t i = 0; i < report.parameters.size(); ++i) {
        const std::string& path = report.targets[i].path;
        out.parameters.emplace_back(path.empty() ? report.loop->pin(report.parameters[i].member) : path,
                                    report.parameters[i].text);
    }
    return out;
}

waveform::ChartPage chartPageFor(const TuneReport& report, bool isDark) {
    waveform::ChartPage page;
    page.isDark = isDark;
    page.title = report.name;
    page.lines.push_back(formula(report.best().model) + ", explains " + numberText(report.best().fit, 4) + " %");
    if (const RuleAnswer* answer = report.answer())
        page.lines.push_back(std::string(title(answer->rule)) + ": " + gainsText(answer->assessment.gains) + ", Ms " +
                             numberText(answer->assessment.figures.sensitivity, 3));
    return page;
}

} // namespace

std::string pictureOf(const TuneReport& report, bool isDark) {
    waveform::ChartPage page = chartPageFor(report, isDark);
    page.charts = modelCharts(pageFor(report));
    return svgOf(page);
}

std::string bodePictureOf(const TuneReport& report, bool isDark) {
    waveform::ChartPage page = chartPageFor(report, isDark);
    page.columns = 1;
    for (waveform::Chart& chart : bodeOf(pageFor(report))) page.charts.push_back(std::move(chart));
    return svgOf(page);
}

std::string healthText(const TuneReport& report) {
    std::string out = "Health of " + report.name + "\n";
    for (const Message& sentence : wordsOf(report.health)) out += "  " + sentence.english() + "\n";
    for (const auto& [what, value] : healthRows(report.health)) out += "  " + padded(what.english(), 36) + value + "\n";
    return out;
}

std::string pageOf(const TuneReport& report) { return htmlOf(pageFor(report)); }

} // namespace plc::cli
