// A list of plain values that grows at its end, to a hundred megabytes and more. Where it outgrows its place, the
// system moves its pages (std::realloc): nothing is copied, and no new memory is touched for what is there already,
// which a std::vector would do for half a second at a time. One thread.
#pragma once
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace plc::inside {

template <typename T> class PlainList {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t));

public:
    PlainList() = default;
    PlainList(const PlainList&) = delete;
    PlainList& operator=(const PlainList&) = delete;

    void push_back(const T& value) {
        if (m_size == m_room) grow();
        new (m_values.get() + m_size) T(value);
        ++m_size;
    }
    void clear() { m_size = 0; }

    [[nodiscard]] size_t size() const { return m_size; }
    [[nodiscard]] bool empty() const { return m_size == 0; }
    [[nodiscard]] T& operator[](size_t at) { return m_values.get()[at]; }
    [[nodiscard]] const T& operator[](size_t at) const { return m_values.get()[at]; }
    [[nodiscard]] T& back() { return m_values.get()[m_size - 1]; }
    [[nodiscard]] T* begin() { return m_values.get(); }
    [[nodiscard]] T* end() { return m_values.get() + m_size; }
    [[nodiscard]] const T* begin() const { return m_values.get(); }
    [[nodiscard]] const T* end() const { return m_values.get() + m_size; }

private:
    struct Free {
        void operator()(T* values) const { std::free(values); }
    };
    void grow() {
        const size_t room = m_room == 0 ? 64 : m_room * 2;
        auto* larger = static_cast<T*>(std::realloc(static_cast<void*>(m_values.get()), room * sizeof(T)));
        if (!larger) throw std::bad_alloc();
        (void)m_values.release(); // moved or where it was
        m_values.reset(larger);
        m_room = room;
    }

    std::unique_ptr<T[], Free> m_values;
    size_t m_size = 0, m_room = 0;
};

} // namespace plc::inside
