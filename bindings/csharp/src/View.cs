namespace Cleft
{
    /// <summary>What a page that shows a mesh has besides; nothing more, if nothing is set.</summary>
    public sealed class View
    {
        /// <summary>What the mesh is called; or null.</summary>
        public string Title { get; set; }
        /// <summary>The report of "cleft mesh --json", as text; or null.</summary>
        public string Report { get; set; }
        /// <summary>The path of a table of the names of labels; or null for the names of the mesh.</summary>
        public string Names { get; set; }
        /// <summary>The least dihedral angle that is marked, in degrees; 0 for that of the report, else 25.</summary>
        public double Goal { get; set; }
        /// <summary>How many tetrahedra the page has at most; 0 for 3,000,000.</summary>
        public long MaxTets { get; set; }
        /// <summary>A second mesh to compare with; or null.</summary>
        public Mesh Other { get; set; }
        /// <summary>What the second mesh is called; or null.</summary>
        public string OtherTitle { get; set; }
        /// <summary>The report of the second mesh; or null.</summary>
        public string OtherReport { get; set; }

        internal static byte[] Text(string text, string name)
        {
            return Utf8.Write(text ?? "", name);
        }
    }
}
