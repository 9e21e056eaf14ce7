using NeuronMocap.Retargeting;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Drivers;

public sealed class HandPropTests : SourceFixture
{
    [Fact]
    public void A_prop_follows_a_figure_that_goes_to_its_idle_pose()
    {
        MocapSource source = AddSimulator();
        PerformerSpawner spawner = new GameObject("Spawner").AddComponent<PerformerSpawner>();
        (spawner.Source, spawner.DespawnSeconds, spawner.BlendSeconds) = (source, 0, 0.2f);
        Loop.RunUntil(() => spawner.Figures.Count == 1 && spawner.Figures[0].Driver.IsDriving);
        FigureDriver driver = spawner.Figures[0].Driver;
        HandProp prop = new GameObject("Sword").AddComponent<HandProp>();
        prop.Driver = driver;
        source.Close();

        for (int i = 0; i < 20; i++)
        {
            Loop.Frame();
            Assert.True(driver.TryGetBonePose(HumanoidBone.RightHand, out Vector3 hand, out _));
            Assert.Equal(0, (hand - prop.transform.position).magnitude, 1e-4f);
        }

        Assert.True(spawner.Figures[0].IsIdle);
    }

    [Fact]
    public void A_prop_does_not_look_for_a_faulty_figure_in_every_frame()
    {
        TestFigure figure = TestFigure.Build("Figure");
        Avatar avatar = figure.Animator.avatar!;
        figure.Animator.avatar = null;
        HumanoidDriver driver = figure.Drive(null);
        figure.Animator.avatar = avatar;
        Assert.False(driver.TryGetBonePose(HumanoidBone.RightHand, out _, out _));

        Loop.Frame(1.1f);
        Assert.True(driver.TryGetBonePose(HumanoidBone.RightHand, out _, out _));
    }
}
