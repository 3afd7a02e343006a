// KeptBytes: what was dear to make, kept by what it was made of. It may be lost at any time, and is then made again.
#pragma once

#include "io/base/content_hash.h"

#include <optional>
#include <string>

namespace io {

class KeptBytes {
public:
    virtual ~KeptBytes() = default;
    virtual std::optional<std::string> find(const ContentKey& key) = 0;
    virtual void keep(const ContentKey& key, const std::string& bytes) = 0;
};

} // namespace io
