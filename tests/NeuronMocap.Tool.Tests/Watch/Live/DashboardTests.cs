using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Tests.Infrastructure;
using NeuronMocap.Tool.Watch.Live;
using static NeuronMocap.Tool.Tests.Watch.Live.DashboardScreen;

namespace NeuronMocap.Tool.Tests.Watch.Live;

public sealed class DashboardTests
{
    [Theory]
    [InlineData(80, 24)]
    [InlineData(120, 40)]
    public void A_missing_connection_shows_its_reason_and_advice(int width, int height)
    {
        string text = string.Join('\n', Draw(State(Refused), width, height));

        Assert.Contains("CONNECTION REFUSED", text, StringComparison.Ordinal);
        Assert.Contains("Nothing listens there. Check the port.", text, StringComparison.Ordinal);
        Assert.Contains("attempt 2 failed, next in", text, StringComparison.Ordinal);
    }

    [Fact]
    public void The_small_view_shows_counters_drawings_and_bones()
    {
        string text = string.Join('\n', Draw(WithPose(), 80, 24));

        foreach (string part in (string[])["RECEIVING", "TCP studio:7001", "1.1.0.0 NEW", "180 values", "YXZ assumed", "> 0 Char00", "front", "side", "R.Foot", "q quit"])
            Assert.Contains(part, text, StringComparison.Ordinal);

        Assert.Contains("84.1", text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(60, 16)]
    [InlineData(80, 24)]
    [InlineData(140, 40)]
    [InlineData(40, 12)]
    public void A_failed_file_is_shown_with_its_reason(int width, int height)
    {
        LiveState state = WithPose();
        state.AddFailure(new FileFailure("recording", "take.nmrec", "the disk is full.", 7, 0));
        Assert.Contains("RECORDING FAILED: the disk is full.", string.Concat(Draw(state, width, height)), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(80, 24)]
    [InlineData(140, 40)]
    public void Two_failed_files_are_shown_beside_the_status(int width, int height)
    {
        LiveState state = WithPose();
        state.AddFailure(new FileFailure("recording", "take.nmrec", "the disk is full.", 7, 0));
        state.AddFailure(new FileFailure("export", "take.bvh", "the disk is full.", 7, 0));
        string[] lines = Draw(state, width, height);
        string text = string.Concat(lines);
        foreach (string part in (string[])["RECORDING FAILED: the disk is full.", "EXPORT FAILED: the disk is full.", "Receiving from studio:7001."])
            Assert.Contains(part, text, StringComparison.Ordinal);

        // Also in the events, with their time.
        Assert.Equal(2, lines.Count(static line => line.Contains("● ", StringComparison.Ordinal) && line.Contains(" failed: the disk", StringComparison.Ordinal)));
    }

    // The sentence above that line names the origin of the order.
    [Fact]
    public void The_stream_line_does_not_contradict_the_command_channel()
    {
        var state = new LiveState(new ConnectionOptions { Server = new ServerAddress("studio", 7001), CommandPort = 8013 })
        {
            Status = new(ConnectionState.Receiving, ConnectionReason.None, "Receiving from studio:7001: binary format; rotation order YXZ, as the command channel says."),
        };
        state.Take(Poses.Upright());
        string text = string.Concat(Draw(state, 100, 30));
        Assert.Contains("YXZ, as the command channel says", text, StringComparison.Ordinal);
        Assert.DoesNotContain("assumed", text, StringComparison.Ordinal);
    }

    [Fact]
    public void No_keys_are_offered_without_a_keyboard()
    {
        var state = new LiveState(new ConnectionOptions()) { Status = Receiving, HasKeyboard = false };
        string last = Draw(state, 80, 24)[^1];
        Assert.StartsWith("Ctrl-C quits", last, StringComparison.Ordinal);
        Assert.DoesNotContain("record", last, StringComparison.Ordinal);
    }

    [Fact]
    public void The_result_of_a_key_is_shown_and_kept_in_the_events()
    {
        LiveState state = WithPose();
        state.Say("Recorded 2.1 s, 121 frames, 179.1 kB to take.nmrec.");
        string[] lines = Draw(state, 80, 24);
        Assert.Equal("Recorded 2.1 s, 121 frames, 179.1 kB to take.nmrec.", lines[1].TrimEnd());
        Assert.Contains("● Recorded 2.1 s", lines[^2], StringComparison.Ordinal);
    }

    [Fact]
    public void The_timecode_and_the_buffer_are_shown()
    {
        var state = new LiveState(new ConnectionOptions { UdpPort = 7012 }) { Status = Receiving with { ReceiveBufferSize = 212_992 } };
        float[] values = new float[180];
        state.Take(new MotionFrame(new MotionHeader { Version = DataVersion.Studio, Reserved1 = 0x0A0B0C, Reserved2 = 7 }, values));
        string text = string.Join('\n', Draw(state, 80, 24));
        Assert.Contains("timecode 10:11:12:07", text, StringComparison.Ordinal);
        Assert.Contains("buffer 208 KiB of 4 MiB", text, StringComparison.Ordinal);
    }
}
