package org.cleft;

/**
 * What is wrong with a mesh; all counts are 0 for a sound one.
 *
 * @param valid whether nothing is wrong
 * @param negativeTets tetrahedra turned inside out
 * @param flatTets tetrahedra without volume
 * @param repeatedCorners tetrahedra that name a point twice
 * @param crowdedFaces faces of more than two tetrahedra
 * @param foldedFaces faces whose two tetrahedra lie on one side
 * @param hullOffBox hull triangles in no side of the bounding box
 * @param openInterfaceEdges edges inside the box with one interface triangle only
 * @param unusedPoints points of no tetrahedron
 * @param repeatedPoints points at the place of another
 * @param volume of the tetrahedra
 * @param boxVolume of the bounding box
 * @param hullArea of the hull
 * @param boxArea of the bounding box
 * @param interfaceTriangles triangles between two labels
 * @param hullTriangles triangles of the hull
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
    static Validation of(NativeValidation v, String sentence) {
        boolean valid = v.getValid() != 0;
        return new Validation(valid, v.getNegative_tets(), v.getFlat_tets(), v.getRepeated_corners(),
                v.getCrowded_faces(), v.getFolded_faces(), v.getHull_off_box(), v.getOpen_interface_edges(),
                v.getUnused_points(), v.getRepeated_points(), v.getVolume(), v.getBox_volume(), v.getHull_area(),
                v.getBox_area(), v.getInterface_triangles(), v.getHull_triangles(), valid ? "" : sentence);
    }
}
