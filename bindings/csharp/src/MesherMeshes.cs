using System;

namespace Cleft
{
    // Meshes, and the reports on them.
    public sealed partial class Mesher
    {
        // ----------------------------------------------------------------------------------------------- meshes

        /// <summary>Meshes a volume.</summary>
        public Mesh Mesh(Volume volume, Options options = null) { return Mesh(volume, null, null, options); }

        /// <summary>Meshes a volume with a sizing field or a background mesh of your own; both may be null. If both are
        /// given, the background is adapted to the metric of the field.</summary>
        public Mesh Mesh(Volume volume, Sizing sizing, Mesh background, Options options = null)
        {
            NativeHandle of = Required(volume, nameof(volume)), how = HandleOf(options);
            NativeHandle sizes = HandleOf(sizing), behind = HandleOf(background);
            return new Mesh(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_mesh_volume(context, of, sizes, behind, how, out made)));
        }

        /// <summary>The background mesh of a sizing field: it fills the box and knows nothing of labels.</summary>
        public Mesh BackgroundMesh(Sizing sizing, Options options = null)
        {
            NativeHandle sizes = Required(sizing, nameof(sizing)), how = HandleOf(options);
            return new Mesh(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_background_create(context, sizes, how, out made)));
        }

        /// <summary>Cleaves a background mesh along the interfaces of a volume.</summary>
        public Mesh Cleave(Volume volume, Mesh background, Options options = null)
        {
            NativeHandle of = Required(volume, nameof(volume)), how = HandleOf(options);
            NativeHandle behind = Required(background, nameof(background));
            return new Mesh(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_mesh_cleave(context, of, behind, how, out made)));
        }

        /// <summary>Raises the worst dihedral angles of a cleaved mesh of this volume.</summary>
        public Mesh Improve(Volume volume, Mesh cleaved, Options options = null)
        {
            NativeHandle of = Required(volume, nameof(volume)), how = HandleOf(options);
            NativeHandle mesh = Required(cleaved, nameof(cleaved));
            return new Mesh(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_mesh_improve(context, of, mesh, how, out made)));
        }

        /// <summary>The mesh without the labels that Options.Strip and Options.Only leave out.</summary>
        public Mesh Strip(Mesh whole, Options options)
        {
            NativeHandle mesh = Required(whole, nameof(whole)), how = Required(options, nameof(options));
            return new Mesh(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_mesh_strip(context, mesh, how, out made)));
        }

        /// <summary>
        /// A mesh from arrays, which are copied: x y z of each point, 4 numbers of points a tetrahedron counted from
        /// indexBase (0 or 1), and their labels, or null for 0.
        /// </summary>
        public Mesh MeshOf(double[] points, int[] tets, int[] labels = null, int indexBase = 0)
        {
            Arguments.Groups(points, 3, "point", nameof(points));
            Arguments.Groups(tets, 4, "tetrahedron", nameof(tets));
            if (labels != null)
                Arguments.Length(labels, tets.Length / 4, nameof(labels));
            Arguments.IndexBase(indexBase, nameof(indexBase));
            return new Mesh(Make((NativeHandle context, out IntPtr made) => CleftNative.cleft_mesh_create(
                context, points.Length / 3, points, tets.Length / 4, tets, labels, indexBase, out made)));
        }

        // ------------------------------------------------------------------------------------- what meshes are

        /// <summary>
        /// What Mesh(volume, sizing, background, options) will come to: tetrahedra, within 15 %, and memory. No mesh is
        /// made.
        /// </summary>
        public Estimate Estimate(Volume volume, Sizing sizing = null, Mesh background = null, Options options = null)
        {
            NativeHandle of = Required(volume, nameof(volume)), how = HandleOf(options);
            NativeHandle sizes = HandleOf(sizing), behind = HandleOf(background);
            using (var figures = new NativeEstimate()) {
                Run(context => CleftNative.cleft_mesh_estimate(context, of, sizes, behind, how, figures));
                return new Estimate(figures);
            }
        }

        /// <summary>The shape of the tetrahedra in figures.</summary>
        public Quality Quality(Mesh mesh)
        {
            NativeHandle of = Required(mesh, nameof(mesh));
            using (var figures = new NativeQuality()) {
                Run(context => CleftNative.cleft_mesh_quality(context, of, figures));
                return new Quality(figures);
            }
        }

        /// <summary>How well a mesh meets the metric of a sizing field.</summary>
        public MetricQuality MetricQuality(Mesh mesh, Sizing sizing)
        {
            NativeHandle of = Required(mesh, nameof(mesh)), by = Required(sizing, nameof(sizing));
            using (var figures = new NativeMetricQuality()) {
                Run(context => CleftNative.cleft_mesh_metric_quality(context, of, by, figures));
                return new MetricQuality(figures);
            }
        }

        /// <summary>Looks for faults. With fillsBox, the mesh is also asked to fill its bounding box.</summary>
        public Validation Validate(Mesh mesh, bool fillsBox = false)
        {
            NativeHandle of = Required(mesh, nameof(mesh));
            using (var found = new NativeValidation()) {
                string sentence = "";
                Run(context => {
                    int status = CleftNative.cleft_mesh_validate(context, of, fillsBox ? 1 : 0, found);
                    sentence = CleftNative.cleft_context_last_error(context);
                    return status;
                });
                return new Validation(found, sentence);
            }
        }

        /// <summary>The triangles between labels and those of the hull.</summary>
        public Surface Surface(Mesh mesh)
        {
            NativeHandle of = Required(mesh, nameof(mesh));
            return new Surface(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_surface_create(context, of, out made)));
        }

        /// <summary>
        /// What became of each label, for a mesh that was not stripped, in the order of Volume.Labels; and which labels
        /// touch in the mesh alone.
        /// </summary>
        public Report Report(Volume volume, Mesh mesh) { return Report(volume, mesh, false); }

        /// <summary>The same, with distances between interfaces if <paramref name="withDistances"/>.</summary>
        public Report Report(Volume volume, Mesh mesh, bool withDistances)
        {
            NativeHandle before = Required(volume, nameof(volume)), after = Required(mesh, nameof(mesh));
            IntPtr address = Make((NativeHandle context, out IntPtr made) => withDistances
                ? CleftNative.cleft_report_create_with_distances(context, before, after, out made)
                : CleftNative.cleft_report_create(context, before, after, out made));
            using (var report = new NativeHandle(address, CleftNative.cleft_report_destroy))
                return new Report(report);
        }
    }
}
