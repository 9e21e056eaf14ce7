using NeuronMocap.Tool.View;

namespace NeuronMocap.Tool.Tests.View;

public sealed class FirstUseTests
{
    // The program does not wait for it, so nobody would see that it fails.
    [Fact]
    public async Task What_the_first_page_needs_is_made_without_a_fault() => await FirstUse.RunAsync().Soon();
}
