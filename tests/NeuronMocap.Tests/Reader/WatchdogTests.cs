using System.Net;
using System.Text;
using NeuronMocap.Reader;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

public sealed class WatchdogTests
{
    private static readonly TimeSpan Ordinary = TimeSpan.FromMilliseconds(25);
    private static readonly TimeSpan Seldom = TimeSpan.FromTicks(Watchdog.Idleness * Ordinary.Ticks);
    private static readonly TimeSpan Silence = TimeSpan.FromTicks(4 * Ordinary.Ticks);

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_silent_reader_is_checked_seldom_until_something_arrives(bool isGarbage)
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(Options(server));
        var log = new StatusLog(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await log.WaitAsync(static status => status is { State: ConnectionState.Silent, Reason: ConnectionReason.NoData });
        await Limits.UntilAsync(() => reader.CheckPeriod == Seldom);

        connection.Socket.Send(isGarbage ? Encoding.ASCII.GetBytes("SSH-2.0-OpenSSH_9.6\r\n") : TestPackets.Motion(1));
        if (isGarbage)
        {
            await log.WaitAsync(static status => status is { State: ConnectionState.Silent, Reason: ConnectionReason.UnknownFormat });
            Assert.Equal(Ordinary, reader.CheckPeriod);
        }
        else
        {
            // Silence is found as early as before, and then checks become seldom again.
            await log.WaitAsync(ConnectionState.Receiving);
            await Limits.UntilAsync(() => reader.Status.State == ConnectionState.Silent && reader.CheckPeriod == Seldom);
        }
    }

    [Fact]
    public async Task What_needs_checks_keeps_them()
    {
        using var server = new TestServer();
        using var commands = new TestServer();
        NeuronReaderOptions options = Options(server);
        options.CommandPort = commands.Port;
        await using var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await log.WaitAsync(ConnectionState.Silent);
        Assert.Equal(Ordinary, reader.CheckPeriod);
    }

    [Fact]
    public async Task Refused_senders_need_checks()
    {
        await using var reader = new NeuronReader(new NeuronReaderOptions
        {
            Transport = TransportKind.Udp,
            Port = 0,
            AllowedSenders = [IPAddress.Parse("192.0.2.1")],
            SilenceTimeout = Silence,
        });
        var log = new StatusLog(reader);
        reader.Start();
        await log.WaitAsync(ConnectionState.Silent);
        Assert.Equal(Ordinary, reader.CheckPeriod);
    }

    [Fact]
    public void Checks_become_seldom_when_so_many_have_found_nothing()
    {
        var period = TimeSpan.FromMinutes(1);
        bool isIdle = true;
        int checks = 0;
        using var watchdog = new Watchdog(period, _ => checks++, () => isIdle);
        for (int round = 0; round < 2; round++)
        {
            for (int i = 1; i < Watchdog.Idleness; i++)
            {
                watchdog.Check();
                watchdog.Adjust();
                Assert.Equal(period, watchdog.Period);
            }

            watchdog.Check();
            Assert.Equal(TimeSpan.FromTicks(Watchdog.Idleness * period.Ticks), watchdog.Period);

            isIdle = false;
            watchdog.Adjust();
            Assert.Equal(period, watchdog.Period);
            isIdle = true;
        }

        Assert.Equal(2 * Watchdog.Idleness, checks);
    }

    [Fact]
    public void Readers_that_began_at_different_times_are_checked_together()
    {
        TimeSpan period = TimeSpan.FromSeconds(5);
        double[] instants = [.. new[] { 100.0, 101.3, 104.999 }.Select(now => now + Watchdog.NextShared(TimeSpan.FromSeconds(now), period).TotalSeconds)];
        Assert.Equal([105, 105, 105], instants);
    }

    private static NeuronReaderOptions Options(TestServer server)
    {
        NeuronReaderOptions options = server.Options();
        options.SilenceTimeout = Silence;
        return options;
    }
}
