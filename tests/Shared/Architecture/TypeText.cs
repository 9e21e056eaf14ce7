using System.Globalization;
using System.Reflection;
using System.Text;

namespace NeuronMocap.Tests.Architecture;

/// <summary>Types, parameters and constants in C# notation, including nullable annotations.</summary>
internal static class TypeText
{
    private static readonly Dictionary<Type, string> Keywords = new()
    {
        [typeof(void)] = "void",
        [typeof(object)] = "object",
        [typeof(string)] = "string",
        [typeof(bool)] = "bool",
        [typeof(char)] = "char",
        [typeof(sbyte)] = "sbyte",
        [typeof(byte)] = "byte",
        [typeof(short)] = "short",
        [typeof(ushort)] = "ushort",
        [typeof(int)] = "int",
        [typeof(uint)] = "uint",
        [typeof(long)] = "long",
        [typeof(ulong)] = "ulong",
        [typeof(nint)] = "nint",
        [typeof(nuint)] = "nuint",
        [typeof(float)] = "float",
        [typeof(double)] = "double",
        [typeof(decimal)] = "decimal",
    };

    public static string Of(Type type) => Of(type, nullability: null);

    public static string Of(FieldInfo field) => Of(field.FieldType, new NullabilityInfoContext().Create(field));

    public static string Of(PropertyInfo property) => Of(property.PropertyType, new NullabilityInfoContext().Create(property));

    public static string Of(EventInfo one) => Of(one.EventHandlerType!, new NullabilityInfoContext().Create(one));

    public static string Of(ParameterInfo parameter)
    {
        string type = Of(parameter.ParameterType, new NullabilityInfoContext().Create(parameter));
        if (string.IsNullOrEmpty(parameter.Name))
            return type;

        string modifier = (parameter.ParameterType.IsByRef, parameter.IsOut, parameter.IsIn) switch
        {
            (true, true, _) => "out ",
            (true, _, true) => "in ",
            (true, _, _) => "ref ",
            _ => parameter.CustomAttributes.Any(one => one.AttributeType.Name is "ParamArrayAttribute" or "ParamCollectionAttribute")
                ? "params "
                : "",
        };
        string value = parameter.HasDefaultValue ? " = " + DefaultOf(parameter) : "";
        return $"{modifier}{type} {parameter.Name}{value}";
    }

    public static string Literal(object? value) => value switch
    {
        null => "null",
        string text => $"\"{text}\"",
        bool flag => flag ? "true" : "false",
        _ => Convert.ToString(value, CultureInfo.InvariantCulture)!,
    };

    public static string Constraints(IEnumerable<Type> arguments)
    {
        var text = new StringBuilder();
        foreach (Type argument in arguments.Where(argument => argument.IsGenericParameter))
        {
            GenericParameterAttributes attributes = argument.GenericParameterAttributes;
            List<string> parts = [];
            if (attributes.HasFlag(GenericParameterAttributes.ReferenceTypeConstraint))
                parts.Add("class");
            if (attributes.HasFlag(GenericParameterAttributes.NotNullableValueTypeConstraint))
                parts.Add("struct");
            IEnumerable<Type> bases = argument.GetGenericParameterConstraints().Where(one => one != typeof(ValueType));
            parts.AddRange(bases.Select(Of).Order(StringComparer.Ordinal));
            if (attributes.HasFlag(GenericParameterAttributes.DefaultConstructorConstraint) && !parts.Contains("struct", StringComparer.Ordinal))
                parts.Add("new()");
            if (parts.Count > 0)
                text.Append(CultureInfo.InvariantCulture, $" where {argument.Name} : {string.Join(", ", parts)}");
        }

        return text.ToString();
    }

    private static string DefaultOf(ParameterInfo parameter)
    {
        Type type = Nullable.GetUnderlyingType(parameter.ParameterType) ?? parameter.ParameterType;
        return parameter.RawDefaultValue switch
        {
            null when type.IsValueType && type == parameter.ParameterType => "default",
            { } value when type.IsEnum => $"{Of(type)}.{Enum.ToObject(type, value)}",
            var value => Literal(value),
        };
    }

    private static string Of(Type type, NullabilityInfo? nullability)
    {
        if (type.IsByRef)
            return Of(type.GetElementType()!, nullability);

        string mark = !type.IsValueType && nullability is not null && NullabilityState.Nullable == ReadOrWrite(nullability) ? "?" : "";
        if (type.IsArray)
            return $"{Of(type.GetElementType()!, nullability?.ElementType)}[{new string(',', type.GetArrayRank() - 1)}]{mark}";
        if (type.IsPointer)
            return Of(type.GetElementType()!) + "*";
        if (Nullable.GetUnderlyingType(type) is { } value)
            return Of(value, nullability?.GenericTypeArguments.FirstOrDefault()) + "?";
        if (type.IsGenericParameter)
            return type.Name + mark;

        return (Keywords.TryGetValue(type, out string? keyword) ? keyword : FullName(type, nullability)) + mark;
    }

    private static NullabilityState ReadOrWrite(NullabilityInfo nullability) =>
        nullability.ReadState == NullabilityState.Unknown ? nullability.WriteState : nullability.ReadState;

    private static string FullName(Type type, NullabilityInfo? nullability)
    {
        Type[] all = type.GetGenericArguments();
        int inherited = type.DeclaringType?.GetGenericArguments().Length ?? 0;
        string outer = type.DeclaringType is { } declaring ? OuterName(declaring, all) : type.Namespace ?? "";
        NullabilityInfo[] states = nullability?.GenericTypeArguments ?? [];
        IEnumerable<string> arguments = all.Skip(inherited).Select((argument, i) => Of(argument, states.ElementAtOrDefault(inherited + i)));
        string list = string.Join(", ", arguments);
        return $"{outer}.{type.Name.Split('`')[0]}{(list.Length > 0 ? $"<{list}>" : "")}";
    }

    private static string OuterName(Type declaring, Type[] arguments) =>
        Of(declaring.IsGenericTypeDefinition ? declaring.MakeGenericType(arguments[..declaring.GetGenericArguments().Length]) : declaring);
}
