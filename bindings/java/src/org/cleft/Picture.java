package org.cleft;

import java.util.Objects;

/**
 * How a picture shows a mesh: {@code new Picture().cut(0, 0.5).strip(0).legend(true)}. It never changes: the methods
 * that set something answer a new one.
 */
public final class Picture implements Cloneable {
    private MeshFiles.Colouring by = MeshFiles.Colouring.LABEL;
    private MeshFiles.Backdrop backdrop = MeshFiles.Backdrop.LIGHT;
    private int width; // 0: the default of the library, as below
    private int height;
    private boolean edges = true;
    private boolean legend;
    private double[] cut = new double[3];
    private double[] view = new double[3];
    private double[] up = new double[3];
    private double[] range = new double[2];
    private double zoom;
    private double lineWidth;
    private int[] strip = {};
    private int[] whole = {};

    /** All labels in their colours, not cut, on white. */
    public Picture() {}

    private interface Change {
        void make(Picture twin);
    }

    private Picture with(Change change) {
        try {
            Picture twin = (Picture) clone();
            change.make(twin);
            return twin;
        } catch (CloneNotSupportedException impossible) {
            throw new AssertionError(impossible);
        }
    }

    private static double[] direction(double x, double y, double z) {
        Arguments.finite("x", x);
        Arguments.finite("y", y);
        Arguments.finite("z", z);
        return new double[] {x, y, z};
    }

    /**
     * The same with colours of another kind.
     *
     * @param colouring what gives a tetrahedron its colour
     * @return a description
     */
    public Picture by(MeshFiles.Colouring colouring) {
        Objects.requireNonNull(colouring, "colouring");
        return with(twin -> twin.by = colouring);
    }

    /**
     * The same with these measures at the ends of the colours.
     *
     * @param low the lesser
     * @param high the greater
     * @return a description
     */
    public Picture range(double low, double high) {
        Arguments.finite("low", low);
        Arguments.finite("high", high);
        return with(twin -> twin.range = new double[] {low, high});
    }

    /**
     * The same on another background.
     *
     * @param behind what is behind the mesh
     * @return a description
     */
    public Picture backdrop(MeshFiles.Backdrop behind) {
        Objects.requireNonNull(behind, "behind");
        return with(twin -> twin.backdrop = behind);
    }

    /**
     * The same in another size.
     *
     * @param pixelsAcross the width, at least 1
     * @param pixelsDown the height, at least 1
     * @return a description
     */
    public Picture size(int pixelsAcross, int pixelsDown) {
        Arguments.atLeastOne("pixelsAcross", pixelsAcross);
        Arguments.atLeastOne("pixelsDown", pixelsDown);
        return with(twin -> {
            twin.width = pixelsAcross;
            twin.height = pixelsDown;
        });
    }

    /**
     * The same cut across an axis. Whole tetrahedra are taken away on the side of the eye, those in front of all cuts.
     *
     * @param axis 0, 1 or 2 for x, y or z
     * @param share where, as a share of the box
     * @return a description
     */
    public Picture cut(int axis, double share) {
        if (axis < 0 || axis > 2)
            throw new IllegalArgumentException("axis is " + axis + "; it must be 0, 1 or 2");
        double[] shares = cut.clone();
        shares[axis] = share;
        return with(twin -> twin.cut = shares);
    }

    /**
     * The same without these labels.
     *
     * @param labels that are not drawn
     * @return a description
     */
    public Picture strip(int... labels) {
        int[] copy = Objects.requireNonNull(labels, "labels").clone();
        return with(twin -> twin.strip = copy);
    }

    /**
     * The same with these labels not cut.
     *
     * @param labels that stay whole
     * @return a description
     */
    public Picture whole(int... labels) {
        int[] copy = Objects.requireNonNull(labels, "labels").clone();
        return with(twin -> twin.whole = copy);
    }

    /**
     * The same from another side.
     *
     * @param x of the direction from the mesh to the eye
     * @param y of that direction
     * @param z of that direction
     * @return a description
     */
    public Picture view(double x, double y, double z) {
        double[] toEye = direction(x, y, z);
        return with(twin -> twin.view = toEye);
    }

    /**
     * The same with another direction upwards.
     *
     * @param x of the direction
     * @param y of the direction
     * @param z of the direction
     * @return a description
     */
    public Picture up(double x, double y, double z) {
        double[] upwards = direction(x, y, z);
        return with(twin -> twin.up = upwards);
    }

    /**
     * The same in another scale.
     *
     * @param factor 1 to fill the picture
     * @return a description
     */
    public Picture zoom(double factor) {
        Arguments.positive("factor", factor);
        return with(twin -> twin.zoom = factor);
    }

    /**
     * The same with edges or without.
     *
     * @param drawn whether edges are drawn
     * @return a description
     */
    public Picture edges(boolean drawn) {
        return with(twin -> twin.edges = drawn);
    }

    /**
     * The same with edges of another width.
     *
     * @param pixels of a line
     * @return a description
     */
    public Picture lineWidth(double pixels) {
        Arguments.positive("pixels", pixels);
        return with(twin -> twin.lineWidth = pixels);
    }

    /**
     * The same with a legend or without.
     *
     * @param drawn whether the colours are explained at the right
     * @return a description
     */
    public Picture legend(boolean drawn) {
        return with(twin -> twin.legend = drawn);
    }

    int[] stripped() {
        return strip;
    }

    int[] uncut() {
        return whole;
    }

    /** For a call; the caller deletes it. */
    NativePicture toNative() {
        NativePicture look = new NativePicture();
        look.setBy(by.ordinal());
        look.setBackdrop(backdrop.ordinal());
        look.setWidth(width);
        look.setHeight(height);
        look.setNo_edges(edges ? 0 : 1);
        look.setLegend(legend ? 1 : 0);
        look.setZoom(zoom);
        look.setLine_width(lineWidth);
        for (int axis = 0; axis < 3; ++axis) {
            look.set_cut(axis, cut[axis]);
            look.set_view(axis, view[axis]);
            look.set_up(axis, up[axis]);
        }
        for (int end = 0; end < 2; ++end)
            look.set_range(end, range[end]);
        return look;
    }
}
