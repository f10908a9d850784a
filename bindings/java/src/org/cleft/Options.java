package org.cleft;

import java.util.Objects;

/**
 * How to mesh: {@code new Options().sizeMax(3).background(Background.OCTREE).strip(0)}. Values that are not set are the
 * library's defaults; {@link OptionDescription#table} lists them with their ranges. A value out of its range throws
 * {@link CleftException.InvalidOption}, and leaves the option as it was. For one thread at a time.
 */
public final class Options extends NativeObject {
    /** Options with their defaults. */
    public Options() {
        super("Options", create(), NativeSize.SMALL, CleftNative::cleft_options_destroy);
    }

    private static long create() {
        NativeLibrary.core();
        long[] out = out();
        CleftException.check(CleftNative.cleft_options_create(out));
        return out[0];
    }

    // <options> made by tools/generate.py from src/capi/options.toml

    /**
     * Sets {@code background}: kind of background mesh (particles, lattice or octree; default particles).
     *
     * @param value the new value
     * @return these options
     */
    public Options background(Background value) {
        return set(CleftNative.CLEFT_OPTION_BACKGROUND, (long) Objects.requireNonNull(value, "value").number);
    }

    /**
     * {@code background}: kind of background mesh (particles, lattice or octree; default particles).
     *
     * @return the value
     */
    public Background background() {
        return Background.values()[(int) integer(CleftNative.CLEFT_OPTION_BACKGROUND)];
    }

    /**
     * Sets {@code size}: one wanted edge length everywhere, in world units. 0: the library computes it from the
     * features of the volume (at least 0; default 0).
     *
     * @param value the new value
     * @return these options
     */
    public Options size(double value) {
        return set(CleftNative.CLEFT_OPTION_SIZE, value);
    }

    /**
     * {@code size}: one wanted edge length everywhere, in world units. 0: the library computes it from the features of
     * the volume (at least 0; default 0).
     *
     * @return the value
     */
    public double size() {
        return real(CleftNative.CLEFT_OPTION_SIZE);
    }

    /**
     * Sets {@code sizeMin}: least wanted edge length, in world units. 0: the least voxel spacing (at least 0; default
     * 0).
     *
     * @param value the new value
     * @return these options
     */
    public Options sizeMin(double value) {
        return set(CleftNative.CLEFT_OPTION_SIZE_MIN, value);
    }

    /**
     * {@code sizeMin}: least wanted edge length, in world units. 0: the least voxel spacing (at least 0; default 0).
     *
     * @return the value
     */
    public double sizeMin() {
        return real(CleftNative.CLEFT_OPTION_SIZE_MIN);
    }

    /**
     * Sets {@code sizeMax}: greatest wanted edge length, in world units. Single edges may be up to 2.3 times as long.
     * 0: a quarter of the longest side of the box, or 1.5 times its thickness if that is less (at least 0; default 0).
     *
     * @param value the new value
     * @return these options
     */
    public Options sizeMax(double value) {
        return set(CleftNative.CLEFT_OPTION_SIZE_MAX, value);
    }

    /**
     * {@code sizeMax}: greatest wanted edge length, in world units. Single edges may be up to 2.3 times as long. 0: a
     * quarter of the longest side of the box, or 1.5 times its thickness if that is less (at least 0; default 0).
     *
     * @return the value
     */
    public double sizeMax() {
        return real(CleftNative.CLEFT_OPTION_SIZE_MAX);
    }

    /**
     * Sets {@code featureScale}: edge length at an interface divided by the local feature size. 0.5 gives a fine mesh,
     * 2 a coarse one (0.001 to 1000; default 1).
     *
     * @param value the new value
     * @return these options
     */
    public Options featureScale(double value) {
        return set(CleftNative.CLEFT_OPTION_FEATURE_SCALE, value);
    }

    /**
     * {@code featureScale}: edge length at an interface divided by the local feature size. 0.5 gives a fine mesh, 2 a
     * coarse one (0.001 to 1000; default 1).
     *
     * @return the value
     */
    public double featureScale() {
        return real(CleftNative.CLEFT_OPTION_FEATURE_SCALE);
    }

    /**
     * Sets {@code gradation}: greatest growth of the edge length per unit of distance (the Lipschitz constant of the
     * sizing field). 0.15 is gentle, 1 is steep (0.01 to 1; default 0.3).
     *
     * @param value the new value
     * @return these options
     */
    public Options gradation(double value) {
        return set(CleftNative.CLEFT_OPTION_GRADATION, value);
    }

    /**
     * {@code gradation}: greatest growth of the edge length per unit of distance (the Lipschitz constant of the sizing
     * field). 0.15 is gentle, 1 is steep (0.01 to 1; default 0.3).
     *
     * @return the value
     */
    public double gradation() {
        return real(CleftNative.CLEFT_OPTION_GRADATION);
    }

    /**
     * Sets {@code interfaceSize}: greatest wanted edge length at interfaces, in world units. 0: no limit (at least 0;
     * default 0).
     *
     * @param value the new value
     * @return these options
     */
    public Options interfaceSize(double value) {
        return set(CleftNative.CLEFT_OPTION_INTERFACE_SIZE, value);
    }

    /**
     * {@code interfaceSize}: greatest wanted edge length at interfaces, in world units. 0: no limit (at least 0;
     * default 0).
     *
     * @return the value
     */
    public double interfaceSize() {
        return real(CleftNative.CLEFT_OPTION_INTERFACE_SIZE);
    }

    /**
     * Sets {@code surfaceError}: greatest distance, in world units, that triangles of an interface shall have from it.
     * Sizes follow the curvature of the interface. -1: half the least voxel spacing; a label map says no more. 0: no
     * limit (at least -1; default -1).
     *
     * @param value the new value
     * @return these options
     */
    public Options surfaceError(double value) {
        return set(CleftNative.CLEFT_OPTION_SURFACE_ERROR, value);
    }

    /**
     * {@code surfaceError}: greatest distance, in world units, that triangles of an interface shall have from it. Sizes
     * follow the curvature of the interface. -1: half the least voxel spacing; a label map says no more. 0: no limit
     * (at least -1; default -1).
     *
     * @return the value
     */
    public double surfaceError() {
        return real(CleftNative.CLEFT_OPTION_SURFACE_ERROR);
    }

    /**
     * Sets {@code anisotropy}: greatest edge length along an interface divided by that across it. Elements are long
     * where the interface is flat, and where voxels are long. Angles are then good in the metric of the lengths. It
     * takes the particles background. 1: lengths are the same in all directions (1 to 1000; default 1).
     *
     * @param value the new value
     * @return these options
     */
    public Options anisotropy(double value) {
        return set(CleftNative.CLEFT_OPTION_ANISOTROPY, value);
    }

    /**
     * {@code anisotropy}: greatest edge length along an interface divided by that across it. Elements are long where
     * the interface is flat, and where voxels are long. Angles are then good in the metric of the lengths. It takes the
     * particles background. 1: lengths are the same in all directions (1 to 1000; default 1).
     *
     * @return the value
     */
    public double anisotropy() {
        return real(CleftNative.CLEFT_OPTION_ANISOTROPY);
    }

    /**
     * Sets {@code keepThin}: use edges of half the least voxel spacing, or of sizeMin, where a label is one voxel
     * thick. The mesh then keeps such parts whole (on or off; default off).
     *
     * @param value the new value
     * @return these options
     */
    public Options keepThin(boolean value) {
        return set(CleftNative.CLEFT_OPTION_KEEP_THIN, value ? 1L : 0L);
    }

    /**
     * {@code keepThin}: use edges of half the least voxel spacing, or of sizeMin, where a label is one voxel thick. The
     * mesh then keeps such parts whole (on or off; default off).
     *
     * @return the value
     */
    public boolean keepThin() {
        return integer(CleftNative.CLEFT_OPTION_KEEP_THIN) != 0;
    }

    /**
     * Sets {@code tets}: wanted number of tetrahedra in the kept labels, met within 10 %. The library scales the sizes
     * for it, and maxTets does not limit them. 0: the sizes decide (0 to 2147483647; default 0).
     *
     * @param value the new value
     * @return these options
     */
    public Options tets(long value) {
        return set(CleftNative.CLEFT_OPTION_TETS, value);
    }

    /**
     * {@code tets}: wanted number of tetrahedra in the kept labels, met within 10 %. The library scales the sizes for
     * it, and maxTets does not limit them. 0: the sizes decide (0 to 2147483647; default 0).
     *
     * @return the value
     */
    public long tets() {
        return integer(CleftNative.CLEFT_OPTION_TETS);
    }

    /**
     * Sets {@code maxTets}: greatest expected number of background tetrahedra. To keep to it, the library raises the
     * least edge length, but only if size, sizeMin and tets are 0. If tets is set and labels are left out, maxTets
     * limits the whole mesh instead. 0: no limit (0 to 2147483647; default 10000000).
     *
     * @param value the new value
     * @return these options
     */
    public Options maxTets(long value) {
        return set(CleftNative.CLEFT_OPTION_MAX_TETS, value);
    }

    /**
     * {@code maxTets}: greatest expected number of background tetrahedra. To keep to it, the library raises the least
     * edge length, but only if size, sizeMin and tets are 0. If tets is set and labels are left out, maxTets limits the
     * whole mesh instead. 0: no limit (0 to 2147483647; default 10000000).
     *
     * @return the value
     */
    public long maxTets() {
        return integer(CleftNative.CLEFT_OPTION_MAX_TETS);
    }

    /**
     * Sets {@code smooth}: width, in voxels, of the kernel that smooths a label map when the volume is made (2 to 6;
     * default 5). It counts where a volume is made or read: a finished volume keeps its own.
     *
     * @param value the new value
     * @return these options
     */
    public Options smooth(int value) {
        return set(CleftNative.CLEFT_OPTION_SMOOTH, (long) value);
    }

    /**
     * {@code smooth}: width, in voxels, of the kernel that smooths a label map when the volume is made (2 to 6; default
     * 5). It counts where a volume is made or read: a finished volume keeps its own.
     *
     * @return the value
     */
    public int smooth() {
        return (int) integer(CleftNative.CLEFT_OPTION_SMOOTH);
    }

    /**
     * Sets {@code snap}: rule that moves background points onto interfaces. The rule quality looks at the surrounding
     * elements, and safe keeps to the safe distances of the published method. The rule none moves no point (quality,
     * safe or none; default quality).
     *
     * @param value the new value
     * @return these options
     */
    public Options snap(Snap value) {
        return set(CleftNative.CLEFT_OPTION_SNAP, (long) Objects.requireNonNull(value, "value").number);
    }

    /**
     * {@code snap}: rule that moves background points onto interfaces. The rule quality looks at the surrounding
     * elements, and safe keeps to the safe distances of the published method. The rule none moves no point (quality,
     * safe or none; default quality).
     *
     * @return the value
     */
    public Snap snap() {
        return Snap.values()[(int) integer(CleftNative.CLEFT_OPTION_SNAP)];
    }

    /**
     * Sets {@code improve}: effort spent on the worst dihedral angles after cleaving (off, fast or best; default fast).
     *
     * @param value the new value
     * @return these options
     */
    public Options improve(Improvement value) {
        return set(CleftNative.CLEFT_OPTION_IMPROVE, (long) Objects.requireNonNull(value, "value").number);
    }

    /**
     * {@code improve}: effort spent on the worst dihedral angles after cleaving (off, fast or best; default fast).
     *
     * @return the value
     */
    public Improvement improve() {
        return Improvement.values()[(int) integer(CleftNative.CLEFT_OPTION_IMPROVE)];
    }

    /**
     * Sets {@code minAngle}: dihedral angle, in degrees, that no tetrahedron shall be below. A greatest angle and a
     * greatest radius ratio go with it: 148.5 degrees and 8.0 with 25, 141.8 and 6.8 with 30. A warning says how many
     * tetrahedra miss them. 0: 25, or 32 where improve is best (0 to 35; default 0).
     *
     * @param value the new value
     * @return these options
     */
    public Options minAngle(double value) {
        return set(CleftNative.CLEFT_OPTION_MIN_ANGLE, value);
    }

    /**
     * {@code minAngle}: dihedral angle, in degrees, that no tetrahedron shall be below. A greatest angle and a greatest
     * radius ratio go with it: 148.5 degrees and 8.0 with 25, 141.8 and 6.8 with 30. A warning says how many tetrahedra
     * miss them. 0: 25, or 32 where improve is best (0 to 35; default 0).
     *
     * @return the value
     */
    public double minAngle() {
        return real(CleftNative.CLEFT_OPTION_MIN_ANGLE);
    }

    /**
     * Sets {@code steps}: number of relaxation steps of the particles (0 to 1000; default 8).
     *
     * @param value the new value
     * @return these options
     */
    public Options steps(int value) {
        return set(CleftNative.CLEFT_OPTION_STEPS, (long) value);
    }

    /**
     * {@code steps}: number of relaxation steps of the particles (0 to 1000; default 8).
     *
     * @return the value
     */
    public int steps() {
        return (int) integer(CleftNative.CLEFT_OPTION_STEPS);
    }

    /**
     * Sets {@code seed}: number that varies the arrangement of the particles. The same seed gives the same mesh (at
     * least 0; default 0).
     *
     * @param value the new value
     * @return these options
     */
    public Options seed(long value) {
        return set(CleftNative.CLEFT_OPTION_SEED, value);
    }

    /**
     * {@code seed}: number that varies the arrangement of the particles. The same seed gives the same mesh (at least 0;
     * default 0).
     *
     * @return the value
     */
    public long seed() {
        return integer(CleftNative.CLEFT_OPTION_SEED);
    }

    /**
     * Sets {@code strict}: fail if the mesh loses a kept label, or loses or breaks a piece of one of more than 30
     * voxels. Fail too if two kept labels meet in the mesh but not in the voxels (on or off; default off).
     *
     * @param value the new value
     * @return these options
     */
    public Options strict(boolean value) {
        return set(CleftNative.CLEFT_OPTION_STRICT, value ? 1L : 0L);
    }

    /**
     * {@code strict}: fail if the mesh loses a kept label, or loses or breaks a piece of one of more than 30 voxels.
     * Fail too if two kept labels meet in the mesh but not in the voxels (on or off; default off).
     *
     * @return the value
     */
    public boolean strict() {
        return integer(CleftNative.CLEFT_OPTION_STRICT) != 0;
    }

    /**
     * Sets {@code repair}: dihedral angle, in degrees, below which tetrahedra of a user-supplied background are
     * repaired before cleaving. 0: no repair (0 to 35; default 30).
     *
     * @param value the new value
     * @return these options
     */
    public Options repair(double value) {
        return set(CleftNative.CLEFT_OPTION_REPAIR, value);
    }

    /**
     * {@code repair}: dihedral angle, in degrees, below which tetrahedra of a user-supplied background are repaired
     * before cleaving. 0: no repair (0 to 35; default 30).
     *
     * @return the value
     */
    public double repair() {
        return real(CleftNative.CLEFT_OPTION_REPAIR);
    }

    /**
     * Sets {@code block}: thickness, in voxels, of the slabs that are meshed one by one and then joined. No size is
     * more than a quarter of it, and the mesh differs a little from that of the whole volume. 0: the whole volume at
     * once (0 to 1000000; default 0).
     *
     * @param value the new value
     * @return these options
     */
    public Options block(long value) {
        return set(CleftNative.CLEFT_OPTION_BLOCK, value);
    }

    /**
     * {@code block}: thickness, in voxels, of the slabs that are meshed one by one and then joined. No size is more
     * than a quarter of it, and the mesh differs a little from that of the whole volume. 0: the whole volume at once (0
     * to 1000000; default 0).
     *
     * @return the value
     */
    public long block() {
        return integer(CleftNative.CLEFT_OPTION_BLOCK);
    }

    /**
     * Sets {@code delaunay}: engine that makes the tetrahedra of the particles. Both give the same mesh; a library may
     * be built without TetGen (cleft or tetgen; default cleft).
     *
     * @param value the new value
     * @return these options
     */
    public Options delaunay(DelaunayEngine value) {
        return set(CleftNative.CLEFT_OPTION_DELAUNAY, (long) Objects.requireNonNull(value, "value").number);
    }

    /**
     * {@code delaunay}: engine that makes the tetrahedra of the particles. Both give the same mesh; a library may be
     * built without TetGen (cleft or tetgen; default cleft).
     *
     * @return the value
     */
    public DelaunayEngine delaunay() {
        return DelaunayEngine.values()[(int) integer(CleftNative.CLEFT_OPTION_DELAUNAY)];
    }

    // </options>

    /**
     * Sets the greatest wanted edge length inside one label.
     *
     * @param label the label
     * @param size in world units; 0 removes the limit for this label
     * @return these options
     */
    public Options labelSize(int label, double size) {
        return refused(with(address -> CleftNative.cleft_options_set_label_size(address, label, size)));
    }

    /**
     * Sets the labels whose tetrahedra are left out of the finished mesh.
     *
     * @param labels the labels, instead of those set before
     * @return these options
     */
    public Options strip(int... labels) {
        Objects.requireNonNull(labels, "labels");
        return refused(with(address -> CleftNative.cleft_options_set_strip(address, labels, labels.length)));
    }

    /**
     * Sets the labels whose tetrahedra alone are kept.
     *
     * @param labels the labels, instead of those set before; none: all are kept
     * @return these options
     */
    public Options only(int... labels) {
        Objects.requireNonNull(labels, "labels");
        return refused(with(address -> CleftNative.cleft_options_set_only(address, labels, labels.length)));
    }

    /**
     * Sets an option by name from text, as the command line does.
     *
     * @param name as in {@link OptionDescription#name}
     * @param value in words or digits
     * @return these options
     */
    public Options set(String name, String value) {
        int status = with(address -> CleftNative.cleft_options_set_text(address, name, value));
        if (status != CleftNative.CLEFT_OK)  // in the words of the library, which are those of the caller here
            throw CleftException.of(status, with(CleftNative::cleft_options_last_error));
        return this;
    }

    private Options set(int key, long value) {
        return refused(with(address -> CleftNative.cleft_options_set_integer(address, key, value)));
    }

    private Options set(int key, double value) {
        return refused(with(address -> CleftNative.cleft_options_set_real(address, key, value)));
    }

    private long integer(int key) {
        long[] value = new long[1];
        checked(address -> CleftNative.cleft_options_get_integer(address, key, value));
        return value[0];
    }

    private double real(int key) {
        double[] value = new double[1];
        checked(address -> CleftNative.cleft_options_get_real(address, key, value));
        return value[0];
    }

    private Options refused(int status) {
        if (status != CleftNative.CLEFT_OK)
            throw CleftException.of(status, Wording.inJava(with(CleftNative::cleft_options_last_error)));
        return this;
    }
}
