package org.cleft;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/** Reads and writes files. The native part of this class is loaded when it is first used; it needs ITK. */
public final class MeshFiles {
    /** Directions of the world axes. */
    public enum World {
        /** Left, posterior, superior: ITK's, DICOM's, and those of files of 3D Slicer. */
        LPS,
        /** Right, anterior, superior: NIfTI's. */
        RAS
    }

    /** What the voxels of a file mean. */
    public enum VoxelKind {
        /** Labels if the numbers are whole and not negative, else indicator functions. */
        AUTO,
        /** Labels. */
        LABELS,
        /** Indicator functions. */
        INDICATORS
    }

    /** What a file holds. */
    public enum Content {
        /** Neither a volume nor a mesh, as far as one can tell. */
        UNKNOWN,
        /** A volume. */
        VOLUME,
        /** A mesh. */
        MESH
    }

    /**
     * How to read a volume.
     *
     * @param world the axes that coordinates come out in
     * @param kind what the voxels mean
     * @param spacing three lengths taken instead of the file's, 0 for the file's; or null
     */
    public record Reading(World world, VoxelKind kind, double[] spacing) {
        /** As the file says. */
        public static final Reading DEFAULT = new Reading(World.LPS, VoxelKind.AUTO, null);

        /**
         * Checks the parts.
         *
         * @param world the axes that coordinates come out in
         * @param kind what the voxels mean
         * @param spacing three lengths taken instead of the file's, 0 for the file's; or null
         */
        public Reading {
            Objects.requireNonNull(world, "world");
            Objects.requireNonNull(kind, "kind");
            if (spacing != null && spacing.length != 3)
                throw new IllegalArgumentException("spacing has " + spacing.length + " numbers; it must have 3");
        }
    }

    /**
     * A field of one number a voxel.
     *
     * @param grid how many voxels there are and where they lie
     * @param values x fastest
     */
    public record Field(Grid grid, double[] values) {}

    /**
     * A format of files.
     *
     * @param name as in "msh22", to write a mesh in it
     * @param extensions as in ".nii.gz"
     * @param text what it holds
     * @param readsMesh whether meshes are read
     * @param writesMesh whether meshes are written
     * @param readsVolume whether volumes are read
     * @param writesSizing whether sizing fields are written
     */
    public record Format(String name, List<String> extensions, String text, boolean readsMesh, boolean writesMesh,
            boolean readsVolume, boolean writesSizing) {}

    private MeshFiles() {}

    /**
     * The formats that are read and written.
     *
     * @return the rows of the table
     */
    public static List<Format> formats() {
        List<Format> formats = new ArrayList<>();
        eachFormat(row -> {
            int does = row.getDirections();
            formats.add(new Format(row.getName(), List.of(row.getExtensions().trim().split(" +")), row.getText(),
                    (does & CleftIoNative.CLEFT_IO_READS_MESH) != 0, (does & CleftIoNative.CLEFT_IO_WRITES_MESH) != 0,
                    (does & CleftIoNative.CLEFT_IO_READS_VOLUME) != 0,
                    (does & CleftIoNative.CLEFT_IO_WRITES_SIZING) != 0));
        });
        return List.copyOf(formats);
    }

    /**
     * What a file most likely holds.
     *
     * @param path the file, or a folder with a DICOM series
     * @return a guess
     */
    public static Content guess(Path path) {
        NativeLibrary.files();
        return Content.values()[CleftIoNative.cleft_io_guess(bytes(path))];
    }

    /**
     * Reads a volume: NIfTI, NRRD, MetaImage, TIFF, a folder with a DICOM series and more.
     *
     * @param mesher who reads
     * @param reading how
     * @param options of which the smoothing is read; may be null
     * @param paths one file, or one a material: indicator functions
     * @return a volume
     */
    public static Volume readVolume(Mesher mesher, Reading reading, Options options, Path... paths) {
        byte[] names = bytes(paths);
        return withReading(reading, how -> new Volume(mesher.make((context, arguments, out) ->
                CleftIoNative.cleft_io_read_volume(context, arguments[0], names, how, out), options)));
    }

    /**
     * Reads a volume as its file says.
     *
     * @param mesher who reads
     * @param path the file
     * @return a volume
     */
    public static Volume readVolume(Mesher mesher, Path path) {
        return readVolume(mesher, Reading.DEFAULT, null, path);
    }

    /**
     * Reads voxels without a header, x fastest.
     *
     * @param mesher who reads
     * @param type of the voxels
     * @param bigEndian whether the most significant byte comes first
     * @param skip bytes before the first voxel
     * @param dims voxels along x, y and z
     * @param spacing lengths of a voxel; or null for 1
     * @param options of which the smoothing is read; may be null
     * @param paths one file, or one a material: indicator functions
     * @return a volume
     */
    public static Volume readRaw(Mesher mesher, VoxelType type, boolean bigEndian, long skip, long[] dims,
            double[] spacing, Options options, Path... paths) {
        if (dims.length != 3 || spacing != null && spacing.length != 3)
            throw new IllegalArgumentException("dims and spacing must have 3 numbers");
        byte[] names = bytes(paths);
        NativeLibrary.files();
        NativeRaw raw = new NativeRaw();
        try {
            raw.setType(type.number);
            raw.setBig_endian(bigEndian ? 1 : 0);
            raw.setSkip(skip);
            for (int axis = 0; axis < 3; ++axis)
                raw.set_axis(axis, dims[axis], spacing == null ? 0 : spacing[axis]);
            return new Volume(mesher.make((context, arguments, out) ->
                    CleftIoNative.cleft_io_read_raw(context, arguments[0], names, raw, out), options));
        } finally {
            raw.delete();
        }
    }

    /**
     * Reads a field of one number a voxel.
     *
     * @param mesher who reads
     * @param reading how
     * @param path the file
     * @return the field
     */
    public static Field readField(Mesher mesher, Reading reading, Path path) {
        long[] dims = new long[3];
        double[] affine = new double[12];
        byte[] name = bytes(path);
        long values = withReading(reading, how -> mesher.make((context, arguments, out) ->
                CleftIoNative.cleft_io_read_field(context, name, how, dims, affine, out)));
        try {
            Grid grid = new Grid(dims[0], dims[1], dims[2]).affine(affine);
            double[] copy = new double[NativeObject.length(grid.voxels(), 1)];
            int batch = 1 << 20;
            for (int at = 0; at < copy.length; at += batch) {
                int count = Math.min(batch, copy.length - at);
                CleftNative.memory_at(values + 8L * at, 8L * count).order(java.nio.ByteOrder.nativeOrder())
                        .asDoubleBuffer().get(copy, at, count);
            }
            return new Field(grid, copy);
        } finally {
            CleftIoNative.cleft_io_free(values);
        }
    }

    /**
     * Reads a sizing field of your own, from a file with the same voxels as the volume.
     *
     * @param mesher who reads
     * @param volume the volume
     * @param reading how; the world in which the volume was read
     * @param combine whether to take the lesser of this and of the computed field
     * @param options for the computed field; may be null
     * @param path the file
     * @return a sizing field
     */
    public static Sizing readSizing(
            Mesher mesher, Volume volume, Reading reading, boolean combine, Options options, Path path) {
        Objects.requireNonNull(volume, "volume");
        byte[] name = bytes(path);
        return withReading(reading, how -> new Sizing(mesher.make((context, arguments, out) ->
                CleftIoNative.cleft_io_read_sizing(
                        context, arguments[0], name, how, combine ? 1 : 0, arguments[1], out), volume, options)));
    }

    /**
     * Writes a sizing field as a volume of numbers, to look at.
     *
     * @param mesher who writes
     * @param sizing the field
     * @param world the one in which the volume was read
     * @param path the file
     */
    public static void writeSizing(Mesher mesher, Sizing sizing, World world, Path path) {
        Objects.requireNonNull(sizing, "sizing");
        NativeLibrary.files();
        byte[] name = bytes(path);
        mesher.run((context, arguments, out) ->
                CleftIoNative.cleft_io_write_sizing(context, arguments[0], name, world.ordinal()), sizing);
    }

    /**
     * Reads a mesh of tetrahedra: .vtu, .vtk, .mesh, .msh, .node with .ele.
     *
     * @param mesher who reads
     * @param path the file
     * @return a mesh
     */
    public static Mesh readMesh(Mesher mesher, Path path) {
        NativeLibrary.files();
        byte[] name = bytes(path);
        return new Mesh(mesher.make((context, arguments, out) -> CleftIoNative.cleft_io_read_mesh(context, name, out)));
    }

    /**
     * Writes a mesh in the format of the extension of the path, all or nothing.
     *
     * @param mesher who writes
     * @param mesh the mesh
     * @param path the file
     */
    public static void writeMesh(Mesher mesher, Mesh mesh, Path path) {
        NativeLibrary.files();
        writeMesh(mesher, mesh, path, CleftIoNative.CLEFT_FORMAT_BY_NAME);
    }

    /**
     * Writes a mesh, all or nothing.
     *
     * @param mesher who writes
     * @param mesh the mesh
     * @param path the file
     * @param format the name of a {@link Format}
     */
    public static void writeMesh(Mesher mesher, Mesh mesh, Path path, String format) {
        int[] number = {CleftIoNative.CLEFT_FORMAT_BY_NAME};
        eachFormat(row -> {
            if (row.getName().equals(format))
                number[0] = row.getFormat();
        });
        if (number[0] == CleftIoNative.CLEFT_FORMAT_BY_NAME)
            throw new IllegalArgumentException("there is no format of meshes " + format);
        writeMesh(mesher, mesh, path, number[0]);
    }

    private static void writeMesh(Mesher mesher, Mesh mesh, Path path, int format) {
        Objects.requireNonNull(mesh, "mesh");
        byte[] name = bytes(path);
        mesher.run((context, arguments, out) ->
                CleftIoNative.cleft_io_write_mesh(context, arguments[0], name, format), mesh);
    }

    private static void eachFormat(java.util.function.Consumer<NativeFormatDescription> use) {
        NativeLibrary.files();
        NativeFormatDescription row = new NativeFormatDescription();
        try {
            for (int index = 0; index < CleftIoNative.cleft_io_format_count(); ++index) {
                CleftException.check(CleftIoNative.cleft_io_format_info(index, row));
                use.accept(row);
            }
        } finally {
            row.delete();
        }
    }

    private static <T> T withReading(Reading reading, java.util.function.Function<NativeReading, T> use) {
        NativeLibrary.files();
        NativeReading how = new NativeReading();
        try {
            how.setWorld(reading.world().ordinal());
            how.setKind(reading.kind().ordinal());
            for (int axis = 0; reading.spacing() != null && axis < 3; ++axis)
                how.set_spacing(axis, reading.spacing()[axis]);
            return use.apply(how);
        } finally {
            how.delete();
        }
    }

    /** Texts for the library, each closed by a zero. */
    private static byte[] bytes(Path... paths) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        for (Path path : paths) {
            bytes.writeBytes(path.toString().getBytes(StandardCharsets.UTF_8));
            bytes.write(0);
        }
        return bytes.toByteArray();
    }
}
