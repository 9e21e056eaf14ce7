using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

public sealed class StatusBoardTests
{
    [Fact]
    public void A_change_made_by_a_handler_is_reported_after_the_current_one()
    {
        List<string> told = [];
        StatusPublisher? board = null;
        board = new StatusPublisher(status =>
        {
            if (status.Message == "first")
                board!.Set(Status("second"));

            told.Add(status.Message);
        });
        board.Set(Status("first"));
        Assert.Equal(["first", "second"], told);
    }

    [Fact]
    public void Stopped_is_final()
    {
        var board = new StatusPublisher(_ => { });
        board.Set(new ConnectionStatus(ConnectionState.Stopped, ConnectionReason.Requested, "end"));
        Assert.False(board.TrySet(_ => true, _ => Status("more")));
        Assert.Equal("end", board.Current.Message);
    }

    [Fact]
    public void An_invalid_change_is_not_reported()
    {
        var board = new StatusPublisher(_ => Assert.Fail("told"));
        Assert.False(board.TrySet(_ => false, _ => Status("never")));
        Assert.Equal(ConnectionState.Created, board.State);
    }

    [Fact]
    public async Task Changes_of_many_threads_are_reported_one_at_a_time()
    {
        int telling = 0;
        int told = 0;
        bool overlapped = false;
        var board = new StatusPublisher(_ =>
        {
            overlapped |= Interlocked.Increment(ref telling) != 1;
            told++;
            Interlocked.Decrement(ref telling);
        });
        await Task.WhenAll(Enumerable.Range(0, 4).Select(_ => Task.Run(() =>
        {
            for (int i = 0; i < 1000; i++)
                board.Set(Status("change"));
        }))).Soon();

        Assert.False(overlapped);
        Assert.Equal(4000, told);
    }

    private static ConnectionStatus Status(string message) => new(ConnectionState.Connecting, ConnectionReason.None, message);
}
