using System.Collections;
using System.Reflection;

namespace UnityEngine.StandIn;

/// <summary>Determines the fields that Unity serialises, and copies their values.</summary>
internal static class Serialization
{
    private const BindingFlags Declared = BindingFlags.DeclaredOnly | BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;

    /// <summary>Returns the serialised fields, those of base types first: public or [SerializeField], of a kind that Unity can serialise.</summary>
    public static IEnumerable<FieldInfo> GetFields(Type type)
    {
        if (type.BaseType is { } parent && parent != typeof(object) && parent != typeof(ValueType))
        {
            foreach (FieldInfo field in GetFields(parent))
                yield return field;
        }

        if (typeof(Object).IsAssignableFrom(type) && type.Assembly == typeof(Object).Assembly)
            yield break;

        foreach (FieldInfo field in type.GetFields(Declared).OrderBy(static field => field.MetadataToken))
        {
            bool isOffered = field.IsPublic || field.IsDefined(typeof(SerializeField));
            if (isOffered && !field.IsInitOnly && !field.IsDefined(typeof(NonSerializedAttribute)) && IsKept(field.FieldType))
                yield return field;
        }
    }

    public static bool IsKept(Type type) =>
        IsLeaf(type)
        || (GetElementType(type) is { } element && GetElementType(element) is null && IsKept(element))
        || (type.IsDefined(typeof(SerializableAttribute), inherit: false) && type.Namespace?.StartsWith("System", StringComparison.Ordinal) != true
            && !typeof(Delegate).IsAssignableFrom(type) && !type.IsAbstract);

    public static bool IsLeaf(Type type) =>
        type.IsPrimitive || type.IsEnum || type == typeof(string) || typeof(Object).IsAssignableFrom(type)
        || (type.IsValueType && type.Assembly == typeof(Object).Assembly) || type == typeof(AnimationCurve);

    public static Type? GetElementType(Type type) =>
        type.IsArray && type.GetArrayRank() == 1 ? type.GetElementType()
        : type.IsGenericType && type.GetGenericTypeDefinition() == typeof(List<>) ? type.GetGenericArguments()[0]
        : null;

    /// <summary>Copies a serialised value. References to objects go through <paramref name="map"/>.</summary>
    public static object? Copy(object? value, Type type, Func<Object, Object> map)
    {
        if (value is Object item)
            return map(item);

        if (value is AnimationCurve curve)
            return new AnimationCurve([.. curve.keys]);

        if (GetElementType(type) is { } element)
            return CopyList((IList?)value, type, element, map);

        if (IsLeaf(type))
            return value ?? (type == typeof(string) ? "" : null);

        object copy = Activator.CreateInstance(type, nonPublic: true)!;
        if (value is not null)
            CopyFields(value, copy, map);

        return copy;
    }

    public static void CopyFields(object from, object to, Func<Object, Object> map)
    {
        foreach (FieldInfo field in GetFields(from.GetType()))
            field.SetValue(to, Copy(field.GetValue(from), field.FieldType, map));
    }

    private static object CopyList(IList? value, Type type, Type element, Func<Object, Object> map)
    {
        int count = value?.Count ?? 0;
        IList copy = type.IsArray ? Array.CreateInstance(element, count) : (IList)Activator.CreateInstance(type)!;
        for (int i = 0; i < count; i++)
        {
            object? item = Copy(value![i], element, map);
            if (type.IsArray)
                copy[i] = item;
            else
                copy.Add(item);
        }

        return copy;
    }
}
