// Made by tools/generate.py from include/cleft/cleft.h.
package org.cleft;

/**
 * How far an interface of the mesh is from that of the volume, in world units, or a line where three labels meet.
 *
 * @param first the lowest of the labels
 * @param second the next one
 * @param third the highest of the labels of a line; for an interface the same as `second`
 * @param isLine true if it is a line where three labels meet
 * @param elements number of triangles of the interface, or of edges of the line, in the mesh
 * @param points number of points of the volume's interface or line that were looked at
 * @param meshMean mean distance from the mesh to the volume
 * @param mesh99 99 % of the mesh are no farther from the volume
 * @param meshGreatest greatest distance from the mesh to the volume
 * @param volumeMean mean distance from the volume to the mesh
 * @param volume99 99 % of the points are no farther from the mesh
 * @param volumeGreatest greatest distance from the volume to the mesh
 */
public record Distance(
        int first,
        int second,
        int third,
        boolean isLine,
        long elements,
        long points,
        double meshMean,
        double mesh99,
        double meshGreatest,
        double volumeMean,
        double volume99,
        double volumeGreatest) {
    static Distance of(NativeDistance row) {
        return new Distance(
                row.getFirst(),
                row.getSecond(),
                row.getThird(),
                row.getIs_line() != 0,
                row.getElements(),
                row.getPoints(),
                row.getMesh_mean(),
                row.getMesh_99(),
                row.getMesh_greatest(),
                row.getVolume_mean(),
                row.getVolume_99(),
                row.getVolume_greatest());
    }
}
