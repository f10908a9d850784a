// Tells what an assembly offers: for each public type and member its identifier in the XML documentation, a tab, and
// its declaration in C#. Members follow their type, in the order of the sources.
using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

static class Signatures
{
    const BindingFlags Declared = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance |
        BindingFlags.Static | BindingFlags.DeclaredOnly;

    static readonly Dictionary<string, string> Keywords = new Dictionary<string, string>
    {
        { "Void", "void" }, { "Object", "object" }, { "String", "string" }, { "Boolean", "bool" }, { "Byte", "byte" },
        { "SByte", "sbyte" }, { "Int16", "short" }, { "UInt16", "ushort" }, { "Int32", "int" }, { "UInt32", "uint" },
        { "Int64", "long" }, { "UInt64", "ulong" }, { "Single", "float" }, { "Double", "double" },
    };

    static bool IsSeen(MethodBase method) =>
        method != null && (method.IsPublic || method.IsFamily || method.IsFamilyOrAssembly);

    // The name of a type as a program writes it.
    static string Name(Type type)
    {
        if (type.IsByRef)
            return Name(type.GetElementType());
        if (type.IsArray)
            return Name(type.GetElementType()) + "[" + new string(',', type.GetArrayRank() - 1) + "]";
        if (Nullable.GetUnderlyingType(type) != null)
            return Name(Nullable.GetUnderlyingType(type)) + "?";
        string name = type.Name.Split('`')[0];
        if (type.IsGenericType)
            return name + "<" + string.Join(", ", type.GetGenericArguments().Select(Name)) + ">";
        if (type.Namespace == "System" && Keywords.ContainsKey(type.Name))
            return Keywords[type.Name];
        return type.IsNested && !type.IsGenericParameter ? Name(type.DeclaringType) + "." + name : name;
    }

    // The name of a type in an identifier.
    static string Id(Type type)
    {
        if (type.IsByRef)
            return Id(type.GetElementType()) + "@";
        if (type.IsArray)
        {
            int rank = type.GetArrayRank();
            string bounds = rank == 1 ? "" : string.Join(",", Enumerable.Repeat("0:", rank));
            return Id(type.GetElementType()) + "[" + bounds + "]";
        }
        if (type.IsGenericParameter)
            return (type.DeclaringMethod != null ? "``" : "`") + type.GenericParameterPosition;
        if (!type.IsGenericType || type.IsGenericTypeDefinition)
            return type.FullName.Replace('+', '.');
        string name = type.GetGenericTypeDefinition().FullName.Split('`')[0].Replace('+', '.');
        return name + "{" + string.Join(",", type.GetGenericArguments().Select(Id)) + "}";
    }

    static string Ids(ParameterInfo[] parameters) =>
        parameters.Length == 0 ? "" : "(" + string.Join(",", parameters.Select(one => Id(one.ParameterType))) + ")";

    static string Value(object value, Type type)
    {
        if (value == null)
            return type.IsValueType ? "default" : "null";
        if (value is string)
            return "\"" + value + "\"";
        if (type.IsEnum)
            return Name(type) + "." + Enum.GetName(type, value);
        return value is bool ? value.ToString().ToLowerInvariant() :
            Convert.ToString(value, System.Globalization.CultureInfo.InvariantCulture);
    }

    static string Parameter(ParameterInfo parameter)
    {
        string text = parameter.IsOut ? "out " : parameter.ParameterType.IsByRef ? "ref " : "";
        text += parameter.IsDefined(typeof(ParamArrayAttribute), false) ? "params " : "";
        text += Name(parameter.ParameterType) + " " + parameter.Name;
        return parameter.IsOptional ? text + " = " + Value(parameter.RawDefaultValue, parameter.ParameterType) : text;
    }

    static string Parameters(ParameterInfo[] parameters) => string.Join(", ", parameters.Select(Parameter));

    static string Access(MethodBase method) =>
        (method.IsPublic ? "public " : "protected ") + (method.IsStatic ? "static " : "") +
        (method.IsAbstract ? "abstract " : method.IsVirtual && !method.IsFinal && method is MethodInfo &&
            ((MethodInfo)method).GetBaseDefinition() != method ? "override " : "");

    static string Generic(Type[] types) =>
        types.Length == 0 ? "" : "<" + string.Join(", ", types.Select(Name)) + ">";

    static string Line(ConstructorInfo made, string owner) =>
        "M:" + owner + ".#ctor" + Ids(made.GetParameters()) + "\t" + Access(made) +
        made.DeclaringType.Name.Split('`')[0] + "(" + Parameters(made.GetParameters()) + ")";

    static string Line(MethodInfo method, string owner)
    {
        var types = method.IsGenericMethod ? method.GetGenericArguments() : new Type[0];
        return "M:" + owner + "." + method.Name + (types.Length > 0 ? "``" + types.Length : "") +
            Ids(method.GetParameters()) + "\t" + Access(method) + Name(method.ReturnType) + " " + method.Name +
            Generic(types) + "(" + Parameters(method.GetParameters()) + ")";
    }

    static string Line(PropertyInfo property, string owner)
    {
        var index = property.GetIndexParameters();
        var shown = IsSeen(property.GetMethod) ? property.GetMethod : property.SetMethod;
        return "P:" + owner + "." + property.Name + Ids(index) + "\t" + Access(shown) + Name(property.PropertyType) +
            " " + (index.Length > 0 ? "this[" + Parameters(index) + "]" : property.Name) + " { " +
            (IsSeen(property.GetMethod) ? "get; " : "") + (IsSeen(property.SetMethod) ? "set; " : "") + "}";
    }

    static string Line(FieldInfo field, string owner)
    {
        string kind = field.IsLiteral ? "const " : field.IsStatic ? "static " : "";
        string value = field.IsLiteral ? " = " + Value(field.GetRawConstantValue(), typeof(object)) : "";
        return "F:" + owner + "." + field.Name + "\t" + (field.DeclaringType.IsEnum
            ? field.Name + value : "public " + kind + Name(field.FieldType) + " " + field.Name + value);
    }

    // The line of a member, or null if programs do not see it.
    static string Line(MemberInfo member, string owner)
    {
        if (member is ConstructorInfo made)
            return IsSeen(made) && !made.IsStatic ? Line(made, owner) : null;
        if (member is MethodInfo method)
            return IsSeen(method) && !method.IsSpecialName && method.Name != "Finalize" ? Line(method, owner) : null;
        if (member is PropertyInfo property)
            return IsSeen(property.GetMethod) || IsSeen(property.SetMethod) ? Line(property, owner) : null;
        if (member is FieldInfo field)
            return (field.IsPublic || field.IsFamily) && !field.IsSpecialName ? Line(field, owner) : null;
        return null;
    }

    static string Declaration(Type type)
    {
        if (typeof(Delegate).IsAssignableFrom(type))
        {
            var invoke = type.GetMethod("Invoke");
            return "public delegate " + Name(invoke.ReturnType) + " " + Name(type) + "(" +
                Parameters(invoke.GetParameters()) + ")";
        }
        string kind = type.IsEnum ? "enum" : type.IsInterface ? "interface" : type.IsValueType ? "struct" :
            type.IsAbstract && type.IsSealed ? "static class" : type.IsAbstract ? "abstract class" :
            type.IsSealed ? "sealed class" : "class";
        var parents = new List<Type>();
        if (type.IsClass && type.BaseType != typeof(object))
            parents.Add(type.BaseType);
        var known = type.BaseType == null ? new Type[0] : type.BaseType.GetInterfaces();
        var added = type.GetInterfaces().Where(one => one.IsVisible && !known.Contains(one)).ToArray();
        parents.AddRange(added.Where(one => !added.Any(other => other.GetInterfaces().Contains(one))));
        return "public " + kind + " " + Name(type) +
            (parents.Count > 0 ? " : " + string.Join(", ", parents.Select(Name)) : "");
    }

    static void Main(string[] arguments)
    {
        var types = Assembly.LoadFrom(arguments[0]).GetTypes().Where(type => type.IsVisible);
        foreach (var type in types.OrderBy(type => type.FullName, StringComparer.Ordinal))
        {
            Console.WriteLine("T:" + Id(type) + "\t" + Declaration(type));
            if (typeof(Delegate).IsAssignableFrom(type))
                continue;
            foreach (var member in type.GetMembers(Declared).OrderBy(member => member.MetadataToken))
            {
                string line = Line(member, Id(type));
                if (line != null)
                    Console.WriteLine(line);
            }
        }
    }
}
