// One writer takes things out of a shared structure while readers may still look at them: readers pin an epoch, the
// writer frees what it took out two epochs ago. Owned by the structure. Pinning is lock-free and any thread may do it;
// the other functions belong to the writer.
#pragma once
#include <atomic>
#include <cstdint>
#include <utility>

namespace plc {

class Epochs {
public:
    class Pin {
    public:
        explicit Pin(const Epochs& epochs) : m_epochs(&epochs) {
            for (;;) {
                const uint64_t epoch = epochs.m_epoch.load(std::memory_order_seq_cst);
                m_slot = static_cast<unsigned>(epoch & 1);
                epochs.m_readers[m_slot].fetch_add(1, std::memory_order_seq_cst);
                if (epochs.m_epoch.load(std::memory_order_seq_cst) == epoch) return;
                epochs.m_readers[m_slot].fetch_sub(1, std::memory_order_release);
            }
        }
        Pin(Pin&& other) noexcept : m_epochs(std::exchange(other.m_epochs, nullptr)), m_slot(other.m_slot) {}
        Pin& operator=(Pin&&) = delete;
        ~Pin() {
            if (m_epochs) m_epochs->m_readers[m_slot].fetch_sub(1, std::memory_order_release);
        }

    private:
        const Epochs* m_epochs;
        unsigned m_slot = 0;
    };

    [[nodiscard]] Pin pin() const { return Pin(*this); }
    [[nodiscard]] uint64_t current() const { return m_epoch.load(std::memory_order_relaxed); }
    /// Enters the next epoch when no reader is left in the one before this; what was taken out in epoch e is free once
    /// current() ≥ e + 2.
    void tryAdvance() {
        const uint64_t epoch = m_epoch.load(std::memory_order_relaxed);
        if (m_readers[(epoch + 1) & 1].load(std::memory_order_seq_cst) == 0)
            m_epoch.store(epoch + 1, std::memory_order_seq_cst);
    }

private:
    std::atomic<uint64_t> m_epoch{0};
    mutable std::atomic<uint32_t> m_readers[2] = {};
};

} // namespace plc
