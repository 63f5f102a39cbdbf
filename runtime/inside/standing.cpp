#include "runtime/inside/standing.h"
#include "runtime/inside/rerun.h"

#include <algorithm>
#include <cstring>

namespace plc::inside {

using image::WatchKind;

namespace {

constexpr int kRounds = 4; // what acted may let the program write elsewhere

std::optional<history::ScanInput> beginningOf(const history::History& history, const Standing& standing) {
    const history::Statistics all = history.statistics();
    history::ScanInput input;
    input.program = standing.program;
    input.start.plcRuns = true;
    if (all.end > all.first) {
        std::shared_ptr<const image::CompiledProgram> before;
        auto last = history.inputOf(all.end - 1);
        std::vector<std::byte> image = history.seek(all.end - 1, &before);
        if (!last || before != standing.program) return std::nullopt; // the first scan after an online change
        input = std::move(*last);
        input.image = std::move(image);
        input.start.timeBefore = input.stamp.time.count();
        input.startIsPartial = true;
        input.notes.clear();
    } else {
        input.image = standing.program->initialImage;
        input.startIsPartial = false;
    }
    input.image.resize(std::max<size_t>(standing.program->layout.imageSize, input.image.size()));
    image::ImageHeader head; // as the scan that stands began
    std::memcpy(&head, standing.image.data(), sizeof head);
    input.stamp = {all.end, head.scan, history::Nanoseconds(head.timeNs)};
    input.calendarStartNs = head.calendarNs - head.timeNs;
    return input;
}

/// Follows a scan's writes and finds where it stands.
class Finder {
public:
    Finder(const Look& look, const Standing& standing, std::vector<std::byte> image)
        : m_look(look), m_standing(standing), m_image(std::move(image)), m_isWritten(m_image.size()) {}

    struct Place {
        EventIndex event = kNone;
        std::vector<uint32_t> differences; // offsets that were not written until there
        size_t wrong = 0;                  // offsets that were
        [[nodiscard]] bool isExact() const { return event != kNone && differences.empty() && wrong == 0; }
    };

    Place find() {
        Place best;
        for (EventIndex i = 0; i < m_look.events().size(); ++i) {
            const Event& event = m_look.events()[i];
            if (event.kind == WatchKind::Write) write(event);
            if (event.kind == WatchKind::Pass) countLoop(event);
            if (!isHere(event)) continue;
            Place place = compare(i);
            if (place.isExact()) return place;
            const auto badness = [](const Place& p) { return p.wrong * 1000 + p.differences.size(); };
            if (best.event == kNone || badness(place) < badness(best)) best = std::move(place);
        }
        return best;
    }

private:
    [[nodiscard]] bool isHere(const Event& event) const {
        if (event.kind != WatchKind::Statement || !(event.stmt()->range == m_standing.at.range)) return false;
        const Activation& activation = m_look.activations()[event.activation];
        return activation.function == m_standing.at.functionIndex &&
               activation.instance == m_standing.at.instanceOffset;
    }

    void write(const Event& event) {
        if (size_t(event.offset) + event.size > m_image.size()) return;
        std::fill_n(m_isWritten.begin() + event.offset, event.size, true);
        // Of what is longer only the beginning is reported: what it became is taken from where it stands.
        const size_t known = std::min<size_t>(event.size, sizeof event.bits);
        const size_t there = std::min(m_standing.image.size(), size_t(event.offset) + event.size);
        for (size_t at = event.offset + known; at < there; ++at) m_image[at] = m_standing.image[at];
        std::memcpy(m_image.data() + event.offset, &event.bits, known);
    }

    /// The variable of a FOR is written without a report: what it is, the image says.
    void countLoop(const Event& event) {
        const tree::Place* place = event.stmt()->kind == tree::StmtKind::For ? event.stmt()->place : nullptr;
        if (!place || place->bit >= 0) return;
        const bool isOwn = place->kind == tree::PlaceKind::Instance;
        if (!isOwn && place->kind != tree::PlaceKind::Absolute) return;
        const size_t begin = place->offset + (isOwn ? m_look.activations()[event.activation].instance : 0);
        const types::TypeTable& types = *m_look.tree().types;
        const size_t end = begin + types[types.storage(place->type)].size;
        if (end > m_image.size() || end > m_standing.image.size()) return;
        std::copy_n(m_standing.image.begin() + static_cast<std::ptrdiff_t>(begin), end - begin,
                    m_image.begin() + static_cast<std::ptrdiff_t>(begin));
    }

    [[nodiscard]] Place compare(EventIndex event) const {
        Place place;
        place.event = event;
        const size_t end =
            std::min<size_t>({m_image.size(), m_standing.image.size(), m_standing.program->layout.dataEnd});
        if (std::memcmp(m_image.data() + kClockEnd, m_standing.image.data() + kClockEnd, end - kClockEnd) == 0)
            return place;
        for (uint32_t at = kClockEnd; at < end; ++at) {
            if (m_image[at] == m_standing.image[at]) continue;
            if (m_isWritten[at])
                ++place.wrong;
            else
                place.differences.push_back(at);
        }
        return place;
    }

    const Look& m_look;
    const Standing& m_standing;
    std::vector<std::byte> m_image;
    std::vector<bool> m_isWritten;
};

} // namespace

std::optional<StandingLook> lookAtStanding(Insight& insight, const Standing& standing) {
    if (standing.image.size() < sizeof(image::ImageHeader)) return std::nullopt;
    std::optional<history::ScanInput> input = beginningOf(insight.history(), standing);
    if (!input) return std::nullopt;
    for (int round = 0; round < kRounds; ++round) {
        const auto look = insight.lookFrom(*input);
        if (!look || (*look)->leftOut() > 0) return std::nullopt;
        const auto place = Finder(**look, standing, input->image).find();
        if (place.isExact()) return StandingLook{*look, place.event};
        if (place.differences.empty() && place.event != kNone) return std::nullopt;
        // Nothing in the scan wrote these: what acted from outside did.
        const size_t end =
            std::min<size_t>({input->image.size(), standing.image.size(), standing.program->layout.dataEnd});
        bool isChanged = false;
        if (place.event == kNone) { // it does not come there at all without what acted
            isChanged =
                std::memcmp(input->image.data() + kClockEnd, standing.image.data() + kClockEnd, end - kClockEnd);
            std::copy(standing.image.begin() + kClockEnd, standing.image.begin() + static_cast<std::ptrdiff_t>(end),
                      input->image.begin() + kClockEnd);
        }
        for (const uint32_t at : place.differences) {
            input->image[at] = standing.image[at];
            isChanged = true;
        }
        if (!isChanged) return std::nullopt;
    }
    return std::nullopt;
}

} // namespace plc::inside
