// Commands from any thread to one: producers push without locks, the owner pops in the order in which pushes took
// effect. Owned by the consumer, which outlives the producers.
#pragma once
#include <atomic>
#include <cstdint>
#include <optional>
#include <utility>

namespace plc {

template <class T> class MpscQueue {
public:
    MpscQueue() : m_tail(new Node), m_head(m_tail) {}
    MpscQueue(const MpscQueue&) = delete;
    MpscQueue& operator=(const MpscQueue&) = delete;
    ~MpscQueue() {
        while (pop()) {
        }
        delete m_tail;
    }
    /// Any thread.
    void push(T value) {
        Node* node = new Node;
        node->value.emplace(std::move(value));
        m_pushed.fetch_add(1, std::memory_order_relaxed); // before it can be popped
        Node* before = m_head.exchange(node, std::memory_order_acq_rel);
        before->next.store(node, std::memory_order_release);
    }
    /// Consumer: the oldest, or none (also while a push is just taking place).
    std::optional<T> pop() {
        Node* next = m_tail->next.load(std::memory_order_acquire);
        if (!next) return std::nullopt;
        std::optional<T> value(std::in_place, std::move(*next->value)); // a node behind the tail has one
        next->value.reset();
        delete m_tail;
        m_tail = next;
        ++m_popped;
        return value;
    }
    /// How many have been pushed so far: a consumer that pops up to here ends, however fast the producers are.
    [[nodiscard]] uint64_t pushed() const { return m_pushed.load(std::memory_order_relaxed); }
    /// Consumer: the oldest of the first `end` that were pushed, or none when all of them have been popped.
    std::optional<T> popBefore(uint64_t end) { return m_popped < end ? pop() : std::nullopt; }
    [[nodiscard]] bool isEmpty() const { return m_tail->next.load(std::memory_order_acquire) == nullptr; } // consumer

private:
    struct Node {
        std::atomic<Node*> next{nullptr};
        std::optional<T> value;
    };
    Node* m_tail;          // consumer
    uint64_t m_popped = 0; // consumer
    std::atomic<Node*> m_head;
    std::atomic<uint64_t> m_pushed{0};
};

} // namespace plc
