// The C++ header: handles that own, exceptions, callbacks, arrays.
#include "cleft/cleft.hpp"
#include "support/cmocka.hpp"

#include <cmath>
#include <cstring>
#include <type_traits>

namespace
{

constexpr int N = 10;
constexpr int32_t kBall = -1, kRest = 2;

cleft::Volume ball(const cleft::Context& context)
{
    std::vector<int32_t> voxels(N * N * N, kRest);
    for (int v = 0; v < N * N * N; ++v) {
        const double x = v % N - 4.5, y = v / N % N - 4.5, z = v / (N * N) - 4.5;
        if (x * x + y * y + z * z < 12)
            voxels[static_cast<size_t>(v)] = kBall;
    }
    return cleft::Volume::from_labels(context, voxels.data(), {N, N, N});
}

cleft::Options coarse()
{
    cleft::Options options;
    options.set("background", "lattice").set_real(CLEFT_OPTION_SIZE_MIN, 2);
    return options;
}

template <class Thrown, class Body>
std::string thrown_by(const Body& body)
{
    try {
        body();
    } catch (const Thrown& error) {
        return error.what();
    }
    return "nothing was thrown";
}

static_assert(!std::is_copy_constructible<cleft::Mesh>::value && std::is_move_constructible<cleft::Mesh>::value &&
                  std::is_move_assignable<cleft::Context>::value &&
                  std::is_base_of<std::runtime_error, cleft::Error>::value,
              "handles are owned by one, and errors are runtime errors");

void a_volume_becomes_a_mesh_by_stages_and_at_once(void**)
{
    const cleft::Context context;
    cleft::Volume volume = ball(context);
    volume.set_label_name(kBall, "ball");
    assert_int_equal(volume.dims()[2], N);
    assert_int_equal(volume.labels().size(), 2);
    assert_int_equal(volume.labels()[0], kBall);
    assert_int_equal(volume.voxel_counts()[0] + volume.voxel_counts()[1], N * N * N);
    assert_int_equal(volume.label_at({5, 5, 5}), kBall);

    const cleft::Options options = coarse();
    const cleft::Sizing sizing = cleft::Sizing::constant(context, volume, 2);
    assert_true(sizing.at({1, 1, 1}) == 2 && sizing.values().size() == N * N * N);
    const cleft::Mesh background = cleft::Mesh::background(context, sizing, options);
    const cleft::Mesh stages = background.cleaved(context, volume, options).improved(context, volume, options);
    const cleft::Mesh whole = cleft::Mesh::of_volume(context, volume, options, &sizing);
    for (const cleft::Mesh* mesh : {&stages, &whole}) {
        assert_int_equal(mesh->validate(context, true).valid, 1);
        assert_string_equal(mesh->label_name(kBall).c_str(), "ball");
        assert_int_equal(mesh->tets().size(), 4 * mesh->tet_labels().size());
        assert_int_equal(mesh->quality(context).tet_count, static_cast<int64_t>(mesh->tet_labels().size()));
        const cleft::Surface surface(context, *mesh);
        assert_int_equal(surface.triangles().size() / 3, mesh->validate(context).interface_triangles);
        for (size_t i = 0; i < surface.labels().size(); ++i)
            assert_int_equal(surface.labels()[i], i % 2 ? kRest : kBall);
        assert_int_equal(surface.hull_sides().size(), surface.hull_labels().size());
        const cleft::Report report(context, volume, *mesh);
        assert_int_equal(report.rows().size(), 2);
        assert_int_equal(report.rows()[0].label, kBall);
    }
    cleft::Options strip;
    strip.set_strip({kRest});
    assert_int_equal(whole.stripped(context, strip).labels().size(), 1);
    assert_false(context.metrics().empty());
}

void arrays_and_indicators_come_in(void**)
{
    const cleft::Context context;
    const cleft::Mesh mesh =
        cleft::Mesh::from_arrays(context, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 1, 2, 3}, {INT32_MIN});
    assert_int_equal(mesh.labels()[0], INT32_MIN);
    assert_true(mesh.points().copy().back() == 1);
    assert_string_equal(mesh.validate(context).first_fault.c_str(), "");
    assert_string_not_equal(mesh.validate(context, true).first_fault.c_str(), "");
    const std::vector<float> function = {-1, 1};
    const cleft::Affine affine = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0};
    const cleft::Volume volume =
        cleft::Volume::from_indicators<float>(context, {function.data()}, {2, 1, 1}, &affine, {7, -7});
    assert_int_equal(volume.labels()[1], -7);
    assert_true(volume.affine() == affine);
    thrown_by<cleft::Error>([&] {
        cleft::Volume::from_indicators<float>(context, {function.data()}, {2, 1, 1}, nullptr, {7});
    });
}

void metrics_come_in_and_go_out(void**)
{
    const cleft::Context context;
    const cleft::Volume volume = ball(context);
    std::vector<double> tensors;
    for (int v = 0; v < N * N * N; ++v)
        for (const double entry : {0.25, 0.01, -0.02, 0.2 + 0.01 * (v % N), 0.03, 1.0})
            tensors.push_back(entry);
    const cleft::Sizing sizing = cleft::Sizing::from_metric(context, volume, tensors.data());
    assert_true(sizing.has_metric());
    const std::vector<float> back = sizing.metric();
    assert_int_equal(back.size(), tensors.size());
    for (size_t i = 0; i < back.size(); ++i)
        assert_true(std::abs(static_cast<double>(back[i]) - tensors[i]) < 1e-5);
    const cleft::Sizing flat = cleft::Sizing::constant_metric(context, volume, {{1.0 / 9, 0, 0, 1.0 / 9, 0, 1}});
    assert_true(flat.has_metric() && std::abs(static_cast<double>(flat.metric().back()) - 1) < 1e-6);
    const cleft::Mesh mesh = cleft::Mesh::of_volume(context, volume, coarse(), &flat);
    assert_int_equal(mesh.validate(context, true).valid, 1);
    const cleft_metric_quality quality = mesh.metric_quality(context, flat);
    assert_int_equal(quality.tet_count, mesh.tet_labels().size());
    assert_true(quality.edge_least > 0 && quality.edge_least < 1 && quality.edge_greatest > 1);
    const cleft::Sizing plain = cleft::Sizing::constant(context, volume, 2);
    assert_false(plain.has_metric());
    assert_string_not_equal(thrown_by<cleft::Error>([&] { plain.metric(); }).c_str(), "nothing was thrown");
    tensors[0] = -1;
    assert_non_null(
        strstr(thrown_by<cleft::Error>([&] { cleft::Sizing::from_metric(context, volume, tensors.data()); }).c_str(),
               "voxel"));
}

void failures_are_thrown_with_status_and_sentence(void**)
{
    const cleft::Context context;
    const cleft::Volume volume = ball(context);
    try {
        cleft::Sizing::constant(context, volume, -1);
        fail();
    } catch (const cleft::Error& error) {
        assert_int_equal(error.status(), CLEFT_ERROR_ARGUMENT);
        assert_string_equal(error.what(), cleft_context_last_error(context.get()));
    }
    assert_non_null(
        strstr(thrown_by<std::runtime_error>([] { cleft::Options().set("size_min", "wide"); }).c_str(), "wide"));
    assert_string_equal(thrown_by<cleft::Error>([&] { ball(context).set_label_name(99, "none"); }).c_str(),
                        cleft_status_string(CLEFT_ERROR_ARGUMENT));
    assert_non_null(strstr(thrown_by<cleft::Error>([&] {
                               cleft::Mesh::from_arrays(context, {0, 0}, {});
                           }).c_str(),
                           "threes"));
}

void callbacks_are_functions_and_their_exceptions_come_out(void**)
{
    cleft::Context first;
    bool stop = false;
    first.set_progress([&](double, const char*) { return !stop; });
    cleft::Context context = std::move(first);  // what it calls moves along
    const cleft::Volume volume = ball(context);
    const cleft::Options options = coarse();
    stop = true;
    try {
        cleft::Mesh::of_volume(context, volume, options);
        fail();
    } catch (const cleft::Error& error) {
        assert_int_equal(error.status(), CLEFT_ERROR_CANCELLED);
    }
    context.set_progress([](double, const char* stage) -> bool { throw std::logic_error(stage); });
    assert_non_null(
        strstr(thrown_by<std::logic_error>([&] { cleft::Mesh::of_volume(context, volume, options); }).c_str(), "i"));
    context.set_progress(nullptr);
    std::vector<std::string> sentences;
    context.set_log([&](int32_t, const char* sentence) { sentences.push_back(sentence); });
    context.check(cleft_context_log(context.get(), CLEFT_LOG_INFO, "heard"));
    assert_string_equal(sentences.at(0).c_str(), "heard");
    cleft::Mesh mesh = cleft::Mesh::of_volume(context, volume, options);
    context.set_log([](int32_t, const char* sentence) { throw std::logic_error(sentence); });
    assert_string_equal(thrown_by<std::logic_error>([&] {
                            context.check(cleft_context_log(context.get(), CLEFT_LOG_INFO, "thrown"));
                        }).c_str(),
                        "thrown");
    const cleft::Mesh other(mesh.release());
    assert_null(mesh.get());
    assert_true(other.tets().size() > 0);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(a_volume_becomes_a_mesh_by_stages_and_at_once),
        cmocka_unit_test(arrays_and_indicators_come_in),
        cmocka_unit_test(metrics_come_in_and_go_out),
        cmocka_unit_test(failures_are_thrown_with_status_and_sentence),
        cmocka_unit_test(callbacks_are_functions_and_their_exceptions_come_out),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
