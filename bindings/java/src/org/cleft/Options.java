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

    /**
     * Sets the kind of background mesh.
     *
     * @param value the new value
     * @return these options
     */
    public Options background(Background value) {
        return set(CleftNative.CLEFT_OPTION_BACKGROUND, (long) Objects.requireNonNull(value, "value").number);
    }

    /**
     * The kind of background mesh.
     *
     * @return the value
     */
    public Background background() {
        return Background.values()[(int) integer(CleftNative.CLEFT_OPTION_BACKGROUND)];
    }

    /**
     * Sets one edge length everywhere, in world units; 0: computed from the features of the volume.
     *
     * @param value the new value
     * @return these options
     */
    public Options size(double value) {
        return set(CleftNative.CLEFT_OPTION_SIZE, value);
    }

    /**
     * One edge length everywhere, in world units; 0: computed from the features of the volume.
     *
     * @return the value
     */
    public double size() {
        return real(CleftNative.CLEFT_OPTION_SIZE);
    }

    /**
     * Sets the least edge length; 0: the least voxel spacing.
     *
     * @param value the new value
     * @return these options
     */
    public Options sizeMin(double value) {
        return set(CleftNative.CLEFT_OPTION_SIZE_MIN, value);
    }

    /**
     * The least edge length; 0: the least voxel spacing.
     *
     * @return the value
     */
    public double sizeMin() {
        return real(CleftNative.CLEFT_OPTION_SIZE_MIN);
    }

    /**
     * Sets the greatest wanted edge length; 0: a quarter of the longest side of the box,
     * or its thickness times 1.5 if that is less.
     *
     * @param value the new value
     * @return these options
     */
    public Options sizeMax(double value) {
        return set(CleftNative.CLEFT_OPTION_SIZE_MAX, value);
    }

    /**
     * The greatest wanted edge length; 0: a quarter of the longest side of the box,
     * or its thickness times 1.5 if that is less.
     *
     * @return the value
     */
    public double sizeMax() {
        return real(CleftNative.CLEFT_OPTION_SIZE_MAX);
    }

    /**
     * Sets the edge length at an interface over the local feature size; 0.5 is fine, 2 is coarse.
     *
     * @param value the new value
     * @return these options
     */
    public Options featureScale(double value) {
        return set(CleftNative.CLEFT_OPTION_FEATURE_SCALE, value);
    }

    /**
     * The edge length at an interface over the local feature size; 0.5 is fine, 2 is coarse.
     *
     * @return the value
     */
    public double featureScale() {
        return real(CleftNative.CLEFT_OPTION_FEATURE_SCALE);
    }

    /**
     * Sets the greatest growth of the edge length over a distance.
     *
     * @param value the new value
     * @return these options
     */
    public Options gradation(double value) {
        return set(CleftNative.CLEFT_OPTION_GRADATION, value);
    }

    /**
     * The greatest growth of the edge length over a distance.
     *
     * @return the value
     */
    public double gradation() {
        return real(CleftNative.CLEFT_OPTION_GRADATION);
    }

    /**
     * Sets the greatest wanted edge length at interfaces; 0: none.
     *
     * @param value the new value
     * @return these options
     */
    public Options interfaceSize(double value) {
        return set(CleftNative.CLEFT_OPTION_INTERFACE_SIZE, value);
    }

    /**
     * The greatest wanted edge length at interfaces; 0: none.
     *
     * @return the value
     */
    public double interfaceSize() {
        return real(CleftNative.CLEFT_OPTION_INTERFACE_SIZE);
    }

    /**
     * Sets the wanted number of tetrahedra, met within 10 %; 0: as the sizes say.
     *
     * @param value the new value
     * @return these options
     */
    public Options tets(long value) {
        return set(CleftNative.CLEFT_OPTION_TETS, value);
    }

    /**
     * The wanted number of tetrahedra, met within 10 %; 0: as the sizes say.
     *
     * @return the value
     */
    public long tets() {
        return integer(CleftNative.CLEFT_OPTION_TETS);
    }

    /**
     * Sets whether parts of labels that are one voxel thick get edges so short that they come out whole.
     *
     * @param value the new value
     * @return these options
     */
    public Options keepThin(boolean value) {
        return set(CleftNative.CLEFT_OPTION_KEEP_THIN, value ? 1L : 0L);
    }

    /**
     * Whether parts of labels that are one voxel thick get edges so short that they come out whole.
     *
     * @return the value
     */
    public boolean keepThin() {
        return integer(CleftNative.CLEFT_OPTION_KEEP_THIN) != 0;
    }

    /**
     * Sets about how many tetrahedra there may be: where sizeMin is 0, the least edge length is raised for it; 0: no limit.
     *
     * @param value the new value
     * @return these options
     */
    public Options maxTets(long value) {
        return set(CleftNative.CLEFT_OPTION_MAX_TETS, value);
    }

    /**
     * About how many tetrahedra there may be; 0: no limit.
     *
     * @return the value
     */
    public long maxTets() {
        return integer(CleftNative.CLEFT_OPTION_MAX_TETS);
    }

    /**
     * Sets the width in voxels of the kernel that smooths label maps. It counts where a volume is made or read, in
     * {@link Mesher#labels} and {@link MeshFiles#readVolume}: in a call with a finished volume it changes nothing.
     *
     * @param value the new value
     * @return these options
     */
    public Options smooth(int value) {
        return set(CleftNative.CLEFT_OPTION_SMOOTH, (long) value);
    }

    /**
     * The width in voxels of the kernel that smooths label maps, when a volume is made or read.
     *
     * @return the value
     */
    public int smooth() {
        return (int) integer(CleftNative.CLEFT_OPTION_SMOOTH);
    }

    /**
     * Sets the rule that moves background points onto interfaces.
     *
     * @param value the new value
     * @return these options
     */
    public Options snap(Snap value) {
        return set(CleftNative.CLEFT_OPTION_SNAP, (long) Objects.requireNonNull(value, "value").number);
    }

    /**
     * The rule that moves background points onto interfaces.
     *
     * @return the value
     */
    public Snap snap() {
        return Snap.values()[(int) integer(CleftNative.CLEFT_OPTION_SNAP)];
    }

    /**
     * Sets the effort spent on the worst dihedral angles.
     *
     * @param value the new value
     * @return these options
     */
    public Options improve(Improvement value) {
        return set(CleftNative.CLEFT_OPTION_IMPROVE, (long) Objects.requireNonNull(value, "value").number);
    }

    /**
     * The effort spent on the worst dihedral angles.
     *
     * @return the value
     */
    public Improvement improve() {
        return Improvement.values()[(int) integer(CleftNative.CLEFT_OPTION_IMPROVE)];
    }

    /**
     * Sets the relaxation steps of the particles.
     *
     * @param value the new value
     * @return these options
     */
    public Options steps(int value) {
        return set(CleftNative.CLEFT_OPTION_STEPS, (long) value);
    }

    /**
     * The relaxation steps of the particles.
     *
     * @return the value
     */
    public int steps() {
        return (int) integer(CleftNative.CLEFT_OPTION_STEPS);
    }

    /**
     * Sets what varies the arrangement of the particles.
     *
     * @param value the new value
     * @return these options
     */
    public Options seed(long value) {
        return set(CleftNative.CLEFT_OPTION_SEED, value);
    }

    /**
     * What varies the arrangement of the particles.
     *
     * @return the value
     */
    public long seed() {
        return integer(CleftNative.CLEFT_OPTION_SEED);
    }

    /**
     * Sets whether a lost label is a failure.
     *
     * @param value the new value
     * @return these options
     */
    public Options strict(boolean value) {
        return set(CleftNative.CLEFT_OPTION_STRICT, value ? 1L : 0L);
    }

    /**
     * Whether a lost label is a failure.
     *
     * @return the value
     */
    public boolean strict() {
        return integer(CleftNative.CLEFT_OPTION_STRICT) != 0;
    }

    /**
     * Sets the dihedral angle in degrees below which tetrahedra of a given background are repaired; 0: none.
     *
     * @param value the new value
     * @return these options
     */
    public Options repair(double value) {
        return set(CleftNative.CLEFT_OPTION_REPAIR, value);
    }

    /**
     * The dihedral angle in degrees below which tetrahedra of a given background are repaired; 0: none.
     *
     * @return the value
     */
    public double repair() {
        return real(CleftNative.CLEFT_OPTION_REPAIR);
    }

    /**
     * Sets the greatest wanted edge length inside one label.
     *
     * @param label the label
     * @param size in world units; 0 takes the wish back
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
