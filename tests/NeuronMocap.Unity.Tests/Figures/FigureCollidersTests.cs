using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Drivers;

namespace NeuronMocap.Unity.Tests.Figures;

public sealed class FigureCollidersTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void Each_bone_of_the_body_has_a_capsule_from_joint_to_joint()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(null);

        Assert.Equal(20, FigureColliders.Add(driver));

        AssertCapsule(figure, Bone.LeftArm, figure[Bone.LeftForeArm].position);
        AssertCapsule(figure, Bone.RightUpLeg, figure[Bone.RightLeg].position);
        AssertCapsule(figure, Bone.Spine, figure[Bone.Spine1].position);
        AssertCapsule(figure, Bone.LeftHand, figure[Bone.LeftHandMiddle1].position);
        Assert.Equal(20, figure.Root.GetComponentsInChildren<CapsuleCollider>(true).Length);
        Assert.All(figure.Root.GetComponentsInChildren<Rigidbody>(true), static body =>
        {
            Assert.True(body.isKinematic);
            Assert.Equal(CollisionDetectionMode.ContinuousSpeculative, body.collisionDetectionMode);
        });
        string[] names = [.. figure.Root.GetComponentsInChildren<Transform>(true).Select(static item => item.name)];
        Assert.Equal(names.Distinct(StringComparer.Ordinal), names);
    }

    // The sizes of a test figure's legs: 0.8 of the default body, in a root scaled by 1.5.
    [Fact]
    public void Capsules_are_as_thick_as_fits_the_figure()
    {
        TestFigure figure = TestFigure.Build("Figure");
        FigureColliders.Add(figure.Drive(null));

        CapsuleCollider thigh = Capsule(figure, Bone.LeftUpLeg);
        float radius = thigh.radius * thigh.transform.lossyScale.y;
        float legs = (figure[Bone.LeftUpLeg].position - figure[Bone.LeftLeg].position).magnitude + (figure[Bone.LeftLeg].position - figure[Bone.LeftFoot].position).magnitude;
        Assert.Equal(0.085f * legs, radius, 0.005f);
        Assert.Equal(1, thigh.direction);

        // The head has no bone at its end, so it continues the neck.
        CapsuleCollider head = Capsule(figure, Bone.Head);
        Vector3 neck = figure[Bone.Head].position - figure[Bone.Neck1].position;
        Assert.Equal(0, Vector3.Angle(neck, head.transform.position - figure[Bone.Head].position), 0.5f);
    }

    [Fact]
    public void Bones_with_a_body_stay_as_they_are()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(null);
        Rigidbody own = figure[Bone.Hips].gameObject.AddComponent<Rigidbody>();

        Assert.Equal(19, FigureColliders.Add(driver));
        Assert.Equal(0, FigureColliders.Add(driver));

        Assert.False(own.isKinematic);
        Assert.Equal(19, figure.Root.GetComponentsInChildren<CapsuleCollider>(true).Length);
    }

    [Fact]
    public void Generic_rigs_have_capsules_and_still_find_their_bones()
    {
        HumanoidFigure built = HumanoidFigure.Build(SkeletonBody.GetDefault());
        GenericRigDriver driver = built.Root.AddComponent<GenericRigDriver>();
        int before = 59 - driver.MissingBones.Count;

        Assert.InRange(FigureColliders.Add(driver), 15, 20);
        driver.Rebind();
        _loop.Frame();

        Assert.Equal(before, 59 - driver.MissingBones.Count);
        Assert.Equal(59, before);
    }

    [Fact]
    public void A_driver_without_a_figure_says_why()
    {
        HumanoidDriver driver = new GameObject("Empty").AddComponent<HumanoidDriver>();

        var exception = Assert.Throws<InvalidOperationException>(() => FigureColliders.Add(driver));
        Assert.Contains("No Animator", exception.Message, StringComparison.Ordinal);
    }

    private static CapsuleCollider Capsule(TestFigure figure, Bone bone) =>
        Assert.Single(figure.Root.GetComponentsInChildren<CapsuleCollider>(true), item => item.transform.parent == figure[bone]);

    private static void AssertCapsule(TestFigure figure, Bone bone, Vector3 end)
    {
        CapsuleCollider capsule = Capsule(figure, bone);
        Vector3 start = figure[bone].position;
        Vector3 along = (capsule.transform.rotation * Vector3.up).normalized;
        Assert.Equal(0, (((start + end) / 2) - capsule.transform.position).magnitude, 0.002f);
        Assert.InRange(Math.Abs(Vector3.Dot(along, (end - start).normalized)), 0.999f, 1.001f);
        Assert.True(capsule.height * capsule.transform.lossyScale.y >= (end - start).magnitude);
        Assert.True(capsule.height >= 2 * capsule.radius);
    }
}
