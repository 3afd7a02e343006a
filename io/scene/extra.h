// Keys that a newer version wrote and this one does not know: kept as text and written back unchanged.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace io {

// Dotted path of the key ("sun.corona") and its value as compact JSON text.
using ExtraKeys = std::vector<std::pair<std::string, std::string>>;

// Costs one pointer where there are none, which is nearly always. Compared by content, copied by reference.
class Extra {
public:
    const ExtraKeys& keys() const
    {
        static const ExtraKeys none;
        return m_keys ? *m_keys : none;
    }
    void add(std::string path, std::string json)
    {
        auto copy = std::make_shared<ExtraKeys>(keys());
        copy->emplace_back(std::move(path), std::move(json));
        m_keys = std::move(copy);
    }
    bool operator==(const Extra& other) const { return m_keys == other.m_keys || keys() == other.keys(); }

private:
    std::shared_ptr<const ExtraKeys> m_keys;
};

} // namespace io
