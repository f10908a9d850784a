#include "io/image_series.hpp"

#include "base/error.hpp"
#include "io/text_scanner.hpp"

#include <fnmatch.h>
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <regex>

namespace cleft::io
{

namespace fs = std::filesystem;

namespace
{

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Runs of digits compare as numbers: "slice9" comes before "slice10".
bool natural_less(const std::string& a, const std::string& b)
{
    size_t i = 0;
    size_t j = 0;
    while (i < a.size() && j < b.size()) {
        if (is_digit(a[i]) && is_digit(b[j])) {
            const size_t start_a = std::min(a.find_first_not_of('0', i), a.size());
            const size_t start_b = std::min(b.find_first_not_of('0', j), b.size());
            size_t end_a = start_a;
            size_t end_b = start_b;
            while (end_a < a.size() && is_digit(a[end_a]))
                ++end_a;
            while (end_b < b.size() && is_digit(b[end_b]))
                ++end_b;
            if (end_a - start_a != end_b - start_b)
                return end_a - start_a < end_b - start_b;
            const int order = a.compare(start_a, end_a - start_a, b, start_b, end_b - start_b);
            if (order != 0)
                return order < 0;
            i = end_a;
            j = end_b;
        } else if (a[i] != b[j]) {
            return a[i] < b[j];
        } else {
            ++i;
            ++j;
        }
    }
    return a.size() - i < b.size() - j;
}

std::vector<std::string> matching_files(const std::string& pattern)
{
    const fs::path path(pattern);
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::vector<std::string> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (fnmatch(path.filename().c_str(), entry.path().filename().c_str(), FNM_PERIOD) == 0)
            found.push_back(entry.path().string());
    std::sort(found.begin(), found.end(), natural_less);
    return found;
}

std::vector<std::string> numbered_files(const std::string& path, const std::smatch& conversion)
{
    const size_t width = conversion[1].length() ? std::stoul(conversion[1]) : 0;
    const auto name = [&](int number) {
        std::string digits = std::to_string(number);
        if (digits.size() < width)
            digits.insert(0, width - digits.size(), '0');
        return conversion.prefix().str() + digits + conversion.suffix().str();
    };
    std::vector<std::string> found;
    for (int number = fs::exists(name(0)) ? 0 : 1; fs::exists(name(number)); ++number)
        found.push_back(name(number));
    if (found.empty())
        throw Error(CLEFT_ERROR_FILE, "there is neither '" + name(0) + "' nor '" + name(1) + "' (" + path + ")");
    return found;
}

// DICOM knows where each slice is: the step between slices comes from that, and a missing slice is noticed.
void set_third_axis(const std::vector<Vector3>& origins, Image& image)
{
    const double steps = static_cast<double>(origins.size() - 1);
    const Vector3 way = minus(origins.back(), origins.front());
    if (length(way) == 0)
        return;
    const Vector3 step = times(1 / steps, way);
    for (size_t s = 0; s < origins.size(); ++s) {
        const Vector3 expected = times(static_cast<double>(s), step);
        if (length(minus(minus(origins[s], origins.front()), expected)) > 0.05 * length(step))
            throw Error(CLEFT_ERROR_FORMAT, "its slices are not evenly spaced: is one missing?");
    }
    image.spacing[2] = length(step);
    image.directions[2] = times(1 / length(step), step);
}

Image stack(const std::vector<std::string>& slices)
{
    Image volume;
    std::vector<Vector3> origins;
    for (size_t s = 0; s < slices.size(); ++s) {
        const Image slice = naming_file(slices[s], [&] { return read_image(slices[s]); });
        if (slice.dims[2] != 1 || slice.fields != 1)
            throw Error(CLEFT_ERROR_FORMAT, "'" + slices[s] + "' is not a single slice");
        if (s == 0) {
            volume.dims = {slice.dims[0], slice.dims[1], static_cast<int64_t>(slices.size())};
            volume.component = slice.component;
            volume.directions = slice.directions;
            volume.spacing = slice.spacing;
            volume.origin = slice.origin;
            allocate_voxels(volume);
        }
        if (slice.dims[0] != volume.dims[0] || slice.dims[1] != volume.dims[1] || slice.component != volume.component)
            throw Error(CLEFT_ERROR_FORMAT,
                        "'" + slices[s] + "' has another size or type of voxels than '" + slices[0] + "'");
        std::memcpy(volume.voxels.get() + s * slice.bytes(), slice.voxels.get(), slice.bytes());
        origins.push_back(slice.origin);
        for (const std::string& note : slice.notes)  // one slice speaks for all that say the same
            if (std::find(volume.notes.begin(), volume.notes.end(), note) == volume.notes.end())
                volume.notes.push_back(note);
    }
    set_third_axis(origins, volume);
    return volume;
}

}  // namespace

Image read_image_or_series(const std::string& path)
{
    return naming_file(path, [&] {
        if (fs::is_directory(path))
            return stack(dicom_slices(path));
        if (fs::exists(path))
            return read_image(path);
        std::smatch conversion;
        if (std::regex_search(path, conversion, std::regex("%0?([0-9]{0,2})d")))
            return stack(numbered_files(path, conversion));
        if (path.find_first_of("*?") == std::string::npos)
            return read_image(path);
        const std::vector<std::string> slices = matching_files(path);
        if (slices.empty())
            throw Error(CLEFT_ERROR_FILE, "no file has such a name");
        return stack(slices);
    });
}

}  // namespace cleft::io
