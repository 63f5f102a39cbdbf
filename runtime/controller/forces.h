// The list of forced variables and their bytes, applied twice in each scan. Scan thread only.
#pragma once
#include "runtime/controller/forced.h"
#include "runtime/image/journal.h"

namespace plc::controller {

/// Marks what lies at [offset, offset + size) as written.
void markWritten(std::span<uint8_t> dirtyPages, uint32_t offset, uint32_t size);

class Forces {
public:
    [[nodiscard]] const std::vector<Forced>& list() const { return m_list; }
    [[nodiscard]] bool isEmpty() const { return m_list.empty(); }
    /// The forced variable that shares bytes with `place`, or null.
    [[nodiscard]] const Forced* overlapping(const types::TypeTable& types, const image::Place& place) const;
    void set(const types::TypeTable& types, Forced forced);
    bool remove(const image::Place& place);
    void clear();
    /// The bytes that are held, for the journal; and only those, for a scan made again from it.
    [[nodiscard]] std::vector<image::ForcedBytes> bytes() const;
    [[nodiscard]] std::vector<image::ForcedBytes> patches() const; // the same without paths
    void setBytes(const std::vector<image::ForcedBytes>& forces);
    void apply(std::byte* image, std::span<uint8_t> dirtyPages) const;
    /// Finds the variables again in another program; returns the paths that are gone there.
    std::vector<std::string> rebind(const image::Layout& layout);

private:
    struct Patch {
        uint32_t offset = 0, size = 0, begin = 0; // size bytes of m_bytes from begin
        int bit = -1;
    };
    void addPatch(const types::TypeTable& types, const Forced& forced);
    std::vector<Forced> m_list;
    std::vector<Patch> m_patches; // one for each of m_list
    std::vector<std::byte> m_bytes;
};

} // namespace plc::controller
