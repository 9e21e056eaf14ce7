using System.Buffers.Binary;
using System.Numerics;
using System.Text.Json;
using System.Text.Json.Nodes;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Tests.View.Takes;
using NeuronMocap.Tool.View.Characters;

namespace NeuronMocap.Tool.Tests.View.Characters;

// Poses of characters for frames of a take.
public sealed class CharacterTakeTests : IDisposable
{
    private const int Frames = 400;

    private readonly OpenTakes _files = new();

    public void Dispose() => _files.Dispose();

    [Fact]
    public async Task The_performers_own_skeleton_moves_as_in_the_take()
    {
        await using CharacterServer server = await StartAsync();
        (string take, string performer) = await OpenAsync(server);
        SkeletonBody body = (await server.Takes.FindPerformerAsync(performer, TestContext.Current.CancellationToken))!.Body;
        CharacterNode[] nodes = SampleCharacters.OfBody(body);
        uint id = await server.AddAsync(nodes);
        await server.SendAsync(HttpMethod.Put, $"api/characters/{id}", new JsonObject { ["plant"] = false });
        CharacterRig rig = server.Library.Find($"{id}").Character.State.Rig;

        byte[][] poses = Split(await server.GetBytesAsync(Address(take, id, performer, 100, 20)));
        Assert.Equal(20, poses.Length);
        var expected = new BoneTransform[BoneHierarchy.BoneCount];
        for (int i = 0; i < poses.Length; i++)
        {
            var pose = new DecodedPose(nodes, rig, poses[i]);
            Assert.Equal((100 + i) * 1_000_000L / 60, pose.Microseconds, 20.0);
            OpenTakes.GetPose(0, 100 + i, expected);
            ForwardKinematics.ToWorld(expected, expected, body.Variant);
            Matrix4x4[] world = pose.World();
            foreach (Bone bone in BoneHierarchy.Bones)
                SampleCharacters.AssertNear(expected[(int)bone].Position / 100, world[(int)bone].Translation, 0.002f, $"{bone}");
        }
    }

    [Fact]
    public async Task Planted_feet_do_not_depend_on_where_a_part_begins()
    {
        await using CharacterServer server = await StartAsync();
        (string take, string performer) = await OpenAsync(server);
        CharacterNode[] nodes = SampleCharacters.OfRig("mixamo");
        uint id = await server.AddAsync(nodes);
        CharacterRig rig = server.Library.Find($"{id}").Character.State.Rig;
        byte[][] whole = Split(await server.GetBytesAsync(Address(take, id, performer, 0, Frames)));
        byte[][] part = Split(await server.GetBytesAsync(Address(take, id, performer, 320, 200)));
        Assert.Equal((Frames, Frames - 320), (whole.Length, part.Length));
        for (int i = 0; i < part.Length; i++)
        {
            Matrix4x4[] expected = new DecodedPose(nodes, rig, whole[320 + i]).World();
            Matrix4x4[] actual = new DecodedPose(nodes, rig, part[i]).World();
            for (int node = 0; node < nodes.Length; node++)
                SampleCharacters.AssertNear(expected[node].Translation, actual[node].Translation, 0.005f, nodes[node].Name);
        }
    }

    [Fact]
    public async Task Parts_outside_the_take_are_empty_and_unknown_performers_a_sentence()
    {
        await using CharacterServer server = await StartAsync();
        (string take, string performer) = await OpenAsync(server);
        uint id = await server.AddAsync(SampleCharacters.OfRig("mixamo"));
        Assert.Empty(await server.GetBytesAsync(Address(take, id, performer, Frames, 10)));
        (int status, JsonElement body) = await server.SendAsync(HttpMethod.Get, Address(take, id, "nobody", 0, 1));
        Assert.Equal((404, "No open take has this performer."), (status, body.GetProperty("error").GetString()));
        Assert.Equal(404, (await server.SendAsync(HttpMethod.Get, Address(take, id + 1, performer, 0, 1))).Status);
        Assert.Equal(400, (await server.SendAsync(HttpMethod.Get, Address(take, id, performer, -1, 1))).Status);
        Assert.Equal(400, (await server.SendAsync(HttpMethod.Get, Address(take, id, performer, 0, CharacterTake.MostFrames + 1))).Status);
    }

    private static string Address(string take, uint character, string performer, int from, int count) =>
        $"api/takes/{take}/characters/{character}/poses?performer={Uri.EscapeDataString(performer)}&from={from}&count={count}";

    private static byte[][] Split(byte[] answer)
    {
        List<byte[]> poses = [];
        for (int at = 0; at < answer.Length;)
        {
            int size = (int)BinaryPrimitives.ReadUInt32LittleEndian(answer.AsSpan(at));
            poses.Add(answer[(at + sizeof(uint))..(at + sizeof(uint) + size)]);
            at += sizeof(uint) + size;
        }

        return [.. poses];
    }

    // The stream does not matter. The broadcaster only needs to exist.
    private static async Task<CharacterServer> StartAsync()
    {
        using var demo = Broadcaster.StartDemo();
        return await CharacterServer.StartAsync(demo.LocalEndPoint!);
    }

    private async Task<(string Take, string Performer)> OpenAsync(CharacterServer server)
    {
        string path = _files.Record(Enumerable.Range(0, Frames).Select(static frame => (frame * 1000 / 60.0, 0, frame)));
        string take = await server.Takes.OpenAsync(path, order: null, TestContext.Current.CancellationToken);
        while (true)
        {
            (_, JsonElement info) = await server.SendAsync(HttpMethod.Get, $"api/takes/{take}");
            if (info.GetProperty("progress").GetDouble() == 1 && info.GetProperty("performers")[0].GetProperty("frames").GetInt32() == Frames)
                return (take, info.GetProperty("performers")[0].GetProperty("key").GetString()!);

            await Task.Delay(5, TestContext.Current.CancellationToken);
        }
    }
}
