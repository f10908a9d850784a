namespace Cleft
{
    /// <summary>How a picture shows a mesh; all labels in their colours on white, if nothing is set.</summary>
    public sealed class Picture
    {
        /// <summary>What gives a tetrahedron its colour.</summary>
        public Colouring By { get; set; }
        /// <summary>Two measures at the ends of the colours; or null for those of the colouring.</summary>
        public double[] Range { get; set; }
        /// <summary>What is behind the mesh.</summary>
        public Backdrop Backdrop { get; set; }
        /// <summary>Pixels across.</summary>
        public int Width { get; set; } = 1200;
        /// <summary>Pixels down.</summary>
        public int Height { get; set; } = 900;
        /// <summary>
        /// Where the mesh is cut across x, y and z, as shares of the box, 0 for no cut; or null. Whole tetrahedra are
        /// taken away on the side of the eye, those in front of all cuts.
        /// </summary>
        public double[] Cut { get; set; }
        /// <summary>Labels that are not drawn.</summary>
        public int[] Strip { get; set; } = new int[0];
        /// <summary>Labels that are not cut.</summary>
        public int[] Whole { get; set; } = new int[0];
        /// <summary>The direction from the mesh to the eye; or null.</summary>
        public double[] View { get; set; }
        /// <summary>The direction that is upwards; or null.</summary>
        public double[] Up { get; set; }
        /// <summary>1 to fill the picture.</summary>
        public double Zoom { get; set; } = 1;
        /// <summary>Are the edges of the tetrahedra drawn?</summary>
        public bool Edges { get; set; } = true;
        /// <summary>The width of edges, in pixels.</summary>
        public double LineWidth { get; set; } = 1;
        /// <summary>Are the colours explained at the right?</summary>
        public bool Legend { get; set; }

        internal NativePicture ToNative()
        {
            Check(Cut, 3, nameof(Cut));
            Check(View, 3, nameof(View));
            Check(Up, 3, nameof(Up));
            Check(Range, 2, nameof(Range));
            Arguments.AtLeastOne(Width, nameof(Width));
            Arguments.AtLeastOne(Height, nameof(Height));
            Arguments.Positive(Zoom, nameof(Zoom));
            Arguments.Positive(LineWidth, nameof(LineWidth));
            var look = new NativePicture {
                by = (int)Arguments.Defined(By, nameof(By)),
                backdrop = (int)Arguments.Defined(Backdrop, nameof(Backdrop)),
                width = Width, height = Height, no_edges = Edges ? 0 : 1, legend = Legend ? 1 : 0,
                zoom = Zoom, line_width = LineWidth
            };
            for (int axis = 0; axis < 3; ++axis) {
                look.set_cut(axis, Cut == null ? 0 : Cut[axis]);
                look.set_view(axis, View == null ? 0 : View[axis]);
                look.set_up(axis, Up == null ? 0 : Up[axis]);
            }
            for (int end = 0; end < 2; ++end)
                look.set_range(end, Range == null ? 0 : Range[end]);
            return look;
        }

        private static void Check(double[] numbers, int wanted, string name)
        {
            if (numbers != null)
                Arguments.Length(numbers, wanted, name);
        }
    }
}
