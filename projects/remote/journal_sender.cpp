#include "projects/remote/journal_sender.h"

#include "runtime/controller/scan_start.h"

namespace plc::remote {

using history::JournalEntry;

void JournalSender::gather(history::PositionRange range) {
    m_entries.clear();
    m_history.forEachJournal(range.begin, range.end, [this](history::Position position, const JournalEntry& entry) {
        m_entries.emplace(position, entry);
        return true;
    });
}

std::vector<std::byte> JournalSender::of(history::Position position) {
    const auto known = m_entries.find(position);
    const bool acted = known != m_entries.end();
    const bool isComplete = acted && known->second.start && !known->second.startIsPartial;
    if (m_isConnected && !acted) return {};
    if (isComplete && (m_isConnected || known->second.isFresh)) {
        m_isConnected = true;
        return history::toBytes(known->second);
    }
    // Not known any more: the next scan tries again, and this one has no journal there.
    const std::optional<JournalEntry> entry = whole(position);
    m_isConnected = entry.has_value();
    return entry ? history::toBytes(*entry) : std::vector<std::byte>();
}

/// Everything that the scan began from, as what differs from the program's initial image.
std::optional<JournalEntry> JournalSender::whole(history::Position position) const {
    const Result<history::ScanInput> input = m_history.inputOf(position);
    if (!input || !input->hasJournal) return {};
    const image::CompiledProgram& program = *input->program;
    constexpr uint32_t kBehindClock = offsetof(image::ImageHeader, taskPeriodNs);
    JournalEntry entry;
    entry.isFresh = true;
    entry.start =
        input->startIsPartial ? controller::completed(input->start, program, input->image.data()) : input->start;
    entry.notes = input->notes;
    entry.patch = history::difference(program.initialImage, input->image, kBehindClock, program.layout.dataEnd, {});
    return entry;
}

} // namespace plc::remote
