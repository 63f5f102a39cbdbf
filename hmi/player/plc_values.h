// The values of a running (or recorded) controller for panels: expressions over the newest snapshot, or over the recorded
// image that the time slider has chosen. Owned by the player; main thread. The session must outlive it.
#pragma once
#include "hmi/player/plc_convert.h"
#include "hmi/view/value_source.h"
#include "projects/session/session.h"

#include <QStringList>

namespace plc::hmi {

class PlcValues final : public ValueSource {
public:
    explicit PlcValues(session::Session& session);

    /// Takes the newest snapshot if there is one; at most once per frame. True if values may have changed.
    bool refresh();
    /// A past scan of the recording, or none for the present.
    void setPosition(std::optional<history::Position> position);
    std::optional<history::Position> position() const { return m_position; }
    const session::Status& status() const { return m_status; }
    session::Session& session() { return m_session; }

    BindingId bind(const QString& expression) override;
    const Value& value(BindingId binding) const override;
    ValueFacts facts(BindingId binding) const override;
    std::vector<CurvePiece> curve(BindingId binding, double seconds, int buckets) const override;
    Freshness freshness() const override;
    qint64 clock() const override;
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
    session::Session& m_session;
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
