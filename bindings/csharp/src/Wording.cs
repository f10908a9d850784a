using System.Collections.Generic;
using System.Text;

namespace Cleft
{
    /// <summary>
    /// Sentences of the library, in which options are called as the properties of Options are: SizeMax for size_max.
    /// </summary>
    internal static class Wording
    {
        private static readonly Dictionary<string, string> Properties = MakeProperties();

        private static Dictionary<string, string> MakeProperties()
        {
            var properties = new Dictionary<string, string> {
                { "threads", "Threads" }, { "strip", "Strip" }, { "only", "Only" }
            };
            foreach (OptionDescription row in OptionDescription.Table())
                properties[row.Name] = PropertyOf(row.Name);
            return properties;
        }

        /// <summary>The sentence for one who writes C#. What is quoted, names of files, stays as it is.</summary>
        internal static string InCSharp(string sentence)
        {
            int first = sentence.IndexOf('\''), end = sentence.LastIndexOf('\'') + 1;
            if (first < 0)
                first = end = sentence.Length;
            return Renamed(sentence.Substring(0, first), true) + sentence.Substring(first, end - first)
                + Renamed(sentence.Substring(end), false);
        }

        /// <summary>
        /// Names of one word are plain words as well: they are renamed only where they begin the sentence.
        /// </summary>
        private static string Renamed(string part, bool beginsSentence)
        {
            var text = new StringBuilder();
            for (int at = 0; at < part.Length;) {
                int end = at;
                while (end < part.Length && IsOfAWord(part[end]))
                    ++end;
                string word = part.Substring(at, end - at);
                bool named = word.IndexOf('_') > 0 || at == 0 && beginsSentence;
                text.Append(named && Properties.TryGetValue(word, out string name) ? name : word);
                if (end < part.Length)
                    text.Append(part[end]);
                at = end + 1;
            }
            return text.ToString();
        }

        private static bool IsOfAWord(char letter) { return char.IsLetterOrDigit(letter) || letter == '_'; }

        private static string PropertyOf(string option)
        {
            string property = "";
            foreach (string part in option.Split('_'))
                property += char.ToUpperInvariant(part[0]) + part.Substring(1);
            return property;
        }
    }
}
