// What a browser keeps of a panel, read from the frames as hmi/web/client reads them, without painting. A frame that
// makes no sense is a `problem`. A value of a test; any thread.
#pragma once
#include <QByteArray>
#include <QList>
#include <QString>

#include <map>

namespace plc::serve {

class DrawnPanel {
public:
    struct Element {
        bool isShown = false;
        QByteArray bounds;          // as it came
        QList<QByteArray> commands; // one after the other
        bool operator==(const Element&) const = default;
    };
    /// False once anything did not make sense.
    bool take(const QByteArray& frame);
    uint32_t number() const { return m_number; }
    const std::map<uint64_t, Element>& elements() const { return m_elements; }
    const QString& problem() const { return m_problem; }

private:
    class Reader;
    void takeElement(Reader& from);
    void checkCommand(const QByteArray& command);
    uint32_t m_number = 0;
    std::map<uint64_t, Element> m_elements;
    std::map<uint64_t, QByteArray> m_glyphs, m_pictures;
    QString m_problem;
};

} // namespace plc::serve
