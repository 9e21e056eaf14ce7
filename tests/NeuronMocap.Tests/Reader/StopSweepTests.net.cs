using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Reader;

public sealed partial class StopSweepTests
{
    public static TheoryData<Situation, Stopping> Pooled => new()
    {
        { Situation.BlackHoled, Stopping.Dispose },
        { Situation.BlackHoled, Stopping.ThreeThreads },
        { Situation.Idle, Stopping.Dispose },
        { Situation.MidFrame, Stopping.DisposeAsync },
        { Situation.MidFrame, Stopping.ThreeThreads },
        { Situation.Streaming, Stopping.Dispose },
        { Situation.Streaming, Stopping.ThreeThreads },
        { Situation.Streaming, Stopping.WhilePumping },
        { Situation.Streaming, Stopping.StatusHandler },
        { Situation.Streaming, Stopping.FrameHandler },
        { Situation.Streaming, Stopping.PumpHandler },
    };

    [Theory]
    [MemberData(nameof(Pooled))]
    public Task Stopping_a_connection_without_a_thread_is_fast_and_leaves_nothing(Situation situation, Stopping stopping) =>
        SweepAsync(situation, stopping, static () => new PooledTcpReceiver());
}
