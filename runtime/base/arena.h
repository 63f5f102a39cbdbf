// Bump allocator for trees: nodes live as long as the arena, destructors do not run for trivially destructible nodes
// and run at the arena's end for the others. Owned by the tree it serves; one thread while building.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace plc {

class Arena {
public:
    Arena() = default;
    Arena(Arena&& other) noexcept { swap(other); }
    Arena& operator=(Arena&& other) noexcept {
        swap(other);
        return *this;
    }
    Arena(const Arena&) = delete;
    Arena& operator=(const Arena&) = delete;
    ~Arena() {
        for (auto it = m_cleanups.rbegin(); it != m_cleanups.rend(); ++it) it->destroy(it->object);
    }

    template <class T, class... Args> T* make(Args&&... args) {
        T* object = new (allocate(sizeof(T), alignof(T))) T{std::forward<Args>(args)...};
        if constexpr (!std::is_trivially_destructible_v<T>)
            m_cleanups.push_back({object, [](void* p) { static_cast<T*>(p)->~T(); }});
        return object;
    }

private:
    struct Cleanup {
        void* object;
        void (*destroy)(void*);
    };
    void swap(Arena& other) noexcept {
        std::swap(m_blocks, other.m_blocks);
        std::swap(m_cleanups, other.m_cleanups);
        std::swap(m_next, other.m_next);
        std::swap(m_end, other.m_end);
    }
    void* allocate(size_t size, size_t alignment) {
        auto at = (reinterpret_cast<uintptr_t>(m_next) + alignment - 1) & ~(alignment - 1);
        if (!m_next || at + size > reinterpret_cast<uintptr_t>(m_end)) {
            const size_t block =
                std::max(size + alignment, kFirstBlock << std::min<size_t>(m_blocks.size(), kDoublings));
            m_blocks.push_back(std::make_unique_for_overwrite<std::byte[]>(block)); // `make` sets what is used
            m_next = m_blocks.back().get();
            m_end = m_next + block;
            at = (reinterpret_cast<uintptr_t>(m_next) + alignment - 1) & ~(alignment - 1);
        }
        m_next = reinterpret_cast<std::byte*>(at + size);
        return reinterpret_cast<void*>(at);
    }
    /// Many files are small: the first block is one page, the sixth and those after it 128 KiB.
    static constexpr size_t kFirstBlock = 4096, kDoublings = 5;
    std::vector<std::unique_ptr<std::byte[]>> m_blocks;
    std::vector<Cleanup> m_cleanups;
    std::byte* m_next = nullptr;
    std::byte* m_end = nullptr;
};

} // namespace plc
