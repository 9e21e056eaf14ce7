using System.Reflection;

namespace UnityEngine.StandIn;

/// <summary>The requirements of attributes on component types.</summary>
internal static class ComponentRules
{
    public static IEnumerable<Type> GetRequired(Type type) => type
        .GetCustomAttributes<RequireComponent>(inherit: true)
        .SelectMany(static needs => (Type?[])[needs.m_Type0, needs.m_Type1, needs.m_Type2])
        .OfType<Type>();

    public static bool Requires(Type type, Type other) => GetRequired(type).Any(needed => needed.IsAssignableFrom(other));

    public static bool IsSingle(Type type) => type.IsDefined(typeof(DisallowMultipleComponent), inherit: true);

    public static bool RunsInEditMode(Type type) =>
        type.IsDefined(typeof(ExecuteAlways), inherit: true) || type.IsDefined(typeof(ExecuteInEditMode), inherit: true);

    public static int GetOrder(Type type) => type.GetCustomAttribute<DefaultExecutionOrder>(inherit: true)?.order ?? 0;
}
