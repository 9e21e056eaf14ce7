namespace NeuronMocap.Tests.Infrastructure;

/// <summary>The runtime that the tests run on.</summary>
internal static class Runtimes
{
    public static bool IsMono { get; } = Type.GetType("Mono.Runtime") is not null;

    /// <summary>Skips a test that Mono cannot run.</summary>
    public static void SkipOnMono(string reason) => Assert.SkipWhen(IsMono, "Mono " + reason);
}
