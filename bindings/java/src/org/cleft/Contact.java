// Made by tools/generate.py from include/cleft/cleft.h.
package org.cleft;

/**
 * Two labels that share triangles in the mesh, but of which no two voxels share a face or an edge. The gap between them
 * is narrower than the tetrahedra there, and a smaller size opens it.
 *
 * @param first the lower of the two labels
 * @param second the other
 * @param triangles the triangles that the two share
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
