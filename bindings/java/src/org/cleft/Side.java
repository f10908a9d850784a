package org.cleft;

/** Sides of the box, in the axes of the voxels; the ordinal is the number in {@link Surface#hullSides}. */
public enum Side {
    // <constants> made by tools/generate.py from include/cleft/cleft.h
    /** The least x. */
    X_MIN,
    /** The greatest x. */
    X_MAX,
    /** The least y. */
    Y_MIN,
    /** The greatest y. */
    Y_MAX,
    /** The least z. */
    Z_MIN,
    /** The greatest z. */
    Z_MAX,
    /** No side of the box. */
    OTHER
    // </constants>
}
