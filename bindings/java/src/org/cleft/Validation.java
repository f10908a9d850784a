// Made by tools/generate.py from include/cleft/cleft.h.
package org.cleft;

/**
 * The faults of a mesh. All counts of faults are 0 for a valid mesh.
 *
 * @param valid true if there is no fault
 * @param negativeTets tetrahedra of negative orientation, by an exact predicate
 * @param flatTets tetrahedra that are flat, or of a volume below 1e-12 of their mean edge cubed
 * @param repeatedCorners tetrahedra that name a point twice
 * @param crowdedFaces faces that more than two tetrahedra share
 * @param foldedFaces faces whose two tetrahedra lie on the same side
 * @param hullOffBox hull triangles that are in no side of the bounding box
 * @param openInterfaceEdges edges inside the box that only one interface triangle has
 * @param unusedPoints points that no tetrahedron uses
 * @param repeatedPoints points with the coordinates of another point
 * @param volume the volume of all tetrahedra
 * @param boxVolume the volume of the bounding box
 * @param hullArea the area of the hull
 * @param boxArea the area of the bounding box
 * @param interfaceTriangles faces between tetrahedra of different labels, counted face by face.
 * cleft_surface_interface_count() of the mesh must be the same
 * @param hullTriangles faces that only one tetrahedron has; cleft_surface_hull_count() must be the same
 * @param firstFault the first fault and its place, "" if there is none
 */
public record Validation(
        boolean valid,
        long negativeTets,
        long flatTets,
        long repeatedCorners,
        long crowdedFaces,
        long foldedFaces,
        long hullOffBox,
        long openInterfaceEdges,
        long unusedPoints,
        long repeatedPoints,
        double volume,
        double boxVolume,
        double hullArea,
        double boxArea,
        long interfaceTriangles,
        long hullTriangles,
        String firstFault) {
    static Validation of(NativeValidation row, String sentence) {
        return new Validation(
                row.getValid() != 0,
                row.getNegative_tets(),
                row.getFlat_tets(),
                row.getRepeated_corners(),
                row.getCrowded_faces(),
                row.getFolded_faces(),
                row.getHull_off_box(),
                row.getOpen_interface_edges(),
                row.getUnused_points(),
                row.getRepeated_points(),
                row.getVolume(),
                row.getBox_volume(),
                row.getHull_area(),
                row.getBox_area(),
                row.getInterface_triangles(),
                row.getHull_triangles(),
                row.getValid() != 0 ? "" : sentence);
    }
}
