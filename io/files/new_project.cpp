// A new project is a copy of one that ships with Wold.
#include "io/base/paths.h"
#include "io/files/documents.h"
#include "io/files/project.h"

namespace io {
namespace fs = std::filesystem;
namespace {

std::string starters()
{
    std::string names;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator{resource("projects"), error})
        if (fs::exists(entry.path() / "project.json", error))
            names += (names.empty() ? "" : ", ") + entry.path().filename().string();
    return names;
}

Status copyTree(const fs::path& from, const fs::path& to)
{
    std::error_code error;
    fs::create_directories(to, error);
    for (fs::recursive_directory_iterator entry{from, error}, end; !error && entry != end; entry.increment(error)) {
        const fs::path target = to / entry->path().lexically_relative(from);
        if (entry->is_directory(error))
            fs::create_directories(target, error);
        else if (entry->is_regular_file(error))
            fs::copy_file(entry->path(), target, error);
        if (error) return Error{target.string(), "cannot be copied: " + error.message()};
    }
    return error ? Status{Error{to.string(), "cannot be made: " + error.message()}} : Status{};
}

Status rename(const fs::path& folder, const std::string& name)
{
    const fs::path file = folder / "project.json";
    Result<std::string> text = readFile(file);
    if (!text) return text.error();
    Complaints ignored;
    Result<ProjectBody> body = readProjectText(std::move(*text), file.string(), ignored);
    if (!body) return body.error();
    body->name = name;
    return writeFile(file, projectText(*body));
}

} // namespace

Status newProject(const fs::path& folder, std::string_view starter)
{
    std::error_code error;
    const fs::path target = fs::weakly_canonical(fs::absolute(folder), error).lexically_normal();
    if (fs::exists(target, error) && !(fs::is_directory(target, error) && fs::is_empty(target, error)))
        return Error{folder.string(), "is there already and not empty; name another folder"};
    const fs::path source = resource("projects/" + std::string{starter});
    if (starter.empty() || starter.find('/') != std::string_view::npos || !fs::exists(source / "project.json", error))
        return Error{std::string{starter}, "there is no such starter; there is " + starters()};

    // Made beside its place and moved there whole, so that a full disk leaves no half of a project.
    fs::path draft = target;
    draft += ".wold-tmp";
    fs::remove_all(draft, error);
    fs::create_directories(target.parent_path(), error);
    Status made = copyTree(source, draft);
    if (made) made = rename(draft, target.filename().string());
    if (made) {
        fs::rename(draft, target, error);
        if (error) made = Error{target.string(), "cannot be made: " + error.message()};
    }
    std::error_code ignored;
    if (!made) fs::remove_all(draft, ignored);
    return made;
}

} // namespace io
