using System;
using System.Collections;
using System.Collections.Generic;

namespace Cleft
{
    /// <summary>What became of each label, in the order of Volume.Labels; and the labels that came to touch.</summary>
    public sealed class Report : IReadOnlyList<LabelReport>
    {
        private readonly List<LabelReport> rows = new List<LabelReport>();

        internal Report(NativeHandle report)
        {
            for (long index = 0; index < CleftNative.cleft_report_count(report); ++index)
                using (var row = new NativeLabelReport()) {
                    CleftException.Check(CleftNative.cleft_report_label(report, index, row));
                    rows.Add(new LabelReport(row));
                }
            var contacts = new List<Contact>();
            for (long index = 0; index < CleftNative.cleft_report_contact_count(report); ++index)
                using (var row = new NativeContact()) {
                    CleftException.Check(CleftNative.cleft_report_contact(report, index, row));
                    contacts.Add(new Contact(row));
                }
            Contacts = contacts;
            var distances = new List<Distance>();
            for (long index = 0; index < CleftNative.cleft_report_distance_count(report); ++index)
                using (var row = new NativeDistance()) {
                    CleftException.Check(CleftNative.cleft_report_distance(report, index, row));
                    distances.Add(new Distance(row));
                }
            Distances = distances;
        }

        /// <summary>
        /// Pairs of labels that touch in the mesh, but not in the volume, ascending; empty if all is well.
        /// </summary>
        public IReadOnlyList<Contact> Contacts { get; }

        /// <summary>
        /// How far the interfaces of the mesh are from those of the volume, by their labels, then its lines; empty
        /// if that was not asked for.
        /// </summary>
        public IReadOnlyList<Distance> Distances { get; }

        /// <summary>Row <paramref name="index"/>.</summary>
        public LabelReport this[int index] => rows[index];

        /// <summary>How many labels there are.</summary>
        public int Count => rows.Count;

        /// <inheritdoc/>
        public IEnumerator<LabelReport> GetEnumerator() { return rows.GetEnumerator(); }

        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }

        /// <summary>What this is, in a few words.</summary>
        public override string ToString() { return "Report of " + Count + " labels, " + Contacts.Count + " contacts"; }
    }

    /// <summary>
    /// Two labels that share triangles in the mesh, but of which no two voxels share a face or an edge. The gap between
    /// them is narrower than the tetrahedra there, and a smaller size opens it.
    /// </summary>
    public sealed partial class Contact
    {
        /// <summary>What this is, in a few words.</summary>
        public override string ToString()
        {
            return FormattableString.Invariant($"Contact of {First} and {Second}: {Triangles} triangles");
        }
    }

    /// <summary>
    /// How far an interface of the mesh is from that of the volume, in world units, or a line where three labels meet.
    /// </summary>
    public sealed partial class Distance
    {
        /// <summary>What this is, in a few words.</summary>
        public override string ToString()
        {
            return FormattableString.Invariant($"Distance of {First} and {Second}: at most {MeshGreatest}");
        }
    }
}
