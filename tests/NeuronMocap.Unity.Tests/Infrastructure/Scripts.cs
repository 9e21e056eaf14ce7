using System.Reflection;
using System.Runtime.CompilerServices;

namespace NeuronMocap.Unity.Tests.Infrastructure;

/// <summary>Loads the package's assemblies, as a project does, before other code lists them.</summary>
internal static partial class Scripts
{
#pragma warning disable CA2255 // Not a library: the tests' own start.
    [ModuleInitializer]
#pragma warning restore CA2255
    internal static void Load()
    {
        foreach (string name in (string[])["NeuronMocap.Unity", "NeuronMocap.Unity.Compatibility", "NeuronMocap.Unity.InputSystem", "NeuronMocap.Unity.Timeline", "NeuronMocap.Unity.Samples"])
            Assembly.Load(name);

        LoadEditor();
    }

    static partial void LoadEditor();
}
