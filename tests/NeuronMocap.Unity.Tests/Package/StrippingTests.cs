using System.Reflection;
using UnityEngine.Scripting;

namespace NeuronMocap.Unity.Tests.Package;

/// <summary>
/// A player build strips engine classes that no script names. According to Unity's reference, GameObject.CreatePrimitive then fails on the device. It
/// also leaves out assemblies of packages that nothing refers to.
/// </summary>
public sealed class StrippingTests
{
    [Fact]
    public void Code_that_creates_primitives_keeps_their_types()
    {
        string package = Path.Combine(Repository.Root, "unity-package");
        string[] makers = [.. Directory.GetFiles(package, "*.cs", SearchOption.AllDirectories).Select(File.ReadAllText).Where(static text => text.Contains("CreatePrimitive(", StringComparison.Ordinal))];
        Assert.NotEmpty(makers);
        foreach (string text in makers)
        {
            Assert.Contains("typeof(MeshFilter)", text, StringComparison.Ordinal);
            Assert.Contains("typeof(MeshRenderer)", text, StringComparison.Ordinal);
            foreach (PrimitiveType made in Enum.GetValues<PrimitiveType>().Where(type => text.Contains($"PrimitiveType.{type}", StringComparison.Ordinal)))
                Assert.Contains($"typeof({ColliderOf(made)})", text, StringComparison.Ordinal);
        }
    }

    // No scene has a component of such an assembly.
    [Fact]
    public void Assemblies_that_only_act_at_the_start_are_always_linked()
    {
        Assembly[] assemblies = [.. AppDomain.CurrentDomain.GetAssemblies()
            .Where(static assembly => assembly.GetName().Name!.StartsWith("NeuronMocap.Unity", StringComparison.Ordinal) && ActsAtStart(assembly))
            .Where(static assembly => !assembly.GetTypes().Any(static type => type.IsSubclassOf(typeof(MonoBehaviour)) || type.IsSubclassOf(typeof(ScriptableObject))))];

        Assert.NotEmpty(assemblies);
        Assert.All(assemblies, static assembly => Assert.True(assembly.IsDefined(typeof(AlwaysLinkAssemblyAttribute)), assembly.GetName().Name));
    }

    private static bool ActsAtStart(Assembly assembly) => assembly.GetTypes()
        .SelectMany(static type => type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly))
        .Any(static method => method.IsDefined(typeof(RuntimeInitializeOnLoadMethodAttribute)));

    private static string ColliderOf(PrimitiveType primitive) => primitive switch
    {
        PrimitiveType.Cube => "BoxCollider",
        PrimitiveType.Sphere => "SphereCollider",
        PrimitiveType.Capsule or PrimitiveType.Cylinder => "CapsuleCollider",
        _ => "MeshCollider",
    };
}
