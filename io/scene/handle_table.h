// HandleTable: where each key lies. Open addressing with 12 bytes an entry, so that a million keys of any values cost
// some 20 MB.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace io {

class HandleTable {
public:
    static constexpr std::uint32_t kNowhere = ~0u;

    struct Place {
        std::uint32_t node = kNowhere;
        std::uint32_t item = 0;
    };

    std::size_t size() const { return m_size; }
    std::size_t bytes() const { return m_entries.capacity() * sizeof(Entry); }

    Place find(std::uint32_t key) const { return m_entries.empty() ? Place{} : m_entries[slotOf(key)].place; }

    void set(std::uint32_t key, Place place)
    {
        if ((m_size + 1) * 5 > m_entries.size() * 4) resize(m_entries.size() * 3 / 2 + 16);
        Entry& entry = m_entries[slotOf(key)];
        m_size += entry.place.node == kNowhere;
        entry = {key, place};
    }

    // What came after it in its run moves up, so that no tombstones gather.
    void erase(std::uint32_t key)
    {
        if (m_entries.empty()) return;
        std::size_t hole = slotOf(key);
        if (m_entries[hole].place.node == kNowhere) return;
        --m_size;
        const std::size_t count = m_entries.size();
        for (std::size_t i = after(hole); m_entries[i].place.node != kNowhere; i = after(i)) {
            const std::size_t travelled = (i + count - home(m_entries[i].key)) % count;
            if (travelled < (i + count - hole) % count) continue;
            m_entries[hole] = m_entries[i];
            hole = i;
        }
        m_entries[hole] = {};
    }

    void reserve(std::size_t keys)
    {
        if (keys * 5 / 4 + 16 > m_entries.size()) resize(keys * 5 / 4 + 16);
    }
    void clear()
    {
        m_entries = {};
        m_size = 0;
    }

private:
    struct Entry {
        std::uint32_t key = 0;
        Place place;
    };

    // Multiplied by 2^32 / golden ratio (Knuth), neighbouring keys lie far apart.
    std::size_t home(std::uint32_t key) const
    {
        return std::size_t((std::uint64_t(key * 2654435769u) * m_entries.size()) >> 32);
    }
    std::size_t after(std::size_t slot) const { return slot + 1 == m_entries.size() ? 0 : slot + 1; }

    // The key's slot, or the free one where it would go.
    std::size_t slotOf(std::uint32_t key) const
    {
        std::size_t slot = home(key);
        while (m_entries[slot].place.node != kNowhere && m_entries[slot].key != key)
            slot = after(slot);
        return slot;
    }

    void resize(std::size_t count)
    {
        std::vector<Entry> old(count);
        old.swap(m_entries);
        for (const Entry& entry : old)
            if (entry.place.node != kNowhere) m_entries[slotOf(entry.key)] = entry;
    }

    std::vector<Entry> m_entries;
    std::size_t m_size = 0;
};

} // namespace io
