// Makes the volume of a case, meshes it in the case's way, and looks at each mesh that comes back.
#include "storm/trial.hpp"

#include "storm/mesh_checker.hpp"
#include "storm/parts_checker.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace storm
{

namespace
{

constexpr double kMostTets = 40000, kMostOfAll = 400000;  // where the library is not asked to keep to max_tets

// A user-supplied background, as arrays.
struct Arrays {
    std::vector<double> points;
    std::vector<int32_t> tets;
};

// What is done to a background before it is given back.
enum class Tampering { none, holes, shift, repeat, turn, count };

bool makes_invalid(Tampering tampering) { return tampering == Tampering::repeat || tampering == Tampering::turn; }

void tamper(Arrays& arrays, Tampering tampering, double size)
{
    switch (tampering) {
        case Tampering::holes:
            for (size_t t = 0; t < arrays.tets.size() / 4; t += 7)
                for (size_t i = 0; i < 4; ++i)
                    arrays.tets[4 * t + i] = arrays.tets[arrays.tets.size() - 4 + i];
            for (size_t t = arrays.tets.size() / 4; t-- > 0;)
                if (t % 7 == 0)
                    arrays.tets.erase(arrays.tets.begin() + static_cast<int64_t>(4 * t),
                                      arrays.tets.begin() + static_cast<int64_t>(4 * t + 4));
            break;
        case Tampering::shift:
            for (double& x : arrays.points)
                x += 0.3 * size;
            break;
        case Tampering::repeat:
            for (size_t i = 0; i < 4; ++i)
                arrays.tets.push_back(arrays.tets[i]);
            break;
        case Tampering::turn:
            std::swap(arrays.tets[2], arrays.tets[3]);
            break;
        default:
            break;
    }
}

class Trial
{
public:
    explicit Trial(const Case& given) : case_(given)
    {
        if (cleft_context_create(&context_) != CLEFT_OK || cleft_options_create(&options_) != CLEFT_OK)
            std::abort();
        tampering_ =
            static_cast<Tampering>(static_cast<size_t>(case_.voxel_count()) % static_cast<size_t>(Tampering::count));
    }
    ~Trial()
    {
        for (cleft_mesh* mesh : meshes_)
            cleft_mesh_destroy(mesh);
        cleft_sizing_destroy(sizing_);
        cleft_volume_destroy(volume_);
        cleft_options_destroy(options_);
        cleft_context_destroy(context_);
    }
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    Outcome run()
    {
        Outcome outcome;
        outcome.status = status_of_all();
        outcome.sentence = cleft_context_last_error(context_);
        outcome.tets = meshes_.empty() ? 0 : cleft_mesh_tet_count(meshes_.back());
        outcome.fault = fault_;
        if (!fault_.empty())
            return outcome;
        const bool is_invalid = case_.way == Way::background && makes_invalid(tampering_);
        if (outcome.status == CLEFT_OK && is_invalid && was_tampered_)
            outcome.fault = "an invalid background was taken";
        else if (outcome.status != CLEFT_OK && !is_documented(outcome.status))
            outcome.fault = "status " + std::to_string(outcome.status) + " is not one that is documented for this";
        else if (outcome.status != CLEFT_OK && outcome.status != CLEFT_ERROR_OPTION && !left_out_ &&
                 outcome.sentence.empty())
            outcome.fault = "there is no sentence about the failure";
        return outcome;
    }

private:
    bool is_documented(cleft_status status) const
    {
        switch (status) {
            case CLEFT_ERROR_ARGUMENT:
            case CLEFT_ERROR_NOT_FINITE:
            case CLEFT_ERROR_TOO_LARGE:
            case CLEFT_ERROR_OPTION:
            case CLEFT_ERROR_LABEL_LOST:
                return true;
            case CLEFT_ERROR_INVALID_MESH:
                return was_tampered_ && makes_invalid(tampering_);
            case CLEFT_ERROR_CANCELLED:
                return case_.cancel_at > 0;
            default:
                return false;
        }
    }

    cleft_status status_of_all()
    {
        cleft_status status = cleft_context_set_threads(context_, case_.threads);
        if (status == CLEFT_OK && case_.cancel_at > 0 && case_.way != Way::parts)
            status = cleft_context_set_progress(context_, cancel_in_time, this);
        if (status == CLEFT_OK)
            status = set_options();
        if (status == CLEFT_OK)
            status = make_volume();
        if (status != CLEFT_OK)
            return status;
        switch (case_.way) {
            case Way::sizing:
                return mesh_by_own_sizes();
            case Way::background:
                return mesh_by_own_background();
            case Way::metric:
                return mesh_by_own_metric();
            case Way::stages:
                return mesh_by_stages();
            case Way::parts:
                return mesh_by_parts();
            default:
                return mesh_whole();
        }
    }

    static int cancel_in_time(double, const char*, void* user)
    {
        Trial& trial = *static_cast<Trial*>(user);
        return ++trial.calls_ == trial.case_.cancel_at;
    }

    cleft_status set_options()
    {
        for (const auto& [name, value] : case_.options)
            if (const cleft_status status = cleft_options_set_text(options_, name.c_str(), value.c_str()))
                return status;
        for (const auto& [label, size] : case_.label_sizes)
            if (const cleft_status status = cleft_options_set_label_size(options_, label, size))
                return status;
        if (const cleft_status status =
                cleft_options_set_only(options_, case_.only.data(), static_cast<int64_t>(case_.only.size())))
            return status;
        return cleft_options_set_strip(options_, case_.strip.data(), static_cast<int64_t>(case_.strip.size()));
    }

    cleft_status make_volume()
    {
        if (case_.functions.empty())
            return cleft_volume_create_labels(context_, case_.type, case_.labels.data(), case_.dims.data(),
                                              case_.affine.data(), options_, &volume_);
        std::vector<const void*> fields;
        for (const auto& function : case_.functions)
            fields.push_back(function.data());
        return cleft_volume_create_indicators(context_, CLEFT_TYPE_FLOAT32, fields.data(),
                                              static_cast<int64_t>(fields.size()), case_.dims.data(),
                                              case_.affine.data(), nullptr, &volume_);
    }

    // Sizes that are asked for are taken as they are, whatever max_tets is, and a lattice has the least everywhere.
    bool asks_for_too_much()
    {
        if (cleft_sizing_create(context_, volume_, options_, &sizing_) != CLEFT_OK)
            return false;  // meshing says why
        int64_t dims[3];
        double affine[12];
        if (cleft_sizing_dims(sizing_, dims) != CLEFT_OK || cleft_sizing_affine(sizing_, affine) != CLEFT_OK)
            std::abort();
        const float* sizes = cleft_sizing_values(sizing_);
        const double least = double{*std::min_element(sizes, sizes + dims[0] * dims[1] * dims[2])};
        double box = 1;
        for (size_t axis = 0; axis < 3; ++axis)
            box *= static_cast<double>(dims[axis]) * std::hypot(affine[axis], affine[4 + axis], affine[8 + axis]);
        constexpr double kTetsACube = 12;
        return std::max(cleft_sizing_expected_tets(sizing_), kTetsACube * box / (least * least * least)) > kMostOfAll;
    }

    cleft_status mesh_whole()
    {
        const bool has_sizes = std::any_of(case_.options.begin(), case_.options.end(), [](const auto& option) {
            return option.first == "interface_size" || option.first == "size_min" || option.first == "size";
        });
        if ((has_sizes || !case_.label_sizes.empty()) && asks_for_too_much())
            return left_out();
        return checked(cleft_mesh_volume(context_, volume_, nullptr, nullptr, options_, next()), kept_box());
    }

    cleft_status mesh_by_parts()
    {
        const cleft_status status = mesh_whole();
        const std::string sentence = cleft_context_last_error(context_);
        if (status == CLEFT_OK && fault_.empty())
            fault_ = validated(meshes_.back());
        if (!left_out_ && fault_.empty())
            fault_ = fault_of_parts(case_, options_, {status, sentence, meshes_.back()});
        return status;
    }

    // By the library; that it fills the box was judged already. Far from the origin, rounding may flatten tetrahedra.
    std::string validated(const cleft_mesh* mesh)
    {
        constexpr double kFar = 1e9;  // voxels
        const double spacing = std::hypot(case_.affine[0], case_.affine[4], case_.affine[8]);
        if (std::hypot(case_.affine[3], case_.affine[7], case_.affine[11]) > kFar * spacing)
            return "";
        cleft_validation found{};
        found.struct_size = sizeof found;
        const cleft_status status = cleft_mesh_validate(context_, mesh, 0, &found);
        return status == CLEFT_OK && found.valid == 1 ? "" : cleft_context_last_error(context_);
    }

    cleft_status mesh_by_own_sizes()
    {
        if (const cleft_status status = cleft_sizing_create_values(context_, volume_, CLEFT_TYPE_FLOAT64,
                                                                   case_.sizes.data(), 0, options_, &sizing_))
            return status;
        const double expected = cleft_sizing_expected_tets(sizing_);
        if (!(expected > 0 && expected < 1e300))
            fault_ = "the expected number of tetrahedra is " + std::to_string(expected);
        // User-supplied sizes are taken as they are, and may well ask for a mesh that takes an hour.
        if (expected > kMostTets)
            return left_out();
        return checked(cleft_mesh_volume(context_, volume_, sizing_, nullptr, options_, next()), kept_box());
    }

    // Of the storm's own accord.
    cleft_status left_out()
    {
        left_out_ = true;
        return CLEFT_ERROR_TOO_LARGE;
    }

    cleft_status mesh_by_own_metric()
    {
        const double* tensors = case_.tensors.data();
        const cleft_status status = case_.tensors.size() == 6
                                        ? cleft_sizing_create_constant_metric(context_, volume_, tensors, &sizing_)
                                        : cleft_sizing_create_metric(context_, volume_, CLEFT_TYPE_FLOAT64, tensors,
                                                                     case_.is_combined, options_, &sizing_);
        if (status != CLEFT_OK)
            return status;
        if (cleft_sizing_has_metric(sizing_) != 1)
            fault_ = "the sizing field has no metric";
        if (cleft_sizing_expected_tets(sizing_) > kMostTets)
            return left_out();
        if (case_.is_staged)
            return mesh_on(background_of_sizing());
        return checked(cleft_mesh_volume(context_, volume_, sizing_, nullptr, options_, next()), kept_box());
    }

    cleft_status make_background()
    {
        if (const cleft_status status = cleft_sizing_create_constant(context_, volume_, case_.constant_size, &sizing_))
            return status;
        if (cleft_sizing_expected_tets(sizing_) > kMostTets)
            return left_out();
        return background_of_sizing();
    }

    cleft_status background_of_sizing()
    {
        Expectation plain = whole_box();
        plain.labels = {0};
        return checked(cleft_background_create(context_, sizing_, options_, next()), plain);
    }

    cleft_status mesh_by_own_background()
    {
        if (const cleft_status status = make_background())
            return status;
        if (!fault_.empty())
            return CLEFT_OK;
        const cleft_mesh* made = meshes_.back();
        Arrays arrays;
        arrays.points.assign(cleft_mesh_points(made), cleft_mesh_points(made) + 3 * cleft_mesh_point_count(made));
        arrays.tets.assign(cleft_mesh_tets(made), cleft_mesh_tets(made) + 4 * cleft_mesh_tet_count(made));
        tamper(arrays, tampering_, case_.constant_size);
        was_tampered_ = true;
        if (const cleft_status status =
                cleft_mesh_create(context_, static_cast<int64_t>(arrays.points.size() / 3), arrays.points.data(),
                                  static_cast<int64_t>(arrays.tets.size() / 4), arrays.tets.data(), nullptr, 0, next()))
            return status;
        Expectation kept = kept_box();
        kept.fills_box = kept.fills_box && tampering_ == Tampering::none;
        const cleft_mesh* given = meshes_.back();
        return checked(cleft_mesh_volume(context_, volume_, nullptr, given, options_, next()), kept);
    }

    cleft_status mesh_by_stages() { return mesh_on(make_background()); }

    // The stages after the background, whose status is given.
    cleft_status mesh_on(cleft_status status)
    {
        if (status == CLEFT_OK)
            status = checked(cleft_mesh_cleave(context_, volume_, previous(), options_, next()), whole_box());
        if (status == CLEFT_OK)
            status = checked(cleft_mesh_improve(context_, volume_, previous(), options_, next()), whole_box());
        if (status == CLEFT_OK && !case_.strip.empty())
            status = checked(cleft_mesh_strip(context_, previous(), options_, next()), kept_box());
        return status;
    }

    // A place for the next mesh, behind the one before.
    cleft_mesh** next()
    {
        meshes_.push_back(nullptr);
        return &meshes_.back();
    }
    // The mesh before the one that is being made: evaluated before or after next(), it is the last that there is.
    const cleft_mesh* previous() const
    {
        for (size_t i = meshes_.size(); i-- > 0;)
            if (meshes_[i])
                return meshes_[i];
        return nullptr;
    }

    cleft_status checked(cleft_status status, const Expectation& expected)
    {
        if (status == CLEFT_OK && fault_.empty())
            fault_ = fault_of(meshes_.back(), expected);
        else if (status != CLEFT_OK && meshes_.back())
            fault_ = "a call that failed gave a mesh";
        return status;
    }

    Expectation whole_box() const
    {
        Expectation expected;
        const int32_t* labels = cleft_volume_labels(volume_);
        expected.labels.assign(labels, labels + cleft_volume_label_count(volume_));
        for (size_t corner = 0; corner < 8; ++corner)
            for (size_t row = 0; row < 3; ++row) {
                double x = case_.affine[4 * row + 3];
                for (size_t axis = 0; axis < 3; ++axis) {
                    const double end = (corner >> axis & 1) ? static_cast<double>(case_.dims[axis]) - 0.5 : -0.5;
                    x += case_.affine[4 * row + axis] * end;
                }
                expected.box[corner][row] = x;
            }
        return expected;
    }

    Expectation kept_box() const
    {
        Expectation expected = whole_box();
        expected.fills_box = case_.strip.empty() && case_.only.empty();
        return expected;
    }

    const Case& case_;
    Tampering tampering_ = Tampering::none;
    bool was_tampered_ = false;
    bool left_out_ = false;
    int64_t calls_ = 0;
    std::string fault_;
    cleft_context* context_ = nullptr;
    cleft_options* options_ = nullptr;
    cleft_volume* volume_ = nullptr;
    cleft_sizing* sizing_ = nullptr;
    std::vector<cleft_mesh*> meshes_;  // all that were made, in their order
};

}  // namespace

Outcome run(const Case& drawn) { return Trial(drawn).run(); }

}  // namespace storm
