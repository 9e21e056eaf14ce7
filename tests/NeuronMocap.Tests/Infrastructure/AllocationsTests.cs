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
            if (++calls < 20_000)
                last = new object();
        });
        Assert.NotNull(last);
    }
}
