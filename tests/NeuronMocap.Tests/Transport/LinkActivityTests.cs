using System.Diagnostics;
using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

public sealed class LinkActivityTests
{
    private readonly List<ConnectionStatus> _told = [];
    private readonly StatusPublisher _status;
    private readonly LinkActivity _activity;
    private readonly long _start;

    public LinkActivityTests()
    {
        _status = new StatusPublisher(_told.Add);
        _activity = new LinkActivity(_status, TimeSpan.FromSeconds(3), udpSenders: null);
        _activity.Begin("host:7001");
        _status.Set(new ConnectionStatus(ConnectionState.Connected, ConnectionReason.None, "connected"));
        _start = Stopwatch.GetTimestamp();
    }

    [Fact]
    public void The_first_packet_changes_the_state_to_receiving_once()
    {
        Deliver(0);
        Deliver(1);
        Assert.Equal([ConnectionState.Connected, ConnectionState.Receiving], _told.Select(status => status.State));
        Assert.True(_activity.HasPackets);
    }

    [Fact]
    public void Silence_is_reported_once_and_ends_with_the_next_packet()
    {
        Deliver(0);
        _activity.Check(After(2.9));
        Assert.Equal(ConnectionState.Receiving, _status.State);
        _activity.Check(After(3.1));
        _activity.Check(After(4));
        Deliver(5);
        Assert.Equal(
            [ConnectionState.Connected, ConnectionState.Receiving, ConnectionState.Silent, ConnectionState.Receiving],
            _told.Select(status => status.State));
        Assert.Equal(ConnectionReason.NoData, _told[2].Reason);
        Assert.Contains("3 s", _told[2].Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("0 Char00 0.00 93.02 0.00", "Binary")]
    [InlineData("HTTP/1.1 400 Bad Request", "7001")]
    [InlineData("SSH-2.0-OpenSSH_9.6", "SSH")]
    [InlineData("\u0016\u0003\u0001\u0002", "TLS")]
    [InlineData("\u0016\u0004\u0001\u0002", "16 04 01 02")]
    public void An_unknown_format_names_the_setting(string bytes, string expected)
    {
        foreach (char value in bytes)
            _activity.OnSkipped([(byte)value], SkipReason.NoTokens);

        _activity.Check(After(4));
        Assert.Equal((ConnectionState.Silent, ConnectionReason.UnknownFormat), (_told[^1].State, _told[^1].Reason));
        Assert.Contains(expected, _told[^1].Message, StringComparison.Ordinal);
    }

    // The line comes after the rest of another one, which is explained first.
    [Fact]
    public void A_reason_that_says_more_replaces_the_message_of_a_silence_once()
    {
        byte[] line = "0 Char 02 1.0 2.0 ||"u8.ToArray();
        _activity.OnSkipped("12.50 ||"u8, SkipReason.MalformedLine);
        _activity.Check(After(4));
        for (int i = 0; i < 3; i++)
        {
            _activity.OnSkipped(line, i == 1 ? SkipReason.MissingAvatar : SkipReason.AmbiguousName);
            _activity.Check(After(5 + i));
        }

        Assert.Equal([ConnectionState.Connected, ConnectionState.Silent, ConnectionState.Silent], _told.Select(status => status.State));
        Assert.DoesNotContain("spaces and numbers", _told[1].Message, StringComparison.Ordinal);
        Assert.Contains("spaces and numbers", _told[2].Message, StringComparison.Ordinal);
    }

    [Fact]
    public void An_unknown_version_is_named()
    {
        _activity.OnSkipped([0xFF, 0xDD, 4, 3, 2, 9, 0, 0], SkipReason.UnknownVersion);
        _activity.Check(After(4));
        Assert.Contains("9.2.3.4", _told[^1].Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Garbage_before_packets_is_not_the_reason_for_silence()
    {
        _activity.OnSkipped("HTTP/1.1"u8, SkipReason.NoTokens);
        Deliver(0);
        _activity.Check(After(4));
        Assert.Equal(ConnectionReason.NoData, _told[^1].Reason);
    }

    [Fact]
    public void Nothing_is_reported_without_a_connection()
    {
        _status.Set(new ConnectionStatus(ConnectionState.Waiting, ConnectionReason.Refused, "waiting"));
        _activity.Check(After(100));
        Assert.Equal(ConnectionState.Waiting, _told[^1].State);
    }

    [Fact]
    public void A_slow_handler_is_not_a_silent_server()
    {
        _activity.BeginDelivery(Packet(0));
        _activity.Check(After(10));
        Assert.Equal(ConnectionState.Receiving, _status.State);
        _activity.EndDelivery();
        _activity.Check(After(12));
        Assert.Equal(ConnectionState.Receiving, _status.State);
        _activity.Check(After(14));
        Assert.Equal(ConnectionState.Silent, _status.State);
    }

    [Fact]
    public void Packets_without_frames_are_named()
    {
        _activity.BeginDelivery(new ReceivedPacket(PacketKind.Motion, TestPackets.Motion(1, count: 0), After(0), 0));
        _activity.EndDelivery();
        _activity.Check(After(4));
        Assert.Equal(ConnectionReason.NoData, _told[^1].Reason);
        Assert.Contains("none of them contains a frame", _told[^1].Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Earlier_empty_packets_are_not_the_reason_for_silence()
    {
        _activity.BeginDelivery(new ReceivedPacket(PacketKind.Motion, TestPackets.Motion(1, count: 0), After(0), 0));
        _activity.EndDelivery();
        Deliver(0);
        _activity.Check(After(4));
        Assert.Contains("nothing has arrived", _told[^1].Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Incomplete_packets_are_named()
    {
        _activity.OnSkipped(TestPackets.Motion(1).AsSpan(0, 1024), SkipReason.Incomplete);
        _activity.Check(After(4));
        Assert.Contains("the rest is lost", _told[^1].Message, StringComparison.Ordinal);
        LinkEnd closed = new(ConnectionReason.ClosedByPeer, "closed");
        Assert.Equal(closed, _activity.Explain(closed));
    }

    [Theory]
    [InlineData("220.5310 -3.12 4.00 5.5 ", "Binary")]
    [InlineData("220 Char00 0.00 93.02 1.0", "Binary")]
    [InlineData("220.53", "32 32 30 2E")]
    [InlineData("220 mail.example.com ESMTP\r\n", "mail or FTP")]
    [InlineData("220-Welcome\r\n", "mail or FTP")]
    [InlineData("Char00 0.00 93.02 1.0 2.0 3.0", "instead of the avatar's number")]
    [InlineData("Anna Lena -0.50 93.02 1.0 2.0 3.0", "instead of the avatar's number")]
    [InlineData("Welcome to port 7001 ", "starts with 57")]
    [InlineData("CCCC 1.00 93.02 1.0 2.0 3.0", "instead of the avatar's number")]
    [InlineData("CCCC\u0010\u0027\0\0\u001F\u008A", "starts with 43 43 43 43")]
    public void Numbers_are_not_a_greeting(string bytes, string expected)
    {
        FormatGuess guess = FormatGuess.Of(System.Text.Encoding.ASCII.GetBytes(bytes), SkipReason.NoTokens);
        Assert.Contains(expected, guess.Description, StringComparison.Ordinal);
    }

    [Fact]
    public void A_single_blocked_datagram_gives_no_advice()
    {
        var filter = new SenderFilter([IPAddress.Loopback]);
        LinkActivity activity = OverUdp(filter);
        filter.CountRefused(Stray);
        activity.Check(After(3.5));
        Assert.Equal((ConnectionState.Silent, ConnectionReason.NoData), (_told[^1].State, _told[^1].Reason));
        Assert.Contains("AllowedSenders does not list (1 in all)", _told[^1].Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_blocked_stream_is_reported_while_it_lasts()
    {
        var filter = new SenderFilter([IPAddress.Loopback]);
        LinkActivity activity = OverUdp(filter);
        var reasons = new List<ConnectionReason>();
        for (double seconds = 0.5; seconds < 16; seconds += 0.5)
        {
            for (int i = 0; i < 30 && seconds is > 5 and < 11; i++)
                filter.CountRefused(Stray);

            activity.Check(After(seconds));
            if (reasons.Count == 0 || _told[^1].Reason != reasons[^1])
                reasons.Add(_told[^1].Reason);
        }

        Assert.Equal([ConnectionReason.None, ConnectionReason.NoData, ConnectionReason.SenderNotAllowed, ConnectionReason.NoData], reasons);
    }

    // The timer may run between a jump and the first frame after it.
    [Fact]
    public void After_a_jump_in_a_playback_what_was_told_holds_until_the_next_frame()
    {
        var stream = new StreamDescription(StreamFormat.Text, ConnectionReason.None, ": text format.");
        var activity = new LinkActivity(_status, TimeSpan.FromSeconds(3), udpSenders: null, () => stream);
        activity.BeginDelivery(Packet(0));
        activity.EndDelivery();
        ConnectionStatus told = _told[^1];
        stream = default;
        activity.Check(After(1.5));
        Assert.Equal((told, StreamFormat.Text), (_told[^1], told.Format));
        stream = new StreamDescription(StreamFormat.Studio, ConnectionReason.None, ": binary format of Axis Studio.");
        activity.Check(After(2));
        Assert.Equal(StreamFormat.Studio, _told[^1].Format);
    }

    private static SocketAddress Stray => new IPEndPoint(IPAddress.Parse("192.0.2.1"), 40_000).Serialize();

    private LinkActivity OverUdp(SenderFilter filter)
    {
        var activity = new LinkActivity(_status, TimeSpan.FromSeconds(3), filter);
        activity.Begin("UDP port 7001");
        activity.Check(After(0.1));
        return activity;
    }

    private void Deliver(double seconds)
    {
        _activity.BeginDelivery(Packet(seconds));
        _activity.EndDelivery();
        _activity.Check(After(seconds));
    }

    private ReceivedPacket Packet(double seconds) => new(PacketKind.Motion, TestPackets.Motion(1), After(seconds), 0);

    private long After(double seconds) => _start + (long)(seconds * Stopwatch.Frequency);
}
