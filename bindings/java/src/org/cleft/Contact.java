// Made by tools/generate.py from include/cleft/cleft.h.
package org.cleft;

/**
 * Two labels that share triangles in the mesh, although no two of their voxels share a face or an edge. The gap between
 * them is narrower than the tetrahedra there, and a smaller size opens it.
 *
 * @param first the lower of the two labels
 * @param second the higher of the two labels
 * @param triangles number of triangles that the two labels share
 */
public record Contact(
        int first,
        int second,
        long triangles) {
    static Contact of(NativeContact row) {
        return new Contact(
                row.getFirst(),
                row.getSecond(),
                row.getTriangles());
    }
}
