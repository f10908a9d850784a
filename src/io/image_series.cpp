// Finds the files that a path or a pattern stands for, and puts single slices on each other. What
// is not certain about their order or number is refused or reported.
#include "io/image_series.hpp"

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "io/dicom_image.hpp"
#include "io/folder_names.hpp"
#include "io/path_kind.hpp"
#include "io/read_image.hpp"
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
            // Without leading zeros the longer run is the greater number. So digits of any count
            // compare without a conversion that could overflow.
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

// The files of the pattern's folder whose names it fits, sorted.
template <class Fits>
std::vector<std::string> files_beside(const std::string& pattern, const Fits& fits)
{
    const fs::path path(pattern);
    // names_in() wants a folder; names in the answer keep the form that the user gave.
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::vector<std::string> found;
    for (const std::string& name : names_in(folder.string()))
        if (fits(name))
            found.push_back((path.has_parent_path() ? folder / name : fs::path(name)).string());
    std::sort(found.begin(), found.end(), natural_less);
    return found;
}

// A name with one number in it that differs from name to name: what is before it, its digits, what is behind.
struct NumberedName {
    std::string before, digits, behind;
};

// Splits at the run of digits that begins at `at` or, if a number is longer there, around it.
NumberedName split_name(const std::string& path, size_t at)
{
    size_t start = std::min(at, path.size());
    while (start > 0 && is_digit(path[start - 1]))
        --start;
    const size_t end = std::min(path.find_first_not_of("0123456789", start), path.size());
    return {path.substr(0, start), path.substr(start, end - start), path.substr(end)};
}

// The numbers of files whose names differ in one number alone, in their order; none if the names are of another kind.
std::vector<int64_t> numbers_of(const std::vector<std::string>& files)
{
    const std::string& first = files.front();
    const std::string& last = files.back();
    // In natural order, the first and the last name differ at the number that counts the slices.
    const auto at =
        static_cast<size_t>(std::mismatch(first.begin(), first.end(), last.begin(), last.end()).first - first.begin());
    const NumberedName pattern = split_name(first, at);
    std::vector<int64_t> numbers;
    for (const std::string& file : files) {
        const NumberedName name = split_name(file, at);
        // Names of another kind, such as dates, tell nothing about gaps. Nine digits fit 32 bits
        // and are more than a series has.
        if (name.before != pattern.before || name.behind != pattern.behind || name.digits.empty() ||
            name.digits.size() > 9)
            return {};
        numbers.push_back(std::stoll(name.digits));
    }
    return numbers;
}

// Tells of gaps, and of a step other than 1.
std::vector<std::string> notes_on_numbers(const std::vector<std::string>& files)
{
    const std::vector<int64_t> numbers = numbers_of(files);
    if (numbers.size() < 2)
        return {};
    int64_t step = numbers[1] - numbers[0];
    for (size_t i = 1; i < numbers.size(); ++i)
        step = std::min(step, numbers[i] - numbers[i - 1]);
    // "1.png" and "01.png" have the same number, and nothing tells which slice comes first.
    if (step == 0)
        throw Error(CLEFT_ERROR_FILE, "two of its files have the same number");
    // A gap is reported and not refused: programs that export each second slice leave such numbers, and
    // the pattern asked for what is there.
    const int64_t missing = (numbers.back() - numbers.front()) / step + 1 - static_cast<int64_t>(numbers.size());
    for (size_t i = 1; i < numbers.size(); ++i)
        if (numbers[i] != numbers[i - 1] + step)
            return {"the numbers of its files have gaps: of " + std::to_string(missing) +
                    " missing slices the first is "
                    "number " +
                    std::to_string(numbers[i - 1] + step) + ", and those that are there are put together"};
    if (step > 1)
        return {"the numbers of its files go up by " + std::to_string(step)};
    return {};
}

std::vector<std::string> matching_files(const std::string& pattern)
{
    const std::string name = fs::path(pattern).filename().string();
    const std::vector<std::string> found = files_beside(
        // FNM_PERIOD: "*" does not match hidden files, as in a shell.
        pattern, [&](const std::string& file) { return fnmatch(name.c_str(), file.c_str(), FNM_PERIOD) == 0; });
    if (found.empty())
        throw Error(CLEFT_ERROR_FILE, "no file has such a name");
    return found;
}

std::vector<std::string> numbered_files(const std::string& path, const std::smatch& conversion)
{
    const size_t width = conversion[1].length() ? std::stoul(conversion[1]) : 0;
    const auto name = [&](int64_t number) {
        std::string digits = std::to_string(number);
        if (digits.size() < width)
            digits.insert(0, width - digits.size(), '0');
        return conversion.prefix().str() + digits + conversion.suffix().str();
    };
    // Programs count slices from 0 or from 1; no other beginning is tried.
    const int64_t first = is_there(name(0)) ? 0 : 1;
    int64_t number = first;
    std::vector<std::string> found;
    for (; is_there(name(number)); ++number)
        found.push_back(name(number));
    if (found.empty())
        throw Error(CLEFT_ERROR_FILE, "there is neither '" + name(0) + "' nor '" + name(1) + "'");
    // Is there a file beyond the first that is missing?
    // With "%03d" the user says that slices are numbered one by one. A higher number behind a gap
    // shows that one is missing.
    for (const std::string& file : files_beside(path, [](const std::string&) { return true; })) {
        const auto before = static_cast<size_t>(conversion.prefix().length());
        const auto behind = static_cast<size_t>(conversion.suffix().length());
        if (file.size() <= before + behind)
            continue;
        const std::string digits = file.substr(before, file.size() - before - behind);
        if (digits.size() > 9 || digits.find_first_not_of("0123456789") != std::string::npos)
            continue;
        const int64_t beyond = std::stoll(digits);
        if (beyond > number && file == name(beyond))
            throw Error(CLEFT_ERROR_FILE, "'" + name(number) + "' is missing, but there is '" + file + "'");
    }
    return found;
}

// Slices that all lie at one place by their headers. DICOM sorts slices by their places, so that these are no stack.
// Other programs copy the header of a volume to each of its slices.
void note_one_place(const Vector3& origin, Image& volume)
{
    if (volume.placed && volume.dims[2] > 1)
        throw Error(CLEFT_ERROR_FORMAT,
                    "its slices lie at the same place: a series over time, or of several contrasts, is no volume");
    if (length(origin) > 0 && volume.dims[2] > 1)
        volume.notes.push_back("its slices all lie at one place by their headers: they are put " +
                               number_text(volume.spacing[2]) + " apart, in the order of their names");
}

// DICOM knows where each slice is: the step between slices comes from that, and a missing slice is noticed.
void set_third_axis(const std::vector<Vector3>& origins, Image& image)
{
    const double steps = static_cast<double>(origins.size() - 1);
    const Vector3 way = minus(origins.back(), origins.front());
    // PNG, JPEG, BMP and TIFF have no place. The third axis then stays as the first slice has it.
    if (length(way) == 0) {
        note_one_place(origins.front(), image);
        return;
    }
    const Vector3 step = times(1 / steps, way);
    for (size_t s = 0; s < origins.size(); ++s) {
        const Vector3 expected = times(static_cast<double>(s), step);
        // The same twentieth of a step as in a folder of DICOM.
        if (length(minus(minus(origins[s], origins.front()), expected)) > 0.05 * length(step))
            throw Error(CLEFT_ERROR_FORMAT, "its slices are not evenly spaced: is one missing?");
    }
    image.spacing[2] = length(step);
    image.directions[2] = times(1 / length(step), step);
}

void check_alike(const Image& slice, const std::string& name, const Image& volume, const std::string& first)
{
    // Relative to the spacing, and absolute for directions of length 1: text in headers is rounded,
    // and a real difference is greater.
    constexpr double kTolerance = 1e-3;
    if (slice.dims[0] != volume.dims[0] || slice.dims[1] != volume.dims[1] || slice.component != volume.component)
        throw Error(CLEFT_ERROR_FORMAT, "'" + name + "' has another size or type of voxels than '" + first + "'");
    for (size_t axis = 0; axis < 3; ++axis) {
        const double spacing = volume.spacing[axis];
        if (std::abs(slice.spacing[axis] - spacing) > kTolerance * spacing ||
            length(minus(slice.directions[axis], volume.directions[axis])) > kTolerance)
            throw Error(CLEFT_ERROR_FORMAT, "'" + name + "' has another spacing or other axes than '" + first + "'");
    }
}

Image stack(const std::vector<std::string>& slices)
{
    Image volume;
    std::vector<Vector3> origins;
    for (size_t s = 0; s < slices.size(); ++s) {
        const Image slice = naming_file(slices[s], [&] { return read_image(slices[s]); });
        // A pattern that matches volumes would put them on each other along the third axis, which
        // is never meant.
        if (slice.dims[2] != 1 || slice.fields != 1)
            throw Error(CLEFT_ERROR_FORMAT, "'" + slices[s] + "' is not a single slice");
        if (s == 0) {
            volume.dims = {slice.dims[0], slice.dims[1], static_cast<int64_t>(slices.size())};
            volume.component = slice.component;
            volume.directions = slice.directions;
            volume.spacing = slice.spacing;
            volume.origin = slice.origin;
            volume.placed = slice.placed;
            allocate_voxels(volume);
        }
        check_alike(slice, slices[s], volume, slices[0]);
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
        // A path that exists is what it says, even if its name has "*" or "%d" in it. Patterns are
        // tried on what does not exist.
        if (is_folder(path))
            return read_dicom_folder(path);
        if (is_there(path))
            return read_image(path);
        std::smatch conversion;
        // Only %d, %3d and %03d; the path is never given to printf().
        if (std::regex_search(path, conversion, std::regex("%0?([0-9]{0,2})d")))
            return stack(numbered_files(path, conversion));
        if (path.find_first_of("*?") == std::string::npos)
            return read_image(path);
        const std::vector<std::string> slices = matching_files(path);
        std::vector<std::string> notes = notes_on_numbers(slices);
        Image volume = stack(slices);
        volume.notes.insert(volume.notes.begin(), notes.begin(), notes.end());
        return volume;
    });
}

}  // namespace cleft::io
