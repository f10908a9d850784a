// What is too large for a part, which no test can make.
#include "base/error.hpp"
#include "mesh/face_buckets.hpp"
#include "parts/mesh_part.hpp"
#include "support/cmocka.hpp"

using namespace cleft;

namespace
{

std::string refusal(int64_t points, int64_t tets)
{
    try {
        check_size_of_part(points, tets);
    } catch (const Error& error) {
        assert_int_equal(error.status(), CLEFT_ERROR_TOO_LARGE);
        return error.what();
    }
    return "";
}

void a_part_has_so_many(void**)
{
    // Numbers of 32 bits number the half-faces, and count them.
    assert_true(4 * kMostTetsOfMesh <= int64_t{UINT32_MAX} && 4 * (kMostTetsOfMesh + 1) > int64_t{UINT32_MAX});
    assert_string_equal(refusal(0, 0).c_str(), "");
    assert_string_equal(refusal(INT32_MAX, kMostTetsOfMesh).c_str(), "");
    assert_string_equal(refusal(1, 1073741824).c_str(),
                        "a part has 1073741824 tetrahedra, with ghosts, and may have at most 1073741823: more ranks "
                        "would share them");
    assert_string_equal(refusal(2147483648, 1).c_str(),
                        "a part has 2147483648 points, with ghosts, and may have at most 2147483647: more ranks would "
                        "share them");
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(a_part_has_so_many)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
