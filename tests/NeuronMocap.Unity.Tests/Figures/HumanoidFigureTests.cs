using NeuronMocap.Figures;
using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Infrastructure;
using UnityEngine.Rendering;

namespace NeuronMocap.Unity.Tests.Figures;

public sealed class HumanoidFigureTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public static TheoryData<SkeletonVariant> Variants => [SkeletonVariant.Neck1, SkeletonVariant.Spine3];

    public void Dispose() => _loop.Dispose();

    [Theory]
    [MemberData(nameof(Variants))]
    public void A_figure_is_a_human_with_50_of_the_55_bones(SkeletonVariant variant)
    {
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault(variant));

        Assert.Empty(ConsoleLog.Entries);
        Assert.True(figure.Avatar.isValid);
        Assert.True(figure.Animator.isHuman);
        HumanBodyBones[] without = [.. Enum.GetValues<HumanBodyBones>()
            .Where(bone => bone < HumanBodyBones.LastBone && figure.Animator.GetBoneTransform(bone) == null)];
        Assert.Equal(
            [HumanBodyBones.LeftToes, HumanBodyBones.RightToes, HumanBodyBones.LeftEye, HumanBodyBones.RightEye, HumanBodyBones.Jaw],
            without);
        Assert.Equal("Neck", figure.Animator.GetBoneTransform(HumanBodyBones.Neck)!.name);
        Assert.Equal("Spine1", figure.Animator.GetBoneTransform(HumanBodyBones.Chest)!.name);
        Assert.Equal(
            variant == SkeletonVariant.Spine3 ? "Spine3" : "Spine2",
            figure.Animator.GetBoneTransform(HumanBodyBones.UpperChest)!.name);
        Assert.Equal("LeftHandIndex1", figure.Animator.GetBoneTransform(HumanBodyBones.LeftIndexProximal)!.name);
    }

    [Theory]
    [MemberData(nameof(Variants))]
    public void Every_joint_has_its_offset(SkeletonVariant variant)
    {
        SkeletonBody body = Tall(variant);
        HumanoidFigure figure = HumanoidFigure.Build(body);

        foreach (Bone bone in BoneHierarchy.Bones)
        {
            // In double precision and in the stream's axes, mirrored at the end.
            double x = 0, y = 0, z = 0;
            for (Bone? step = bone; step is { } known; step = BoneHierarchy.GetParent(known, variant))
            {
                x += body.GetOffset(known).X;
                y += body.GetOffset(known).Y;
                z += body.GetOffset(known).Z;
            }

            Vector3 place = figure.GetBone(bone).position;
            double error = Math.Max(Math.Abs(place.x + (x / 100)), Math.Max(Math.Abs(place.y - (y / 100)), Math.Abs(place.z - (z / 100))));
            Assert.True(error < 1e-4, $"{bone} is {error} m off.");
            Assert.Equal(BoneHierarchy.GetName(bone, variant), figure.GetBone(bone).name);
        }
    }

    [Fact]
    public void A_figure_is_placed_at_its_parent()
    {
        Transform parent = new GameObject("Parent").transform;
        parent.SetPositionAndRotation(new Vector3(3, 1, -2), Quaternion.Euler(0, 90, 0));

        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault(), parent: parent);

        Assert.Empty(ConsoleLog.Entries);
        Assert.Equal(parent, figure.Root.transform.parent);
        Assert.Equal(Vector3.zero, figure.Root.transform.localPosition);
        Vector3 head = figure.GetBone(Bone.Head).position;
        Assert.True((head - new Vector3(3, 1 + 1.44102f, -2)).magnitude < 1e-4f, head.ToString());
    }

    [Fact]
    public void A_name_clash_with_a_bone_is_resolved()
    {
        HumanoidFigure figure = HumanoidFigure.Build(SkeletonBody.GetDefault(), name: "Head");

        Assert.True(figure.Avatar.isValid);
        Assert.NotEqual("Head", figure.Root.name);
    }

    [Theory]
    [MemberData(nameof(Variants))]
    public void The_surface_encloses_the_body_and_stands_on_the_ground(SkeletonVariant variant)
    {
        SkeletonBody body = Tall(variant);
        HumanoidFigure figure = HumanoidFigure.Build(body);
        Mesh mesh = figure.Renderer.sharedMesh!;

        Assert.Equal(2, mesh.subMeshCount);
        Assert.Equal(mesh.vertexCount, mesh.boneWeights.Length);
        Assert.All(mesh.boneWeights, static weight => Assert.Equal(1, weight.weight0));
        Assert.InRange(mesh.bounds.min.y, -0.02f, 0.02f);
        Assert.InRange(mesh.bounds.max.y, figure.GetBone(Bone.Head).position.y + 0.1f, 2.2f);
        float hand = Mathf.Abs(figure.GetBone(Bone.LeftHandMiddle3).position.x);
        Assert.InRange(mesh.bounds.max.x, hand, hand + 0.05f);
        Assert.InRange(-mesh.bounds.min.x, hand, hand + 0.05f);

        // At rest, the bind poses leave every vertex in place.
        for (int i = 0; i < mesh.vertexCount; i++)
        {
            int bone = mesh.boneWeights[i].boneIndex0;
            Vector3 shown = (figure.Renderer.bones[bone].localToWorldMatrix * mesh.bindposes[bone]).MultiplyPoint3x4(mesh.vertices[i]);
            Assert.True((shown - mesh.vertices[i]).magnitude < 1e-4f);
        }
    }

    [Theory]
    [MemberData(nameof(Variants))]
    public void Every_triangle_faces_as_its_normals(SkeletonVariant variant)
    {
        Mesh mesh = FigureMesh.Create(FigureSurface.Create(SkeletonBody.GetDefault(variant)));
        int[] corners = mesh.triangles;
        for (int i = 0; i < corners.Length; i += 3)
        {
            Vector3 a = mesh.vertices[corners[i]], b = mesh.vertices[corners[i + 1]], c = mesh.vertices[corners[i + 2]];
            Vector3 facing = mesh.normals[corners[i]] + mesh.normals[corners[i + 1]] + mesh.normals[corners[i + 2]];
            Assert.True(Vector3.Dot(Vector3.Cross(b - a, c - a), facing) > 0, $"Inside out: triangle {i / 3}.");
        }
    }

    [Fact]
    public void A_figure_leaves_nothing_in_every_way_of_ending()
    {
        HumanoidFigure.Build(SkeletonBody.GetDefault()).Dispose();
        _loop.Frame();
        int before = Measure.LiveObjects;

        HumanoidFigure.Build(SkeletonBody.GetDefault()).Dispose();
        Object.Destroy(HumanoidFigure.Build(SkeletonBody.GetDefault()).Root);
        _loop.Frames(2);

        Assert.Equal(before, Measure.LiveObjects);
    }

    [Fact]
    public void A_figure_leaves_nothing_in_edit_mode()
    {
        using var loop = new PlayerLoop(play: false);
        HumanoidFigure.Build(SkeletonBody.GetDefault()).Dispose();
        int before = Measure.LiveObjects;

        HumanoidFigure.Build(SkeletonBody.GetDefault()).Dispose();

        Assert.Equal(before, Measure.LiveObjects);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void An_invalid_body_is_refused_and_leaves_nothing()
    {
        System.Numerics.Vector3[] offsets = SkeletonBody.GetDefault().Offsets.ToArray();
        offsets[(int)Bone.LeftForeArm] = new System.Numerics.Vector3(0, -25, 0);
        offsets[(int)Bone.LeftHand] = new System.Numerics.Vector3(0, -25, 0);
        var body = new SkeletonBody(offsets);
        int before = Measure.LiveObjects;

        Assert.Throws<ArgumentException>(() => HumanoidFigure.Build(body));

        _loop.Frames(2);
        Assert.Equal(before, Measure.LiveObjects);
    }

    [Fact]
    public void The_material_suits_the_render_pipeline()
    {
        Assert.Equal("Standard", HumanoidFigure.Build(SkeletonBody.GetDefault()).Renderer.sharedMaterials[0]!.shader.name);

        Shader.Available.Add("Universal Render Pipeline/Lit");
        GraphicsSettings.currentRenderPipeline = ScriptableObject.CreateInstance<TestPipeline>();
        try
        {
            FigureLook look = FigureLook.Of(Color.red, Color.blue);
            Material?[] materials = HumanoidFigure.Build(SkeletonBody.GetDefault(), look).Renderer.sharedMaterials;
            Assert.Equal("Universal Render Pipeline/Lit", materials[0]!.shader.name);
            Assert.Equal(Color.red, materials[0]!.GetColor("_BaseColor"));
            Assert.Equal(Color.blue, materials[1]!.GetColor("_BaseColor"));

            // A player without lit shaders still shows the figure.
            Shader.Available.Remove("Universal Render Pipeline/Lit");
            Assert.Equal("Sprites/Default", HumanoidFigure.Build(SkeletonBody.GetDefault()).Renderer.sharedMaterials[0]!.shader.name);
            HumanoidFigure.Build(SkeletonBody.GetDefault());
            Assert.Contains("Set a Material", Assert.Single(ConsoleLog.Problems).Message, StringComparison.Ordinal);
        }
        finally
        {
            GraphicsSettings.currentRenderPipeline = null;
            Shader.Available.Remove("Universal Render Pipeline/Lit");
        }
    }

    [Fact]
    public void A_given_material_is_copied_and_coloured()
    {
        var template = new Material(Shader.Find("Standard")!) { renderQueue = 2450 };
        FigureLook look = FigureLook.Of(Color.green, Color.red);
        look.Material = template;

        Material shown = HumanoidFigure.Build(SkeletonBody.GetDefault(), look).Renderer.sharedMaterials[0]!;

        Assert.NotEqual(template, shown);
        Assert.Equal(Color.green, shown.GetColor("_Color"));
        Assert.Equal(Color.white, template.GetColor("_Color"));
    }

    internal static SkeletonBody Tall(SkeletonVariant variant)
    {
        BoneDimensions sizes = SkeletonBody.GetDefault(variant).Measure();
        return SkeletonBody.FromDimensions(sizes with { UpperLeg = 0.47f, LowerLeg = 0.45f, UpperArm = 0.31f, ShoulderWidth = 0.36f, Body = 0.6f }, variant);
    }

    private sealed class TestPipeline : RenderPipelineAsset
    {
        public override Shader? defaultShader => Shader.Find("Universal Render Pipeline/Lit");
    }
}
