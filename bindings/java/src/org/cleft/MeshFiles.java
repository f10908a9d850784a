package org.cleft;

import java.io.ByteArrayOutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * Reads and writes files. The native part of this class is loaded when it is first used; it needs GDCM and libraries of
 * pictures.
 */
public final class MeshFiles {
    /** Directions of the world axes. */
    public enum World {
        // <World> made by tools/generate.py from include/cleft/cleft_io.h
        /** Left, posterior, superior, as in ITK, DICOM and files of 3D Slicer; the default. */
        LPS,
        /** Right, anterior, superior, as in NIfTI: x and y have the opposite sign. */
        RAS
        // </World>
    }

    /** What the voxels of a file mean. */
    public enum VoxelKind {
        // <VoxelKind> made by tools/generate.py from include/cleft/cleft_io.h
        /**
         * By the values. In one file, whole numbers (within 1/50) are labels. Fractions on both sides of 0 that change
         * from voxel to voxel are a signed function. In several files or frames, 0 and one other whole number each are
         * masks. Fractions are indicator functions. The component refuses anything else.
         */
        AUTO,
        /** Labels, fractions rounded to the nearest; or several masks. */
        LABELS,
        /** Indicator functions, from any type of voxels. */
        INDICATORS
        // </VoxelKind>
    }

    /** What a file holds. */
    public enum Content {
        // <Content> made by tools/generate.py from include/cleft/cleft_io.h
        /** Neither a volume nor a mesh, as far as the name and first bytes show. */
        UNKNOWN,
        /** A volume. */
        VOLUME,
        /** A mesh. */
        MESH
        // </Content>
    }

    /** How the six numbers of a symmetric tensor follow each other in a file. */
    public enum TensorOrder {
        // <TensorOrder> made by tools/generate.py from include/cleft/cleft_io.h
        /** As the file says; six numbers of which it says nothing are refused. */
        FILE,
        /** That of NRRD and of this library: xx, xy, xz, yy, yz, zz. */
        NRRD,
        /** That of VTK: xx, yy, zz, xy, yz, xz. */
        VTK,
        /** That of NIfTI, MEDIT and mmg: xx, xy, yy, xz, yz, zz. */
        NIFTI
        // </TensorOrder>
    }

    /** What gives a tetrahedron its colour on a picture. */
    public enum Colouring {
        // <Colouring> made by tools/generate.py from include/cleft/cleft_io.h
        /** Its label, which has the same colour in every mesh. */
        LABEL,
        /** Its least dihedral angle, from 0 to 70 degrees. */
        ANGLE,
        /** Its radius ratio, from 1 (the regular tetrahedron) to 4. */
        RATIO,
        /** Its mean edge, from the least to the greatest that are drawn, by factors. */
        SIZE
        // </Colouring>
    }

    /** What is behind a mesh on a picture. */
    public enum Backdrop {
        // <Backdrop> made by tools/generate.py from include/cleft/cleft_io.h
        /** White. */
        LIGHT,
        /** Nearly black. */
        DARK,
        /** Nothing: the picture is transparent there. */
        NONE
        // </Backdrop>
    }

    /**
     * How to read a volume.
     *
     * @param world the axes that coordinates come out in
     * @param kind what the voxels mean
     * @param spacing three lengths taken instead of the file's, 0 for the file's; or null. The origin stays
     * @param scale what the file's origin and spacing are multiplied by: 0.001 makes metres of millimetres
     */
    public record Reading(World world, VoxelKind kind, double[] spacing, double scale) {
        /** As the file says. */
        public static final Reading DEFAULT = new Reading(World.LPS, VoxelKind.AUTO, null);

        /**
         * Checks the parts.
         *
         * @param world the axes that coordinates come out in
         * @param kind what the voxels mean
         * @param spacing three lengths taken instead of the file's, 0 for the file's; or null. The origin stays
         * @param scale what the file's origin and spacing are multiplied by: 0.001 makes metres of millimetres
         */
        public Reading {
            Objects.requireNonNull(world, "world");
            Objects.requireNonNull(kind, "kind");
            if (spacing != null)
                Arguments.length("spacing", spacing.length, 3);
            for (int axis = 0; spacing != null && axis < 3; ++axis)
                if (spacing[axis] != 0)
                    Arguments.positive("spacing[" + axis + "]", spacing[axis]);
            Arguments.positive("scale", scale);
        }

        /**
         * In the unit of the file.
         *
         * @param world the axes that coordinates come out in
         * @param kind what the voxels mean
         * @param spacing three lengths taken instead of the file's, 0 for the file's; or null. The origin stays
         */
        public Reading(World world, VoxelKind kind, double[] spacing) {
            this(world, kind, spacing, 1);
        }

        /**
         * The same with another unit of length: coordinates come out multiplied.
         *
         * @param factor what the file's origin and spacing are multiplied by: 0.001 makes metres of millimetres
         * @return how to read
         */
        public Reading scaled(double factor) {
            return new Reading(world, kind, spacing, factor);
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
        return Content.values()[CleftIoNative.cleft_io_guess(bytes("path", path))];
    }

    /**
     * Reads a volume: NIfTI, NRRD, MetaImage, TIFF, a folder with a DICOM series and more.
     *
     * @param mesher who reads
     * @param reading how
     * @param options of which the smoothing is read; may be null
     * @param paths one file, or one a material: masks or indicator functions
     * @return a volume
     */
    public static Volume readVolume(Mesher mesher, Reading reading, Options options, Path... paths) {
        Objects.requireNonNull(mesher, "mesher");
        byte[] names = bytes("paths", paths);
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
        return readVolume(mesher, Reading.DEFAULT, null, Objects.requireNonNull(path, "path"));
    }

    /**
     * Reads voxels without a header.
     *
     * @param mesher who reads
     * @param raw how they lie in the file
     * @param options of which the smoothing is read; may be null
     * @param paths one file, or one a material: as in readVolume()
     * @return a volume
     */
    public static Volume readRaw(Mesher mesher, RawVoxels raw, Options options, Path... paths) {
        Objects.requireNonNull(mesher, "mesher");
        Objects.requireNonNull(raw, "raw");
        byte[] names = bytes("paths", paths);
        NativeLibrary.files();
        NativeRaw how = raw.toNative();
        try {
            return new Volume(mesher.make((context, arguments, out) ->
                    CleftIoNative.cleft_io_read_raw(context, arguments[0], names, how, out), options));
        } finally {
            how.delete();
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
        Objects.requireNonNull(mesher, "mesher");
        long[] dims = new long[3];
        double[] affine = new double[12];
        byte[] name = bytes("path", path);
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
        Objects.requireNonNull(mesher, "mesher");
        Objects.requireNonNull(volume, "volume");
        byte[] name = bytes("path", path);
        return withReading(reading, how -> new Sizing(mesher.make((context, arguments, out) ->
                CleftIoNative.cleft_io_read_sizing(
                        context, arguments[0], name, how, combine ? 1 : 0, arguments[1], out), volume, options)));
    }

    /**
     * Reads a metric of your own, from a file with the same voxels as the volume.
     *
     * @param mesher who reads
     * @param volume the volume, or null for the voxels of the file
     * @param reading how; the world in which the volume was read
     * @param order how the numbers of a tensor follow each other
     * @param combine whether no length may be greater than that of the computed field
     * @param options for the computed field, and the bounds of lengths; may be null
     * @param path the file
     * @return a sizing field that has a metric
     */
    public static Sizing readMetric(Mesher mesher, Volume volume, Reading reading, TensorOrder order, boolean combine,
            Options options, Path path) {
        Objects.requireNonNull(mesher, "mesher");
        Objects.requireNonNull(order, "order");
        byte[] name = bytes("path", path);
        return withReading(reading, how -> new Sizing(mesher.make((context, arguments, out) ->
                CleftIoNative.cleft_io_read_metric(
                        context, arguments[0], name, how, order.ordinal(), combine ? 1 : 0, arguments[1], out),
                volume, options)));
    }

    /**
     * Writes a sizing field as a volume of numbers, or of tensors if it has a metric.
     *
     * @param mesher who writes
     * @param sizing the field
     * @param world the one in which the volume was read
     * @param path the file
     */
    public static void writeSizing(Mesher mesher, Sizing sizing, World world, Path path) {
        Objects.requireNonNull(mesher, "mesher");
        Objects.requireNonNull(sizing, "sizing");
        Objects.requireNonNull(world, "world");
        NativeLibrary.files();
        byte[] name = bytes("path", path);
        mesher.run((context, arguments, out) ->
                CleftIoNative.cleft_io_write_sizing(context, arguments[0], name, world.ordinal()), sizing);
    }

    /**
     * Reads a mesh of tetrahedra: .vtu, .pvtu, .vtk, .vtkhdf, .mesh, .msh, .node with .ele.
     *
     * @param mesher who reads
     * @param path the file
     * @return a mesh
     */
    public static Mesh readMesh(Mesher mesher, Path path) {
        Objects.requireNonNull(mesher, "mesher");
        NativeLibrary.files();
        byte[] name = bytes("path", path);
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
        Objects.requireNonNull(format, "format");
        Map<String, Integer> numbers = new LinkedHashMap<>();
        eachFormat(row -> {
            if ((row.getDirections() & CleftIoNative.CLEFT_IO_WRITES_MESH) != 0)
                numbers.put(row.getName(), row.getFormat());
        });
        if (!numbers.containsKey(format))
            throw new IllegalArgumentException(
                    "format is '" + format + "'; it must be one of " + String.join(", ", numbers.keySet()));
        writeMesh(mesher, mesh, path, numbers.get(format));
    }

    private static void writeMesh(Mesher mesher, Mesh mesh, Path path, int format) {
        Objects.requireNonNull(mesher, "mesher");
        Objects.requireNonNull(mesh, "mesh");
        byte[] name = bytes("path", path);
        mesher.run((context, arguments, out) ->
                CleftIoNative.cleft_io_write_mesh(context, arguments[0], name, format), mesh);
    }

    /**
     * Names the labels of a volume by a table: a label and its name a line, or a table of ITK-SNAP, FreeSurfer,
     * MRIcron or BIDS. Not while another thread uses the volume.
     *
     * @param mesher who reads
     * @param volume the volume
     * @param path the table
     */
    public static void readLabelNames(Mesher mesher, Volume volume, Path path) {
        Objects.requireNonNull(mesher, "mesher");
        Objects.requireNonNull(volume, "volume");
        NativeLibrary.files();
        byte[] name = bytes("path", path);
        mesher.run((context, arguments, out) ->
                CleftIoNative.cleft_io_read_volume_names(context, name, arguments[0]), volume);
    }

    /**
     * Names the labels of a mesh by such a table. Not while another thread uses the mesh.
     *
     * @param mesher who reads
     * @param mesh the mesh
     * @param path the table
     */
    public static void readLabelNames(Mesher mesher, Mesh mesh, Path path) {
        Objects.requireNonNull(mesher, "mesher");
        Objects.requireNonNull(mesh, "mesh");
        NativeLibrary.files();
        byte[] name = bytes("path", path);
        mesher.run((context, arguments, out) ->
                CleftIoNative.cleft_io_read_mesh_names(context, name, arguments[0]), mesh);
    }

    /**
     * Draws a mesh as PNG, without a screen.
     *
     * @param mesher who draws
     * @param mesh the mesh
     * @param picture how it looks
     * @param path the file, whose name ends with .png
     */
    public static void writePicture(Mesher mesher, Mesh mesh, Picture picture, Path path) {
        Objects.requireNonNull(mesher, "mesher");
        Objects.requireNonNull(mesh, "mesh");
        Objects.requireNonNull(picture, "picture");
        byte[] name = bytes("path", path);
        NativeLibrary.files();
        int[] strip = picture.stripped();
        int[] whole = picture.uncut();
        NativePicture look = picture.toNative();
        try {
            mesher.run((context, arguments, out) -> CleftIoNative.cleft_io_write_picture(
                    context, arguments[0], strip, strip.length, whole, whole.length, look, name), mesh);
        } finally {
            look.delete();
        }
    }

    /**
     * Writes a page that shows a mesh in any browser.
     *
     * @param mesher who writes
     * @param mesh the mesh
     * @param view what the page has besides
     * @param path the file
     */
    public static void writeView(Mesher mesher, Mesh mesh, View view, Path path) {
        Objects.requireNonNull(mesher, "mesher");
        Objects.requireNonNull(mesh, "mesh");
        Objects.requireNonNull(view, "view");
        byte[] name = bytes("path", path);
        byte[] table = view.table() == null ? new byte[1] : bytes("table", view.table());
        NativeLibrary.files();
        mesher.run((context, arguments, out) -> view.write(context, arguments, table, name), mesh, view.second());
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
        Objects.requireNonNull(reading, "reading");
        NativeLibrary.files();
        NativeReading how = new NativeReading();
        try {
            how.setWorld(reading.world().ordinal());
            how.setKind(reading.kind().ordinal());
            how.setScale(reading.scale());
            for (int axis = 0; reading.spacing() != null && axis < 3; ++axis)
                how.set_spacing(axis, reading.spacing()[axis]);
            return use.apply(how);
        } finally {
            how.delete();
        }
    }

    /** Texts for the library, each closed by a zero. */
    private static byte[] bytes(String name, Path path) {
        String text = Objects.requireNonNull(path, name).toString();
        // Where the locale cannot tell the letters of a name, the address of the file has its bytes.
        return text.indexOf('\ufffd') < 0 ? Text.bytes(name, text) : Text.unescaped(path.toUri().getRawPath());
    }

    private static byte[] bytes(String name, Path[] paths) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        for (Path path : Arguments.noNulls(name, paths))
            bytes.writeBytes(bytes(name, path));
        return bytes.toByteArray();
    }
}
