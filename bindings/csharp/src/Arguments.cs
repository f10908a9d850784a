using System;

namespace Cleft
{
    /// <summary>What arguments must be. The sentence on a wrong one has its name in C#, and its value.</summary>
    internal static class Arguments
    {
        internal static T NotNull<T>(T value, string name) where T : class
        {
            return value ?? throw new ArgumentNullException(name);
        }

        internal static void Length(Array array, int wanted, string name)
        {
            if (NotNull(array, name).Length != wanted)
                throw new ArgumentException(name + " has " + Elements(array) + "; it must have " + wanted, name);
        }

        internal static void Groups(Array array, int each, string what, string name)
        {
            if (NotNull(array, name).Length % each != 0)
                throw new ArgumentException(
                    name + " has " + Elements(array) + "; it must have " + each + " a " + what, name);
        }

        internal static void Positive(double value, string name)
        {
            if (!(value > 0) || double.IsInfinity(value))
                throw new ArgumentOutOfRangeException(name, value, name + " must be above 0 and finite");
        }

        internal static void Finite(double value, string name)
        {
            if (double.IsNaN(value) || double.IsInfinity(value))
                throw new ArgumentOutOfRangeException(name, value, name + " must be finite");
        }

        /// <summary>As the library refuses points of its world.</summary>
        internal static void FinitePoint(double value, string name)
        {
            if (double.IsNaN(value) || double.IsInfinity(value))
                CleftException.Check(CleftNative.CLEFT_ERROR_NOT_FINITE, name + " is NaN or infinite");
        }

        internal static void AtLeastOne(long value, string name)
        {
            if (value < 1)
                throw new ArgumentOutOfRangeException(name, value, name + " must be at least 1");
        }

        internal static void IndexBase(int value, string name)
        {
            if (value != 0 && value != 1)
                throw new ArgumentOutOfRangeException(name, value, name + " must be 0 or 1");
        }

        /// <summary>Enumerations take any number by a cast.</summary>
        internal static T Defined<T>(T value, string name)
        {
            if (!Enum.IsDefined(typeof(T), value))
                throw new ArgumentOutOfRangeException(
                    name, value, name + " is none of " + string.Join(", ", Enum.GetNames(typeof(T))));
            return value;
        }

        private static string Elements(Array array)
        {
            return array.LongLength == 1 ? "1 element" : array.LongLength + " elements";
        }
    }
}
