// Made by tools/generate.py from include/cleft/cleft.h.
package org.cleft;

/**
 * What is wrong with a mesh; all counts of faults are 0 for a sound one.
 *
 * @param valid true if nothing is wrong
 * @param negativeTets tetrahedra that are turned inside out, by an exact predicate
 * @param flatTets tetrahedra that are flat, or of less volume than 1e-12 of the cube of their mean edge
 * @param repeatedCorners tetrahedra that name a point twice
 * @param crowdedFaces faces of more than two tetrahedra
 * @param foldedFaces faces whose two tetrahedra lie on one side
 * @param hullOffBox hull triangles in no side of the bounding box
 * @param openInterfaceEdges edges inside the box with one interface triangle only
 * @param unusedPoints points of no tetrahedron
 * @param repeatedPoints points at the place of another
 * @param volume the volume of the tetrahedra
 * @param boxVolume the volume of the bounding box
 * @param hullArea the area of the hull
 * @param boxArea the area of the bounding box
 * @param interfaceTriangles faces between tetrahedra of different labels, counted face by face: a surface finds as
 * many, by another way
 * @param hullTriangles faces of one tetrahedron, counted so, too
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
