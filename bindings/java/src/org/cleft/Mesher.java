package org.cleft;

import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;

/**
 * Makes volumes, sizing fields and meshes, and tells how they are made: with how many threads, with what progress.
 *
 * <pre>{@code
 * try (var mesher = new Mesher();
 *         var options = new Options().sizeMax(4);
 *         var volume = mesher.labels(voxels, new Grid(64, 64, 64), options);
 *         var mesh = mesher.mesh(volume, options)) {
 *     double[] points = mesh.points();
 * }
 * }</pre>
 *
 * <p>One call runs on a Mesher at a time; another thread that tries gets an IllegalStateException. {@link #cancel} is
 * for other threads. Interrupting the thread that makes a call cancels it too. Where options may be null, null stands
 * for the defaults.
 */
public final class Mesher extends NativeObject {
    private final Calls calls = new Calls(handle());
    private Progress progress;
    private Log log = Log::showWarnings;

    /** A mesher with one thread. */
    public Mesher() {
        super("Mesher", create(), NativeSize.SMALL, CleftNative::cleft_context_destroy);
        checked(address -> CleftNative.cleft_context_set_progress(address, true));
        checked(address -> CleftNative.cleft_context_set_log(address, true));
    }

    private static long create() {
        NativeLibrary.core();
        long[] out = out();
        CleftException.check(CleftNative.cleft_context_create(out));
        return out[0];
    }

    // ------------------------------------------------------------------------------------------ how calls run

    /**
     * Sets how many threads calls use. The result does not depend on it.
     *
     * @param threads 1 to 1024, or 0 for as many as the machine has
     * @return this mesher
     */
    public Mesher threads(int threads) {
        run((context, arguments, out) -> CleftNative.cleft_context_set_threads(context, threads));
        return this;
    }

    /**
     * How many threads calls use.
     *
     * @return their number, 0 for as many as the machine has
     */
    public int threads() {
        return with(CleftNative::cleft_context_threads);
    }

    /**
     * Sets the function that receives how far calls have come.
     *
     * @param progress a function, or null
     * @return this mesher
     */
    public Mesher progress(Progress progress) {
        this.progress = progress;
        return this;
    }

    /**
     * Sets the function that receives warnings and remarks: at first {@link Log#showWarnings}.
     *
     * @param log a function, or null for nobody
     * @return this mesher
     */
    public Mesher log(Log log) {
        run((context, arguments, out) -> CleftNative.cleft_context_set_log(context, log != null));
        this.log = log;
        return this;
    }

    /** Asks the call that runs on this mesher to stop soon with {@link CleftException.Cancelled}; from any thread. */
    public void cancel() {
        checked(CleftNative::cleft_context_cancel);
    }

    /**
     * Figures that the stages noted: seconds, counts, angles before and after.
     *
     * @return by name, in the order in which they came
     */
    public Map<String, Double> metrics() {
        Map<String, Double> figures = new LinkedHashMap<>();
        byte[][] name = new byte[1][];
        double[] value = new double[1];
        run((context, arguments, out) -> {
            int status = CleftNative.CLEFT_OK;
            long count = CleftNative.cleft_context_metric_count(context);
            for (long index = 0; index < count && status == CleftNative.CLEFT_OK; ++index) {
                status = CleftNative.cleft_context_metric(context, index, name, value);
                figures.put(Text.of(name[0]), value[0]);
            }
            return status;
        });
        return figures;
    }

    /** Forgets the figures. */
    public void clearMetrics() {
        run((context, arguments, out) -> CleftNative.cleft_context_clear_metrics(context));
    }

    // -------------------------------------------------------------------------------------------------- volumes

    /**
     * A label map of bytes without sign, 0 to 255.
     *
     * @param voxels the labels, x fastest; copied
     * @param grid how many there are and where they lie
     * @param options of which the smoothing is read; may be null
     * @return a volume
     */
    public Volume labels(byte[] voxels, Grid grid, Options options) {
        return VoxelArrays.labels(this, VoxelType.UINT8, voxels, grid, options);
    }

    /**
     * A label map of short numbers.
     *
     * @param voxels the labels, x fastest; copied
     * @param grid how many there are and where they lie
     * @param options of which the smoothing is read; may be null
     * @return a volume
     */
    public Volume labels(short[] voxels, Grid grid, Options options) {
        return VoxelArrays.labels(this, VoxelType.INT16, voxels, grid, options);
    }

    /**
     * A label map.
     *
     * @param voxels the labels, x fastest; copied
     * @param grid how many there are and where they lie
     * @param options of which the smoothing is read; may be null
     * @return a volume
     */
    public Volume labels(int[] voxels, Grid grid, Options options) {
        return VoxelArrays.labels(this, VoxelType.INT32, voxels, grid, options);
    }

    /**
     * A label map in a direct buffer, for volumes too large for an array, or that lie outside the heap anyway.
     *
     * @param voxels all of a direct buffer, from 0 to its limit, in the byte order of the machine; copied
     * @param type of the voxels, one of the whole numbers
     * @param grid how many there are and where they lie
     * @param options of which the smoothing is read; may be null
     * @return a volume
     */
    public Volume labels(ByteBuffer voxels, VoxelType type, Grid grid, Options options) {
        return VoxelArrays.labels(this, type, voxels, grid, options);
    }

    /**
     * Indicator functions, one for each material: the greatest wins. One alone is a signed function, inside where it is
     * above 0.
     *
     * @param fields the functions, x fastest; copied
     * @param grid how many voxels there are and where they lie
     * @param labels what the materials are called, or null for 0, 1, 2, ...; two for one function, the outside first
     * @return a volume
     */
    public Volume indicators(double[][] fields, Grid grid, int[] labels) {
        return VoxelArrays.indicators(this, VoxelType.FLOAT64, fields, grid, labels);
    }

    /**
     * Indicator functions of single precision; else as those of double precision.
     *
     * @param fields the functions, x fastest; copied
     * @param grid how many voxels there are and where they lie
     * @param labels what the materials are called, or null for 0, 1, 2, ...; two for one function, the outside first
     * @return a volume
     */
    public Volume indicators(float[][] fields, Grid grid, int[] labels) {
        return VoxelArrays.indicators(this, VoxelType.FLOAT32, fields, grid, labels);
    }

    // --------------------------------------------------------------------------------------------------- sizing

    /**
     * The sizing field of a volume, from its features.
     *
     * @param volume the volume
     * @param options of which those of sizes are read; may be null
     * @return a sizing field
     */
    public Sizing sizing(Volume volume, Options options) {
        Objects.requireNonNull(volume, "volume");
        return new Sizing(make((context, arguments, out) ->
                CleftNative.cleft_sizing_create(context, arguments[0], arguments[1], out), volume, options));
    }

    /**
     * One size everywhere.
     *
     * @param volume the volume
     * @param size the edge length, in world units
     * @return a sizing field
     */
    public Sizing constantSizing(Volume volume, double size) {
        Objects.requireNonNull(volume, "volume");
        return new Sizing(make((context, arguments, out) ->
                CleftNative.cleft_sizing_create_constant(context, arguments[0], size, out), volume));
    }

    /**
     * A sizing field of your own.
     *
     * @param volume the volume
     * @param values one edge length a voxel, above 0, x fastest; copied
     * @param combine whether to take the lesser of this and of the computed field
     * @param options for the computed field; may be null
     * @return a sizing field
     */
    public Sizing sizing(Volume volume, float[] values, boolean combine, Options options) {
        return VoxelArrays.sizing(this, volume, VoxelType.FLOAT32, values, combine, options);
    }

    /**
     * A sizing field of your own, in double precision.
     *
     * @param volume the volume
     * @param values one edge length a voxel, above 0, x fastest; copied
     * @param combine whether to take the lesser of this and of the computed field
     * @param options for the computed field; may be null
     * @return a sizing field
     */
    public Sizing sizing(Volume volume, double[] values, boolean combine, Options options) {
        return VoxelArrays.sizing(this, volume, VoxelType.FLOAT64, values, combine, options);
    }

    /**
     * One metric everywhere: wanted lengths that depend on the direction.
     *
     * @param volume the volume
     * @param tensor xx, xy, xz, yy, yz, zz of a symmetric M; an edge v is to have v^T M v = 1, in world units
     * @return a sizing field
     */
    public Sizing constantMetricSizing(Volume volume, double[] tensor) {
        return VoxelArrays.constantMetricSizing(this, volume, tensor);
    }

    /**
     * A sizing field with a metric: wanted lengths that depend on the direction.
     *
     * @param volume the volume
     * @param tensors xx, xy, xz, yy, yz, zz of a symmetric M for each voxel, x fastest; copied. An edge v is to have
     *     v^T M v = 1, in world units
     * @param combine whether no length may be greater than that of the computed field
     * @param options for the computed field, and the bounds of lengths; may be null
     * @return a sizing field
     */
    public Sizing metricSizing(Volume volume, float[] tensors, boolean combine, Options options) {
        return VoxelArrays.metricSizing(this, volume, VoxelType.FLOAT32, tensors, combine, options);
    }

    /**
     * A sizing field with a metric, in double precision.
     *
     * @param volume the volume
     * @param tensors xx, xy, xz, yy, yz, zz of a symmetric M for each voxel, x fastest; copied. An edge v is to have
     *     v^T M v = 1, in world units
     * @param combine whether no length may be greater than that of the computed field
     * @param options for the computed field, and the bounds of lengths; may be null
     * @return a sizing field
     */
    public Sizing metricSizing(Volume volume, double[] tensors, boolean combine, Options options) {
        return VoxelArrays.metricSizing(this, volume, VoxelType.FLOAT64, tensors, combine, options);
    }

    // --------------------------------------------------------------------------------------------------- meshes

    /**
     * Meshes a volume.
     *
     * @param volume the volume
     * @param options how; may be null
     * @return a mesh
     */
    public Mesh mesh(Volume volume, Options options) {
        return mesh(volume, null, null, options);
    }

    /**
     * Meshes a volume with a sizing field or a background mesh of your own. If both are given, the background is
     * adapted to the metric of the field.
     *
     * @param volume the volume
     * @param sizing how long edges are to be; may be null
     * @param background the mesh that is cleaved; may be null
     * @param options how; may be null
     * @return a mesh
     */
    public Mesh mesh(Volume volume, Sizing sizing, Mesh background, Options options) {
        Objects.requireNonNull(volume, "volume");
        return new Mesh(make((context, arguments, out) -> CleftNative.cleft_mesh_volume(
                context, arguments[0], arguments[1], arguments[2], arguments[3], out),
                volume, sizing, background, options));
    }

    /**
     * The background mesh of a sizing field: it fills the box and knows nothing of labels.
     *
     * @param sizing how long edges are to be
     * @param options of which the kind of background is read; may be null
     * @return a mesh with label 0 only
     */
    public Mesh background(Sizing sizing, Options options) {
        Objects.requireNonNull(sizing, "sizing");
        return new Mesh(make((context, arguments, out) ->
                CleftNative.cleft_background_create(context, arguments[0], arguments[1], out), sizing, options));
    }

    /**
     * Cleaves a background mesh along the interfaces of a volume.
     *
     * @param volume the volume
     * @param background the mesh
     * @param options how; may be null
     * @return a mesh
     */
    public Mesh cleave(Volume volume, Mesh background, Options options) {
        Objects.requireNonNull(volume, "volume");
        Objects.requireNonNull(background, "background");
        return new Mesh(make((context, arguments, out) -> CleftNative.cleft_mesh_cleave(
                context, arguments[0], arguments[1], arguments[2], out), volume, background, options));
    }

    /**
     * Raises the worst dihedral angles of a cleaved mesh.
     *
     * @param volume the volume of which it was made
     * @param cleaved the mesh
     * @param options how; may be null
     * @return a mesh
     */
    public Mesh improve(Volume volume, Mesh cleaved, Options options) {
        Objects.requireNonNull(volume, "volume");
        Objects.requireNonNull(cleaved, "cleaved");
        return new Mesh(make((context, arguments, out) -> CleftNative.cleft_mesh_improve(
                context, arguments[0], arguments[1], arguments[2], out), volume, cleaved, options));
    }

    /**
     * The mesh without the labels that {@link Options#strip} and {@link Options#only} leave out.
     *
     * @param whole the mesh
     * @param options what to leave out
     * @return a mesh
     */
    public Mesh strip(Mesh whole, Options options) {
        Objects.requireNonNull(whole, "whole");
        Objects.requireNonNull(options, "options");
        return new Mesh(make((context, arguments, out) ->
                CleftNative.cleft_mesh_strip(context, arguments[0], arguments[1], out), whole, options));
    }

    /**
     * A mesh from arrays: a background of your own, or a finished mesh to check or write.
     *
     * @param points x y z of each; copied
     * @param tets 4 numbers of points each; copied
     * @param labels one a tetrahedron, or null for 0; copied
     * @param indexBase the number of the first point, 0 or 1
     * @return a mesh
     */
    public Mesh meshOf(double[] points, int[] tets, int[] labels, int indexBase) {
        Arguments.groups("points", Objects.requireNonNull(points, "points").length, 3, "point");
        Arguments.groups("tets", Objects.requireNonNull(tets, "tets").length, 4, "tetrahedron");
        if (labels != null)
            Arguments.length("labels", labels.length, tets.length / 4);
        Arguments.indexBase(indexBase);
        return new Mesh(make((context, arguments, out) -> CleftNative.cleft_mesh_create(
                context, points.length / 3, points, tets.length / 4, tets, labels, indexBase, out)));
    }

    // ----------------------------------------------------------------------------------------- what meshes are

    /**
     * What {@link #mesh(Volume, Sizing, Mesh, Options)} will come to with the same arguments: tetrahedra, within 15 %,
     * and memory. No mesh is made.
     *
     * @param volume the volume
     * @param sizing a sizing field of your own, or null
     * @param background a background mesh of your own, or null
     * @param options the options, or null for the defaults
     * @return the figures
     */
    public Estimate estimate(Volume volume, Sizing sizing, Mesh background, Options options) {
        Objects.requireNonNull(volume, "volume");
        NativeEstimate figures = new NativeEstimate();
        try {
            run((context, arguments, out) -> CleftNative.cleft_mesh_estimate(
                    context, arguments[0], arguments[1], arguments[2], arguments[3], figures),
                    volume, sizing, background, options);
            return Estimate.of(figures);
        } finally {
            figures.delete();
        }
    }

    /**
     * The shape of the tetrahedra in figures.
     *
     * @param mesh the mesh
     * @return the figures
     */
    public Quality quality(Mesh mesh) {
        Objects.requireNonNull(mesh, "mesh");
        NativeQuality figures = new NativeQuality();
        try {
            run((context, arguments, out) -> CleftNative.cleft_mesh_quality(context, arguments[0], figures), mesh);
            return Quality.of(figures);
        } finally {
            figures.delete();
        }
    }

    /**
     * How well a mesh meets the metric of a sizing field.
     *
     * @param mesh the mesh
     * @param sizing a field that has a metric
     * @return the figures
     */
    public MetricQuality metricQuality(Mesh mesh, Sizing sizing) {
        Objects.requireNonNull(mesh, "mesh");
        Objects.requireNonNull(sizing, "sizing");
        NativeMetricQuality figures = new NativeMetricQuality();
        try {
            run((context, arguments, out) -> CleftNative.cleft_mesh_metric_quality(
                    context, arguments[0], arguments[1], figures), mesh, sizing);
            return MetricQuality.of(figures);
        } finally {
            figures.delete();
        }
    }

    /**
     * Looks for faults.
     *
     * @param mesh the mesh
     * @param fillsBox whether it is also asked to fill its bounding box
     * @return what was found
     */
    public Validation validate(Mesh mesh, boolean fillsBox) {
        Objects.requireNonNull(mesh, "mesh");
        NativeValidation found = new NativeValidation();
        try {
            run((context, arguments, out) ->
                    CleftNative.cleft_mesh_validate(context, arguments[0], fillsBox ? 1 : 0, found), mesh);
            return Validation.of(found, with(CleftNative::cleft_context_last_error));
        } finally {
            found.delete();
        }
    }

    /**
     * The triangles between labels and those of the hull.
     *
     * @param mesh the mesh
     * @return its surface
     */
    public Surface surface(Mesh mesh) {
        Objects.requireNonNull(mesh, "mesh");
        return new Surface(make((context, arguments, out) ->
                CleftNative.cleft_surface_create(context, arguments[0], out), mesh));
    }

    /**
     * What became of each label, and which labels touch in the mesh alone.
     *
     * @param volume the volume
     * @param mesh its mesh, not stripped
     * @return a list with a row a label, in the order of {@link Volume#labels}
     */
    public Report report(Volume volume, Mesh mesh) {
        return report(volume, mesh, CleftNative::cleft_report_create);
    }

    /**
     * The same, and how far the interfaces of the mesh are from those of the volume.
     *
     * @param volume the volume
     * @param mesh its mesh, not stripped
     * @return a list with a row a label, whose {@link Report#distances} are there
     */
    public Report reportWithDistances(Volume volume, Mesh mesh) {
        return report(volume, mesh, CleftNative::cleft_report_create_with_distances);
    }

    private interface ReportCall {
        int call(long context, long volume, long mesh, long[] out);
    }

    private Report report(Volume volume, Mesh mesh, ReportCall create) {
        Objects.requireNonNull(volume, "volume");
        Objects.requireNonNull(mesh, "mesh");
        long report = make((context, arguments, out) ->
                create.call(context, arguments[0], arguments[1], out), volume, mesh);
        try {
            return new Report(report);
        } finally {
            CleftNative.cleft_report_destroy(report);
        }
    }

    /** Runs a call that makes something, and answers its address. */
    long make(Calls.Call call, NativeObject... arguments) {
        return run(call, arguments)[0];
    }

    /** Runs a call on this context, while the arguments cannot go away. */
    long[] run(Calls.Call call, NativeObject... arguments) {
        return calls.run(new Callbacks(progress, log), call, arguments);
    }

    @Override
    String description() {
        return " of " + threads() + " threads";
    }
}
