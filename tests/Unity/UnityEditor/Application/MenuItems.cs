using System.Reflection;
using UnityEngine.StandIn;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>The menu entries of the package.</summary>
internal static class MenuItems
{
    public static IReadOnlyList<string> Paths => [.. Find().Where(static item => !item.Entry.validate).Select(static item => item.Entry.menuItem)];

    /// <returns>False if the item does not exist, or if its validation disables it.</returns>
    public static bool Execute(string path, Object? context = null)
    {
        (MenuItem Entry, MethodInfo Method)[] found = [.. Find().Where(item => item.Entry.menuItem == path)];
        MethodInfo? check = found.FirstOrDefault(static item => item.Entry.validate).Method;
        MethodInfo? action = found.FirstOrDefault(static item => !item.Entry.validate).Method;
        if (action is null || (check is not null && !(bool)Call(check, context)!))
            return false;

        Call(action, context);
        return true;
    }

    private static object? Call(MethodInfo method, Object? context) =>
        method.Invoke(null, method.GetParameters().Length == 0 ? [] : [new MenuCommand(context)]);

    private static IEnumerable<(MenuItem Entry, MethodInfo Method)> Find() =>
        from assembly in ScriptStatics.Assemblies
        from type in assembly.GetTypes()
        from method in type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic)
        from entry in method.GetCustomAttributes<MenuItem>()
        select (entry, method);
}
