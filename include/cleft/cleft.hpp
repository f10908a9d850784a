/*
 * The interface of cleft.h for C++11 and later: owners of handles, exceptions, callbacks as std::function. Header only.
 *
 * cleft.h describes each function under its name in C. These rules differ:
 *  - One object owns a handle. It can be moved but not copied. get() returns the handle for functions of C.
 *  - A status other than CLEFT_OK becomes a cleft::Error with the library's sentence.
 *  - Returned arrays are a cleft::View. The object that returned it owns the array, which is valid while that lives.
 *  - An exception in a callback ends the call, which throws it on.
 */
#ifndef CLEFT_HPP
#define CLEFT_HPP

#include "cleft/cleft_context.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cleft
{
inline namespace cpp
{

using Dims = std::array<int64_t, 3>;
using Affine = std::array<double, 12>;  // from voxel indices to the world, 3 rows of 4
using Point = std::array<double, 3>;

/** The cleft_type of a C++ type of voxels. Other types do not compile. */
template <class T>
struct TypeOf;
#define CLEFT_CPP_TYPE(type, number)                \
    template <>                                     \
    struct TypeOf<type> {                           \
        static constexpr cleft_type value = number; \
    };
CLEFT_CPP_TYPE(uint8_t, CLEFT_TYPE_UINT8)
CLEFT_CPP_TYPE(uint16_t, CLEFT_TYPE_UINT16)
CLEFT_CPP_TYPE(int16_t, CLEFT_TYPE_INT16)
CLEFT_CPP_TYPE(uint32_t, CLEFT_TYPE_UINT32)
CLEFT_CPP_TYPE(int32_t, CLEFT_TYPE_INT32)
CLEFT_CPP_TYPE(float, CLEFT_TYPE_FLOAT32)
CLEFT_CPP_TYPE(double, CLEFT_TYPE_FLOAT64)
#undef CLEFT_CPP_TYPE

class Volume : public Owner<cleft_volume, Destroy_volume>
{
public:
    using Owner::Owner;

    /** `voxels` has dims[0] * dims[1] * dims[2] values, x fastest. Without an affine they are unit cubes from the
     *  origin. */
    template <class Voxel>
    static Volume from_labels(const Context& context, const Voxel* voxels, const Dims& dims,
                              const Affine* affine = nullptr, const Options& options = Options())
    {
        return made<Volume, cleft_volume>(context, [&](cleft_volume** out) {
            return cleft_volume_create_labels(context.get(), TypeOf<Voxel>::value, voxels, dims.data(),
                                              affine ? affine->data() : nullptr, options.get(), out);
        });
    }
    /** Without labels, the labels are 0, 1, 2, ... One field is a signed function and has two labels. */
    template <class Real>
    static Volume from_indicators(const Context& context, const std::vector<const Real*>& fields, const Dims& dims,
                                  const Affine* affine = nullptr, const std::vector<int32_t>& labels = {})
    {
        const std::size_t wanted = fields.size() == 1 ? 2 : fields.size();
        if (!labels.empty() && labels.size() != wanted)
            throw Error(CLEFT_ERROR_ARGUMENT, std::to_string(labels.size()) + " labels are given for " +
                                                  std::to_string(wanted) + " materials");
        const std::vector<const void*> pointers(fields.begin(), fields.end());
        return made<Volume, cleft_volume>(context, [&](cleft_volume** out) {
            return cleft_volume_create_indicators(
                context.get(), TypeOf<Real>::value, pointers.data(), static_cast<int64_t>(pointers.size()), dims.data(),
                affine ? affine->data() : nullptr, labels.empty() ? nullptr : labels.data(), out);
        });
    }

    Dims dims() const
    {
        Dims dims{};
        check(cleft_volume_dims(get(), dims.data()));
        return dims;
    }
    Affine affine() const
    {
        Affine affine{};
        check(cleft_volume_affine(get(), affine.data()));
        return affine;
    }
    View<int32_t> labels() const { return {cleft_volume_labels(get()), cleft_volume_label_count(get())}; }
    int64_t indicator_count() const { return cleft_volume_indicator_count(get()); }
    std::vector<int64_t> voxel_counts() const
    {
        std::vector<int64_t> counts(labels().size());
        check(cleft_volume_copy_voxel_counts(get(), counts.data(), static_cast<int64_t>(counts.size())));
        return counts;
    }
    int32_t label_at(const Point& point) const
    {
        int32_t label = 0;
        check(cleft_volume_sample(get(), point.data(), 1, &label));
        return label;
    }
    std::string label_name(int32_t label) const { return cleft_volume_label_name(get(), label); }
    void set_label_name(int32_t label, const std::string& name)
    {
        check(cleft_volume_set_label_name(get(), label, name.c_str()));
    }
};

class Sizing : public Owner<cleft_sizing, Destroy_sizing>
{
public:
    using Owner::Owner;

    static Sizing of_volume(const Context& context, const Volume& volume, const Options& options = Options())
    {
        return made<Sizing, cleft_sizing>(context, [&](cleft_sizing** out) {
            return cleft_sizing_create(context.get(), volume.get(), options.get(), out);
        });
    }
    static Sizing constant(const Context& context, const Volume& volume, double size)
    {
        return made<Sizing, cleft_sizing>(context, [&](cleft_sizing** out) {
            return cleft_sizing_create_constant(context.get(), volume.get(), size, out);
        });
    }
    /** `values` has one float or double per voxel of the volume. */
    template <class Real>
    static Sizing from_values(const Context& context, const Volume& volume, const Real* values, bool combine = false,
                              const Options& options = Options())
    {
        return made<Sizing, cleft_sizing>(context, [&](cleft_sizing** out) {
            return cleft_sizing_create_values(context.get(), volume.get(), TypeOf<Real>::value, values, combine,
                                              options.get(), out);
        });
    }

    /** One metric everywhere: xx, xy, xz, yy, yz, zz. */
    static Sizing constant_metric(const Context& context, const Volume& volume, const std::array<double, 6>& tensor)
    {
        return made<Sizing, cleft_sizing>(context, [&](cleft_sizing** out) {
            return cleft_sizing_create_constant_metric(context.get(), volume.get(), tensor.data(), out);
        });
    }
    /** `tensors` has six floats or doubles per voxel of the volume: xx, xy, xz, yy, yz, zz. */
    template <class Real>
    static Sizing from_metric(const Context& context, const Volume& volume, const Real* tensors, bool combine = false,
                              const Options& options = Options())
    {
        return made<Sizing, cleft_sizing>(context, [&](cleft_sizing** out) {
            return cleft_sizing_create_metric(context.get(), volume.get(), TypeOf<Real>::value, tensors, combine,
                                              options.get(), out);
        });
    }

    View<float> values() const { return {cleft_sizing_values(get()), count()}; }
    bool has_metric() const noexcept { return cleft_sizing_has_metric(get()) != 0; }
    /** Six numbers per voxel, as from_metric() takes them. */
    std::vector<float> metric() const
    {
        std::vector<float> tensors(has_metric() ? 6 * static_cast<std::size_t>(count()) : 0);
        check(cleft_sizing_copy_metric(get(), tensors.data(), static_cast<int64_t>(tensors.size())));
        return tensors;
    }
    double at(const Point& point) const
    {
        double size = 0;
        check(cleft_sizing_at(get(), point.data(), &size));
        return size;
    }
    double expected_tets() const noexcept { return cleft_sizing_expected_tets(get()); }

private:
    int64_t count() const
    {
        Dims dims{};
        check(cleft_sizing_dims(get(), dims.data()));
        return dims[0] * dims[1] * dims[2];
    }
};

/** The findings of cleft_mesh_validate(), and the sentence about the first fault. */
struct Validation : cleft_validation {
    std::string first_fault;
};

class Mesh : public Owner<cleft_mesh, Destroy_mesh>
{
public:
    using Owner::Owner;

    /** Makes the mesh of a volume: cleft_mesh_volume(). */
    static Mesh of_volume(const Context& context, const Volume& volume, const Options& options = Options(),
                          const Sizing* sizing = nullptr, const Mesh* background = nullptr)
    {
        return made<Mesh, cleft_mesh>(context, [&](cleft_mesh** out) {
            return cleft_mesh_volume(context.get(), volume.get(), sizing ? sizing->get() : nullptr,
                                     background ? background->get() : nullptr, options.get(), out);
        });
    }
    /** Estimates the mesh of of_volume() with the same arguments: cleft_mesh_estimate(). */
    static cleft_estimate estimate(const Context& context, const Volume& volume, const Options& options = Options(),
                                   const Sizing* sizing = nullptr, const Mesh* background = nullptr)
    {
        cleft_estimate found{};
        found.struct_size = sizeof found;
        context.check(cleft_mesh_estimate(context.get(), volume.get(), sizing ? sizing->get() : nullptr,
                                          background ? background->get() : nullptr, options.get(), &found));
        return found;
    }
    /** Makes the background of a sizing field: cleft_background_create(). */
    static Mesh background(const Context& context, const Sizing& sizing, const Options& options = Options())
    {
        return made<Mesh, cleft_mesh>(context, [&](cleft_mesh** out) {
            return cleft_background_create(context.get(), sizing.get(), options.get(), out);
        });
    }
    /** Makes a mesh from arrays: cleft_mesh_create(). Without labels, all labels are 0. */
    static Mesh from_arrays(const Context& context, const std::vector<double>& points, const std::vector<int32_t>& tets,
                            const std::vector<int32_t>& labels = {})
    {
        if (points.size() % 3 != 0 || tets.size() % 4 != 0 || (!labels.empty() && labels.size() != tets.size() / 4))
            throw Error(CLEFT_ERROR_ARGUMENT, "points come in threes, tets in fours, with one label each");
        return made<Mesh, cleft_mesh>(context, [&](cleft_mesh** out) {
            return cleft_mesh_create(context.get(), static_cast<int64_t>(points.size() / 3), points.data(),
                                     static_cast<int64_t>(tets.size() / 4), tets.data(),
                                     labels.empty() ? nullptr : labels.data(), 0, out);
        });
    }
    /** Cleaves this mesh, a background, along the interfaces of a volume: cleft_mesh_cleave(). */
    Mesh cleaved(const Context& context, const Volume& volume, const Options& options = Options()) const
    {
        return made<Mesh, cleft_mesh>(context, [&](cleft_mesh** out) {
            return cleft_mesh_cleave(context.get(), volume.get(), get(), options.get(), out);
        });
    }
    Mesh improved(const Context& context, const Volume& volume, const Options& options = Options()) const
    {
        return made<Mesh, cleft_mesh>(context, [&](cleft_mesh** out) {
            return cleft_mesh_improve(context.get(), volume.get(), get(), options.get(), out);
        });
    }
    Mesh stripped(const Context& context, const Options& options) const
    {
        return made<Mesh, cleft_mesh>(
            context, [&](cleft_mesh** out) { return cleft_mesh_strip(context.get(), get(), options.get(), out); });
    }

    /** Three coordinates per point. */
    View<double> points() const { return {cleft_mesh_points(get()), 3 * cleft_mesh_point_count(get())}; }
    /** Four corners per tetrahedron, from 0. */
    View<int32_t> tets() const { return {cleft_mesh_tets(get()), 4 * cleft_mesh_tet_count(get())}; }
    View<int32_t> tet_labels() const { return {cleft_mesh_tet_labels(get()), cleft_mesh_tet_count(get())}; }
    View<int32_t> labels() const { return {cleft_mesh_labels(get()), cleft_mesh_label_count(get())}; }
    std::string label_name(int32_t label) const { return cleft_mesh_label_name(get(), label); }
    void set_label_name(int32_t label, const std::string& name)
    {
        check(cleft_mesh_set_label_name(get(), label, name.c_str()));
    }

    cleft_quality quality(const Context& context) const
    {
        cleft_quality found{};
        found.struct_size = sizeof found;
        context.check(cleft_mesh_quality(context.get(), get(), &found));
        return found;
    }
    cleft_metric_quality metric_quality(const Context& context, const Sizing& sizing) const
    {
        cleft_metric_quality found{};
        found.struct_size = sizeof found;
        context.check(cleft_mesh_metric_quality(context.get(), get(), sizing.get(), &found));
        return found;
    }
    Validation validate(const Context& context, bool fills_box = false) const
    {
        Validation found{};
        found.struct_size = sizeof(cleft_validation);
        context.check(cleft_mesh_validate(context.get(), get(), fills_box, &found));
        found.first_fault = found.valid ? "" : cleft_context_last_error(context.get());
        return found;
    }
};

class Surface : public Owner<cleft_surface, Destroy_surface>
{
public:
    using Owner::Owner;

    Surface(const Context& context, const Mesh& mesh)
        : Owner(made<Surface, cleft_surface>(
              context, [&](cleft_surface** out) { return cleft_surface_create(context.get(), mesh.get(), out); }))
    {
    }
    /** Three corners and two labels per interface triangle. */
    View<int32_t> triangles() const { return {cleft_surface_interface_triangles(get()), 3 * count()}; }
    View<int32_t> labels() const { return {cleft_surface_interface_labels(get()), 2 * count()}; }
    /** Three corners, one label and one CLEFT_SIDE_... per hull triangle. */
    View<int32_t> hull_triangles() const { return {cleft_surface_hull_triangles(get()), 3 * hull_count()}; }
    View<int32_t> hull_labels() const { return {cleft_surface_hull_labels(get()), hull_count()}; }
    View<int32_t> hull_sides() const { return {cleft_surface_hull_sides(get()), hull_count()}; }

private:
    int64_t count() const noexcept { return cleft_surface_interface_count(get()); }
    int64_t hull_count() const noexcept { return cleft_surface_hull_count(get()); }
};

class Report : public Owner<cleft_report, Destroy_report>
{
public:
    using Owner::Owner;

    Report(const Context& context, const Volume& volume, const Mesh& mesh)
        : Owner(made<Report, cleft_report>(context, [&](cleft_report** out) {
              return cleft_report_create(context.get(), volume.get(), mesh.get(), out);
          }))
    {
    }
    /** One row per label, in the order of Volume::labels(). */
    std::vector<cleft_label_report> rows() const
    {
        std::vector<cleft_label_report> rows(static_cast<std::size_t>(cleft_report_count(get())));
        for (std::size_t i = 0; i < rows.size(); ++i) {
            rows[i].struct_size = sizeof rows[i];
            check(cleft_report_label(get(), static_cast<int64_t>(i), &rows[i]));
        }
        return rows;
    }
};

}  // namespace cpp
}  // namespace cleft

#endif
