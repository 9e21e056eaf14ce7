using NeuronMocap.Retargeting;
using NeuronMocap.Unity.Tests.Drivers;
using NeuronMocap.Unity.Tests.Infrastructure;
using NeuronMocap.Unity.Tests.StandIn;

namespace NeuronMocap.Unity.Tests.Figures;

/// <summary>Figures that stand while their performer sends nothing, whenever they are driven.</summary>
public sealed class IdleFigureTests : SourceFixture
{
    [Theory]
    [InlineData(DriveTime.LateUpdate)]
    [InlineData(DriveTime.Update)]
    [InlineData(DriveTime.Physics)]
    public void A_figure_stands_and_returns(DriveTime time)
    {
        SpawnedFigure figure = Spawn(time, out PerformerSpawner spawner);
        HumanoidFigure shown = figure.Root.GetComponent<FigureBuilder>().Figure!;

        spawner.Source!.Close();
        Loop.Frames(60);
        Assert.True(figure.IsIdle);
        AssertStands(shown);
        Loop.Frames(10);
        AssertStands(shown);

        spawner.Source.Open();
        Loop.RunUntil(() => !figure.IsIdle && figure.Driver.IsDriving);
        Loop.RunFor(0.5f);
        List<Quaternion> had = [];
        Loop.RunUntil(() =>
        {
            had.Add(figure.Performer.GetRotation(Bone.LeftArm));
            return had.Count == 60;
        });
        AssertBetween(had, shown.GetBone(Bone.LeftArm).rotation);
    }

    // Bodies and the figure that is seen are at the same place, so nothing moves them to and fro.
    [Fact]
    public void Bodies_go_to_the_idle_pose_through_physics()
    {
        SpawnedFigure figure = Spawn(DriveTime.Physics, out PerformerSpawner spawner);
        HumanoidFigure shown = figure.Root.GetComponent<FigureBuilder>().Figure!;
        Rigidbody arm = shown.GetBone(Bone.LeftForeArm).GetComponent<Rigidbody>();
        HandProp prop = new GameObject("Sword").AddComponent<HandProp>();
        prop.Driver = figure.Driver;
        prop.gameObject.AddComponent<Rigidbody>().isKinematic = true;
        Loop.RunFor(0.1f);
        var speeds = new List<float>();
        new GameObject("Probe").AddComponent<StepProbe>().OnStep = () => speeds.Add(arm.velocity.magnitude);

        spawner.Source!.Close();
        for (int i = 0; i < 60; i++)
        {
            Loop.Frame();
            Assert.Equal(0, (arm.position - arm.transform.position).magnitude, 1e-4f);
            Assert.Equal(0, (shown.GetBone(Bone.RightHand).position - prop.transform.position).magnitude, 1e-3f);
        }

        AssertStands(shown);
        Assert.InRange(speeds.Max(), 0.05f, 15);
        Assert.Equal(0, speeds[^1], 1e-3f);
    }

    [Fact]
    public void A_generic_rig_stands_with_its_arms_down()
    {
        GameObject prefab = GenericRig.Build("", out _);
        prefab.AddComponent<GenericRigDriver>();
        PerformerSpawner spawner = AddSpawner();
        spawner.Prefab = prefab;
        Loop.RunUntil(() => spawner.Figures.Count == 1 && spawner.Figures[0].Driver.IsDriving);
        FigureDriver driver = spawner.Figures[0].Driver;

        spawner.Source!.Close();
        Loop.Frames(60);

        Assert.True(driver.TryGetBonePose(HumanoidBone.LeftHand, out Vector3 hand, out _));
        Assert.True(driver.TryGetBonePose(HumanoidBone.LeftUpperArm, out Vector3 arm, out _));
        Assert.True(hand.y < arm.y - 0.4f, $"{hand} {arm}");
    }

    private static void AssertStands(HumanoidFigure shown)
    {
        Assert.All((Bone[])[Bone.LeftHand, Bone.RightHand], hand =>
        {
            Bone arm = hand == Bone.LeftHand ? Bone.LeftArm : Bone.RightArm;
            Assert.True(shown.GetBone(hand).position.y < shown.GetBone(arm).position.y - 0.4f, "The arm does not hang down.");
        });
        Assert.Equal(shown.Body.GetOffset(Bone.Hips).Y / 100, shown.GetBone(Bone.Hips).position.y, 0.01);
        Assert.Equal(0, Vector3.Angle(shown.GetBone(Bone.Hips).up, Vector3.up), 0.5f);
    }

    // A body shows a pose between two that the performer had in the last three steps. A busy computer makes fewer and longer frames of them.
    private static void AssertBetween(List<Quaternion> had, Quaternion shown) => Assert.Contains(
        had.Zip(had.Skip(1)),
        pair => Quaternion.Angle(pair.First, shown) + Quaternion.Angle(shown, pair.Second) < Quaternion.Angle(pair.First, pair.Second) + 1);

    private static PerformerSpawner AddSpawner()
    {
        PerformerSpawner spawner = new GameObject("Spawner").AddComponent<PerformerSpawner>();
        (spawner.Source, spawner.DespawnSeconds, spawner.BlendSeconds) = (AddSimulator(), 0, 0.3f);
        return spawner;
    }

    private SpawnedFigure Spawn(DriveTime time, out PerformerSpawner spawner)
    {
        PerformerSpawner added = spawner = AddSpawner();
        Loop.RunUntil(() => added.Figures.Count == 1 && added.Figures[0].Driver.IsDriving);
        SpawnedFigure figure = spawner.Figures[0];

        // No other figure is built from here on.
        Loop.RunFor(0.6f);
        if (time == DriveTime.Physics)
            FigureColliders.Add(figure.Driver);

        figure.Driver.DriveTime = time;
        Loop.RunUntil(() => figure.Driver.IsDriving);
        return figure;
    }
}
