namespace UnityEngine.StandIn;

/// <summary>Shared resources of every project: the shapes of primitives and their material. Each exists once.</summary>
internal static class BuiltInResources
{
    private static readonly Dictionary<PrimitiveType, Mesh> _meshes = [];
    private static Material? _material;

    public static Material DefaultMaterial => _material is { IsDestroyed: false } ? _material
        : _material = new Material(Shader.Find("Standard")!) { name = "Default-Material" };

    public static Mesh GetMesh(PrimitiveType type)
    {
        if (!_meshes.TryGetValue(type, out Mesh? mesh) || mesh.IsDestroyed)
            _meshes[type] = mesh = new Mesh { name = type.ToString() };

        return mesh;
    }
}
