// Meshes as arrays, in and out.
#include "base/counted.hpp"
#include "base/ordinal.hpp"
#include "capi/firewall.hpp"
#include "capi/mesh_frame.hpp"
#include "mesh/quadratic.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

using namespace cleft::capi;
using cleft::Error;
using cleft::ordinal;
using cleft::Run;

namespace
{

// Each number by its name, for a caller who has exchanged two arguments.
void check_counts(int64_t point_count, int64_t tet_count, int32_t index_base)
{
    for (const auto& [name, count] : {std::pair("point_count", point_count), std::pair("tet_count", tet_count)}) {
        const std::string is = name + (" is " + std::to_string(count));
        if (count < 0)
            throw Error(CLEFT_ERROR_ARGUMENT, is + "; it must not be negative");
        if (count > INT32_MAX)
            throw Error(CLEFT_ERROR_TOO_LARGE, is + "; it must be at most 2147483647");
    }
    if (index_base != 0 && index_base != 1)
        throw Error(CLEFT_ERROR_ARGUMENT, "index_base is " + std::to_string(index_base) + "; it must be 0 or 1");
}

// A number out of range would have every later function read past the points, so this is checked once, here.
cleft::Array<cleft::Tet> checked_tets(const int32_t* tets, int64_t tet_count, int64_t point_count, int32_t index_base)
{
    cleft::Array<cleft::Tet> out(tet_count);
    for (int64_t t = 0; t < tet_count; ++t)
        for (size_t i = 0; i < 4; ++i) {
            // In 64 bits, where INT32_MIN less the base does not overflow.
            const int64_t corner = int64_t{tets[4 * t + static_cast<int64_t>(i)]} - index_base;
            if (corner < 0 || corner >= point_count)
                throw Error(CLEFT_ERROR_ARGUMENT,
                            "the " + ordinal(t) + " tetrahedron names point " + std::to_string(corner + index_base) +
                                ", but there " + cleft::is_or_are(point_count) + " " +
                                cleft::counted(point_count, "point") + ", counted from " + std::to_string(index_base));
            out[t][i] = static_cast<int32_t>(corner);
        }
    return out;
}

// data() of an empty vector need not be NULL, which the header promises.
template <class T>
const T* data_or_null(const cleft::Array<T>& v)
{
    return v.empty() ? nullptr : v.data();
}

void check_capacity(int64_t capacity, size_t needed)
{
    // Callers that size a buffer from another mesh would have it overrun; languages with arrays pass their true length.
    if (capacity < static_cast<int64_t>(needed))
        throw Error(CLEFT_ERROR_BUFFER,
                    "the buffer holds " + std::to_string(capacity) + " of " + std::to_string(needed) + " values");
}

}  // namespace

cleft_status cleft_mesh_create(cleft_context* context, int64_t point_count, const double* points, int64_t tet_count,
                               const int32_t* tets, const int32_t* labels, int32_t index_base,
                               cleft_mesh** out) noexcept
{
    return guarded_create(context, out, "mesh", [&](const Run&) {
        check_counts(point_count, tet_count, index_base);
        // No elements, no array: languages hand over NULL for an empty one.
        if (point_count > 0)
            required(points, "points");
        if (tet_count > 0)
            required(tets, "tets");
        cleft_mesh mesh;
        mesh.mesh.points.resize(point_count);
        for (int64_t i = 0; i < point_count; ++i) {
            const cleft::Vec3 point(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
            // Here and not in a later check, since NaN makes every comparison false and so slips through them.
            if (!point.allFinite())
                throw Error(CLEFT_ERROR_NOT_FINITE, "the " + ordinal(i) + " point is NaN or infinite");
            mesh.mesh.points[i] = point;
        }
        mesh.mesh.tets = checked_tets(tets, tet_count, point_count, index_base);
        if (labels)
            mesh.mesh.labels.assign(labels, labels + tet_count);
        else
            // A background needs no labels, but all functions of a mesh may ask for them.
            mesh.mesh.labels.assign(tet_count, 0);
        // Found once, for the functions that lend them have no place to put an error.
        mesh.labels = distinct_labels(mesh.mesh.labels, Run());
        return mesh;
    });
}

void cleft_mesh_destroy(cleft_mesh* mesh) noexcept { destroy(mesh); }

int64_t cleft_mesh_point_count(const cleft_mesh* mesh) noexcept
{
    return is_sound(mesh) ? static_cast<int64_t>(mesh->mesh.points.size()) : 0;
}

// Lent without a copy: an array of Vec3 is one of interleaved doubles (base/vec.hpp).
const double* cleft_mesh_points(const cleft_mesh* mesh) noexcept
{
    return is_sound(mesh) && !mesh->mesh.points.empty() ? mesh->mesh.points.front().data() : nullptr;
}

int64_t cleft_mesh_tet_count(const cleft_mesh* mesh) noexcept
{
    return is_sound(mesh) ? static_cast<int64_t>(mesh->mesh.tets.size()) : 0;
}

const int32_t* cleft_mesh_tets(const cleft_mesh* mesh) noexcept
{
    return is_sound(mesh) && !mesh->mesh.tets.empty() ? mesh->mesh.tets.front().data() : nullptr;
}

const int32_t* cleft_mesh_tet_labels(const cleft_mesh* mesh) noexcept
{
    return is_sound(mesh) ? data_or_null(mesh->mesh.labels) : nullptr;
}

int64_t cleft_mesh_label_count(const cleft_mesh* mesh) noexcept
{
    return is_sound(mesh) ? static_cast<int64_t>(mesh->labels.size()) : 0;
}

const int32_t* cleft_mesh_labels(const cleft_mesh* mesh) noexcept
{
    return is_sound(mesh) ? data_or_null(mesh->labels) : nullptr;
}

cleft_status cleft_mesh_set_label_name(cleft_mesh* mesh, int32_t label, const char* name) noexcept
{
    return guarded(nullptr, [&] {
        cleft_mesh& m = checked(mesh, "mesh");
        set_label_name(m.names, m.labels, label, name, "the mesh");
    });
}

const char* cleft_mesh_label_name(const cleft_mesh* mesh, int32_t label) noexcept
{
    return is_sound(mesh) ? label_name(mesh->names, label) : "";
}

cleft_status cleft_mesh_copy_points(const cleft_mesh* mesh, double* points, int64_t capacity) noexcept
{
    return guarded(nullptr, [&] {
        const auto& from = checked(mesh, "mesh").mesh.points;
        required(points, "points");
        check_capacity(capacity, 3 * from.size());
        if (!from.empty())
            std::memcpy(points, from.front().data(), from.size() * sizeof(cleft::Vec3));
    });
}

cleft_status cleft_mesh_copy_tets(const cleft_mesh* mesh, int32_t index_base, int32_t* tets, int64_t capacity) noexcept
{
    return guarded(nullptr, [&] {
        const auto& from = checked(mesh, "mesh").mesh.tets;
        required(tets, "tets");
        check_counts(0, 0, index_base);
        check_capacity(capacity, 4 * from.size());
        for (const cleft::Tet& tet : from)
            for (const int32_t corner : tet)
                // A base of 1 is for Fortran, MATLAB and Julia, and for most file formats of solvers.
                *tets++ = corner + index_base;
    });
}

cleft_status cleft_mesh_copy_tet_labels(const cleft_mesh* mesh, int32_t* labels, int64_t capacity) noexcept
{
    return guarded(nullptr, [&] {
        const auto& from = checked(mesh, "mesh").mesh.labels;
        required(labels, "labels");
        check_capacity(capacity, from.size());
        std::copy(from.begin(), from.end(), labels);
    });
}

cleft_status cleft_mesh_copy_quadratic(const cleft_mesh* mesh, int32_t index_base, double* points,
                                       int64_t point_capacity, int32_t* tets, int64_t tet_capacity,
                                       int64_t* point_count) noexcept
{
    return guarded(nullptr, [&] {
        const cleft::UserMesh& from = checked(mesh, "mesh").mesh;
        required(point_count, "point_count");
        check_counts(0, 0, index_base);
        // Made in each of the two calls: a mesh is immutable, and keeps nothing from the first for the second.
        const cleft::MiddleNodes middles(from.tets);
        const size_t corners = from.points.size();
        // A mesh has about seven times as many edges as points, so its middles can pass the limit where its points do
        // not.
        if (corners + middles.count() >= INT32_MAX)
            throw Error(CLEFT_ERROR_TOO_LARGE, "more than 2147483646 points");
        // All checks come before the first write: a failure leaves the caller's memory as it was.
        if (points || tets) {
            required(points, "points");
            required(tets, "tets");
            check_capacity(point_capacity, 3 * (corners + middles.count()));
            check_capacity(tet_capacity, 10 * from.tets.size());
        }
        *point_count = static_cast<int64_t>(corners + middles.count());
        // The first of two calls: the number of middles is not known from the counts of the mesh.
        if (!points)
            return;
        if (corners > 0)
            std::memcpy(points, from.points.front().data(), corners * sizeof(cleft::Vec3));
        for (size_t m = 0; m < middles.count(); ++m) {
            const cleft::Vec3 middle = middles.place(m, from.points);
            std::copy(middle.data(), middle.data() + 3, points + 3 * (corners + m));
        }
        for (const cleft::Tet& tet : from.tets)
            for (const int32_t node : middles.nodes(tet, corners))
                *tets++ = node + index_base;
    });
}
