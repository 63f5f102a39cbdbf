// The values of a run for panels: expressions over the newest snapshot, or over the recorded image that the time slider
// has chosen; a run that is over is shown at its newest scan. Owned by the player; main thread. The run must outlive
// it.
#pragma once
#include "hmi/station/plc_convert.h"
#include "hmi/view/scene/value_source.h"
#include "projects/session/run.h"

#include <QStringList>

namespace plc::hmi {

class PlcValues final : public ValueSource {
public:
    explicit PlcValues(const session::Run& run) : PlcValues(&run) {}
    explicit PlcValues(const session::Run* run); // null: nothing to show yet

    /// Takes the newest snapshot if there is one; at most once per frame. True if values may have changed.
    bool refresh();
    /// A past scan of the recording, or none for the present.
    void setPosition(std::optional<history::Position> position);
    std::optional<history::Position> position() const { return m_position; }
    /// Another run, at its newest scan until a position is set; null: nothing to show.
    void setRun(const session::Run* run);
    bool isPast() const { return m_position || (m_run && !m_run->isLive()); }
    const session::Status& status() const { return m_status; }

    BindingId bind(const QString& expression) override;
    const Value& value(BindingId binding) const override;
    ValueFacts facts(BindingId binding) const override;
    std::vector<CurvePiece> curve(BindingId binding, double seconds, int buckets) const override;
    Freshness freshness() const override;
    qint64 clock() const override;
    /// The calendar at PLC time 0 of what is shown; nothing before the first scan.
    std::optional<qint64> clockAtZero() const;
    quint64 revision() const override { return m_revision; }

private:
    struct Binding {
        QString text;
        expression::Expression compiled;
        QString problem;
        ValueFacts facts;
        Value value;
        // A reader of one variable remembers its bytes: equal bytes are an equal value.
        std::vector<std::byte> lastBytes;
    };
    void compile(Binding& binding);
    void runUnder(const std::shared_ptr<const image::CompiledProgram>& program);
    bool refreshPast(bool changed);
    void evaluate();
    /// The scan that is shown when it is not the present one.
    std::optional<history::Position> shownPosition() const;
    const session::Run* m_run;
    session::Status m_status;
    std::shared_ptr<const image::CompiledProgram> m_program;
    std::vector<Binding> m_bindings;
    QHash<QString, int> m_ids;
    std::vector<std::byte> m_image;
    std::optional<history::Position> m_position;
    std::optional<history::ScanStamp> m_pastStamp;
    uint64_t m_scan = ~uint64_t(0);
    quint64 m_revision = 1;
};

} // namespace plc::hmi
