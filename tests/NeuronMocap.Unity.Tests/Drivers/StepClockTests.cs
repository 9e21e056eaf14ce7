namespace NeuronMocap.Unity.Tests.Drivers;

public class StepClockTests
{
    private const double Frame = 1 / 60.0;

    private readonly StepClock _clock = new();

    [Fact]
    public void Times_of_steps_follow_the_source_with_little_noise()
    {
        var random = new System.Random(1);
        for (int i = 0; i < 600; i++)
        {
            // A frame is up to 4 ms late.
            _clock.Follow(i * Frame, 100 + (i * Frame) + (0.004 * random.NextDouble()), 1);
            if (i < 60)
                continue;

            double step = (i * Frame) + 0.007;
            Assert.Equal(100.002 + step, _clock.ToSource(step), 0.0015);
        }
    }

    [Theory]
    [InlineData(0.25)]
    [InlineData(2)]
    public void A_time_scale_changes_the_length_of_steps(double timeScale)
    {
        for (int i = 0; i < 100; i++)
            _clock.Follow(i * Frame * timeScale, 5 + (i * Frame), timeScale);

        Assert.Equal(5 + (99 * Frame), _clock.ToSource(99 * Frame * timeScale), 1e-9);
        Assert.Equal(0.02 / timeScale, _clock.ToSource(10.02) - _clock.ToSource(10), 1e-9);
    }

    [Fact]
    public void A_hitch_and_a_pause_of_the_game_are_followed_at_once()
    {
        _clock.Follow(1, 10, 1);
        _clock.Follow(1.3, 11, 1);
        Assert.Equal(11, _clock.ToSource(1.3));

        for (int i = 1; i <= 50; i++)
            _clock.Follow(1.3, 11 + (i * Frame), 0);

        Assert.Equal(11 + (50 * Frame), _clock.ToSource(1.3), 1e-9);
        _clock.Reset();
        Assert.False(_clock.IsStarted);
        _clock.Follow(2, 20, 1);
        Assert.Equal(20.5, _clock.ToSource(2.5));
    }
}
