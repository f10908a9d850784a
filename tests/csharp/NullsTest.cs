using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Threading;
using Cleft;

/// <summary>
/// Null for each parameter of each public method and constructor in turn: it is taken, or refused by its name.
/// </summary>
sealed class NullsTest
{
    static readonly Type[] kinds = {
        typeof(Mesher), typeof(Options), typeof(Volume), typeof(Sizing), typeof(Mesh), typeof(Surface), typeof(Grid),
        typeof(RawVoxels), typeof(Reading), typeof(Picture), typeof(View), typeof(MeshFiles)
    };

    readonly Mesher mesher = new Mesher { Log = null };
    readonly Dictionary<Type, object> samples = new Dictionary<Type, object>();

    void MakeSamples()
    {
        int voxels = (int)Checks.Grid.Voxels;
        Volume volume = Checks.BallVolume(mesher);
        Mesh mesh = Checks.BallMesh(mesher);
        foreach (object sample in new object[] {
            mesher, Checks.Quick(), volume, mesh, mesher.ConstantSizing(volume, 3), mesher.Surface(mesh), Checks.Grid,
            new RawVoxels { Dims = new long[] { 1, 1, 1 } }, new Reading(), new Picture(), new View(),
            "no such folder/a.vtu",
            new[] { "no such folder/a.vtu" },
            new byte[voxels], new short[voxels], new ushort[voxels], new int[voxels], new uint[voxels], new long[3],
            new float[voxels], new double[voxels], new[] { new float[voxels], new float[voxels] },
            new[] { new double[voxels], new double[voxels] }, CancellationToken.None, 0, 1L, 1.0, false,
            Marshal.AllocHGlobal(8 * voxels) })
            samples[sample.GetType()] = sample;
        samples[typeof(Func<double, string, bool>)] = (Func<double, string, bool>)((fraction, stage) => true);
        samples[typeof(Action<LogLevel, string>)] = (Action<LogLevel, string>)((level, sentence) => { });
    }

    void TestEveryNull()
    {
        MakeSamples();
        var all = kinds.SelectMany(kind => kind.GetConstructors().Cast<MethodBase>().Concat(kind.GetMethods(
            BindingFlags.Public | BindingFlags.Static | BindingFlags.Instance | BindingFlags.DeclaredOnly)));
        int tried = 0;
        foreach (MethodBase one in all)
            foreach (ParameterInfo parameter in one.GetParameters())
                if (!parameter.ParameterType.IsValueType && !parameter.IsOut) {
                    TryNull(one, parameter);
                    ++tried;
                }
        Checks.Check(tried > 60, "only " + tried + " were tried");
    }

    void TryNull(MethodBase one, ParameterInfo at)
    {
        object[] arguments = one.GetParameters().Select(parameter => parameter == at ? null : Sample(parameter))
            .ToArray();
        object on = one.IsStatic || one is ConstructorInfo ? null : samples[one.DeclaringType];
        PropertyInfo property = one.IsSpecialName && on != null
            ? one.DeclaringType.GetProperty(one.Name.Replace("set_", "")) : null;
        object former = property?.GetValue(on);
        string who = one.DeclaringType.Name + "." + one.Name + "(" + at.Name + ")";
        try {
            if (one is ConstructorInfo constructor)
                constructor.Invoke(arguments);
            else
                one.Invoke(on, arguments);
            property?.SetValue(on, former);
        } catch (TargetInvocationException thrown) {
            string name = property?.Name ?? at.Name;
            if (thrown.InnerException is ArgumentNullException failure)
                Checks.Check(failure.ParamName == name, who + " names " + failure.ParamName);
            else
                Checks.Check(
                    !(thrown.InnerException is NullReferenceException)
                        && !thrown.InnerException.Message.Contains("NULL"),
                    who + ": " + thrown.InnerException);
        }
    }

    object Sample(ParameterInfo parameter)
    {
        Type type = parameter.ParameterType;
        if (parameter.IsOut)
            return null;
        return type.IsEnum ? Enum.GetValues(type).GetValue(0) : samples[type];
    }
}
