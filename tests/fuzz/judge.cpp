// Judges what the library returns by its public interface, in the arrays that a user gets.
#include "fuzz/judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace fuzz
{

namespace
{

// Bytes behind the first of a character of UTF-8, by its first; 4 if it is none.
size_t bytes_behind(unsigned char first)
{
    return first < 0x80 ? 0 : first < 0xc2 ? 4 : first < 0xe0 ? 1 : first < 0xf0 ? 2 : first < 0xf5 ? 3 : 4;
}

void judge_sentence(int32_t, const char* sentence, void*)
{
    if (!*sentence || !is_line(sentence))
        fault("a warning is no line of text: " + std::string(sentence));
}

// Statuses that a user brings about. Others are faults of the library, or of the machine it runs on.
bool is_users(cleft_status status)
{
    switch (status) {
        case CLEFT_ERROR_ARGUMENT:
        case CLEFT_ERROR_NOT_FINITE:
        case CLEFT_ERROR_TOO_LARGE:
        case CLEFT_ERROR_OPTION:
        case CLEFT_ERROR_UNSUPPORTED:
        case CLEFT_ERROR_INVALID_MESH:
        case CLEFT_ERROR_LABEL_LOST:
        case CLEFT_ERROR_FILE:
        case CLEFT_ERROR_FORMAT:
            return true;
        default:
            return false;
    }
}

template <class Number>
bool are_finite(const Number* numbers, int64_t count)
{
    return std::all_of(numbers, numbers + count, [](Number x) { return std::isfinite(x); });
}

bool are_ascending(const int32_t* labels, int64_t count)
{
    return std::adjacent_find(labels, labels + count, [](int32_t a, int32_t b) { return a >= b; }) == labels + count;
}

}  // namespace

void fault(const std::string& sentence)
{
    std::fprintf(stderr, "FAULT: %s\n", sentence.c_str());
    std::abort();
}

bool is_line(const std::string& text)
{
    for (size_t i = 0; i < text.size(); ++i) {
        const auto first = static_cast<unsigned char>(text[i]);
        if (first < ' ' || first == 0x7f || bytes_behind(first) > 3)
            return false;
        for (size_t behind = bytes_behind(first); behind > 0; --behind)
            if (++i >= text.size() || (static_cast<unsigned char>(text[i]) >> 6) != 2)
                return false;
    }
    return true;
}

Options::Options() { expect(cleft_options_create(&options_) == CLEFT_OK, "no options can be made"); }

Options::~Options() { cleft_options_destroy(options_); }

Context::Context()
{
    expect(cleft_context_create(&context_) == CLEFT_OK, "no context can be made");
    expect(cleft_context_set_log(context_, judge_sentence, nullptr) == CLEFT_OK, "the log callback is refused");
}

Context::~Context() { cleft_context_destroy(context_); }

bool Context::succeeded(cleft_status status) const
{
    if (status == CLEFT_OK)
        return true;
    const std::string sentence = cleft_context_last_error(context_);
    if (!is_users(status))
        fault("the status is " + std::string(cleft_status_string(status)) + ": " + sentence);
    if (sentence.empty() || !is_line(sentence))
        fault("an error is no line of text: " + sentence);
    return false;
}

void judge_volume(const Context& context, const cleft_volume* volume)
{
    int64_t dims[3] = {};
    double affine[12] = {};
    expect(cleft_volume_dims(volume, dims) == CLEFT_OK && cleft_volume_affine(volume, affine) == CLEFT_OK,
           "a volume has no dimensions or no affine");
    expect(dims[0] > 0 && dims[1] > 0 && dims[2] > 0, "a volume has no voxels");
    expect(are_finite(affine, 12), "an affine is not finite");
    const int64_t count = cleft_volume_label_count(volume);
    const int32_t* labels = cleft_volume_labels(volume);
    expect(count > 0, "a volume has no labels");
    expect(cleft_volume_indicator_count(volume) > 0 || are_ascending(labels, count), "labels are not ascending");
    std::vector<int64_t> voxels(static_cast<size_t>(count));
    expect(context.succeeded(cleft_volume_copy_voxel_counts(volume, voxels.data(), count)), "voxels are not counted");
    int64_t sum = 0;
    for (const int64_t n : voxels)
        sum += n;
    expect(sum == dims[0] * dims[1] * dims[2], "the labels have more or fewer voxels than the volume");
    for (int64_t i = 0; i < count; ++i)
        expect(is_line(cleft_volume_label_name(volume, labels[i])), "the name of a label is no line of text");
    double centre[3];
    for (int row = 0; row < 3; ++row)
        centre[row] = affine[4 * row] * static_cast<double>(dims[0] / 2) +
                      affine[4 * row + 1] * static_cast<double>(dims[1] / 2) +
                      affine[4 * row + 2] * static_cast<double>(dims[2] / 2) + affine[4 * row + 3];
    int32_t label = 0;
    if (are_finite(centre, 3))
        expect(cleft_volume_sample(volume, centre, 1, &label) == CLEFT_OK &&
                   std::find(labels, labels + count, label) != labels + count,
               "a voxel has a label that the volume does not have");
}

void judge_arrays(const Context& context, const cleft_mesh* mesh)
{
    const int64_t points = cleft_mesh_point_count(mesh);
    const int64_t tets = cleft_mesh_tet_count(mesh);
    const int32_t* corners = cleft_mesh_tets(mesh);
    const int32_t* labels = cleft_mesh_labels(mesh);
    const int64_t label_count = cleft_mesh_label_count(mesh);
    expect(points > 0 && tets > 0 && label_count > 0, "a mesh is empty");
    expect(are_finite(cleft_mesh_points(mesh), 3 * points), "a point is not finite");
    expect(std::all_of(corners, corners + 4 * tets, [&](int32_t p) { return p >= 0 && p < points; }),
           "a tetrahedron names a point that there is not");
    expect(are_ascending(labels, label_count), "the labels of a mesh are not ascending");
    for (int64_t t = 0; t < tets; ++t)
        expect(std::binary_search(labels, labels + label_count, cleft_mesh_tet_labels(mesh)[t]),
               "a tetrahedron has a label that the mesh does not have");
    for (int64_t i = 0; i < label_count; ++i)
        expect(is_line(cleft_mesh_label_name(mesh, labels[i])), "the name of a label is no line of text");
    cleft_validation found{};
    found.struct_size = sizeof found;
    expect(context.succeeded(cleft_mesh_validate(context, mesh, 0, &found)), "a mesh cannot be validated");
    cleft_quality quality{};
    quality.struct_size = sizeof quality;
    if (context.succeeded(cleft_mesh_quality(context, mesh, &quality)))
        expect(quality.tet_count == tets, "the quality is of another number of tetrahedra");
    cleft_surface* surface = nullptr;
    if (context.succeeded(cleft_surface_create(context, mesh, &surface)) && found.valid)
        expect(cleft_surface_interface_count(surface) == found.interface_triangles &&
                   cleft_surface_hull_count(surface) == found.hull_triangles,
               "the surface has other triangles than the validation counts");
    cleft_surface_destroy(surface);
}

}  // namespace fuzz
