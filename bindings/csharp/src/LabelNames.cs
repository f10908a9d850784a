using System;
using System.Collections.Generic;

namespace Cleft
{
    /// <summary>What volumes and meshes share of the names of labels.</summary>
    internal static class LabelNames
    {
        /// <summary>The names that are not empty.</summary>
        internal static IReadOnlyDictionary<int, string> Of(ArrayView<int> labels, Func<int, string> name)
        {
            var names = new Dictionary<int, string>();
            foreach (int label in labels)
                if (name(label).Length > 0)
                    names[label] = name(label);
            return names;
        }

        /// <summary>Throws as the library would, with a sentence.</summary>
        internal static void Check(string what, ArrayView<int> labels, int label, string name)
        {
            Arguments.NotNull(name, nameof(name));
            foreach (char letter in name)
                if (char.IsControl(letter))
                    CleftException.Check(CleftNative.CLEFT_ERROR_ARGUMENT, "name has a control character in it");
            int[] all = labels.ToArray();
            if (Array.IndexOf(all, label) < 0)
                CleftException.Check(CleftNative.CLEFT_ERROR_ARGUMENT,
                    "label is " + label + ", which " + what + " has not; it has " + Listed(all));
        }

        private static string Listed(int[] labels)
        {
            const int most = 10;
            string text = string.Join(", ", new ArraySegment<int>(labels, 0, Math.Min(most, labels.Length)));
            return labels.Length > most ? text + " and " + (labels.Length - most) + " more" : text;
        }
    }
}
