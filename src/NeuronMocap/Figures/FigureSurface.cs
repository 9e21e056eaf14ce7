using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Figures;

/// <summary>
/// The surface of a jointed doll in the sizes of a body, for any renderer. It is one mesh in the rest pose, with two sets of triangles, one
/// for each colour. Each vertex follows one bone. Immutable and thread-safe.
/// </summary>
/// <remarks>Axes are those of the stream: right-handed, Y up, X to the left of the figure, Z forward. Lengths are in metres.</remarks>
public sealed class FigureSurface
{
    private readonly Vector3[] _joints;
    private readonly Vector3[] _positions;
    private readonly Vector3[] _normals;
    private readonly Bone[] _bones;
    private readonly int[] _bodyTriangles;
    private readonly int[] _accentTriangles;

    internal FigureSurface(Vector3[] joints, FigureSurfaceBuilder builder)
    {
        _joints = joints;
        _positions = [.. builder.Positions];
        _bones = [.. builder.Bones];
        _bodyTriangles = [.. builder.BodyTriangles];
        _accentTriangles = [.. builder.AccentTriangles];
        _normals = SurfaceNormals.Of(_positions, _bodyTriangles, _accentTriangles);
    }

    /// <summary>Gets the positions of the 59 bones at rest, in <see cref="Bone"/> order, relative to the origin on the ground; metres.</summary>
    public ReadOnlySpan<Vector3> Joints => _joints;

    /// <summary>Gets the positions of the vertices at rest, relative to the origin on the ground; metres.</summary>
    public ReadOnlySpan<Vector3> Positions => _positions;

    /// <summary>Gets the directions in which the surface faces at the vertices at rest. Their length is 1.</summary>
    public ReadOnlySpan<Vector3> Normals => _normals;

    /// <summary>Gets the bone that moves each vertex.</summary>
    public ReadOnlySpan<Bone> Bones => _bones;

    /// <summary>
    /// Gets the triangles of body, limbs and head, as three vertex numbers each. Seen from outside, the corners are counter-clockwise.
    /// </summary>
    public ReadOnlySpan<int> BodyTriangles => _bodyTriangles;

    /// <summary>Gets the triangles of joints and visor, in the second colour. They are like <see cref="BodyTriangles"/>.</summary>
    public ReadOnlySpan<int> AccentTriangles => _accentTriangles;

    /// <summary>Creates the surface for a body.</summary>
    /// <param name="body">The sizes. They must be finite.</param>
    /// <returns>The surface.</returns>
    /// <exception cref="ArgumentNullException">The body is null.</exception>
    public static FigureSurface Create(SkeletonBody body)
    {
        ArgumentNullException.ThrowIfNull(body);
        return Create(body, FigureShapes.Of(body));
    }

    internal static FigureSurface Create(SkeletonBody body, IEnumerable<FigureShape> shapes)
    {
        Vector3[] joints = GetJoints(body);
        var builder = new FigureSurfaceBuilder();
        foreach (FigureShape shape in shapes)
            builder.Add(shape, joints[(int)shape.Bone]);

        return new FigureSurface(joints, builder);
    }

    private static Vector3[] GetJoints(SkeletonBody body)
    {
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        body.CopyRestPose(pose);
        ForwardKinematics.ToWorld(pose, pose, body.Variant);
        var joints = new Vector3[BoneHierarchy.BoneCount];
        for (int bone = 0; bone < joints.Length; bone++)
            joints[bone] = pose[bone].Position * FigureShapes.Metre;

        return joints;
    }
}
