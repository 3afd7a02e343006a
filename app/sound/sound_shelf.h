// The sounds of a project that were asked for: short ones are kept, each file is complained about once.
#pragma once

#include "app/sound/voice.h"
#include "io/base/complaint.h"

#include <map>
#include <string>

namespace app {

enum class SoundCut { Whole, Parts }; // parts: a file of steps holds several, with silence between

class SoundShelf {
public:
    explicit SoundShelf(std::filesystem::path project) : m_project{std::move(project)} {}

    struct Sound {
        std::vector<std::shared_ptr<const ClipBuffer>> clips; // more than one only for parts
        bool streamed = false;                                // too long to be kept: openStream()
        double seconds = 0;
        double used = 0; // when it was asked for last
    };
    // Null where it cannot be read.
    const Sound* find(const std::string& file, int channels, SoundCut cut, double now);
    bool has(const std::string& file, int channels, SoundCut cut) const { return m_sounds.contains({file, channels, cut}); }
    std::optional<SoundFile> openStream(const std::string& file);
    bool exists(const std::string& file) const; // without a complaint

    io::Complaints takeComplaints() { return std::exchange(m_complaints, {}); }
    void forget() { m_sounds.clear(); } // read anew what files hold now

private:
    using Key = std::tuple<std::string, int, SoundCut>;
    io::Result<Sound> read(const std::string& file, int channels, SoundCut cut) const;
    io::Result<SoundFile> open(const std::string& file) const;
    void makeRoom(const Key& except);

    std::filesystem::path m_project;
    std::map<Key, std::optional<Sound>> m_sounds; // none: it cannot be read
    io::Complaints m_complaints;
};

} // namespace app
