namespace NeuronMocap.Unity.Tests.Infrastructure;

/// <summary>Measures allocations of rendered frames on the main thread.</summary>
internal static class FrameAllocations
{
    /// <summary>Asserts that frames of a scene allocate nothing after a warm-up. Other threads do not disturb the measurement.</summary>
    /// <param name="loop">The loop of the scene.</param>
    public static void AssertNone(PlayerLoop loop) => Allocations.AssertNone(() => loop.Frame());
}
