// Where a view reads its values: the player answers from the PLC, the designer and tests from what they hold. The view
// knows no PLC. Owned by whoever owns the scene; main thread.
#pragma once
#include "hmi/model/value.h"
#include "runtime/base/signal.h"

#include <QHash>
#include <QMap>
#include <QObject>

namespace plc::hmi {

/// An expression that a view has asked for; equal expressions share an id.
struct BindingId {
    int index = -1;
    bool isValid() const { return index >= 0; }
    bool operator==(const BindingId&) const = default;
};

/// How much the values can be trusted, shown over the panel when they are not live.
enum class Freshness { Live, Past, Stopped, Paused, Fault, Disconnected };

/// A bucket with its own two times, since those of a trend are as long as so many scans were, and scans differ.
struct CurvePiece : SignalBucket {
    int64_t from = 0, to = 0; // nanoseconds, counted from now: negative
    [[nodiscard]] bool hasValue() const { return count > 0; }
};

class ValueSource {
public:
    virtual ~ValueSource() = default;
    /// An empty expression gives an invalid id; a wrong one a binding whose value is none with the reason.
    virtual BindingId bind(const QString& expression) = 0;
    virtual const Value& value(BindingId binding) const = 0;
    virtual ValueFacts facts(BindingId binding) const = 0;
    /// The last `seconds` of the binding in at most `buckets` pieces, oldest first.
    virtual std::vector<CurvePiece> curve(BindingId binding, double seconds, int buckets) const = 0;
    virtual Freshness freshness() const = 0;
    /// Nanoseconds since 1970 of the scan that is shown.
    virtual qint64 clock() const = 0;
    /// A stamp that changes whenever values may have changed.
    virtual quint64 revision() const = 0;
};

/// Values that are set by hand, with an optional record of what they were: for the designer's sample, pictures and
/// tests.
class HeldValues final : public ValueSource {
public:
    void set(const QString& expression, Value value);
    void setFacts(const QString& expression, ValueFacts facts);
    void setCurve(const QString& expression, std::vector<CurvePiece> pieces);
    void setFreshness(Freshness freshness) { m_freshness = freshness, ++m_revision; }
    void setClock(qint64 nanoseconds) { m_clock = nanoseconds, ++m_revision; }
    QStringList boundExpressions() const { return m_ids.keys(); }

    BindingId bind(const QString& expression) override;
    const Value& value(BindingId binding) const override;
    ValueFacts facts(BindingId binding) const override;
    std::vector<CurvePiece> curve(BindingId binding, double seconds, int buckets) const override;
    Freshness freshness() const override { return m_freshness; }
    qint64 clock() const override { return m_clock; }
    quint64 revision() const override { return m_revision; }

private:
    struct Entry {
        Value value;
        ValueFacts facts;
        std::vector<CurvePiece> curve;
    };
    QMap<QString, int> m_ids;
    std::vector<Entry> m_entries;
    Freshness m_freshness = Freshness::Live;
    qint64 m_clock = 0;
    quint64 m_revision = 1;
};

} // namespace plc::hmi
