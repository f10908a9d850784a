package org.cleft;

import java.util.Objects;

/**
 * How voxels without a header lie in a file, x fastest: {@code new RawVoxels(VoxelType.INT16, 64, 64, 40).spacing(0.5,
 * 0.5, 2).bigEndian(true)}. It never changes: the methods that set something answer a new one.
 */
public final class RawVoxels {
    private final VoxelType type;
    private final long[] dims;
    private double[] spacing; // null: 1
    private boolean bigEndian;
    private long skip;
    private MeshFiles.VoxelKind kind = MeshFiles.VoxelKind.AUTO;

    /**
     * Voxels of side 1 from the first byte of the file on, the least significant byte first.
     *
     * @param type of the voxels
     * @param nx voxels along x
     * @param ny voxels along y
     * @param nz voxels along z
     */
    public RawVoxels(VoxelType type, long nx, long ny, long nz) {
        this(Objects.requireNonNull(type, "type"), new Grid(nx, ny, nz).dims());
    }

    private RawVoxels(VoxelType type, long[] dims) {
        this.type = type;
        this.dims = dims;
    }

    private RawVoxels copy() {
        RawVoxels twin = new RawVoxels(type, dims);
        twin.spacing = spacing;
        twin.bigEndian = bigEndian;
        twin.skip = skip;
        twin.kind = kind;
        return twin;
    }

    /**
     * The same with these sides of a voxel. The corner of the box is at zero.
     *
     * @param x along x, above 0
     * @param y along y, above 0
     * @param z along z, above 0
     * @return a description
     */
    public RawVoxels spacing(double x, double y, double z) {
        Arguments.positive("x", x);
        Arguments.positive("y", y);
        Arguments.positive("z", z);
        RawVoxels twin = copy();
        twin.spacing = new double[] {x, y, z};
        return twin;
    }

    /**
     * The same in another order of bytes.
     *
     * @param first whether the most significant byte comes first
     * @return a description
     */
    public RawVoxels bigEndian(boolean first) {
        RawVoxels twin = copy();
        twin.bigEndian = first;
        return twin;
    }

    /**
     * The same behind a header that is passed over.
     *
     * @param bytes before the first voxel; what follows must be exactly the voxels
     * @return a description
     */
    public RawVoxels skip(long bytes) {
        if (bytes < 0)
            throw new IllegalArgumentException("bytes is " + bytes + "; it must not be negative");
        RawVoxels twin = copy();
        twin.skip = bytes;
        return twin;
    }

    /**
     * The same with another meaning of the voxels.
     *
     * @param meaning what the voxels mean
     * @return a description
     */
    public RawVoxels kind(MeshFiles.VoxelKind meaning) {
        RawVoxels twin = copy();
        twin.kind = Objects.requireNonNull(meaning, "meaning");
        return twin;
    }

    /** For a call; the caller deletes it. */
    NativeRaw toNative() {
        NativeRaw raw = new NativeRaw();
        raw.setType(type.number);
        raw.setBig_endian(bigEndian ? 1 : 0);
        raw.setKind(kind.ordinal());
        raw.setSkip(skip);
        for (int axis = 0; axis < 3; ++axis)
            raw.set_axis(axis, dims[axis], spacing == null ? 0 : spacing[axis]);
        return raw;
    }
}
