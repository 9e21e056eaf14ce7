using System.Reflection;
using System.Runtime.CompilerServices;

namespace UnityEngine.StandIn;

/// <summary>The static state of the package's assemblies, which a domain reload resets.</summary>
internal static class ScriptStatics
{
    private const BindingFlags Static = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    /// <summary>The assemblies with scripts of the project.</summary>
    public static IEnumerable<Assembly> Assemblies => AppDomain.CurrentDomain.GetAssemblies().Where(static assembly =>
        assembly.GetName().Name is { } name && name.StartsWith("NeuronMocap.Unity", StringComparison.Ordinal) && !name.StartsWith("NeuronMocap.Unity.Tests", StringComparison.Ordinal));

    public static IEnumerable<MethodInfo> GetInitializers(RuntimeInitializeLoadType moment) => Assemblies
        .SelectMany(static assembly => assembly.GetTypes())
        .Where(static type => !type.ContainsGenericParameters)
        .SelectMany(static type => type.GetMethods(Static))
        .Where(method => method.GetCustomAttribute<RuntimeInitializeOnLoadMethodAttribute>()?.loadType == moment);

    /// <summary>Resets every static field and runs initialisers again.</summary>
    public static void Reset()
    {
        foreach (Type type in Assemblies.SelectMany(static assembly => assembly.GetTypes()).Where(static type => !type.ContainsGenericParameters && type.IsClass))
            Reset(type);
    }

    public static void Reset(Type type)
    {
        FieldInfo[] fields = type.GetFields(Static);
        if (fields.Length == 0 || type.IsDefined(typeof(CompilerGeneratedAttribute), inherit: false))
            return;

        foreach (FieldInfo field in fields.Where(static field => !field.IsLiteral && !field.IsInitOnly))
            field.SetValue(null, field.FieldType.IsValueType ? Activator.CreateInstance(field.FieldType) : null);

        // Reflection runs an initialiser only once, so this runs its code again. Optimised code may not notice changes of read-only fields, so tests
        // run without optimisation.
        if (type.TypeInitializer is { } initializer)
            Run(initializer.MethodHandle.GetFunctionPointer());
    }

    private static unsafe void Run(IntPtr code) => ((delegate*<void>)code)();
}
