// A person's own looks: environments kept by name in a folder of theirs, for any of their worlds.
#pragma once

#include "io/base/complaint.h"
#include "io/base/result.h"
#include "io/scene/environment.h"

#include <filesystem>
#include <string>
#include <vector>

namespace io {

class KeptLooks {
public:
    explicit KeptLooks(std::filesystem::path folder) : m_folder{std::move(folder)} {}

    std::vector<std::string> names() const; // in the alphabet's order; empty where there is no folder
    Result<Environment> read(const std::string& name, Complaints& complaints) const;
    Status save(const std::string& name, const Environment& look); // in place of one of the same name
    Status remove(const std::string& name);

private:
    Result<std::filesystem::path> fileOf(const std::string& name) const; // an error for what is no name

    std::filesystem::path m_folder;
};

// What `name` stands for, Wold's own or a person's, in the place of `own`.
Result<Environment> lookNamed(const std::string& name, const Environment& own, const KeptLooks& kept, Complaints& complaints);

std::filesystem::path looksFolder(); // $XDG_CONFIG_HOME/wold/looks

} // namespace io
