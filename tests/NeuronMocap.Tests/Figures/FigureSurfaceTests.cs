using System.Numerics;
using NeuronMocap.Figures;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Figures;

public sealed class FigureSurfaceTests
{
    public static TheoryData<SkeletonVariant> Variants => [SkeletonVariant.Neck1, SkeletonVariant.Spine3];

    [Theory, MemberData(nameof(Variants))]
    public void Every_triangle_faces_outwards(SkeletonVariant variant)
    {
        SkeletonBody body = SkeletonBody.GetDefault(variant);
        foreach (FigureShape shape in FigureShapes.Of(body))
        {
            FigureSurface surface = FigureSurface.Create(body, [shape]);
            Vector3 centre = Mean(surface.Positions.ToArray());
            int[] corners = Corners(surface);
            for (int i = 0; i < corners.Length; i += 3)
            {
                Vector3 a = surface.Positions[corners[i]], b = surface.Positions[corners[i + 1]], c = surface.Positions[corners[i + 2]];
                Vector3 normal = Vector3.Cross((b - a) * 1000, (c - a) * 1000);
                Assert.True(Vector3.Dot(normal, ((a + b + c) / 3) - centre) > 0, $"Inside out or empty: {shape.Bone}, triangle {i / 3}.");
                Assert.True(Vector3.Dot(normal, surface.Normals[corners[i]]) > 0);
            }
        }
    }

    [Theory, MemberData(nameof(Variants))]
    public void It_encloses_the_body_and_stands_on_the_ground(SkeletonVariant variant)
    {
        var body = SkeletonBody.FromDimensions(SkeletonBody.GetDefault(variant).Measure() with { UpperLeg = 0.47f, LowerLeg = 0.45f, UpperArm = 0.31f }, variant);
        FigureSurface surface = FigureSurface.Create(body);

        Vector3[] positions = surface.Positions.ToArray();
        Assert.InRange(positions.Min(static position => position.Y), -0.02f, 0.02f);
        Assert.InRange(positions.Max(static position => position.Y), surface.Joints[(int)Bone.Head].Y + 0.1f, 2.2f);
        float hand = surface.Joints[(int)Bone.LeftHandMiddle3].X;
        Assert.InRange(positions.Max(static position => position.X), hand, hand + 0.05f);
        Assert.InRange(-positions.Min(static position => position.X), hand, hand + 0.05f);
        Assert.True(positions.Max(static position => position.Z) > 0.1f, "The toes and the visor are in front.");
    }

    [Fact]
    public void Each_vertex_has_a_bone_a_unit_normal_and_a_triangle()
    {
        FigureSurface surface = FigureSurface.Create(SkeletonBody.GetDefault());

        Assert.Equal(surface.Positions.Length, surface.Bones.Length);
        Assert.Equal(surface.Positions.Length, surface.Normals.Length);
        Assert.All(surface.Normals.ToArray(), static normal => Assert.Equal(1, normal.Length(), 1e-5));
        Assert.Equal(Enumerable.Range(0, surface.Positions.Length), Corners(surface).Distinct().Order());
        Assert.True(surface.Positions.Length < ushort.MaxValue, "Vertex numbers of glTF files have 16 bits.");
    }

    [Fact]
    public void Its_joints_are_those_of_the_rest_pose()
    {
        SkeletonBody body = SkeletonBody.GetDefault();
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        body.CopyRestPose(pose);
        ForwardKinematics.ToWorld(pose, pose);

        FigureSurface surface = FigureSurface.Create(body);

        foreach (Bone bone in BoneHierarchy.Bones)
            Assert.Equal(0, Vector3.Distance(pose[(int)bone].Position / 100, surface.Joints[(int)bone]), 1e-6);
    }

    [Fact]
    public void A_body_of_points_has_a_finite_surface()
    {
        AssertFinite(FigureSurface.Create(new SkeletonBody(new Vector3[BoneHierarchy.BoneCount], new Vector3[BoneHierarchy.BoneCount])));
    }

    [Theory]
    [InlineData(18, 0)]
    [InlineData(0, 15)]
    public void A_head_or_a_spine_to_the_side_has_a_finite_surface(float head, float spine)
    {
        SkeletonBody body = SkeletonBody.GetDefault();
        Vector3[] offsets = body.Offsets.ToArray();
        Vector3[] ends = body.EndSites.ToArray();
        if (head > 0)
            ends[(int)Bone.Head] = new Vector3(head, 0, 0);
        if (spine > 0)
            offsets[(int)Bone.Spine1] = new Vector3(spine, 0, 0);

        AssertFinite(FigureSurface.Create(new SkeletonBody(offsets, ends)));
    }

    [Fact]
    public void Neighbouring_numbers_have_distinct_colours()
    {
        Assert.Equal(0xF27630, FigureColors.GetAccent(0));
        Assert.Equal(20, Enumerable.Range(0, 20).Select(FigureColors.GetAccent).Distinct().Count());
    }

    private static void AssertFinite(FigureSurface surface)
    {
        Assert.All(surface.Positions.ToArray(), static position => Assert.True(float.IsFinite(position.Length())));
        Assert.All(surface.Normals.ToArray(), static normal => Assert.Equal(1, normal.Length(), 1e-5));
    }

    private static int[] Corners(FigureSurface surface) => [.. surface.BodyTriangles.ToArray(), .. surface.AccentTriangles.ToArray()];

    private static Vector3 Mean(Vector3[] positions) => positions.Aggregate(Vector3.Zero, static (sum, position) => sum + position) / positions.Length;
}
