namespace NeuronMocap.Tests.Infrastructure;

public sealed class AllocationsTests
{
    [Fact]
    public void Code_that_the_runtime_optimizes_late_allocates_nothing()
    {
        int calls = 0;
        object? last = null;
        Allocations.AssertNone(() =>
        {
            if (++calls < 3000)
                last = new object();
        });
        Assert.NotNull(last);
    }

    [Fact]
    public void Measuring_ends_with_the_first_round_that_allocates_nothing()
    {
        int rounds = 0;
        Assert.Equal(0, Allocations.Least(() => ++rounds == 3 ? 0 : 2));
        Assert.Equal(3, rounds);
    }
}
