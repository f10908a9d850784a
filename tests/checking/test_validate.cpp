// Meshes with one fault made on purpose: the validation finds it, counts it and says where it is.
#include "base/ordinal.hpp"
#include "checking/validate.hpp"

#include "mesh/strip.hpp"
#include "support/cmocka.hpp"
#include "support/meshes.hpp"
#include "support/near.hpp"

#include <iterator>
#include <limits>

using namespace cleft;
using namespace cleft_test;

namespace
{

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Validation check(const LabelledMesh& mesh, bool fills_box = true)
{
    const Run run;
    return validate(mesh, fills_box, run);
}

Array<int64_t> counts(const Validation& v)
{
    return {v.bad_index,
            v.repeated_corner,
            v.negative,
            v.flat,
            v.hull_faces,
            v.shared_faces,
            v.crowded_faces,
            v.folded_faces,
            v.hull_off_box,
            v.interface_faces,
            v.open_interface_edges,
            v.non_finite,
            v.unused_points,
            v.repeated_points};
}

bool says(const Validation& v, const std::string& words) { return v.first_fault.find(words) != std::string::npos; }

void each_fault_is_found_and_named(void**)
{
    for (const MeshCase& c : mesh_cases()) {
        const Validation v = check(c.mesh);
        if (c.fault.empty() ? !v.valid() : !says(v, c.fault))
            print_message("%s: \"%s\"\n", c.name.c_str(), v.first_fault.c_str());
        assert_true(c.fault.empty() ? v.valid() : says(v, c.fault));
    }
}

void good_meshes_have_the_measures_of_their_box(void**)
{
    const Validation v = check(good_mesh(2));
    assert_true(v.valid());
    assert_true(near(v.box_volume, 6, 1e-12));
    assert_true(near(v.volume, 6, 1e-12));
    assert_true(near(v.box_area, 22, 1e-12));
    assert_true(near(v.hull_area, 22, 1e-12));
    assert_int_equal(v.hull_faces, 2 * 2 * (6 * 4 + 4 * 3 + 3 * 6));
    assert_true(v.interface_faces > 0);
}

void things_are_counted_from_the_first(void**)
{
    const char* const words[] = {"1st", "2nd", "3rd", "4th", "11th", "12th", "13th", "21st", "111th", "122nd"};
    const int64_t indices[] = {0, 1, 2, 3, 10, 11, 12, 20, 110, 121};
    for (size_t i = 0; i < std::size(words); ++i)
        assert_string_equal(ordinal(indices[i]).c_str(), words[i]);
    const int32_t dims[3] = {4, 3, 2};
    assert_string_equal(voxel_in_words(4 * (3 * 1 + 2) + 3, dims).c_str(),
                        "the voxel that is the 4th along x, the 3rd along y and the 2nd along z");
}

void the_place_of_a_fault_is_told(void**)
{
    LabelledMesh mesh = good_mesh(1);
    std::swap(mesh.tets[40][0], mesh.tets[40][1]);
    const Validation v = check(mesh);
    assert_true(says(v, "the 41st tetrahedron at ("));
    mesh = good_mesh(1);
    mesh.points.push_back(Vec3(0.25, 1.5, 0.5));
    const std::string last = std::to_string(mesh.points.size());
    assert_string_equal(check(mesh).first_fault.c_str(),
                        ("the " + last + "th point at (0.25, 1.5, 0.5) is in no tetrahedron").c_str());
}

Validation check_case(const std::string& name)
{
    const Array<MeshCase> cases = mesh_cases();
    const auto found = std::find_if(cases.begin(), cases.end(), [&](const MeshCase& c) { return c.name == name; });
    return check(found->mesh);
}

void each_break_counts_where_it_should(void**)
{
    assert_int_equal(check_case("inverted").negative, 1);
    assert_int_equal(check_case("inner_hole").hull_off_box, 4);
    assert_int_equal(check_case("notch").hull_off_box, 3);
    assert_int_equal(check_case("t_junction").hull_off_box, 6);
    assert_true(near(check_case("t_junction").volume, 6, 1e-12));
    assert_int_equal(check_case("repeated_point").repeated_points, 1);
    assert_int_equal(check_case("repeated_point").hull_off_box, 6);
    assert_int_equal(check_case("crowded").crowded_faces, 1);
    assert_int_equal(check_case("flat").flat, 1);
    assert_int_equal(check_case("repeated_corner").repeated_corner, 1);
    assert_int_equal(check_case("several").unused_points, 2);
    assert_true(check_case("folded").folded_faces > 0);
    assert_true(check_case("folded").volume > 6.001);
}

void a_crack_along_an_interface_leaves_open_edges(void**)
{
    LabelledMesh mesh = good_mesh(1);
    const size_t t = inner_tet(mesh);
    mesh.material[t] = 1;
    assert_int_equal(check(mesh).interface_faces, 4);
    assert_int_equal(check(mesh).open_interface_edges, 0);
    // With a corner of its own, the tetrahedron shares only the face opposite.
    mesh.points.push_back(mesh.points[mesh.tets[t][0]]);
    mesh.tets[t][0] = static_cast<int32_t>(mesh.points.size()) - 1;
    assert_int_equal(check(mesh).interface_faces, 1);
    assert_int_equal(check(mesh).open_interface_edges, 3);
}

void bad_numbers_never_crash(void**)
{
    for (const int32_t bad : {-1, INT32_MIN, INT32_MAX, 1000000}) {
        LabelledMesh mesh = good_mesh(3);
        mesh.tets[7][2] = bad;
        const Validation v = check(mesh);
        assert_int_equal(v.bad_index, 1);
        assert_true(says(v, "the 8th tetrahedron names a point that is not among"));
    }
    for (const double bad : {kNan, HUGE_VAL, -HUGE_VAL}) {
        LabelledMesh mesh = good_mesh(3);
        mesh.points[mesh.tets[7][2]][1] = bad;
        const Validation v = check(mesh);
        assert_int_equal(v.non_finite, 1);
        assert_true(says(v, "is not finite"));
    }
    LabelledMesh mesh = good_mesh(3);
    for (Tet& tet : mesh.tets)
        tet = {-5, 3, 1 << 30, 0};
    assert_int_equal(check(mesh).bad_index, mesh.tets.size());
    mesh = good_mesh(3);
    mesh.material.pop_back();
    assert_true(says(check(mesh), "but a material for"));
    mesh = good_mesh(3);
    for (Vec3& x : mesh.points)
        x *= 1e308;
    assert_false(check(mesh).valid());
    assert_false(check(LabelledMesh()).valid());
    assert_false(check(LabelledMesh(), false).valid());
}

void random_nonsense_never_crashes(void**)
{
    Random random(3);
    for (int round = 0; round < 300; ++round) {
        LabelledMesh mesh;
        const uint64_t points = random.below(12);
        for (uint64_t p = 0; p < points; ++p)
            mesh.points.push_back(Vec3(random.unit(), std::floor(3 * random.unit()), 0.5));
        for (uint64_t t = random.below(30); t > 0; --t) {
            Tet tet;
            for (int32_t& corner : tet)
                corner = static_cast<int32_t>(random.below(points + 2)) - 1;
            mesh.tets.push_back(tet);
            mesh.material.push_back(static_cast<int32_t>(random.below(3)));
        }
        const Validation v = check(mesh, round % 2 == 0);
        assert_false(v.valid());
    }
}

void a_stripped_mesh_is_valid_without_its_box(void**)
{
    LabelledMesh mesh = good_mesh(2);
    strip(mesh.points, mesh.tets, mesh.material, [](int32_t m) { return m == 0; });
    assert_true(check(mesh, false).valid());
    assert_false(check(mesh, true).valid());
}

// The counts do not depend on how points, tetrahedra and corners are numbered.
void numbering_does_not_matter(void**)
{
    Random random(11);
    for (const MeshCase& c : mesh_cases()) {
        const LabelledMesh shuffled = renumbered(c.mesh, random);
        assert_true(counts(check(shuffled)) == counts(check(c.mesh)));
        assert_true(check(shuffled).valid() == check(c.mesh).valid());
    }
}

void one_and_two_threads_give_the_same(void**)
{
    LabelledMesh mesh = good_mesh(4, Vec3(3, 2, 1), {18, 12, 9});
    make_t_junction(mesh);
    std::swap(mesh.tets[400][0], mesh.tets[400][1]);
    Run one, two;
    two.threads = 2;
    const Validation a = validate(mesh, true, one), b = validate(mesh, true, two);
    assert_true(counts(a) == counts(b));
    assert_true(a.first_fault == b.first_fault);
    assert_true(a.volume == b.volume && a.hull_area == b.hull_area);
}

void a_cancel_is_seen(void**)
{
    const std::atomic<bool> cancel{true};
    Run run;
    run.cancel = &cancel;
    bool cancelled = false;
    try {
        validate(good_mesh(1), true, run);
    } catch (const Error& error) {
        cancelled = error.status() == CLEFT_ERROR_CANCELLED;
    }
    assert_true(cancelled);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(each_fault_is_found_and_named),
        cmocka_unit_test(good_meshes_have_the_measures_of_their_box),
        cmocka_unit_test(things_are_counted_from_the_first),
        cmocka_unit_test(the_place_of_a_fault_is_told),
        cmocka_unit_test(each_break_counts_where_it_should),
        cmocka_unit_test(a_crack_along_an_interface_leaves_open_edges),
        cmocka_unit_test(bad_numbers_never_crash),
        cmocka_unit_test(random_nonsense_never_crashes),
        cmocka_unit_test(a_stripped_mesh_is_valid_without_its_box),
        cmocka_unit_test(numbering_does_not_matter),
        cmocka_unit_test(one_and_two_threads_give_the_same),
        cmocka_unit_test(a_cancel_is_seen),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
