using System.Numerics;
using System.Runtime.InteropServices;
using NeuronMocap.Figures;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Gltf;

// The skinned figure of an avatar in a file: nodes, mesh and skin. The node of the figure comes first, then the bones, then the mesh.
internal sealed class GlbFigure
{
    public const int NodeCount = BoneHierarchy.BoneCount + 2;
    private const float Metre = 0.01f;
    private const byte FullWeight = 255;

    private readonly string _name;
    private readonly SkeletonBody _body;
    private readonly int _firstNode;
    private readonly int _positions;
    private readonly int _normals;
    private readonly int _bones;
    private readonly int _weights;
    private readonly int _bodyTriangles;
    private readonly int _accentTriangles;
    private readonly int _bindMatrices;

    public GlbFigure(string name, SkeletonBody body, int firstNode, GlbBinary binary)
    {
        _name = name;
        _body = body;
        _firstNode = firstNode;
        FigureSurface surface = FigureSurface.Create(body);
        Vector3[] positions = surface.Positions.ToArray();
        byte[] bones = new byte[4 * positions.Length];
        byte[] weights = new byte[4 * positions.Length];
        for (int i = 0; i < positions.Length; i++)
            (bones[4 * i], weights[4 * i]) = ((byte)surface.Bones[i], FullWeight);

        _positions = AddVertices(binary, positions.AsSpan(), "VEC3", GlbAccessor.Float, WithLimits(positions));
        _normals = AddVertices(binary, surface.Normals, "VEC3", GlbAccessor.Float);
        _bones = AddVertices(binary, bones.AsSpan(), "VEC4", GlbAccessor.UnsignedByte);
        _weights = AddVertices(binary, weights.AsSpan(), "VEC4", GlbAccessor.UnsignedByte, static accessor => accessor with { IsNormalized = true });
        _bodyTriangles = AddTriangles(binary, surface.BodyTriangles);
        _accentTriangles = AddTriangles(binary, surface.AccentTriangles);
        byte[] matrices = GetBindMatrices(surface.Joints);
        _bindMatrices = binary.Add(new GlbAccessor(GlbAccessor.Float, BoneHierarchy.BoneCount, "MAT4"), null, output => output.Write(matrices, 0, matrices.Length));
    }

    // The nodes without a parent. A skinned mesh below another node would look as if that node moved it.
    public int[] Roots => [_firstNode, _firstNode + NodeCount - 1];

    public int GetNode(int bone) => _firstNode + 1 + bone;

    public void DescribeNodes(GltfJson json, int number)
    {
        json.Object().Text("name", _name).Numbers("children", [GetNode(0)]).EndObject();
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Vector3 offset = _body.Offsets[(int)bone] * Metre;
            json.Object().Text("name", BoneHierarchy.GetName(bone, _body.Variant)).Numbers("translation", offset.X, offset.Y, offset.Z);
            int[] children = [.. BoneHierarchy.Bones.ToArray().Where(other => BoneHierarchy.GetParent(other, _body.Variant) == bone).Select(other => GetNode((int)other))];
            if (children.Length > 0)
                json.Numbers("children", children);

            json.EndObject();
        }

        json.Object().Text("name", $"{_name} figure").Number("mesh", number).Number("skin", number).EndObject();
    }

    public void DescribeMesh(GltfJson json, int bodyMaterial, int accentMaterial)
    {
        json.Object().Text("name", $"{_name} mesh").Array("primitives");
        DescribePart(json, _bodyTriangles, bodyMaterial);
        DescribePart(json, _accentTriangles, accentMaterial);
        json.EndArray().EndObject();
    }

    public void DescribeSkin(GltfJson json) => json.Object().Text("name", $"{_name} skin").Number("inverseBindMatrices", _bindMatrices)
        .Number("skeleton", GetNode(0)).Numbers("joints", Enumerable.Range(GetNode(0), BoneHierarchy.BoneCount)).EndObject();

    private void DescribePart(GltfJson json, int triangles, int material) => json.Object()
        .Object("attributes").Number("POSITION", _positions).Number("NORMAL", _normals).Number("JOINTS_0", _bones).Number("WEIGHTS_0", _weights).EndObject()
        .Number("indices", triangles).Number("material", material).EndObject();

    private static Func<GlbAccessor, GlbAccessor> WithLimits(Vector3[] positions)
    {
        Vector3 min = positions.Aggregate(Vector3.Min);
        Vector3 max = positions.Aggregate(Vector3.Max);
        return accessor => accessor with { Min = [min.X, min.Y, min.Z], Max = [max.X, max.Y, max.Z] };
    }

    private static int AddVertices<T>(
        GlbBinary binary, ReadOnlySpan<T> values, string type, int componentType, Func<GlbAccessor, GlbAccessor>? change = null)
        where T : unmanaged
    {
        byte[] bytes = MemoryMarshal.AsBytes(values).ToArray();
        int count = typeof(T) == typeof(byte) ? values.Length / 4 : values.Length;
        var accessor = new GlbAccessor(componentType, count, type);
        return binary.Add(change?.Invoke(accessor) ?? accessor, GlbBinary.Vertices, output => output.Write(bytes, 0, bytes.Length));
    }

    private static int AddTriangles(GlbBinary binary, ReadOnlySpan<int> corners)
    {
        ushort[] numbers = new ushort[corners.Length];
        for (int i = 0; i < numbers.Length; i++)
            numbers[i] = checked((ushort)corners[i]);

        byte[] bytes = MemoryMarshal.AsBytes(numbers.AsSpan()).ToArray();
        return binary.Add(
            new GlbAccessor(GlbAccessor.UnsignedShort, numbers.Length, "SCALAR"), GlbBinary.Triangles, output => output.Write(bytes, 0, bytes.Length));
    }

    // From the axes of the figure to those of each bone at rest, column by column.
    private static byte[] GetBindMatrices(ReadOnlySpan<Vector3> joints)
    {
        var matrices = new Matrix4x4[joints.Length];
        for (int i = 0; i < matrices.Length; i++)
            matrices[i] = Matrix4x4.CreateTranslation(-joints[i]);

        return MemoryMarshal.AsBytes(matrices.AsSpan()).ToArray();
    }
}
