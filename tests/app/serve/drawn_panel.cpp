#include "drawn_panel.h"

namespace plc::serve {

/// At its end, everything is nothing.
class DrawnPanel::Reader {
public:
    explicit Reader(const QByteArray& bytes) : m_bytes(bytes) {}
    bool isAtEnd() const { return m_at >= m_bytes.size(); }
    bool isTorn() const { return m_isTorn; }
    uint8_t byte() {
        if (isAtEnd()) m_isTorn = true;
        return m_isTorn ? uint8_t(0) : static_cast<uint8_t>(m_bytes[m_at++]);
    }
    uint64_t count() {
        uint64_t out = 0;
        for (int shift = 0; shift < 64; shift += 7) {
            const uint8_t part = byte();
            out |= static_cast<uint64_t>(part & 127) << shift;
            if (part < 128) return out;
        }
        m_isTorn = true;
        return 0;
    }
    void lengths(int many) {
        for (; many > 0; --many) (void)count();
    }
    QByteArray blob() {
        const uint64_t size = count();
        if (m_isTorn || size > static_cast<uint64_t>(m_bytes.size() - m_at)) {
            m_isTorn = true;
            return {};
        }
        const QByteArray out = m_bytes.mid(m_at, static_cast<qsizetype>(size));
        m_at += out.size();
        return out;
    }
    /// The bytes of what `read` reads.
    template <class Read> QByteArray bytesOf(const Read& read) {
        const qsizetype begin = m_at;
        read();
        return m_bytes.mid(begin, m_at - begin);
    }
    void path() {
        (void)byte();
        for (;;) {
            switch (byte()) {
            case 0:
                return;
            case 1:
            case 2:
                lengths(2);
                break;
            case 3:
                lengths(6);
                break;
            case 4:
                break;
            default:
                m_isTorn = true;
                return;
            }
        }
    }

private:
    QByteArray m_bytes;
    qsizetype m_at = 0;
    bool m_isTorn = false;
};

bool DrawnPanel::take(const QByteArray& frame) {
    Reader from(frame);
    m_number = static_cast<uint32_t>(from.count());
    while (!from.isAtEnd() && m_problem.isEmpty()) {
        switch (const uint8_t section = from.byte()) {
        case 1: {
            const uint64_t id = from.count();
            m_glyphs[id] = from.bytesOf([&] { from.path(); });
            break;
        }
        case 2: {
            const uint64_t id = from.count();
            m_pictures[id] = from.blob();
            break;
        }
        case 3:
            takeElement(from);
            break;
        case 4:
            m_elements.clear();
            break;
        default:
            m_problem = QStringLiteral("section %1").arg(section);
        }
    }
    if (from.isTorn()) m_problem = QStringLiteral("frame %1 is torn").arg(m_number);
    return m_problem.isEmpty();
}

void DrawnPanel::takeElement(Reader& from) {
    const uint64_t index = from.count();
    Element& element = m_elements[index];
    const uint8_t flags = from.byte();
    element.isShown = (flags & 1) != 0;
    if (flags & 2) element.bounds = from.bytesOf([&] { from.lengths(4); });
    uint64_t at = 0;
    for (uint64_t left = from.count(); left > 0 && !from.isTorn(); --left) {
        at += from.count();
        const uint64_t removed = from.count(), added = from.count();
        if (at + removed > static_cast<uint64_t>(element.commands.size())) {
            m_problem = QStringLiteral("element %1 has no such commands").arg(index);
            return;
        }
        element.commands.remove(static_cast<qsizetype>(at), static_cast<qsizetype>(removed));
        for (uint64_t i = 0; i < added && !from.isTorn(); ++i, ++at) {
            const QByteArray command = from.blob();
            checkCommand(command);
            element.commands.insert(static_cast<qsizetype>(at), command);
        }
    }
}

/// It names only letters and pictures that came before it.
void DrawnPanel::checkCommand(const QByteArray& command) {
    constexpr uint8_t kPicture = 14, kGlyphs = 15;
    Reader from(command);
    const uint8_t kind = from.byte();
    if (kind < 1 || kind > kGlyphs) m_problem = QStringLiteral("command %1").arg(kind);
    if (kind == kPicture && !m_pictures.count(from.count())) m_problem = QStringLiteral("a picture that did not come");
    if (kind != kGlyphs) return;
    for (uint64_t left = from.count(); left > 0 && !from.isTorn(); --left) {
        if (!m_glyphs.count(from.count())) m_problem = QStringLiteral("a letter that did not come");
        from.lengths(2);
    }
    if (from.isTorn() || !from.isAtEnd()) m_problem = QStringLiteral("a text that is torn");
}

} // namespace plc::serve
