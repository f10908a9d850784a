// The files of a folder sorted into series, and the slices of a series put on each other.
#include "io/dicom_series.hpp"

#include "base/error.hpp"
#include "io/dicom_folders.hpp"
#include "io/dicom_image.hpp"
#include "io/text_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace cleft::io
{

namespace fs = std::filesystem;

namespace
{

struct SliceFile {
    std::string path;
    double number = 0;  // in the series
};

struct Series {
    std::string description;
    std::string modality;
    std::string uid;
    std::string size;                 // of its slices
    std::vector<double> orientation;  // of its slices
    std::vector<SliceFile> files;
};

// Files that are no DICOM at all are passed over, and DICOM without voxels, too; damaged DICOM is an error.
bool read_dicom_header(const std::string& path, DicomFile& file)
{
    // The first bytes spare reading whole files that lie beside a series, such as archives and
    // pictures.
    const std::string head = first_bytes_of(path);
    if (!is_dicom_head(head))
        return false;
    const bool marked = head.size() >= 132 && head.compare(128, 4, "DICM") == 0;
    try {
        file = read_dicom_file(path);
    } catch (const Error& error) {
        // A file without the prefix only looked like DICOM, so a failure to read it shows that it
        // is something else.
        if (marked)
            throw Error(error.status(), "'" + path + "': " + error.what());
        return false;
    }
    // Pixel Data in one of its three types. Reports and plans in the folder have none and are
    // passed over.
    return file.data.has(0x7FE00010u) || file.data.has(0x7FE00008u) || file.data.has(0x7FE00009u);
}

bool is_alike(const std::vector<double>& a, const std::vector<double>& b)
{
    // The same tolerance as for slices of one stack. A localizer is turned by far more.
    constexpr double kTurned = 1e-3;
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](double one, double other) { return std::abs(one - other) <= kTurned; });
}

// The series of these, or a new one at the end. A series may begin with slices of another size or direction, to show
// where the others lie.
Series& series_of(const DicomData& data, std::vector<Series>& list)
{
    Series made;
    // Series Instance UID, Series Description, Modality, Columns and Rows, Image Orientation
    // (Patient).
    made.uid = data.text(0x0020000Eu);
    made.description = data.text(0x0008103Eu);
    made.modality = data.text(0x00080060u);
    made.size =
        std::to_string(data.short_number(0x00280011u, 0)) + " x " + std::to_string(data.short_number(0x00280010u, 0));
    made.orientation = data.numbers(0x00200037u);
    const auto found = std::find_if(list.begin(), list.end(), [&](const Series& series) {
        return series.uid == made.uid && series.size == made.size && is_alike(series.orientation, made.orientation);
    });
    return found != list.end() ? *found : list.emplace_back(std::move(made));
}

std::vector<Series> series_in(const std::string& folder)
{
    std::vector<Series> list;
    for (const std::string& path : files_in(folder)) {
        DicomFile file;
        if (!read_dicom_header(path, file))
            continue;
        naming_file(path, [&] {
            // Instance Number. Without places it is the only order that a file tells; the name of a
            // file is arbitrary.
            const std::vector<double> number = file.data.numbers(0x00200013u);
            series_of(file.data, list).files.push_back({path, number.empty() ? 0 : number.front()});
        });
    }
    return list;
}

std::string names_of(const std::vector<Series>& list)
{
    // As many as a message can list and still be read.
    constexpr size_t kNamed = 8;
    std::string text;
    for (size_t s = 0; s < std::min(kNamed, list.size()); ++s) {
        const Series& series = list[s];
        text += std::string(s > 0 ? "; " : "") + "'" + ascii_of(series.description) + "' (" +
                (series.modality.empty() ? "" : ascii_of(series.modality) + ", ") +
                std::to_string(series.files.size()) + (series.files.size() == 1 ? " file" : " files") + " of " +
                series.size + ", UID " + ascii_of(series.uid) + ", " +
                fs::path(series.files.front().path).filename().string() + " ...)";
    }
    return text + (list.size() > kNamed ? "; and " + std::to_string(list.size() - kNamed) + " more" : "");
}

// In the order of their numbers, where no slice tells its place.
// Secondary captures and exports without geometry have numbers at best. Two equal numbers leave the
// order open, and are refused.
DicomStack stack_by_number(const Series& series, std::vector<DicomPlane> planes, Image& volume)
{
    std::vector<size_t> order(planes.size());
    for (size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return series.files[a].number < series.files[b].number; });
    for (size_t slot = 1; slot < order.size(); ++slot)
        if (series.files[order[slot]].number == series.files[order[slot - 1]].number)
            refuse_dicom("its slices do not tell where they lie, and '" + series.files[order[slot - 1]].path +
                         "' and '" + series.files[order[slot]].path + "' have the same number");
    DicomStack stack;
    stack.slots.resize(planes.size());
    for (size_t slot = 0; slot < order.size(); ++slot)
        stack.slots[order[slot]] = static_cast<int64_t>(slot);
    set_plane(planes.front(), stack.geometry);
    volume.notes.push_back("its slices do not tell where they lie: they are taken in the order of their numbers, " +
                           std::string(planes.front().slice_spacing() > 0 ? "their thickness" : "a pixel") + " apart");
    return stack;
}

void add_slice(const Image& slice, size_t number, const std::string& first, Image& volume)
{
    // Frames and slices mixed in one series cannot be put into one order.
    if (slice.dims[2] != 1)
        refuse_dicom("it holds " + std::to_string(slice.dims[2]) +
                     " frames, but a series in a folder is of single slices: read that file alone");
    // The first slice decides type and size. Later ones were sorted by size already; their type is
    // compared below.
    if (number == 0) {
        volume.dims[0] = slice.dims[0];
        volume.dims[1] = slice.dims[1];
        volume.component = slice.component;
        allocate_voxels(volume);
    }
    for (const std::string& note : slice.notes)  // one slice speaks for all that say the same
        if (std::find(volume.notes.begin(), volume.notes.end(), note) == volume.notes.end())
            volume.notes.push_back(note);
    // The rescaled values of slices with different slopes are unified later; the stored types must
    // agree before.
    if (slice.component != volume.component)
        refuse_dicom("it has another type of voxels than '" + first + "'");
    std::memcpy(volume.voxels.get() + number * slice.bytes(), slice.voxels.get(), slice.bytes());
}

Image read_series(const Series& series)
{
    Image volume;
    volume.dims[2] = static_cast<int64_t>(series.files.size());
    std::vector<DicomPlane> planes;
    std::vector<std::string> who;
    for (size_t i = 0; i < series.files.size(); ++i) {
        const std::string& path = series.files[i].path;
        naming_file(path, [&] {
            std::vector<DicomPlane> own;
            // Files are read a second time: holding all of them since the sorting would take twice
            // the memory.
            const Image slice = read_dicom_frames(read_dicom_file(path), own);
            add_slice(slice, i, series.files.front().path, volume);
            planes.push_back(own.front());
        });
        who.push_back("'" + path + "'");
    }
    rescale(planes, volume);
    // If some slices have places and others not, stack_of() names one that has none.
    const bool placed = std::any_of(planes.begin(), planes.end(), [](const DicomPlane& p) { return p.placed; });
    put_in_slots(placed ? stack_of(planes, who) : stack_by_number(series, planes, volume), volume);
    return volume;
}

}  // namespace

Image read_dicom_folder(const std::string& folder)
{
    const std::vector<Series> list = series_in(folder);
    if (list.empty()) {
        const std::vector<std::string> below = dicom_folders_below(folder);
        // Exports of archives put a series three or four folders down.
        if (below.size() == 1)  // the only series in a tree of folders
            return naming_file(below.front(), [&] { return read_dicom_folder(below.front()); });
        refuse_folder_without_series(folder, below);
    }
    if (list.size() > 1)
        throw Error(CLEFT_ERROR_FILE, "the folder must hold one DICOM series, but holds " +
                                          std::to_string(list.size()) + ": " + names_of(list) +
                                          "; give the file of a series that is one file, or move a series into a "
                                          "folder of its own");
    // A single file may be a multi-frame object or a segmentation, which is not read slice by
    // slice.
    if (list.front().files.size() == 1)
        return read_dicom_image(list.front().files.front().path, FileHead{});
    return read_series(list.front());
}

}  // namespace cleft::io
