using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Vendor;

namespace NeuronMocap.Native.Tests.Functions;

// The memory behind the pointers of the data callbacks, byte for byte.
public sealed class FrameTests
{
    [Theory]
    [InlineData(180, "Char00")]
    [InlineData(186, "陈")]
    [InlineData(354, "陈-0123456789-0123456789-01234")]
    [InlineData(360, "")]
    [InlineData(1, "01234567890123456789012345678901")]
    [InlineData(10_224, "é")]
    public async Task A_frame_with_the_new_header_is_delivered_unchanged(int count, string name)
    {
        byte[] packet = new byte[64 + (4 * count)];
        var header = new MotionHeader
        {
            Version = DataVersion.Studio,
            HasDisplacement = true,
            HasReference = true,
            AvatarIndex = 0x01020304,
            AvatarName = new AvatarName(name),
            FrameIndex = uint.MaxValue,
            Reserved = 4,
            Reserved1 = 0x11223344,
            Reserved2 = 0x55667788,
        };
        PacketEncoder.WriteMotion(packet, header, [.. Enumerable.Range(0, count).Select(static i => -i / 7f)]);
        using var server = new TestServer();
        await using var driver = new Driver();
        (string handle, TestConnection connection) = await driver.ConnectAsync(server);

        // In pieces, and after a smaller one.
        await connection.SendAsync(TestPackets.Motion(1, count: 180));
        await connection.SendPiecesAsync(TestPackets.Join(packet, packet), 977);
        await driver.FramesAsync(3);

        foreach (DriverFrame frame in driver.Frames.Skip(1))
        {
            Assert.Equal(packet[..64], frame.Header);
            Assert.Equal(DriverFrame.HashOf(packet.AsSpan(64)), frame.Hash);
        }

        AssertPlaces(driver.Frames, "f", handle);
        connection.Dispose();
        await driver.EndAsync();
    }

    [Fact]
    public async Task A_frame_with_the_old_header_gets_the_new_header_and_a_counted_index()
    {
        using var server = new TestServer();
        await using var driver = new Driver();
        (string handle, TestConnection connection) = await driver.ConnectAsync(server);

        await connection.SendAsync(TestPackets.Join(
            TestPackets.Motion(7, avatar: 0, name: "First", layout: HeaderLayout.Old),
            TestPackets.Motion(7, avatar: 1, count: 186, name: "Second", layout: HeaderLayout.Old),
            TestPackets.Motion(8, avatar: 0, name: "First", layout: HeaderLayout.Old)));
        await driver.FramesAsync(3);

        Assert.Equal(
            [
                TestPackets.Motion(0, avatar: 0, name: "First")[..64],
                TestPackets.Motion(0, avatar: 1, count: 186, name: "Second")[..64],
                TestPackets.Motion(1, avatar: 0, name: "First")[..64],
            ],
            driver.Frames.Select(static frame => frame.Header));
        Assert.Equal(DriverFrame.HashOf(TestPackets.Motion(7, avatar: 1, count: 186).AsSpan(64)), driver.Frames[1].Hash);
        AssertPlaces(driver.Frames, "f", handle);
        connection.Dispose();
        await driver.EndAsync();
    }

    [Theory]
    [InlineData(338)]
    [InlineData(946)]
    public async Task A_calculation_frame_is_delivered_unchanged_with_its_own_object(int count)
    {
        byte[] packet = TestPackets.Calculation(99, avatar: 3, count);
        using var server = new TestServer();
        await using var driver = new Driver();
        (string handle, TestConnection connection) = await driver.ConnectAsync(server);

        await connection.SendAsync(TestPackets.Join(TestPackets.Motion(1), packet, TestPackets.Motion(2)));
        await driver.FramesAsync(2);

        DriverFrame frame = Assert.Single(driver.Calculations);
        Assert.Equal(packet[..64], frame.Header);
        Assert.Equal(DriverFrame.HashOf(packet.AsSpan(64)), frame.Hash);
        Assert.Equal(driver.Frames[0].Thread, frame.Thread);
        AssertPlaces(driver.Calculations, "c", handle);
        connection.Dispose();
        await driver.EndAsync();
    }

    // The driver compares the frame again at the end of every callback, and reports overwritten data.
    [Fact]
    public async Task The_memory_of_a_frame_is_stable_during_the_callback()
    {
        using var server = new TestServer();
        using var other = new TestServer();
        await using var driver = new Driver();
        (string handle, TestConnection connection) = await driver.ConnectAsync(server);
        (string second, TestConnection busy) = await driver.ConnectAsync(other);
        await driver.CallAsync("when frame hold");
        await connection.SendAsync(TestPackets.Motions(1, 100));
        await driver.UntilAsync(() => driver.Reactions.Count == 1);

        // Another connection continues meanwhile, on its own thread and in its own memory.
        await busy.SendAsync(TestPackets.Motions(1, 100));
        await driver.UntilAsync(() => driver.Frames.Count(frame => frame.Sender == second) == 100);
        Assert.Single(driver.Frames, frame => frame.Sender == handle);
        await driver.CallAsync("release");
        await driver.UntilAsync(() => driver.Frames.Count(frame => frame.Sender == handle) == 100);

        Assert.Equal(2, driver.Frames.Select(static frame => (frame.Sender, frame.Thread)).Distinct().Count());
        Assert.Equal(2, driver.Frames.Select(static frame => frame.Thread).Distinct(StringComparer.Ordinal).Count());
        connection.Dispose();
        busy.Dispose();
        await driver.EndAsync();
    }

    [Fact]
    public async Task Frames_without_values_are_not_delivered()
    {
        using var server = new TestServer();
        await using var driver = new Driver();
        (_, TestConnection connection) = await driver.ConnectAsync(server);
        await connection.SendAsync(TestPackets.Join(
            TestPackets.Motion(1, count: 0), TestPackets.Calculation(1, count: 0), new byte[100], TestPackets.Motion(2)));
        await driver.FramesAsync(1);
        Assert.Equal(2u, driver.Frames[0].FrameIndex);
        Assert.Empty(driver.Calculations);
        connection.Dispose();
        await driver.EndAsync();
    }

    private static void AssertPlaces(IEnumerable<DriverFrame> frames, string letter, string handle)
    {
        Assert.All(frames, frame =>
        {
            Assert.Equal((letter, handle), (frame.Object, frame.Sender));
            Assert.NotEqual("main", frame.Thread);
            Assert.Equal((0ul, 64ul), (frame.HeaderAddress % 16, frame.DataAddress - frame.HeaderAddress));
        });

        // Programs may keep the address.
        Assert.Single(frames.Select(static frame => frame.HeaderAddress).Distinct());
    }
}
