// Files of the C interface when something fails while they are written: there is the whole new file, or what was there
// before, and nothing beside.
#include "cleft/cleft_io.h"

#include <csetjmp>
#include <csignal>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include <pthread.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <set>
#include <string>

extern "C" {
#include <cmocka.h>  // last: it has a macro called fail
}

namespace fs = std::filesystem;

// Each allocation counts down, and that at 0 fails.
static long allocations_left = -1;

void* operator new(std::size_t size)
{
    if (allocations_left >= 0 && allocations_left-- == 0)
        throw std::bad_alloc();
    if (void* got = std::malloc(size))
        return got;
    throw std::bad_alloc();
}
void operator delete(void* given) noexcept { std::free(given); }
void operator delete(void* given, std::size_t) noexcept { std::free(given); }

namespace
{

// A folder of its own, a context and a mesh of two tetrahedra.
struct Fixture {
    fs::path folder;
    cleft_context* context = nullptr;
    cleft_mesh* mesh = nullptr;

    Fixture()
    {
        std::string name = (fs::temp_directory_path() / "cleft-outputs-XXXXXX").string();
        assert_non_null(mkdtemp(name.data()));
        folder = name;
        static const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
        static const int32_t tets[] = {0, 1, 2, 3, 1, 4, 2, 3};
        static const int32_t labels[] = {-1, 7};
        assert_int_equal(cleft_context_create(&context), CLEFT_OK);
        assert_int_equal(cleft_mesh_create(context, 5, points, 2, tets, labels, 0, &mesh), CLEFT_OK);
    }
    ~Fixture()
    {
        cleft_mesh_destroy(mesh);
        cleft_context_destroy(context);
        fs::remove_all(folder);
    }

    // The allocation that fails is one of the library's.
    cleft_status write(const std::string& name, long failing = -1) const
    {
        const std::string path = (folder / name).string();
        allocations_left = failing;
        const cleft_status status = cleft_io_write_mesh(context, mesh, path.c_str(), CLEFT_FORMAT_BY_NAME);
        allocations_left = -1;
        return status;
    }
    std::set<std::string> names() const
    {
        std::set<std::string> all;
        for (const auto& entry : fs::directory_iterator(folder))
            all.insert(entry.path().filename().string());
        return all;
    }
    void put(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
    std::string text(const std::string& name) const
    {
        std::ifstream file(folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
};

using Names = std::set<std::string>;

void assert_old_or_new(const std::string& output, const Names& files)
{
    const Fixture f;
    assert_int_equal(f.write(output), CLEFT_OK);
    std::string whole;
    for (const std::string& name : files)
        whole += f.text(name);
    cleft_status status = CLEFT_ERROR_OUT_OF_MEMORY;
    int failures = 0;
    for (long failing = 0; status != CLEFT_OK; ++failing) {
        for (const std::string& name : files)
            f.put(name, "old");
        status = f.write(output, failing);
        std::string found;
        std::string old;
        for (const std::string& name : files) {
            found += f.text(name);
            old += "old";
        }
        assert_true(status == CLEFT_OK || status == CLEFT_ERROR_OUT_OF_MEMORY);
        assert_true(found == (status == CLEFT_OK ? whole : old));
        assert_true(f.names() == files);
        failures += status != CLEFT_OK;
    }
    assert_true(failures > 10);
}

void want_of_memory_leaves_the_old_files(void**)
{
    for (const char* name : {"a.vtu", "a.vtp", "a.vtk", "a.mesh", "a.msh", "a.inp", "a.stl", "a.ply"})
        assert_old_or_new(name, {name});
    assert_old_or_new("a.node", {"a.node", "a.ele", "a.face"});
}

bool is_pending_or_blocked(int signal)
{
    sigset_t pending;
    sigset_t blocked;
    sigpending(&pending);
    pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
    return sigismember(&pending, signal) == 1 || sigismember(&blocked, signal) == 1;
}

void a_limit_on_files_is_a_status(void**)
{
    const Fixture f;
    f.put("a.vtk", "old");
    std::signal(SIGXFSZ, SIG_DFL);
    rlimit before{};
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{10, before.rlim_max};
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    const cleft_status one = f.write("a.vtk");
    const std::string sentence = cleft_context_last_error(f.context);
    const cleft_status three = f.write("b.node");
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    assert_int_equal(one, CLEFT_ERROR_FILE);
    assert_int_equal(three, CLEFT_ERROR_FILE);
    assert_true(sentence.find("a.vtk': File too large") != std::string::npos);
    assert_false(is_pending_or_blocked(SIGXFSZ));
    assert_string_equal(f.text("a.vtk").c_str(), "old");
    assert_true(f.names() == Names{"a.vtk"});
}

void links_stay_links(void**)
{
    const Fixture f;
    fs::create_symlink("b.vtk", f.folder / "a.vtk");
    fs::create_symlink("c.vtk", f.folder / "b.vtk");
    assert_int_equal(f.write("a.vtk"), CLEFT_OK);
    assert_true(fs::is_regular_file(fs::symlink_status(f.folder / "c.vtk")));
    assert_true(f.names() == (Names{"a.vtk", "b.vtk", "c.vtk"}));
    fs::create_symlink("loop.vtk", f.folder / "loop.vtk");
    assert_int_equal(f.write("loop.vtk"), CLEFT_ERROR_FILE);
    fs::create_symlink("none/x.vtk", f.folder / "astray.vtk");
    assert_int_equal(f.write("astray.vtk"), CLEFT_ERROR_FILE);
}

void names_may_be_as_long_as_names_can_be(void**)
{
    const Fixture f;
    const std::string longest = std::string(251, 'x') + ".vtk";
    const std::string stem(250, 'y');
    assert_int_equal(f.write(longest), CLEFT_OK);
    assert_int_equal(f.write(longest), CLEFT_OK);
    assert_int_equal(f.write(stem + ".ele"), CLEFT_OK);
    assert_int_equal(f.write(stem + ".ele"), CLEFT_OK);
    assert_true(f.names() == (Names{longest, stem + ".node", stem + ".ele", stem + ".face"}));
    assert_int_equal(f.write("x" + longest), CLEFT_ERROR_FILE);
    assert_int_equal(f.write("yy" + stem + ".ele"), CLEFT_ERROR_FILE);
    assert_int_equal(f.names().size(), 4);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(want_of_memory_leaves_the_old_files),
        cmocka_unit_test(a_limit_on_files_is_a_status),
        cmocka_unit_test(links_stay_links),
        cmocka_unit_test(names_may_be_as_long_as_names_can_be),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
