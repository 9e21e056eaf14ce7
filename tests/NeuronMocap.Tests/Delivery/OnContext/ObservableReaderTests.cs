using System.Collections.Specialized;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

public sealed class ObservableReaderTests
{
    private readonly FakeDeliveryClock _ticker = new();
    private readonly ManualContext _context = new();
    private readonly List<string> _changes = [];

    [Fact]
    public async Task State_rates_and_avatars_change_on_the_context()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        using ObservableReader shown = Observe(reader);
        Assert.Equal((ConnectionState.Created, "Not started.", false), (shown.State, shown.Message, shown.IsConnected));
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        for (int i = 0; i < 40; i++)
        {
            await connection.SendAsync(TestPackets.Motion(i, avatar: 0, name: "Ann"));
            await connection.SendAsync(TestPackets.Motion(i, avatar: 4, name: "Ben"));
            await connection.SendAsync(TestPackets.Calculation(i, avatar: 4));
        }

        await reader.UntilAsync(static statistics => statistics.Frames == 120);
        await Limits.UntilAsync(() => reader.Status.State == ConnectionState.Receiving);
        Assert.Empty(_changes);
        Assert.Equal(ConnectionState.Created, shown.State);

        Tick();
        Assert.Equal((ConnectionState.Receiving, true, 120L), (shown.State, shown.IsConnected, shown.Frames));
        Assert.Equal([(0, "Ann", 40L), (4, "Ben", 80L)], shown.Avatars.Select(static avatar => (avatar.AvatarIndex, avatar.Name, avatar.Frames)));
        Assert.Contains(nameof(ObservableReader.Message), _changes);
        Assert.Equal(2, _changes.Count(static change => change == "+"));
    }

    [Fact]
    public async Task Only_what_has_changed_is_reported_and_nothing_is_posted_without_a_change()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        using ObservableReader shown = Observe(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await reader.WaitForFramesAsync(1);
        await Limits.UntilAsync(() => reader.Status.State == ConnectionState.Receiving);
        Tick();
        _changes.Clear();
        ObservableAvatar avatar = shown.Avatars[0];
        avatar.PropertyChanged += (_, change) => _changes.Add($"avatar {change.PropertyName}");

        // A single frame has no rate. One more tick sees that nothing has changed.
        Tick();
        int posts = _context.Posts;
        for (int i = 0; i < 10; i++)
            Tick();
        Assert.Equal((posts, 0), (_context.Posts, _changes.Count));

        await connection.SendAsync(TestPackets.Motion(5));
        await reader.WaitForFramesAsync(2);
        Tick();
        string[] expected = ["avatar Frames", "avatar Lost", "Frames", "Lost"];
        Assert.Empty(_changes.Except([.. expected, "avatar FrameRate", "FrameRate"], StringComparer.Ordinal));
        Assert.Empty(expected.Except(_changes, StringComparer.Ordinal));
        Assert.Equal((2, 3, 3), (shown.Frames, shown.Lost, avatar.Lost));
        Assert.Same(avatar, shown.Avatars[0]);
    }

    [Fact]
    public async Task One_post_is_outstanding_however_long_the_window_is_busy()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        using ObservableReader shown = Observe(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        for (int i = 0; i < 10; i++)
        {
            await connection.SendAsync(TestPackets.Motion(i));
            await reader.WaitForFramesAsync(i + 1);
            _ticker.Advance(250);
        }

        Assert.Equal(1, _context.MostWaiting);
    }

    [Fact]
    public async Task The_last_state_is_shown_after_the_reader_is_disposed()
    {
        using var server = new TestServer();
        var reader = new NeuronReader(server.Options());
        ObservableReader shown = Observe(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await reader.DisposeAsync();
        await reader.Completion.Soon();
        _context.RunAll();
        Assert.Equal((ConnectionState.Stopped, ConnectionReason.Requested), (shown.State, shown.Reason));
        Assert.True(_ticker.IsDisposed);
        shown.Dispose();
    }

    [Fact]
    public async Task Rates_are_0_after_the_reader_has_stopped()
    {
        using var server = new TestServer();
        var reader = new NeuronReader(server.Options());
        using ObservableReader shown = Observe(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        for (int i = 0; i < 20; i++)
        {
            await connection.SendAsync(TestPackets.Motion(i));
            await reader.WaitForFramesAsync(i + 1);
        }

        _ticker.Advance(250);
        _context.RunAll();
        Assert.Equal(20, shown.Frames);
        await reader.DisposeAsync();
        await reader.Completion.Soon();
        _context.RunAll();
        Assert.Equal((ConnectionState.Stopped, 0, 20), (shown.State, shown.FrameRate, shown.Frames));
        Assert.Equal(0, Assert.Single(shown.Avatars).FrameRate);
    }

    [Fact]
    public async Task A_handler_that_throws_does_not_keep_other_changes_back()
    {
        using var server = new TestServer();
        var reader = new NeuronReader(server.Options());
        using ObservableReader shown = Observe(reader);
        shown.PropertyChanged += static (_, change) => throw new InvalidOperationException(change.PropertyName);
        ((INotifyCollectionChanged)shown.Avatars).CollectionChanged += static (_, _) => throw new InvalidOperationException("list");
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await reader.WaitForFramesAsync(1);
        await Limits.UntilAsync(() => reader.Status.State == ConnectionState.Receiving);
        _ticker.Advance(250);
        Assert.Equal(nameof(shown.Frames), Assert.Throws<InvalidOperationException>(_context.RunAll).Message);
        Assert.Equal((ConnectionState.Receiving, reader.Status.Message, 1L, 1), (shown.State, shown.Message, shown.Frames, shown.Avatars.Count));

        // One exception for each update, and the next frame counts.
        Assert.Equal(0, _context.Waiting);
        shown.Avatars[0].PropertyChanged += static (_, _) => throw new InvalidOperationException("avatar");
        await connection.SendAsync(TestPackets.Motion(2));
        await reader.WaitForFramesAsync(2);
        _ticker.Advance(250);
        Assert.ThrowsAny<InvalidOperationException>(_context.RunAll);
        Assert.Equal((2L, 2L), (shown.Frames, shown.Avatars[0].Frames));

        await reader.DisposeAsync();
        await reader.Completion.Soon();
        while (_context.Waiting > 0)
            Record.Exception(_context.RunAll);
        Assert.Equal((ConnectionState.Stopped, reader.Status.Message), (shown.State, shown.Message));
        Assert.True(_ticker.IsDisposed);
    }

    [Fact]
    public async Task After_a_dispose_nothing_changes()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        ObservableReader shown = Observe(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await reader.WaitForFramesAsync(1);
        _ticker.Advance(250);
        Assert.Equal(1, _context.Waiting);
        shown.Dispose();
        shown.Dispose();
        _context.RunAll();
        _ticker.Elapsed!();
        Assert.Empty(_changes);
        Assert.Equal(ConnectionState.Created, shown.State);
    }

    [Fact]
    public async Task A_context_that_is_gone_ends_the_updates()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        _context.Posting = static () => throw new InvalidOperationException();
        using ObservableReader shown = Observe(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await reader.WaitForFramesAsync(1);
        await Limits.UntilAsync(() => _ticker.IsDisposed);
        Assert.Equal((1, 0L), (_context.Posts, reader.GetStatistics().CallbackFailures));
    }

    [Fact]
    public void A_reader_that_has_stopped_is_shown_as_stopped()
    {
        var reader = new NeuronReader("127.0.0.1");
        reader.Dispose();
        using ObservableReader shown = Observe(reader);
        Assert.Equal(ConnectionState.Stopped, shown.State);
        _context.RunAll();
        Assert.True(_ticker.IsDisposed);
    }

    [Fact]
    public void Options_out_of_range_are_named()
    {
        using var reader = new NeuronReader("127.0.0.1");
        foreach (double rate in (double[])[0, -1, 0.001, 61, double.NaN])
            Assert.StartsWith("UpdateRate", Assert.Throws<ArgumentException>(() => new ObservableReader(reader, new ObservableReaderOptions { UpdateRate = rate })).Message, StringComparison.Ordinal);

        var both = new ObservableReaderOptions { Context = _context, Post = static _ => true };
        Assert.StartsWith("Context and Post", Assert.Throws<ArgumentException>(() => new ObservableReader(reader, both)).Message, StringComparison.Ordinal);
    }

    private ObservableReader Observe(NeuronReader reader)
    {
        var shown = new ObservableReader(reader, new ObservableReaderOptions { Context = _context }, _ticker, new FakeDeliveryClock());
        shown.PropertyChanged += (_, change) => _changes.Add(change.PropertyName!);
        ((INotifyCollectionChanged)shown.Avatars).CollectionChanged += (_, change) => _changes.Add(change.Action == NotifyCollectionChangedAction.Add ? "+" : "-");
        return shown;
    }

    private void Tick()
    {
        _ticker.Advance(250);
        _context.RunAll();
    }
}
