// Writes the parts of an input into files.
#include "fuzz/given_files.hpp"

#include "fuzz/judge.hpp"

#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

namespace fuzz
{

namespace
{

namespace fs = std::filesystem;

constexpr std::string_view border = "\n--next file--\n";

class Folder
{
public:
    Folder()
    {
        std::string name = (fs::temp_directory_path() / "cleft-fuzz-XXXXXX").string();
        expect(mkdtemp(name.data()) != nullptr, "no folder can be made");
        path_ = name + "/";
    }
    ~Folder()
    {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

void write_file(const std::string& path, std::string_view bytes)
{
    fs::create_directories(fs::path(path).parent_path());
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    expect(file.good(), "a file cannot be written");
}

}  // namespace

std::string give_files(const uint8_t* data, size_t size, const char* names)
{
    static const Folder folder;
    std::string_view rest(reinterpret_cast<const char*>(data), size);
    bool more = true;
    std::istringstream list(names);
    for (std::string name; list >> name;) {
        if (!more) {
            fs::remove(folder.path() + name);
            continue;
        }
        const size_t end = rest.find(border);
        write_file(folder.path() + name, rest.substr(0, end));
        more = end != std::string_view::npos;
        if (more)
            rest.remove_prefix(end + border.size());
    }
    return folder.path();
}

}  // namespace fuzz
