// The newest value of something, from one writer to any number of readers, neither ever waiting for the other. Owned by
// the writer's side.
#pragma once
#include <array>
#include <atomic>
#include <cstdint>

namespace plc {

template <class T> class Published {
public:
    /// Writer: a value to fill in, or null when readers hold every spare one (then this publication is left out).
    [[nodiscard]] T* begin() {
        const uint32_t newest = m_newest.load(std::memory_order_relaxed);
        for (uint32_t i = 0; i < kSlots; ++i) {
            if (i == newest || m_slots[i].readers.load(std::memory_order_seq_cst) != 0) continue;
            m_open = i;
            return &m_slots[i].value;
        }
        return nullptr;
    }
    /// Writer: what begin() gave is the newest now.
    void publish() { m_newest.store(m_open, std::memory_order_seq_cst); }

    /// Any thread: calls read(value) with the newest value, which stays as it is meanwhile; false when nothing was
    /// published yet.
    template <class Read> bool read(Read&& readValue) const {
        for (;;) {
            const uint32_t newest = m_newest.load(std::memory_order_seq_cst);
            if (newest == kNone) return false;
            const Slot& slot = m_slots[newest];
            slot.readers.fetch_add(1, std::memory_order_seq_cst);
            if (m_newest.load(std::memory_order_seq_cst) == newest) {
                readValue(static_cast<const T&>(slot.value));
                slot.readers.fetch_sub(1, std::memory_order_seq_cst);
                return true;
            }
            slot.readers.fetch_sub(1, std::memory_order_seq_cst);
        }
    }

private:
    static constexpr uint32_t kSlots = 6, kNone = ~0u;
    struct Slot {
        T value{};
        mutable std::atomic<uint32_t> readers{0};
    };
    std::array<Slot, kSlots> m_slots;
    std::atomic<uint32_t> m_newest{kNone};
    uint32_t m_open = 0;
};

} // namespace plc
