#include "hmi/station/range_check.h"

#include "hmi/model/errors.h"
#include "hmi/model/property_literals.h"
#include "hmi/station/plc_values.h"

#include <cmath>

namespace plc::hmi {

namespace {

struct Span {
    double least = 0, greatest = 0;
};

class RangeChecker {
public:
    RangeChecker(session::Session& session, const QString& file) : m_values(session), m_file(file) {}

    void check(const Element& element) {
        const auto has = [&](std::string_view key) { return element.descriptor().property(key) != nullptr; };
        if (has("value"_field) && has("min"_number) && has("max"_number) && element.kind() != ElementKind::BarChart)
            hold(element, element.text("value"_text), "min"_number, "max"_number, QStringLiteral("value"));
        if (has("pointX"_field)) {
            hold(element, element.text("pointX"_text), "minX"_number, "maxX"_number, QStringLiteral("pointX"));
            hold(element, element.text("pointY"_text), "minY"_number, "maxY"_number, QStringLiteral("pointY"));
        }
        const Json& series = element.at("series"_field);
        for (size_t row = 0; series.is_array() && row < series.size(); ++row)
            if (series[row].is_object())
                hold(element, Properties(descriptorOf(ElementKind::Unknown), series[row]).text("value"_text),
                     "min"_number, "max"_number, QStringLiteral("series[%1].value").arg(row));
    }

    std::vector<Finding> take() { return std::move(m_found); }

private:
    std::optional<Span> spanOf(const QString& expression) {
        const BindingId binding = m_values.bind(expression);
        if (!binding.isValid()) return {};
        constexpr double Ever = 1e9; // seconds
        std::optional<Span> out;
        for (const CurvePiece& piece : m_values.curve(binding, Ever, 16)) {
            if (!piece.hasValue() || !std::isfinite(piece.minimum) || !std::isfinite(piece.maximum)) continue;
            if (!out) out = Span{piece.minimum, piece.maximum};
            out->least = std::min(out->least, piece.minimum);
            out->greatest = std::max(out->greatest, piece.maximum);
        }
        return out;
    }

    void hold(const Element& element, const QString& expression, std::string_view low, std::string_view high,
              const QString& property) {
        const std::optional<double> from = element.optionalNumber(low), to = element.optionalNumber(high);
        if (expression.isEmpty() || !from || !to || *from >= *to) return;
        const std::optional<Span> span = spanOf(expression);
        const double slack = (*to - *from) * 0.005; // less than a pixel or two
        if (!span || (span->least >= *from - slack && span->greatest <= *to + slack)) return;
        const auto words = [](double number) { return toUtf8(QString::number(number, 'g', 5)); };
        m_found.push_back({FindingKind::LeavesRange, false, m_file, 0, element.id(), property, QString(),
                           errors::ValueLeavesRange(toUtf8(expression), words(span->least), words(span->greatest),
                                                    words(*from), words(*to))});
    }

    PlcValues m_values;
    QString m_file;
    std::vector<Finding> m_found;
};

} // namespace

std::vector<Finding> checkRanges(const PanelProject& project, session::Session& session) {
    std::vector<Finding> out;
    for (const NamedPanel& named : project.panels) {
        RangeChecker checker(session, QStringLiteral("hmi/%1.panel.json").arg(named.name));
        for (const Element& element : named.panel.elements()) checker.check(element);
        for (Finding& finding : checker.take()) out.push_back(std::move(finding));
    }
    return out;
}

} // namespace plc::hmi
