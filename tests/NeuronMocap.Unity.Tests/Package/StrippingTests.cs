namespace NeuronMocap.Unity.Tests.Package;

/// <summary>
/// A player build strips engine classes that no script names. According to Unity's reference, GameObject.CreatePrimitive then fails on the device.
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

    private static string ColliderOf(PrimitiveType primitive) => primitive switch
    {
        PrimitiveType.Cube => "BoxCollider",
        PrimitiveType.Sphere => "SphereCollider",
        PrimitiveType.Capsule or PrimitiveType.Cylinder => "CapsuleCollider",
        _ => "MeshCollider",
    };
}
