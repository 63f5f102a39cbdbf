// The values of a running (or recorded) controller for panels: expressions over the newest snapshot, or over the
// recorded image that the time slider has chosen, or over a recording from a file. Owned by the player; main thread.
// The session must outlive it.
#pragma once
#include "hmi/player/plc_convert.h"
#include "hmi/view/value_source.h"
#include "projects/session/session.h"

#include <QStringList>

namespace plc::hmi {

/// A recording from a file, in the place of a controller.
struct PanelRecording {
    const history::History* history = nullptr;
    std::shared_ptr<const image::CompiledProgram> program; // of the newest scan
    std::function<Result<expression::Expression>(const std::string& text, const image::CompiledProgram& program)>
        compile;
    std::shared_ptr<const void> owner; // keeps the history alive

    history::Recompile recompile(const std::string& text) const;
};

class PlcValues final : public ValueSource {
public:
    explicit PlcValues(session::Session& session) : PlcValues(&session) {}
    explicit PlcValues(session::Session* session); // null: only recordings can be shown

    /// Takes the newest snapshot if there is one; at most once per frame. True if values may have changed.
    bool refresh();
    /// A past scan of the recording, or none for the present.
    void setPosition(std::optional<history::Position> position);
    std::optional<history::Position> position() const { return m_position; }
    /// A recording from a file instead of the controller, at its newest scan until a position is set; none goes back.
    void setRecording(std::optional<PanelRecording> recording);
    bool isPast() const { return m_recording || m_position; }
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
    void evaluate();
    const history::History* history() const {
        return m_recording ? m_recording->history : m_session ? &m_session->history() : nullptr;
    }
    /// The scan that is shown when it is not the present one.
    std::optional<history::Position> shownPosition() const;
    history::Recompile recompile(const QString& text) const;
    session::Session* m_session;
    std::optional<PanelRecording> m_recording;
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
