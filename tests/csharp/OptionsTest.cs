using System;
using System.Linq;
using System.Reflection;
using Cleft;

/// <summary>Options: their names, defaults and ranges are those of the library.</summary>
sealed class OptionsTest
{
    static string Pascal(string name)
    {
        return string.Concat(name.Split('_').Select(part => char.ToUpperInvariant(part[0]) + part.Substring(1)));
    }

    void TestEveryOptionIsAProperty()
    {
        var options = new Options();
        Checks.Check(OptionDescription.Table().Count > 10, "no table");
        foreach (OptionDescription row in OptionDescription.Table()) {
            PropertyInfo property = typeof(Options).GetProperty(Pascal(row.Name));
            Checks.Check(property != null, row.Name);
            object value = property.GetValue(options);
            Checks.Equal(row.Default, value is Enum ? (int)value : Convert.ToDouble(value));
            property.SetValue(options, value);
            Checks.Equal(row.Type == OptionType.Choice, property.PropertyType.IsEnum);
            if (property.PropertyType.IsEnum)
                foreach (object choice in Enum.GetValues(property.PropertyType)) {
                    Checks.Equal(row.Choices[(int)choice], choice.ToString().ToLowerInvariant());
                    if (choice.Equals(DelaunayEngine.Tetgen) && !Library.HasTetgen)
                        continue;
                    property.SetValue(options, choice);
                    Checks.Equal(choice, property.GetValue(options));
                }
        }
    }

    void TestValuesAreKept()
    {
        var options = new Options {
            Size = 2, Tets = 1000000000, Smooth = 3, Strict = true, Seed = 1L << 40,
            Strip = new[] { 0, 5 }, Only = new[] { 3 } };
        options.SetLabelSize(3, 0.5).Set("snap", "safe");
        Checks.Equal(2.0, options.Size);
        Checks.Equal(1000000000L, options.Tets);
        Checks.Equal(3, options.Smooth);
        Checks.Equal(true, options.Strict);
        Checks.Equal(1L << 40, options.Seed);
        Checks.Equal(Snap.Safe, options.Snap);
        Checks.Equal(new[] { 0, 5 }, options.Strip);
        Checks.Equal(new[] { 3 }, options.Only);
    }

    void TestWrongValues()
    {
        var options = new Options { Size = 2 };
        Checks.Thrown<InvalidArgumentException>(() => options.Size = double.NaN);
        Checks.Thrown<InvalidArgumentException>(() => options.Size = double.PositiveInfinity);
        Checks.Thrown<InvalidOptionException>(() => options.Size = -1);
        Checks.Thrown<InvalidOptionException>(() => options.Smooth = 99);
        Checks.Thrown<InvalidOptionException>(() => options.Background = (Background)77);
        Checks.Thrown<InvalidOptionException>(() => options.Set("size", "two"));
        Checks.Thrown<InvalidOptionException>(() => options.Set("colour", "red"));
        Checks.Thrown<CleftException>(() => options.SetLabelSize(1, -1));
        Checks.Thrown<CleftException>(() => options.SetLabelSize(1, double.NaN));
        Checks.Thrown<ArgumentNullException>(() => options.Strip = null);
        Checks.Thrown<ArgumentNullException>(() => options.Set(null, "1"));
        Checks.Thrown<ArgumentNullException>(() => options.Set("size", null));
        Checks.Equal(2.0, options.Size);
        options.Dispose();
        Checks.Thrown<ObjectDisposedException>(() => options.Size = 1);
        Checks.Thrown<ObjectDisposedException>(() => Checks.BallVolume(new Mesher()).ToString().Equals(options.Size));
    }
}
