#include "runtime/controller/forces.h"

#include "runtime/controller/fitting.h"
#include "runtime/image/runtime_context.h"

#include <algorithm>
#include <cstring>

namespace plc::controller {

const Forced* Forces::overlapping(const types::TypeTable& types, const image::Place& place) const {
    for (const Forced& forced : m_list) {
        const uint32_t size = place.bit >= 0 ? 1 : types[place.type].size;
        const uint32_t forcedSize = forced.place.bit >= 0 ? 1 : types[forced.place.type].size;
        if (place.offset + size <= forced.place.offset || forced.place.offset + forcedSize <= place.offset) continue;
        if (place.bit >= 0 && forced.place.bit >= 0 && place.bit != forced.place.bit) continue;
        return &forced;
    }
    return nullptr;
}

void Forces::addPatch(const types::TypeTable& types, const Forced& forced) {
    Patch patch{forced.place.offset, forced.place.bit >= 0 ? 1 : types[forced.place.type].size,
                static_cast<uint32_t>(m_bytes.size()), forced.place.bit};
    m_bytes.resize(m_bytes.size() + patch.size);
    types::writeValue(types, forced.place.type, forced.value, std::span(m_bytes).subspan(patch.begin, patch.size),
                      patch.bit);
    m_patches.push_back(patch);
}

void Forces::set(const types::TypeTable& types, Forced forced) {
    const auto old =
        std::find_if(m_list.begin(), m_list.end(), [&](const Forced& f) { return f.place == forced.place; });
    if (old != m_list.end())
        *old = std::move(forced);
    else
        m_list.push_back(std::move(forced));
    m_patches.clear();
    m_bytes.clear();
    for (const Forced& f : m_list) addPatch(types, f);
}

bool Forces::remove(const image::Place& place) {
    const auto old = std::find_if(m_list.begin(), m_list.end(), [&](const Forced& f) { return f.place == place; });
    if (old == m_list.end()) return false;
    m_patches.erase(m_patches.begin() + (old - m_list.begin()));
    m_list.erase(old);
    return true;
}

void Forces::clear() {
    m_list.clear();
    m_patches.clear();
    m_bytes.clear();
}

std::vector<image::ForcedBytes> Forces::patches() const {
    std::vector<image::ForcedBytes> all;
    for (const Patch& patch : m_patches) {
        const std::byte* first = m_bytes.data() + patch.begin;
        all.push_back({patch.offset,
                       patch.size,
                       static_cast<int16_t>(patch.bit),
                       {},
                       std::vector<std::byte>(first, first + patch.size)});
    }
    return all;
}

std::vector<image::ForcedBytes> Forces::bytes() const {
    std::vector<image::ForcedBytes> all = patches();
    for (size_t i = 0; i < all.size() && i < m_list.size(); ++i) all[i].path = m_list[i].path;
    return all;
}

void Forces::setBytes(const std::vector<image::ForcedBytes>& forces) {
    clear();
    for (const image::ForcedBytes& forced : forces) {
        m_patches.push_back({forced.offset, forced.size, static_cast<uint32_t>(m_bytes.size()), forced.bit});
        m_bytes.insert(m_bytes.end(), forced.bytes.begin(), forced.bytes.end());
    }
}

void markWritten(std::span<uint8_t> dirtyPages, uint32_t offset, uint32_t size) {
    const uint32_t last = (offset + std::max(1u, size) - 1) / image::kDirtyPage;
    for (uint32_t page = offset / image::kDirtyPage; page <= last && page < dirtyPages.size(); ++page)
        dirtyPages[page] = 1;
}

void Forces::apply(std::byte* image, std::span<uint8_t> dirtyPages) const {
    for (const Patch& patch : m_patches) {
        markWritten(dirtyPages, patch.offset, patch.size);
        if (patch.bit < 0) {
            std::memcpy(image + patch.offset, m_bytes.data() + patch.begin, patch.size);
            continue;
        }
        const auto mask = static_cast<std::byte>(1u << patch.bit);
        image[patch.offset] = (image[patch.offset] & ~mask) | (m_bytes[patch.begin] & mask);
    }
}

std::vector<std::string> Forces::rebind(const image::Layout& layout) {
    std::vector<Forced> before = std::move(m_list);
    clear();
    std::vector<std::string> gone;
    for (Forced& forced : before) {
        const Result<image::Place> place = layout.find(forced.path);
        if (place) {
            if (Result<types::Value> value = fitted(*layout.types, forced.value, place->type)) {
                set(*layout.types, Forced{forced.path, *place, std::move(*value)});
                continue;
            }
        }
        gone.push_back(std::move(forced.path));
    }
    return gone;
}

} // namespace plc::controller
