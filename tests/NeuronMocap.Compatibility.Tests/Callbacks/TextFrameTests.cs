using System.Globalization;
using System.Text;
using NeuronMocap.Compatibility.Tests.Infrastructure;

namespace NeuronMocap.Compatibility.Tests.Callbacks;

// Streams that the vendor's library cannot read, in images that its programs understand.
public sealed class TextFrameTests
{
    [Fact]
    public async Task Lines_of_text_become_frames_with_the_new_header_and_a_counted_index()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);

        await server.Connection.SendAsync(Encoding.ASCII.GetBytes(Line(0, "First", 354, 1) + Line(1, "Second", 180, 2) + Line(0, "First", 354, 3)));
        await log.FramesAsync(3);

        Assert.Equal(
            ["First 0 0 354 1 0 1.1.0.0", "Second 1 0 180 0 0 1.1.0.0", "First 0 1 354 1 0 1.1.0.0"],
            log.Frames.Select(static frame => frame.Motion).Select(static header =>
                $"{header.AvatarName} {header.AvatarIndex} {header.FrameIndex} {header.DataCount} {header.bWithDisp} {header.bWithReference} "
                + $"{header.DataVersion.Major}.{header.DataVersion.Minor}.{header.DataVersion.Revision}.{header.DataVersion.BuildNumb}"));
        Assert.Equal([1f, 2f, 3f], log.Frames.Select(static frame => frame.Values[0]));
        Assert.Equal(1.25f + 353, log.Frames[0].Values[353] + 0.25f);
    }

    [Fact]
    public async Task Columns_of_calculation_text_become_calculation_frames()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        string columns = string.Join(' ', Enumerable.Range(0, 946).Select(static i => i.ToString("0.00", CultureInfo.InvariantCulture)));

        await server.Connection.SendAsync(Encoding.ASCII.GetBytes(columns + "\n" + columns + "\n"));
        await Limits.UntilAsync(() => log.CalculationFrames.Count == 2);

        Assert.Equal([0u, 1u], log.CalculationFrames.Select(static frame => frame.Calculation.FrameIndex));
        Assert.Equal((0x88FF, 0x99FF, 946u), (log.CalculationFrames[0].Calculation.Token1, log.CalculationFrames[0].Calculation.Token2, log.CalculationFrames[0].Calculation.DataCount));
        Assert.Equal(945f, log.CalculationFrames[1].Values[945]);
    }

    // Written by a foreign encoder. The vendor's library has no callback for Axis Studio's calculation packets.
    [Theory]
    [InlineData("old-354")]
    [InlineData("new-186")]
    [InlineData("studio-354")]
    [InlineData("text")]
    [InlineData("calculation")]
    [InlineData("mixed")]
    [InlineData("studio-calculation")]
    [InlineData("zero-count")]
    public async Task Every_frame_of_a_foreign_stream_is_delivered(string name)
    {
        StreamFixture fixture = StreamFixture.Load(name);
        ExpectedPacket[] motion = [.. fixture.Expected.Where(static packet => packet.Kind == PacketKind.Motion && packet.Type is "frame")];
        ExpectedPacket[] calculation = [.. fixture.Expected.Where(static packet => packet.Type is "calculation")];
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);

        await server.Connection.SendPiecesAsync(fixture.Bytes, 977);
        server.Connection.Close();
        await Limits.UntilAsync(() => log.Statuses.Count == 4);

        Assert.Equal(motion.Length, log.Frames.Count);
        Assert.Equal(calculation.Length, log.CalculationFrames.Count);
        foreach ((ExpectedPacket expected, LoggedFrame frame) in motion.Zip(log.Frames))
        {
            Assert.Equal(((uint)expected.Avatar, expected.Name), (frame.Motion.AvatarIndex, frame.Motion.AvatarName));
            Assert.Equal(expected.Values, frame.Values);
            if (expected.Index is uint index)
                Assert.Equal(index, frame.Motion.FrameIndex);
        }

        foreach ((ExpectedPacket expected, LoggedFrame frame) in calculation.Zip(log.CalculationFrames))
        {
            Assert.Equal(((uint)expected.Avatar, expected.Name), (frame.Calculation.AvatarIndex, frame.Calculation.AvatarName));
            Assert.Equal(expected.Values, frame.Values);
        }
    }

    private static string Line(int avatar, string name, int count, int first) => string.Create(
        CultureInfo.InvariantCulture,
        $"{avatar} {name} {string.Join(' ', Enumerable.Range(first, count).Select(static value => value.ToString("0.00", CultureInfo.InvariantCulture)))} ||\r\n");
}
