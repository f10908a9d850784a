using System;
using System.Collections.Generic;

namespace Cleft
{
    /// <summary>What a mesh will come to.</summary>
    public sealed partial class Estimate
    {
        /// <summary>What this is, in a few words.</summary>
        public override string ToString()
        {
            return FormattableString.Invariant(
                $"Estimate of {(IsRough ? "roughly " : "")}{Tets:0} tetrahedra and {PeakBytes:0} bytes");
        }
    }

    /// <summary>The shape of a mesh in figures. Angles are dihedral angles, in degrees.</summary>
    public sealed partial class Quality
    {
        /// <summary>What this is, in a few words.</summary>
        public override string ToString()
        {
            return FormattableString.Invariant(
                $"Quality of {TetCount} tetrahedra: dihedral angles {MinDihedral:0.0} to {MaxDihedral:0.0} degrees");
        }
    }

    /// <summary>How well a mesh meets a metric, which measures an edge of the wanted length as 1.</summary>
    public sealed partial class MetricQuality
    {
        /// <summary>What this is, in a few words.</summary>
        public override string ToString()
        {
            return FormattableString.Invariant(
                $"MetricQuality of {TetCount} tetrahedra: {EdgesInRange} of {EdgeCount} edges are in range");
        }
    }

    /// <summary>What is wrong with a mesh; all counts are 0 for a sound one.</summary>
    public sealed partial class Validation
    {
        internal Validation(NativeValidation row, string sentence) : this(row) { FirstFault = IsValid ? "" : sentence; }

        /// <summary>The first fault and its place, "" if there is none.</summary>
        public string FirstFault { get; }

        /// <summary>What this is, in a few words.</summary>
        public override string ToString()
        {
            return IsValid ? "Validation: nothing is wrong" : "Validation: " + FirstFault;
        }
    }

    /// <summary>What became of one label. Volumes are in world units cubed.</summary>
    public sealed partial class LabelReport
    {
        /// <summary>What this is, in a few words.</summary>
        public override string ToString()
        {
            return FormattableString.Invariant(
                $"LabelReport of {Label}: {Voxels} voxels of volume {VoxelVolume}, {Tets} tetrahedra of {MeshVolume}");
        }
    }

    /// <summary>One row of the library's table of options.</summary>
    public sealed class OptionDescription
    {
        private OptionDescription(NativeOptionDescription row)
        {
            Name = row.name;
            Type = (OptionType)row.type;
            Default = row.value;
            Least = row.least;
            Greatest = row.greatest;
            Choices = row.choices.Length == 0 ? new string[0] : row.choices.Split('|');
            Text = row.text;
            Group = row.group;
            Calls = row.calls.Split('|');
        }

        /// <summary>As in "feature_scale".</summary>
        public string Name { get; }
        /// <summary>What values it takes.</summary>
        public OptionType Type { get; }
        /// <summary>The default, as a number.</summary>
        public double Default { get; }
        /// <summary>The least value.</summary>
        public double Least { get; }
        /// <summary>The greatest value.</summary>
        public double Greatest { get; }
        /// <summary>Names of the choices 0, 1, ...; empty for other types.</summary>
        public IReadOnlyList<string> Choices { get; }
        /// <summary>What it does.</summary>
        public string Text { get; }
        /// <summary>The heading under which help lists it.</summary>
        public string Group { get; }
        /// <summary>
        /// The calls that read it, as C names them: "volume", "sizing", "background", "cleave", "improve", "mesh".
        /// </summary>
        public IReadOnlyList<string> Calls { get; }

        /// <summary>All options that have one value.</summary>
        public static IReadOnlyList<OptionDescription> Table()
        {
            NativeModules.Core();
            var rows = new List<OptionDescription>();
            for (int index = 0; index < CleftNative.cleft_option_count(); ++index)
                using (var row = new NativeOptionDescription()) {
                    CleftException.Check(CleftNative.cleft_option_info(index, row));
                    rows.Add(new OptionDescription(row));
                }
            return rows;
        }
    }

    /// <summary>What there is to know of the library.</summary>
    public static class Library
    {
        /// <summary>The version of the native library, as in "1.2.3".</summary>
        public static string Version
        {
            get {
                NativeModules.Core();
                return CleftNative.cleft_version(null, null, null);
            }
        }

        /// <summary>Is TetGen in this build, so that DelaunayEngine.Tetgen can be chosen?</summary>
        public static bool HasTetgen
        {
            get {
                NativeModules.Core();
                return CleftNative.cleft_has_tetgen() != 0;
            }
        }
    }
}
