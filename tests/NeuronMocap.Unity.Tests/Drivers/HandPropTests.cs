using NeuronMocap.Retargeting;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Drivers;

public sealed class HandPropTests : SourceFixture
{
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
