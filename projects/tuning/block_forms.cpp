#include "projects/tuning/block_forms.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <cmath>

namespace plc::tuning {

namespace {

constexpr double kAnyGain = 3.4e38;
constexpr double kGainOfCascade = 1e38;
constexpr double kLongestTime = 4294967.295; // of a TIME in milliseconds
constexpr double kMinute = 60;
/// FB_PID and FB_PI_PID take less than a minute.
constexpr double kBelowMinute = 59.999;

using enum Quantity;
using enum Unit;

// ------------------------------------------------------------------ the toolbox's

BlockForm proportional() {
    return {.type = "FB_P",
            .input = "q_rOput",
            .output = "i_rActVal",
            .setPoint = "i_rSp",
            .manual = "i_xManMode",
            .parameters = {{"i_rKp", Gain, Plain, 0, kAnyGain}}};
}

BlockForm proportionalIntegral() {
    return {.type = "FB_PI",
            .input = "q_rOput",
            .output = "i_rActVal",
            .setPoint = "i_rSp",
            .low = "i_stPara.rMinLim",
            .high = "i_stPara.rMaxLim",
            .manual = "i_xManMode",
            .resumes = "core.wasHeld",
            .cycle = "i_stPara.tCyclTime",
            .cycleUnit = TimeLiteral,
            .parameters = {{"i_stPara.rKp", Gain, Plain, 0, kAnyGain},
                           {"i_stPara.tTn", IntegralTime, TimeLiteral, 0.001, kLongestTime}}};
}

BlockForm withDerivative() {
    return {.type = "FB_PID",
            .input = "q_rPidOput",
            .output = "i_rPv1",
            .setPoint = "i_rSp",
            .low = "i_stPid.rLowLim",
            .high = "i_stPid.rHighLim",
            .manual = "i_xManMode",
            .resumes = "core.wasHeld",
            .cycle = "i_stPid.rTargCyclTime",
            .cycleUnit = Milliseconds,
            .parameters = {{"i_rKp", Gain, Plain, 0, kAnyGain},
                           {"i_rTn", IntegralTime, Milliseconds, 0, kMinute},
                           {"i_rTv", DerivativeTime, Milliseconds, 0, kMinute},
                           {"i_rTd", FilterTime, Milliseconds, 0, kBelowMinute}}};
}

/// The outer loop of FB_PI_PID: its output is the inner one's set point.
BlockForm outerOfCascade() {
    return {.type = "FB_PI_PID",
            .part = "PI",
            .input = "innerSetPoint",
            .output = "i_rActValPI",
            .setPoint = "i_rSp",
            .low = "i_stParaPI.rMinLim",
            .high = "i_stParaPI.rMaxLim",
            .manual = "i_xManModePI",
            .resumes = "pi.wasHeld",
            .cycle = "i_stParaPI.tCyclTime",
            .cycleUnit = TimeLiteral,
            .parameters = {{"i_stParaPI.rKp", Gain, Plain, 0, kGainOfCascade},
                           {"i_stParaPI.tTn", IntegralTime, TimeLiteral, 0, kMinute}}};
}

BlockForm innerOfCascade() {
    return {.type = "FB_PI_PID",
            .part = "PID",
            .input = "q_rOput",
            .output = "i_rActValPID",
            .setPoint = "innerSetPoint",
            .low = "i_stParaPID.rMinLim",
            .high = "i_stParaPID.rMaxLim",
            .manual = "i_xManModePID",
            .resumes = "pid.wasHeld",
            .cycle = "i_stParaPI.tCyclTime",
            .cycleUnit = TimeLiteral,
            .parameters = {{"i_stParaPID.rKp", Gain, Plain, 0, kGainOfCascade},
                           {"i_stParaPID.tTn", IntegralTime, TimeLiteral, 0, kMinute},
                           {"i_stParaPID.tTv", DerivativeTime, TimeLiteral, 0, kMinute},
                           {"i_stParaPID.tTd", FilterTime, TimeLiteral, 0, kMinute}}};
}

// ------------------------------------------------------------------ others

BlockForm ofUtil(std::string_view type, std::string_view cycle) {
    return {.type = type,
            .input = "Y",
            .output = "ACTUAL",
            .setPoint = "SET_POINT",
            .low = "Y_MIN",
            .high = "Y_MAX",
            .manual = "MANUAL",
            .resumes = "core.wasManual",
            .cycle = cycle,
            .cycleUnit = Seconds,
            .parameters = {{"KP", Gain, Plain, -kAnyGain, kAnyGain},
                           {"TN", IntegralTime, Seconds, 0, kAnyGain},
                           {"TV", DerivativeTime, Seconds, 0, kAnyGain}}};
}

BlockForm ofAnnexF(std::string_view type) {
    return {.type = type,
            .input = "XOUT",
            .output = "PV",
            .setPoint = "SP",
            .manual = "AUTO",
            .resumes = "resumes",
            .cycle = "CYCLE",
            .cycleUnit = TimeLiteral,
            .isReversed = true,
            .parameters = {{"KP", Gain, Plain, -kAnyGain, kAnyGain},
                           {"TR", IntegralTime, Seconds, 0, kAnyGain},
                           {"TD", DerivativeTime, Seconds, 0, kAnyGain}}};
}

std::vector<BlockForm> makeForms() {
    return {
        proportional(),    proportionalIntegral(),          withDerivative(), outerOfCascade(),     innerOfCascade(),
        ofUtil("PID", ""), ofUtil("PID_FIXCYCLE", "CYCLE"), ofAnnexF("PID"),  ofAnnexF("PID_LREAL")};
}

std::string timeText(double seconds) {
    const auto microseconds = std::llround(seconds * 1e6);
    if (microseconds % 1000 == 0) return "T#" + std::to_string(microseconds / 1000) + "ms";
    return "T#" + shortestReal(static_cast<double>(microseconds) / 1000) + "ms";
}

std::string textOf(Unit unit, double value) {
    const auto rounded = static_cast<float>(std::strtod(numberText(value, 5).c_str(), nullptr));
    switch (unit) {
    case Unit::Plain:
    case Unit::Seconds:
        return shortestReal(rounded);
    case Unit::Milliseconds:
        return shortestReal(static_cast<float>(std::strtod(numberText(value * 1000, 5).c_str(), nullptr)));
    case Unit::TimeLiteral:
        return timeText(std::round(value * 1e3) / 1e3);
    }
    return {};
}

double wanted(const ControllerGains& gains, Quantity quantity) {
    switch (quantity) {
    case Quantity::Gain:
        return gains.gain;
    case Quantity::IntegralTime:
        return gains.integralTime;
    case Quantity::DerivativeTime:
        return gains.derivativeTime;
    case Quantity::FilterTime:
        return gains.filterTime;
    }
    return 0;
}

} // namespace

std::vector<ControllerKind> BlockForm::kinds() const {
    std::vector<ControllerKind> out{ControllerKind::P};
    for (const ParameterForm& parameter : parameters) {
        if (parameter.quantity == Quantity::IntegralTime) out.push_back(ControllerKind::Pi);
        if (parameter.quantity == Quantity::DerivativeTime) out.push_back(ControllerKind::Pid);
    }
    return out;
}

const std::vector<BlockForm>& blockForms() {
    static const std::vector<BlockForm> all = makeForms();
    return all;
}

std::vector<ParameterValue> parametersOf(const BlockForm& form, const ControllerGains& gains, double cycle) {
    std::vector<ParameterValue> out;
    for (const ParameterForm& parameter : form.parameters) {
        // without a derivative its filter stays as it is
        if (parameter.quantity == Quantity::FilterTime && gains.derivativeTime <= 0) continue;
        double value = wanted(gains, parameter.quantity);
        if (parameter.quantity == Quantity::Gain && form.isReversed) value = -value;
        double least = parameter.least;
        if (parameter.quantity == Quantity::FilterTime) {
            least = cycle * 1.001; // the filter cannot be quicker than the calls
            value = std::max(value, least);
        }
        // no integral part: as far from one as the block can be, where 0 is not taken
        if (parameter.quantity == Quantity::IntegralTime && value <= 0 && least > 0) value = parameter.greatest;
        const double limited = std::clamp(value, least, parameter.greatest);
        out.push_back({std::string(parameter.member), textOf(parameter.unit, limited), limited, limited != value});
    }
    return out;
}

ControllerGains gainsOf(const BlockForm& form, const std::vector<double>& values) {
    ControllerGains out{0, 0, 0, 0};
    for (size_t i = 0; i < form.parameters.size() && i < values.size(); ++i) {
        const ParameterForm& parameter = form.parameters[i];
        const double scale = parameter.unit == Unit::Milliseconds ? 1e-3 : 1;
        switch (parameter.quantity) {
        case Quantity::Gain:
            out.gain = form.isReversed ? -values[i] : values[i];
            break;
        case Quantity::IntegralTime:
            out.integralTime = values[i] * scale;
            break;
        case Quantity::DerivativeTime:
            out.derivativeTime = values[i] * scale;
            break;
        case Quantity::FilterTime:
            out.filterTime = values[i] * scale;
            break;
        }
    }
    return out;
}

} // namespace plc::tuning
