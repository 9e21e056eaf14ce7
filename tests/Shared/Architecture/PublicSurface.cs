using System.Globalization;
using System.Reflection;
using System.Runtime.CompilerServices;

namespace NeuronMocap.Tests.Architecture;

/// <summary>
/// Everything that a user of an assembly can see. There is one line for each type and member, sorted: full name first, then signature, type and
/// modifiers. Lines do not depend on the build, the culture or the order of declaration.
/// </summary>
internal static class PublicSurface
{
    private const BindingFlags Declared =
        BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    public static IReadOnlyList<string> Of(Assembly assembly)
    {
        SortedSet<string> lines = new(StringComparer.Ordinal);
        foreach (Type type in assembly.GetExportedTypes())
        {
            lines.Add(OfType(type));
            lines.UnionWith(Members(type));
        }

        return [.. lines];
    }

    private static string OfType(Type type)
    {
        IEnumerable<string> bases = [.. BaseOf(type), .. InterfacesOf(type)];
        string list = string.Join(", ", bases);
        string inherits = list.Length > 0 ? " : " + list : "";
        return $"{TypeText.Of(type)} [{KindOf(type)}]{inherits}{TypeText.Constraints(type.GetGenericArguments())}";
    }

    private static string KindOf(Type type)
    {
        if (type.IsEnum)
            return type.IsDefined(typeof(FlagsAttribute)) ? "flags enum" : "enum";
        if (typeof(Delegate).IsAssignableFrom(type))
            return "delegate";
        if (type.IsInterface)
            return "interface";
        if (type.IsValueType)
            return (Has(type, "IsReadOnlyAttribute") ? "readonly " : "") + (type.IsByRefLike ? "ref struct" : "struct");

        return (type.IsAbstract, type.IsSealed) switch
        {
            (true, true) => "static class",
            (true, false) => "abstract class",
            (false, true) => "sealed class",
            _ => "class",
        };
    }

    private static IEnumerable<string> BaseOf(Type type)
    {
        if (type.IsEnum)
            return [TypeText.Of(Enum.GetUnderlyingType(type))];

        bool plain = type.IsValueType || type.BaseType is null || type.BaseType == typeof(object) || typeof(Delegate).IsAssignableFrom(type);
        return plain ? [] : [TypeText.Of(type.BaseType!)];
    }

    private static IEnumerable<string> InterfacesOf(Type type)
    {
        if (type.IsEnum || typeof(Delegate).IsAssignableFrom(type))
            return [];

        IEnumerable<Type> inherited = type.BaseType?.GetInterfaces() ?? [];
        return type.GetInterfaces().Except(inherited).Where(one => one.IsVisible).Select(TypeText.Of).Order(StringComparer.Ordinal);
    }

    private static IEnumerable<string> Members(Type type)
    {
        if (type.IsEnum)
            return type.GetFields(BindingFlags.Public | BindingFlags.Static).Select(OfField);
        if (typeof(Delegate).IsAssignableFrom(type))
            return [OfMethod(type.GetMethod("Invoke")!)];

        return
        [
            .. type.GetConstructors(Declared).Where(constructor => IsVisible(constructor) && !constructor.IsStatic).Select(OfConstructor),
            .. type.GetFields(Declared).Where(field => field.IsPublic || field.IsFamily || field.IsFamilyOrAssembly).Select(OfField),
            .. type.GetProperties(Declared).Where(property => property.GetAccessors(nonPublic: true).Any(IsVisible)).Select(OfProperty),
            .. type.GetEvents(Declared).Where(one => IsVisible(one.AddMethod!)).Select(OfEvent),
            .. type.GetMethods(Declared).Where(method => IsVisible(method) && IsWritten(method)).Select(OfMethod),
        ];
    }

    private static string OfConstructor(ConstructorInfo constructor) =>
        $"{TypeText.Of(constructor.DeclaringType!)}.ctor({Parameters(constructor)}){Modifiers(constructor)}";

    private static string OfField(FieldInfo field)
    {
        string name = $"{TypeText.Of(field.DeclaringType!)}.{field.Name}";
        if (field.DeclaringType!.IsEnum)
            return $"{name} = {Convert.ToString(field.GetRawConstantValue(), CultureInfo.InvariantCulture)}";

        string type = TypeText.Of(field);
        if (field.IsLiteral)
            return $"{name} -> {type} = {TypeText.Literal(field.GetRawConstantValue())} [const]";

        string modifiers = (field.IsStatic ? " [static]" : "") + (field.IsInitOnly ? " [readonly]" : "") + (field.IsPublic ? "" : " [protected]");
        return $"{name} -> {type}{modifiers}";
    }

    private static string OfProperty(PropertyInfo property)
    {
        string index = string.Join(", ", property.GetIndexParameters().Select(TypeText.Of));
        string name = $"{TypeText.Of(property.DeclaringType!)}.{(index.Length > 0 ? $"this[{index}]" : property.Name)}";
        string required = Has(property, "RequiredMemberAttribute") ? " [required]" : "";
        MethodInfo first = property.GetAccessors(nonPublic: true).First(IsVisible);
        string accessors = Accessor(property.GetMethod, "get") + Setter(property.SetMethod);
        return $"{name} {{ {accessors}}} -> {TypeText.Of(property)}{Modifiers(first)}{required}";
    }

    private static string Setter(MethodInfo? setter)
    {
        bool init = setter is not null && setter.ReturnParameter.GetRequiredCustomModifiers().Any(one => one.Name is "IsExternalInit");
        return Accessor(setter, init ? "init" : "set");
    }

    private static string Accessor(MethodInfo? accessor, string keyword) =>
        accessor is null || !IsVisible(accessor) ? "" : $"{(accessor.IsPublic ? "" : "protected ")}{keyword}; ";

    private static string OfEvent(EventInfo one) =>
        $"{TypeText.Of(one.DeclaringType!)}.{one.Name} -> event {TypeText.Of(one)}{Modifiers(one.AddMethod!)}";

    private static string OfMethod(MethodInfo method)
    {
        string generic = method.IsGenericMethod ? $"<{string.Join(", ", method.GetGenericArguments().Select(one => one.Name))}>" : "";
        string constraints = method.IsGenericMethod ? TypeText.Constraints(method.GetGenericArguments()) : "";
        string name = $"{TypeText.Of(method.DeclaringType!)}.{method.Name}{generic}({Parameters(method)})";
        return $"{name} -> {TypeText.Of(method.ReturnParameter)}{constraints}{Modifiers(method)}";
    }

    private static string Parameters(MethodBase method)
    {
        string extension = method.IsDefined(typeof(ExtensionAttribute)) ? "this " : "";
        return extension + string.Join(", ", method.GetParameters().Select(TypeText.Of));
    }

    private static string Modifiers(MethodBase method)
    {
        string access = method.IsPublic ? "" : " [protected]";
        if (method.IsStatic)
            return access + " [static]";
        if (method.IsAbstract)
            return access + (method.DeclaringType!.IsInterface ? "" : " [abstract]");
        if (!method.IsVirtual || method is not MethodInfo info)
            return access;
        if (info.GetBaseDefinition() != info)
            return access + (info.IsFinal ? " [sealed override]" : " [override]");

        return access + (info.IsFinal ? "" : " [virtual]");
    }

    // Accessors are written with their property or event. Compiler-generated names cannot be called.
    private static bool IsWritten(MethodInfo method) =>
        !method.Name.Contains('<', StringComparison.Ordinal) && (!method.IsSpecialName || method.Name.StartsWith("op_", StringComparison.Ordinal));

    private static bool IsVisible(MethodBase method) => method.IsPublic || method.IsFamily || method.IsFamilyOrAssembly;

    private static bool Has(MemberInfo member, string attribute) =>
        member.CustomAttributes.Any(one => string.Equals(one.AttributeType.Name, attribute, StringComparison.Ordinal));
}
