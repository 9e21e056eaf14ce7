using System.Reflection;
using System.Runtime.CompilerServices;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Infrastructure;

internal static partial class Scripts
{
    static partial void LoadEditor()
    {
        Assembly.Load("NeuronMocap.Unity.Editor");
        RuntimeHelpers.RunClassConstructor(typeof(EditorApplication).TypeHandle);
    }
}
