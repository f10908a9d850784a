/* Compares the parts of all ranks, put together, with the mesh of one process. */
#ifndef CLEFT_TESTS_PARTS_COMPARE_PARTS_H
#define CLEFT_TESTS_PARTS_COMPARE_PARTS_H

#include "support/capi.h"
#include "support/part_counts.h"

/* What a rank owns is what the whole mesh has under the same numbers. */
static void assert_same_mesh(const cleft_part* const* parts, int32_t ranks, const cleft_mesh* whole)
{
    int64_t points = 0, tets = 0;
    for (int32_t r = 0; r < ranks; ++r) {
        const cleft_part* part = parts[r];
        const cleft_part_counts n = counts_of(part);
        assert_int_equal(n.all_points, cleft_mesh_point_count(whole));
        assert_int_equal(n.all_tets, cleft_mesh_tet_count(whole));
        assert_int_equal(n.first_point, points);
        assert_int_equal(n.first_tet, tets);
        points += n.owned_points;
        tets += n.owned_tets;
        for (int64_t p = 0; p < n.points; ++p) {
            const int64_t number = cleft_part_point_numbers(part)[p];
            assert_memory_equal(cleft_part_points(part) + 3 * p, cleft_mesh_points(whole) + 3 * number,
                                3 * sizeof(double));
            assert_true(p >= n.owned_points ? cleft_part_point_owners(part)[p] != r : number == n.first_point + p);
            if (p < n.owned_points)
                assert_int_equal(cleft_part_point_owners(part)[p], r);
        }
    }
    assert_int_equal(points, cleft_mesh_point_count(whole));
    assert_int_equal(tets, cleft_mesh_tet_count(whole));
}

typedef struct {
    int64_t corners[3];
    int32_t labels[2], side;
} triangle;

static int compare_triangles(const void* a, const void* b)
{
    const triangle *x = (const triangle*)a, *y = (const triangle*)b;
    for (int c = 0; c < 3; ++c)
        if (x->corners[c] != y->corners[c])
            return x->corners[c] < y->corners[c] ? -1 : 1;
    return 0;
}

static void add_triangle(triangle* all, int64_t* count, const int64_t corners[3], int32_t first, int32_t second,
                         int32_t side)
{
    triangle* out = &all[(*count)++];
    int least = 0;
    memset(out, 0, sizeof *out);
    for (int c = 1; c < 3; ++c)
        least = corners[c] < corners[least] ? c : least;
    for (int c = 0; c < 3; ++c)
        out->corners[c] = corners[(least + c) % 3];
    out->labels[0] = first;
    out->labels[1] = second;
    out->side = side;
}

/* All triangles of the parts are those of the surface of the whole mesh, each once, wound alike. */
static void assert_same_triangles(cleft_context* context, const cleft_part* const* parts, int32_t ranks,
                                  const cleft_mesh* whole)
{
    cleft_surface* surface = NULL;
    assert_ok(context, cleft_surface_create(context, whole, &surface));
    const int64_t interfaces = cleft_surface_interface_count(surface), hull = cleft_surface_hull_count(surface);
    triangle* expected = (triangle*)malloc(sizeof(triangle) * (size_t)(interfaces + hull));
    triangle* found = (triangle*)malloc(sizeof(triangle) * (size_t)(interfaces + hull));
    int64_t wanted = 0, count = 0;
    for (int64_t i = 0; i < interfaces; ++i) {
        const int32_t* c = cleft_surface_interface_triangles(surface) + 3 * i;
        const int64_t corners[3] = {c[0], c[1], c[2]};
        add_triangle(expected, &wanted, corners, cleft_surface_interface_labels(surface)[2 * i],
                     cleft_surface_interface_labels(surface)[2 * i + 1], -1);
    }
    for (int64_t i = 0; i < hull; ++i) {
        const int32_t* c = cleft_surface_hull_triangles(surface) + 3 * i;
        const int64_t corners[3] = {c[0], c[1], c[2]};
        const int32_t label = cleft_surface_hull_labels(surface)[i];
        add_triangle(expected, &wanted, corners, label, label, cleft_surface_hull_sides(surface)[i]);
    }
    for (int32_t r = 0; r < ranks; ++r) {
        const cleft_part_counts n = counts_of(parts[r]);
        assert_int_equal(n.all_triangles, wanted);
        assert_int_equal(n.first_triangle, count);
        for (int64_t i = 0; i < n.triangles; ++i) {
            int64_t corners[3];
            for (int c = 0; c < 3; ++c)
                corners[c] = cleft_part_point_numbers(parts[r])[cleft_part_triangles(parts[r])[3 * i + c]];
            const int32_t* labels = cleft_part_triangle_labels(parts[r]) + 2 * i;
            add_triangle(found, &count, corners, labels[0], labels[1], cleft_part_triangle_sides(parts[r])[i]);
        }
    }
    assert_int_equal(count, wanted);
    qsort(expected, (size_t)wanted, sizeof *expected, compare_triangles);
    qsort(found, (size_t)count, sizeof *found, compare_triangles);
    assert_memory_equal(expected, found, sizeof(triangle) * (size_t)wanted);
    free(expected);
    free(found);
    cleft_surface_destroy(surface);
}

/* The rank that owns a tetrahedron of the whole mesh. */
static int32_t owner_of_tet(const cleft_part* const* parts, int32_t ranks, int64_t number)
{
    for (int32_t r = 0; r < ranks; ++r) {
        const cleft_part_counts n = counts_of(parts[r]);
        if (number >= n.first_tet && number < n.first_tet + n.owned_tets)
            return r;
    }
    return -1;
}

/* Numbers and owners, of ghosts too. Ghosts are as the whole mesh has them. */
static void assert_tets(const cleft_part* const* parts, int32_t ranks, const cleft_mesh* whole)
{
    for (int32_t r = 0; r < ranks; ++r) {
        const cleft_part* part = parts[r];
        const cleft_part_counts n = counts_of(part);
        const int64_t* numbers = cleft_part_tet_numbers(part);
        for (int64_t t = 0; t < n.tets; ++t) {
            const int32_t owner = cleft_part_tet_owners(part)[t];
            assert_int_equal(owner, owner_of_tet(parts, ranks, numbers[t]));
            assert_true(t < n.owned_tets ? owner == r && numbers[t] == n.first_tet + t : owner != r);
            assert_true(t == 0 || t == n.owned_tets || numbers[t - 1] < numbers[t]);
            assert_int_equal(cleft_part_tet_labels(part)[t], cleft_mesh_tet_labels(whole)[numbers[t]]);
            for (int c = 0; c < 4; ++c)
                assert_int_equal(cleft_part_point_numbers(part)[cleft_part_tets(part)[4 * t + c]],
                                 cleft_mesh_tets(whole)[4 * numbers[t] + c]);
        }
    }
}

/* A face that owned tetrahedra have: its corners in order, and the tetrahedron's label and number. */
typedef struct {
    int64_t corners[3], number;
    int32_t label;
} face;

static int compare_faces(const void* a, const void* b)
{
    const face *x = (const face*)a, *y = (const face*)b;
    for (int c = 0; c < 3; ++c)
        if (x->corners[c] != y->corners[c])
            return x->corners[c] < y->corners[c] ? -1 : 1;
    return x->number < y->number ? -1 : x->number > y->number;
}

static face face_of(const int64_t corners[3], int32_t label, int64_t number)
{
    face out = {{corners[0], corners[1], corners[2]}, number, label};
    for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 2; ++d)
            if (out.corners[d] > out.corners[d + 1]) {
                const int64_t greater = out.corners[d];
                out.corners[d] = out.corners[d + 1];
                out.corners[d + 1] = greater;
            }
    return out;
}

/* By corners, and by number for each face. */
static face* faces_of(const cleft_mesh* mesh)
{
    const int64_t tets = cleft_mesh_tet_count(mesh);
    face* out = (face*)malloc(sizeof(face) * (size_t)(4 * tets));
    assert_non_null(out);
    for (int64_t i = 0; i < 4 * tets; ++i) {
        const int32_t* tet = cleft_mesh_tets(mesh) + i / 4 * 4;
        const int64_t corners[3] = {tet[(i + 1) % 4], tet[(i + 2) % 4], tet[(i + 3) % 4]};
        out[i] = face_of(corners, cleft_mesh_tet_labels(mesh)[i / 4], i / 4);
    }
    qsort(out, (size_t)(4 * tets), sizeof *out, compare_faces);
    return out;
}

/* The first tetrahedron at a triangle is one that its part owns. */
static void assert_places_of_triangles(const cleft_part* const* parts, int32_t ranks, const cleft_mesh* whole)
{
    face* faces = faces_of(whole);
    for (int32_t r = 0; r < ranks; ++r) {
        const cleft_part* part = parts[r];
        const cleft_part_counts n = counts_of(part);
        for (int64_t i = 0; i < n.triangles; ++i) {
            int64_t corners[3], below = 0, above = 4 * cleft_mesh_tet_count(whole);
            for (int c = 0; c < 3; ++c)
                corners[c] = cleft_part_point_numbers(part)[cleft_part_triangles(part)[3 * i + c]];
            const face wanted = face_of(corners, 0, -1);
            while (below < above) {
                const int64_t middle = (below + above) / 2;
                if (compare_faces(&faces[middle], &wanted) < 0)
                    below = middle + 1;
                else
                    above = middle;
            }
            const face first = faces[below];
            assert_memory_equal(first.corners, wanted.corners, sizeof wanted.corners);
            assert_true(first.number >= n.first_tet && first.number < n.first_tet + n.owned_tets);
            assert_true(first.label == cleft_part_triangle_labels(part)[2 * i] ||
                        first.label == cleft_part_triangle_labels(part)[2 * i + 1]);
        }
    }
    free(faces);
}

/* With ghosts, a part has all tetrahedra at its own points. */
static void assert_ghosts(const cleft_part* const* parts, int32_t ranks, const cleft_mesh* whole)
{
    for (int32_t r = 0; r < ranks; ++r) {
        const cleft_part_counts n = counts_of(parts[r]);
        int64_t at_owned = 0;
        for (int64_t t = 0; t < cleft_mesh_tet_count(whole); ++t) {
            int touches = 0;
            for (int c = 0; c < 4; ++c) {
                const int64_t p = cleft_mesh_tets(whole)[4 * t + c];
                touches |= p >= n.first_point && p < n.first_point + n.owned_points;
            }
            at_owned += touches;
        }
        assert_int_equal(n.tets, at_owned);
    }
}

/* All of it. `parts` by rank. */
static void assert_parts_of(cleft_context* context, const cleft_part* const* parts, int32_t ranks, int32_t ghosts,
                            const cleft_mesh* whole)
{
    assert_same_mesh(parts, ranks, whole);
    assert_tets(parts, ranks, whole);
    assert_same_triangles(context, parts, ranks, whole);
    assert_places_of_triangles(parts, ranks, whole);
    if (ghosts)
        assert_ghosts(parts, ranks, whole);
}

#endif
