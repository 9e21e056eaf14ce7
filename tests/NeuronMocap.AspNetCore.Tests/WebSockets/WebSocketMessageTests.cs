using System.Net.WebSockets;
using System.Numerics;
using System.Text.Json;
using NeuronMocap.AspNetCore.Tests.Infrastructure;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.AspNetCore.Tests.WebSockets;

// What the messages of each form contain.
public sealed class WebSocketMessageTests
{
    [Fact]
    public async Task Packets_arrive_bit_for_bit()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using ClientWebSocket client = await site.ConnectAsync("packet");
        Assert.Equal("packet", client.SubProtocol);

        foreach (byte[] packet in (byte[][])[TestPackets.Motion(1), TestPackets.Calculation(1), TestPackets.Studio(1), TestPackets.Motion(2, avatar: 1, count: 180, layout: HeaderLayout.Old)])
        {
            await site.Motion.SendAsync(packet);
            Assert.Equal(packet, await client.ReadBinaryAsync());
        }
    }

    [Fact]
    public async Task A_client_that_asks_for_nothing_gets_the_lines_of_watch()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using ClientWebSocket client = await site.ConnectAsync();
        Assert.True(string.IsNullOrEmpty(client.SubProtocol));

        await site.Motion.SendAsync(TestPackets.Motion(7));
        JsonElement skeleton = await client.ReadJsonAsync();
        Assert.Equal(("skeleton", 59), (skeleton.GetProperty("type").GetString(), skeleton.GetProperty("bones").GetArrayLength()));
        JsonElement frame = await client.ReadJsonAsync();
        Assert.Equal(("frame", 0, "Char00", 7), (Text(frame, "type"), frame.GetProperty("avatar").GetInt32(), Text(frame, "name"), frame.GetProperty("index").GetInt32()));
        Assert.Equal(
            Enumerable.Range(0, 354).Select(static index => TestPackets.Value(7, 0, index)),
            frame.GetProperty("values").EnumerateArray().Select(static value => value.GetSingle()));
        Assert.Equal(177, frame.GetProperty("positions").GetArrayLength());

        // The skeleton follows only if it changes.
        await site.Motion.SendAsync(TestPackets.Motion(8));
        Assert.Equal("frame", Text(await client.ReadJsonAsync(), "type"));
        await site.Motion.SendAsync(TestPackets.Motion(9, count: 180));
        Assert.Equal("skeleton", Text(await client.ReadJsonAsync(), "type"));
        Assert.Equal("frame", Text(await client.ReadJsonAsync(), "type"));
        await site.Motion.SendAsync(TestPackets.Calculation(9));
        Assert.Equal("calculation", Text(await client.ReadJsonAsync(), "type"));
        await site.Motion.SendAsync(TestPackets.Studio(9));
        Assert.Equal("studioCalculation", Text(await client.ReadJsonAsync(), "type"));
    }

    [Fact]
    public async Task Every_client_learns_the_skeleton()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using ClientWebSocket first = await site.ConnectAsync("json");
        await site.Motion.SendAsync(TestPackets.Motion(1));
        Assert.Equal("skeleton", Text(await first.ReadJsonAsync(), "type"));
        using ClientWebSocket second = await site.ConnectAsync("json");
        await site.Motion.SendAsync(TestPackets.Motion(2));
        Assert.Equal("skeleton", Text(await second.ReadJsonAsync(), "type"));
    }

    [Fact]
    public async Task Poses_are_small_and_nearly_exact()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using ClientWebSocket client = await site.ConnectAsync("pose");
        await using var other = new NeuronReader(new MemoryStream(TestPackets.Motion(3)));
        var sent = new BoneTransform[BoneHierarchy.BoneCount];
        other.MotionReceived += frame => frame.CopyLocalTransforms(sent);
        other.Start();
        await other.Completion.Soon();

        // Calculation data has no pose.
        await site.Motion.SendAsync(TestPackets.Join(TestPackets.Calculation(3), TestPackets.Motion(3)));
        byte[] pose = await client.ReadBinaryAsync();
        var received = new BoneTransform[BoneHierarchy.BoneCount];
        Assert.True(CompactPose.TryDecode(pose, out CompactPoseHeader header, received));
        Assert.InRange(pose.Length, 1, 500);
        Assert.Equal((0, "Char00", 3u), (header.AvatarIndex, header.AvatarName.ToString(), header.FrameIndex));
        Assert.Equal(sent[0].Position, received[0].Position);
        for (int bone = 0; bone < sent.Length; bone++)
            Assert.InRange(Degrees(sent[bone].Rotation, received[bone].Rotation), 0, 0.05);
    }

    [Fact]
    public async Task A_line_of_text_becomes_a_whole_packet()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using ClientWebSocket client = await site.ConnectAsync("packet");
        await site.Motion.SendAsync(TestPackets.Line(4));

        await using var reader = new NeuronReader(new MemoryStream(await client.ReadBinaryAsync()));
        var values = new List<float>();
        reader.MotionReceived += frame => values.AddRange(frame.Values);
        reader.Start();
        await reader.Completion.Soon();
        Assert.Equal(Enumerable.Range(0, 354).Select(static index => TestPackets.Value(4, 0, index)), values);
    }

    private static string? Text(JsonElement line, string field) => line.GetProperty(field).GetString();

    private static double Degrees(Quaternion one, Quaternion other)
    {
        Quaternion turn = Quaternion.Normalize(Quaternion.Conjugate(one) * other);
        return 2 * Math.Atan2(new Vector3(turn.X, turn.Y, turn.Z).Length(), Math.Abs(turn.W)) * 180 / Math.PI;
    }
}
