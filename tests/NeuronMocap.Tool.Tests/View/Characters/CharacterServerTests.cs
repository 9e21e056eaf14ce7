using System.Buffers.Binary;
using System.Diagnostics;
using System.Net.WebSockets;
using System.Numerics;
using System.Text.Json;
using System.Text.Json.Nodes;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.View.Characters;

namespace NeuronMocap.Tool.Tests.View.Characters;

// Requests of a page to a server that receives a stream.
public sealed class CharacterServerTests
{
    [Fact]
    public async Task A_character_says_which_nodes_move()
    {
        using var demo = Broadcaster.StartDemo();
        await using CharacterServer server = await CharacterServer.StartAsync(demo.LocalEndPoint!);
        CharacterNode[] nodes = SampleCharacters.OfRig("mixamo");
        (int status, JsonElement body) = await server.SendAsync(HttpMethod.Post, "api/characters", CharacterServer.Request(nodes));
        Assert.Equal(200, status);
        Assert.Empty(body.GetProperty("problems").EnumerateArray());
        JsonElement[] bones = [.. body.GetProperty("bones").EnumerateArray()];
        Assert.Equal("Hips", bones[0].GetProperty("bone").GetString());
        Assert.Equal("hips", bones[0].GetProperty("humanoid").GetString());
        Assert.Equal(body.GetProperty("hipsNode").GetInt32(), bones[0].GetProperty("node").GetInt32());
        Assert.All(bones, bone => Assert.StartsWith("mixamorig:", nodes[bone.GetProperty("node").GetInt32()].Name, StringComparison.Ordinal));
    }

    // A page stays open while the program starts again, and other pages bring their characters first.
    [Fact]
    public async Task A_character_of_an_earlier_run_is_not_found_under_the_number_of_another()
    {
        using var demo = Broadcaster.StartDemo();
        uint old;
        await using (CharacterServer first = await CharacterServer.StartAsync(demo.LocalEndPoint!))
            old = await first.AddAsync(SampleCharacters.OfRig("mixamo"));
        await using CharacterServer second = await CharacterServer.StartAsync(demo.LocalEndPoint!);
        await second.AddAsync(SampleCharacters.OfRig("mixamo"));
        (int status, _) = await second.SendAsync(HttpMethod.Put, $"api/characters/{old}", new JsonObject { ["performer"] = "0-0" });
        Assert.Equal(404, status);
    }

    [Fact]
    public async Task Poses_arrive_while_a_page_listens_and_cost_nothing_otherwise()
    {
        using var demo = Broadcaster.StartDemo();
        await using CharacterServer server = await CharacterServer.StartAsync(demo.LocalEndPoint!);
        CharacterNode[] nodes = SampleCharacters.OfBody(SkeletonBody.GetDefault());
        uint id = await server.AddAsync(nodes);
        CharacterMotion motion = server.Library.Find($"{id}");
        Assert.Equal((0, 0), (motion.Posed, server.FramesTaken));

        using (ClientWebSocket one = await server.ListenAsync(id))
        using (ClientWebSocket two = await server.ListenAsync(id))
        {
            foreach (ClientWebSocket socket in (ClientWebSocket[])[one, two])
            {
                long time = 0;
                for (int i = 0; i < 5; i++)
                {
                    byte[] bytes = await CharacterServer.ReceiveAsync(socket);
                    Assert.InRange(bytes.Length, 1, 500);
                    var pose = new DecodedPose(nodes, motion.Character.State.Rig, bytes);
                    Assert.Equal(id, pose.Character);
                    Assert.InRange(pose.Microseconds, time, (DateTime.UtcNow - DateTime.UnixEpoch).Ticks / TimeSpan.TicksPerMicrosecond);
                    time = pose.Microseconds;
                    Matrix4x4[] world = pose.World();
                    Assert.InRange(world[(int)Bone.Hips].Translation.Y, 0.5f, 1.5f);
                    Assert.InRange(world[(int)Bone.Head].Translation.Y, 1, 2);
                }
            }

            await one.CloseAsync(WebSocketCloseStatus.NormalClosure, null, TestContext.Current.CancellationToken);
            await two.CloseAsync(WebSocketCloseStatus.NormalClosure, null, TestContext.Current.CancellationToken);
        }

        await CharacterServer.UntilAsync(() => motion.Listeners == 0, "both pages are gone");
        using ClientWebSocket other = await server.ListenAsync(await server.AddAsync(nodes, "0-1"));

        // A frame on its way may still be posed, but then no more.
        long before, after = -1;
        var patience = Stopwatch.StartNew();
        do
        {
            Assert.True(patience.Elapsed < Limits.Unexpected, "The server makes poses that no page wants.");
            before = after;
            long taken = server.FramesTaken;
            await CharacterServer.UntilAsync(() => server.FramesTaken > taken + 5, "another character takes frames");
            after = motion.Posed;
        }
        while (after != before);
    }

    [Fact]
    public async Task A_character_follows_another_performer_from_now_on()
    {
        using var demo = Broadcaster.StartDemo(avatars: 2);
        await using CharacterServer server = await CharacterServer.StartAsync(demo.LocalEndPoint!);
        CharacterNode[] nodes = SampleCharacters.OfBody(SkeletonBody.GetDefault());
        uint id = await server.AddAsync(nodes, "0-9");
        CharacterMotion motion = server.Library.Find($"{id}");
        using ClientWebSocket socket = await server.ListenAsync(id);
        await CharacterServer.UntilAsync(() => server.FramesTaken > 10, "frames of others arrive");
        Assert.Equal(0, motion.Posed);

        var change = new JsonObject { ["performer"] = "0-1", ["plant"] = false };
        (int status, JsonElement body) = await server.SendAsync(HttpMethod.Put, $"api/characters/{id}", change);
        Assert.Equal((200, 59), (status, body.GetProperty("bones").GetArrayLength()));
        Assert.False(motion.Character.State.PlantsFeet);
        Assert.NotEmpty(await CharacterServer.ReceiveAsync(socket));
    }

    [Fact]
    public async Task A_performer_of_the_older_naming_moves_the_bones_of_that_naming()
    {
        using var demo = Broadcaster.StartDemo();
        await using CharacterServer server = await CharacterServer.StartAsync(demo.LocalEndPoint!);
        CharacterNode[] nodes = SampleCharacters.OfBody(SkeletonBody.GetDefault(SkeletonVariant.Spine3));
        uint id = await server.AddAsync(nodes);
        (_, JsonElement body) = await server.SendAsync(HttpMethod.Put, $"api/characters/{id}", new JsonObject { ["variant"] = "Spine3" });
        Assert.Contains(body.GetProperty("bones").EnumerateArray(), static bone => bone.GetProperty("bone").GetString() == "Spine3");
        (int status, _) = await server.SendAsync(HttpMethod.Put, $"api/characters/{id}", new JsonObject { ["variant"] = "Spine9" });
        Assert.Equal(400, status);
    }

    [Fact]
    public async Task A_removed_character_is_gone_for_all_pages()
    {
        using var demo = Broadcaster.StartDemo();
        await using CharacterServer server = await CharacterServer.StartAsync(demo.LocalEndPoint!);
        uint id = await server.AddAsync(SampleCharacters.OfRig("vroid"));
        using ClientWebSocket socket = await server.ListenAsync(id);
        Assert.NotEmpty(await CharacterServer.ReceiveAsync(socket));
        Assert.Equal(204, (await server.SendAsync(HttpMethod.Delete, $"api/characters/{id}")).Status);
        while ((await CharacterServer.ReceiveAsync(socket)).Length > 0)
        {
        }

        Assert.Equal(WebSocketCloseStatus.NormalClosure, socket.CloseStatus);
        foreach (HttpMethod method in (HttpMethod[])[HttpMethod.Delete, HttpMethod.Put])
        {
            (int status, JsonElement body) = await server.SendAsync(method, $"api/characters/{id}", new JsonObject());
            Assert.Equal(404, status);
            Assert.Contains("Drop it on the page again", body.GetProperty("error").GetString()!, StringComparison.Ordinal);
        }

        await Assert.ThrowsAsync<WebSocketException>(() => server.ListenAsync(id));
    }

    [Fact]
    public async Task A_further_character_replaces_one_that_no_page_shows()
    {
        using var demo = Broadcaster.StartDemo();
        await using CharacterServer server = await CharacterServer.StartAsync(demo.LocalEndPoint!);
        CharacterNode[] nodes = SampleCharacters.OfRig("xsens-bvh");
        uint shown = await server.AddAsync(nodes);
        using ClientWebSocket socket = await server.ListenAsync(shown);
        uint forgotten = await server.AddAsync(nodes);
        for (int i = 0; i < CharacterLibrary.MostCharacters - 1; i++)
            await server.AddAsync(nodes);

        Assert.Equal(200, (await server.SendAsync(HttpMethod.Put, $"api/characters/{shown}", new JsonObject())).Status);
        Assert.Equal(404, (await server.SendAsync(HttpMethod.Put, $"api/characters/{forgotten}", new JsonObject())).Status);
    }

    [Theory]
    [InlineData("{}", "no nodes")]
    [InlineData("{\"nodes\":[]}", "nodes")]
    [InlineData("{\"nodes\":[null]}", "The character cannot follow a performer: none of its nodes has the name of a bone")]
    [InlineData("{\"nodes\":[{\"name\":\"Hips\",\"translation\":[1,2]}]}", "three numbers")]
    [InlineData("{\"nodes\":[{\"name\":\"Hips\",\"rotation\":[0,0,1]}]}", "four numbers")]
    [InlineData("{\"nodes\":[{\"name\":\"Hips\",\"parent\":5}]}", "before its parent")]
    [InlineData("{\"nodes\":[{\"name\":\"Hips\"}],\"humanoid\":{\"hips\":-1}}", "does not exist")]
    [InlineData("{\"nodes\":[{\"name\":\"Hips\"}],\"variant\":\"x\"}", "variant")]
    [InlineData("{\"name\":\"cube.glb\",\"nodes\":[{\"name\":\"Hips\"}]}", "cube.glb cannot follow a performer: it lacks these bones: left upper leg, right")]
    [InlineData("{\"nodes\":7}", "JSON")]
    public async Task A_wrong_request_gets_a_sentence(string json, string words)
    {
        using var demo = Broadcaster.StartDemo();
        await using CharacterServer server = await CharacterServer.StartAsync(demo.LocalEndPoint!);
        (int status, JsonElement body) = await server.SendAsync(HttpMethod.Post, "api/characters", JsonNode.Parse(json));
        Assert.Equal(400, status);
        string error = body.GetProperty("error").GetString()!;
        Assert.Contains(words, error, StringComparison.Ordinal);
        Assert.EndsWith(".", error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_request_of_many_megabytes_is_refused()
    {
        using var demo = Broadcaster.StartDemo();
        await using CharacterServer server = await CharacterServer.StartAsync(demo.LocalEndPoint!);
        (int status, _) = await server.SendAsync(HttpMethod.Post, "api/characters", new JsonObject { ["name"] = new string('x', 5 * 1024 * 1024) });
        Assert.Equal(413, status);
    }

    [Fact]
    public void A_pose_has_the_documented_bytes()
    {
        SkeletonBody body = SkeletonBody.GetDefault();
        var rig = CharacterRig.Create(SampleCharacters.OfBody(body));
        var poser = new CharacterPoser(rig, body) { PlantsFeet = false };
        Assert.True(poser.TryTake(SampleCharacters.Pose(body), default, 0));
        byte[] bytes = new byte[CharacterPose.MaxSize];
        Assert.Equal(28 + (59 * 6), CharacterPose.Encode(rig, poser.Pose, 0x01020304, -5, bytes));
        Assert.Equal([1, 2, 59, 0, 4, 3, 2, 1], bytes[..8]);
        Assert.Equal(-5, BinaryPrimitives.ReadInt64LittleEndian(bytes.AsSpan(8)));
        Assert.Equal(1.2f, BinaryPrimitives.ReadSingleLittleEndian(bytes.AsSpan(16)), 1e-4f);
    }
}
