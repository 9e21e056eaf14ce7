using NeuronMocap.Motion;

namespace NeuronMocap.Tests.Motion;

public sealed class GroundEstimatorTests
{
    [Fact]
    public void The_ground_is_at_the_lowest_point()
    {
        var ground = new GroundEstimator();
        Assert.True(float.IsNaN(ground.Height));
        Assert.Equal(5, ground.Update(5, 0));
        Assert.Equal(2, ground.Update(2, 0.01));
        Assert.Equal(2, ground.Height);
    }

    [Fact]
    public void A_jump_hardly_raises_the_ground()
    {
        // Half a second in the air, 30 cm high.
        var ground = new GroundEstimator();
        ground.Update(0, 0);
        float highest = 0;
        for (int i = 0; i <= 60; i++)
        {
            double time = i / 120.0;
            highest = Math.Max(highest, ground.Update((float)(490.5 * time * (0.5 - time)), time));
        }

        Assert.True(highest <= 15, $"{highest} cm");
        Assert.Equal(0, ground.Height, 0.5f);
    }

    [Fact]
    public void Stairs_raise_the_ground_and_NaN_is_ignored()
    {
        var ground = new GroundEstimator();
        for (int i = 0; i < 1300; i++)
            ground.Update(18 * (i / 120), i / 120.0);

        Assert.Equal(180, ground.Height);
        ground.Update(float.NaN, 11);
        ground.Update(0, double.NaN);
        ground.Update(float.NegativeInfinity, 11);
        Assert.Equal(180, ground.Height);
        Assert.Equal(0, ground.Lowest);
        ground.Reset();
        Assert.True(float.IsNaN(ground.Lowest));
        Assert.Equal(-3, ground.Update(-3, 0));
    }
}
