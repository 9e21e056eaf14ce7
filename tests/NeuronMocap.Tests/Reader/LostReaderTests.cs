using System.Runtime.CompilerServices;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

/// <summary>Readers that are neither disposed nor referenced any more.</summary>
[Collection(nameof(Alone))]
public sealed class LostReaderTests : IDisposable
{
    private readonly TestServer _server = new();

    public void Dispose() => _server.Dispose();

    [Fact]
    public async Task A_reader_that_never_started_is_collected()
    {
        WeakReference lost = Create();
        await AssertCollectedAsync(lost);

        [MethodImpl(MethodImplOptions.NoInlining)]
        static WeakReference Create()
        {
            var reader = new NeuronReader("127.0.0.1");
            reader.MotionReceived += _ => { };
            reader.OpenQueue(1);
            return new WeakReference(reader);
        }
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_reader_that_has_ended_is_collected(bool disposes)
    {
        WeakReference lost = await RunAsync(disposes);
        await AssertCollectedAsync(lost);
    }

    [Fact]
    public async Task A_running_reader_is_not_collected()
    {
        using var received = new CountdownEvent(2);
        Lose(received);
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await Limits.UntilAsync(() => received.CurrentCount == 1);
        for (int i = 0; i < 3; i++)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }

        await connection.SendAsync(TestPackets.Motion(2));
        await Limits.UntilAsync(() => received.IsSet);

        [MethodImpl(MethodImplOptions.NoInlining)]
        void Lose(CountdownEvent count)
        {
            var reader = new NeuronReader(_server.Options());
            reader.MotionReceived += _ => count.Signal();
            reader.Start();
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private async Task<WeakReference> RunAsync(bool disposes)
    {
        var reader = new NeuronReader(_server.Options());
        FrameQueue queue = reader.OpenQueue(1);
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await Limits.UntilAsync(() => queue.Count == 1);
        if (disposes)
            await reader.DisposeAsync();
        else
            connection.Close();

        await reader.Completion.Soon();
        return new WeakReference(reader);
    }

    private static Task AssertCollectedAsync(WeakReference lost) => Limits.UntilAsync(() =>
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
        return !lost.IsAlive;
    });
}
