using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Sources;

/// <summary>Handlers of a source's events may do anything with the source.</summary>
public sealed class SourceHandlerTests : SourceFixture
{
    [Theory]
    [InlineData(SourceState.Connecting)]
    [InlineData(SourceState.Receiving)]
    public void A_state_handler_may_disable_the_source(SourceState last)
    {
        // A connection may open before a frame shows it connecting.
        using var hole = new BlackHole();
        MocapSource source = last == SourceState.Connecting ? Add(source => source.Port = hole.Port) : AddSimulator();
        source.StateChanged += state =>
        {
            if (state == last)
                source.enabled = false;
        };
        Loop.RunUntil(() => !source.enabled);
        Loop.Frames(3);

        AssertClosed(source);
    }

    [Fact]
    public void Throwing_handlers_are_logged_and_isolated()
    {
        MocapSource source = AddSimulator(2);
        var told = new List<string>();
        source.StateChanged += _ => throw new InvalidOperationException("state");
        source.StateChanged += state => told.Add(state.ToString());
        source.PerformerJoined += _ => throw new InvalidOperationException("joined");
        source.PerformerLeft += _ => throw new InvalidOperationException("left");
        source.PerformerLeft += performer => told.Add($"{performer.AvatarIndex} left");
        WaitForPose(source, 0);
        WaitForPose(source, 1);
        source.enabled = false;

        Assert.Contains("0 left", told);
        Assert.Contains("1 left", told);
        Assert.Equal(nameof(SourceState.Closed), told[^1]);
        Assert.Equal(["joined", "left", "state"], ConsoleLog.Entries.Select(entry => entry.Exception!.Message).Distinct().Order());
        ConsoleLog.Clear();
        AssertClosed(source);
    }

    [Fact]
    public void A_join_handler_may_disable_the_source()
    {
        MocapSource first = AddSimulator(2);
        WaitForPose(first, 1);

        // On the same connection, both performers join in the same frame.
        MocapSource source = AddSimulator(2);
        source.PerformerJoined += _ => source.enabled = false;
        Loop.RunUntil(() => !source.enabled);
        Loop.Frames(3);

        AssertClosed(source);
        Assert.Equal(2, first.Performers.Count);
    }

    [Fact]
    public void A_leave_handler_may_disable_the_source()
    {
        Broadcaster server = Serve(new SyntheticSource(), new SyntheticSource(avatarIndex: 1));
        MocapSource source = Add(server, source =>
        {
            source.Reconnect = false;
            source.IdleTimeout = 0.1f;
            source.LeaveTimeout = 0.1f;
        });
        WaitForPose(source, 0);
        WaitForPose(source, 1);
        Performer[] performers = [.. source.Performers];
        server.Dispose();
        source.PerformerLeft += _ => source.enabled = false;

        // The game renders no frame until both are gone, so they leave in the same frame. No frame is on its way after the end of the connection.
        Assert.True(SpinWait.SpinUntil(() => source.Reader!.Completion.IsCompleted, Limits.Unexpected));
        Assert.True(SpinWait.SpinUntil(() => performers.All(performer => SourceClock.Now - performer.Stream.LastArrival > SourceClock.ToTicks(0.2)), Limits.Unexpected));
        Loop.Frames(3);

        AssertClosed(source);
    }

    [Fact]
    public void A_leave_handler_may_reopen_the_source()
    {
        MocapSource source = AddSimulator();
        WaitForPose(source);
        bool isDone = false;
        source.PerformerLeft += _ =>
        {
            if (!isDone)
                source.Open();
            isDone = true;
        };
        source.Close();

        Assert.True(source.IsOpen);
        Assert.NotEqual(SourceState.Closed, source.State);
        WaitForPose(source);
        Assert.Empty(ConsoleLog.Entries);
    }

    // The other source keeps the connection, so the reopened source gets the same one.
    [Fact]
    public void A_leave_handler_may_reopen_a_source_that_shares_its_connection()
    {
        Broadcaster server = Serve(new SyntheticSource(), new SyntheticSource(avatarIndex: 1));
        MocapSource[] sources = [AddShort(), AddShort()];
        Loop.RunUntil(() => sources.All(static source => source.Performers.Count == 2 && source.Performers.All(static performer => performer.HasPose)));
        Performer[] performers = [.. sources[0].Performers];
        server.Dispose();
        bool isDone = false;
        sources[0].PerformerLeft += _ =>
        {
            if (isDone)
                return;

            isDone = true;
            sources[0].Close();
            sources[0].Open();
        };

        // The game renders no frame until both are gone, so they leave in the same frame. No frame is on its way after the end of the connection.
        Assert.True(SpinWait.SpinUntil(() => sources[0].Reader!.Completion.IsCompleted, Limits.Unexpected));
        Assert.True(SpinWait.SpinUntil(() => performers.All(performer => SourceClock.Now - performer.Stream.LastArrival > SourceClock.ToTicks(0.2)), Limits.Unexpected));
        Loop.Frames(3);

        Assert.True(isDone);
        Assert.Same(sources[1].Reader, sources[0].Reader);
        Assert.All(sources, static source => Assert.Empty(source.Performers));
        Assert.Empty(ConsoleLog.Entries);

        MocapSource AddShort() => Add(server, source => (source.Reconnect, source.IdleTimeout, source.LeaveTimeout) = (false, 0.1f, 0.1f));
    }

    [Theory]
    [InlineData(SourceKind.Network)]
    [InlineData(SourceKind.BvhFile)]
    public void Null_texts_count_as_empty(SourceKind kind)
    {
        MocapSource source = Add(source =>
        {
            source.Kind = kind;
            source.Address = null!;
            source.File = null!;
        });
        Loop.RunUntil(() => source.State == SourceState.Failed);

        Assert.Equal(string.Empty, source.Address);
        Assert.Equal(string.Empty, source.File);
        Assert.Empty(ConsoleLog.Entries);
    }

    private static void AssertClosed(MocapSource source)
    {
        Assert.Equal(SourceState.Closed, source.State);
        Assert.False(source.IsOpen);
        Assert.Empty(source.Performers);
        Assert.Empty(ConsoleLog.Entries);
    }
}
