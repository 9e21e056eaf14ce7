namespace NeuronMocap.Unity.Tests.Infrastructure;

/// <summary>What rendered frames allocate on the main thread.</summary>
internal static class FrameAllocations
{
    /// <summary>Asserts that frames of a scene, once warm, allocate nothing; other threads do not disturb the measurement.</summary>
    /// <param name="loop">Whose scene.</param>
    public static void AssertNone(PlayerLoop loop) => Allocations.AssertNone(() => loop.Frame());
}
