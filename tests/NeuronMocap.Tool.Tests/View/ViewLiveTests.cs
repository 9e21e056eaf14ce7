using System.Net.WebSockets;
using System.Text.Json;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Tests.View;

// What a page gets of a live stream.
public sealed class ViewLiveTests
{
    [Fact]
    public async Task Hello_describes_the_program_the_source_and_the_performers()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        using (ViewSocket control = await view.ConnectAsync("/control"))
            await control.FindAsync("performer");

        JsonElement hello = await view.GetAsync("/api/hello");
        Assert.Equal("neuron-mocap", hello.GetProperty("name").GetString());
        Assert.Equal("live", hello.GetProperty("mode").GetString());
        Assert.Equal("demo", hello.GetProperty("source").GetString());
        Assert.True(hello.GetProperty("canCommand").GetBoolean());
        Assert.NotEmpty(hello.GetProperty("version").GetString()!);
        JsonElement performer = Assert.Single(hello.GetProperty("performers").EnumerateArray());
        Assert.Equal("0-0", performer.GetProperty("key").GetString());
        Assert.Equal("Demo", performer.GetProperty("name").GetString());
        Assert.Equal(0, performer.GetProperty("index").GetInt32());
        Assert.Matches("^#[0-9a-f]{6}$", performer.GetProperty("colour").GetString()!);
    }

    [Fact]
    public async Task A_performer_has_the_bones_of_the_stream_in_metres_parents_first()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        using ViewSocket control = await view.ConnectAsync("/control");
        JsonElement performer = await control.FindAsync("performer");
        JsonElement[] bones = [.. performer.GetProperty("bones").EnumerateArray()];
        Assert.Equal(BoneHierarchy.Bones.ToArray().Select(static bone => BoneHierarchy.GetName(bone)), bones.Select(static bone => bone.GetProperty("name").GetString()!));
        var seen = new HashSet<string>(StringComparer.Ordinal);
        foreach (JsonElement bone in bones)
        {
            string? parent = bone.GetProperty("parent").GetString();
            Assert.True(parent is null ? seen.Count == 0 : seen.Contains(parent));
            seen.Add(bone.GetProperty("name").GetString()!);
        }

        Assert.Equal("Neck1", performer.GetProperty("variant").GetString());
        Assert.InRange(bones[0].GetProperty("offset")[1].GetDouble(), 0.5, 1.5);
    }

    [Fact]
    public async Task Control_greets_with_hello_and_tells_contacts_and_figures()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        using ViewSocket motion = await view.ConnectAsync("/motion", "pose");
        using ViewSocket control = await view.ConnectAsync("/control");
        byte[]? first = await control.ReceiveAsync();
        Assert.Equal("hello", JsonDocument.Parse(first!).RootElement.GetProperty("type").GetString());

        // The demo walks, so both feet leave the ground now and then.
        await control.FindAsync("contact", static contact => contact.GetProperty("left").GetBoolean());
        await control.FindAsync("contact", static contact => !contact.GetProperty("left").GetBoolean());
        JsonElement status = await control.FindAsync("status", static status => HasLatency(status) && IsReceiving(status));
        Assert.Equal("Receiving", status.GetProperty("words").GetString());
        Assert.Empty(status.GetProperty("advice").GetString()!);
        Assert.StartsWith("127.0.0.1:", status.GetProperty("address").GetString(), StringComparison.Ordinal);
        JsonElement figures = status.GetProperty("performers")[0];
        Assert.Equal("0-0", figures.GetProperty("key").GetString());
        Assert.Equal(0, figures.GetProperty("lost").GetInt64());
    }

    [Fact]
    public async Task Ping_is_answered_with_the_time_of_the_server()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        using ViewSocket control = await view.ConnectAsync("/control");
        await control.SendAsync("""{"type":"ping","t":12.5}""");
        JsonElement pong = await control.FindAsync("pong");
        Assert.Equal(12.5, pong.GetProperty("t").GetDouble());
        double now = (DateTime.UtcNow - DateTime.UnixEpoch).TotalMilliseconds;
        Assert.InRange(pong.GetProperty("time").GetDouble(), now - 120_000, now + 1000);

        // A newer page may say more.
        await control.SendAsync("""{"type":"dance"}""");
        await control.SendAsync("""{"type":"ping","t":1}""");
        await control.FindAsync("pong", static answer => answer.GetProperty("t").GetDouble() == 1);
    }

    [Fact]
    public async Task Motion_is_compact_poses_with_the_number_of_the_performer()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        using ViewSocket motion = await view.ConnectAsync("/motion", "pose");
        var local = new BoneTransform[BoneHierarchy.BoneCount];
        for (int i = 0; i < 3; i++)
        {
            byte[]? pose = await motion.ReceiveAsync();
            Assert.InRange(pose!.Length, 1, 500);
            Assert.True(CompactPose.TryDecode(pose, out CompactPoseHeader header, local));
            Assert.Equal(0, header.AvatarIndex);
        }
    }

    [Fact]
    public async Task A_performer_has_a_figure()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        using ViewSocket control = await view.ConnectAsync("/control");
        await control.FindAsync("performer");
        using HttpResponseMessage answer = await view.Client.GetAsync("/api/performers/0-0/figure.glb", TestContext.Current.CancellationToken).Soon();
        Assert.Equal("model/gltf-binary", answer.Content.Headers.ContentType!.MediaType);
        byte[] glb = await answer.Content.ReadAsByteArrayAsync(TestContext.Current.CancellationToken);
        Assert.Equal("glTF"u8, glb.AsSpan(0, 4));
        Assert.Equal(glb.Length, BitConverter.ToInt32(glb, 8));
        foreach (string key in (string[])["0-1", "1-0", "Demo", "0-0-0"])
            Assert.Equal("There is no such performer.", (await view.GetAsync($"/api/performers/{key}/figure.glb")).GetProperty("error").GetString());
    }

    [Theory]
    [InlineData("not JSON", WebSocketCloseStatus.InvalidPayloadData)]
    [InlineData(null, WebSocketCloseStatus.MessageTooBig)]
    public async Task A_socket_that_sends_nonsense_is_closed_and_others_stay(string? text, WebSocketCloseStatus expected)
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        using ViewSocket other = await view.ConnectAsync("/control");
        using ViewSocket control = await view.ConnectAsync("/control");
        await control.SendAsync(text ?? new string('x', 5000));
        while (await control.ReceiveAsync() is not null)
        {
        }

        Assert.Equal(expected, control.CloseStatus);
        await other.FindAsync("status");
        await other.FindAsync("status");
    }

    [Fact]
    public async Task Two_pages_get_the_same_and_one_that_leaves_does_not_disturb_the_other()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        using ViewSocket one = await view.ConnectAsync("/control");
        using ViewSocket other = await view.ConnectAsync("/control");
        using ViewSocket motion = await view.ConnectAsync("/motion", "pose");
        using ViewSocket otherMotion = await view.ConnectAsync("/motion", "pose");
        JsonElement first = await one.FindAsync("performer");
        JsonElement second = await other.FindAsync("performer");
        Assert.Equal(first.GetProperty("key").GetString(), second.GetProperty("key").GetString());
        await one.CloseAsync();
        await motion.CloseAsync();
        await other.FindAsync("status");
        await other.FindAsync("status");
        Assert.NotNull(await otherMotion.ReceiveAsync());
    }

    [Fact]
    public async Task Ctrl_C_closes_the_sockets_in_order()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        using ViewSocket control = await view.ConnectAsync("/control");
        using ViewSocket motion = await view.ConnectAsync("/motion", "pose");
        await control.FindAsync("performer");
        Task<int> stopping = view.StopAsync();
        while (await control.ReceiveAsync() is not null)
        {
        }

        while (await motion.ReceiveAsync() is not null)
        {
        }

        Assert.Equal(WebSocketCloseStatus.EndpointUnavailable, control.CloseStatus);
        Assert.Equal(WebSocketCloseStatus.EndpointUnavailable, motion.CloseStatus);
        await control.CloseAsync();
        await motion.CloseAsync();
        Assert.Equal(0, await stopping);
    }

    // On a busy computer, the stream can rest for more than a second. Then its rate is 0, and later it is silent.
    private static bool IsReceiving(JsonElement status) => status.GetProperty("state").ValueEquals("receiving")
        && status.GetProperty("bytesPerSecond").GetDouble() > 0 && status.GetProperty("performers")[0].GetProperty("fps").GetDouble() > 0;

    private static bool HasLatency(JsonElement status) =>
        status.GetProperty("performers").EnumerateArray().Any(static performer => performer.GetProperty("latency").ValueKind == JsonValueKind.Number);
}
