using System.Globalization;
using System.Text.Json;
using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Gltf;
using NeuronMocap.Tool.Tests.Files;

namespace NeuronMocap.Tool.Tests.View.Takes;

/// <summary>Downloads of performers who have the same avatar number on different computers.</summary>
public sealed class TakeSenderTests
{
    [Theory]
    [InlineData("t1-0", "Anna", 0f)]
    [InlineData("t1-1", "Ben", TwoSenders.SecondX)]
    public async Task A_download_holds_only_the_chosen_performer(string performer, string name, float x)
    {
        await using TakeClient client = await TakeClient.StartAsync();
        TwoSenders.Record(client.Folder["take.nmrec"]);
        JsonElement info = await client.UploadAsync(client.Folder["take.nmrec"]);
        Assert.Equal(2, info.GetProperty("performers").GetArrayLength());

        using HttpResponseMessage motion = await client.GetFileAsync($"takes/t1/download?format=bvh&performer={performer}");
        using HttpResponseMessage figure = await client.GetFileAsync($"takes/t1/download?format=glb&performer={performer}");
        using HttpResponseMessage table = await client.GetFileAsync($"takes/t1/download?format=csv&performer={performer}");

        var take = new BvhSource(BvhDocument.Parse(await motion.Content.ReadAsByteArrayAsync()));
        Assert.Equal(TwoSenders.Frames, take.FrameCount);
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < TwoSenders.Frames; frame++)
        {
            take.GetPose(frame, pose);
            Assert.Equal(x, pose[0].Position.X);
        }

        Assert.Equal([name], GlbFile.Parse(await figure.Content.ReadAsByteArrayAsync()).Names("animations"));
        string[] rows = [.. (await table.Content.ReadAsStringAsync()).Split('\n').Where(static line => line.Length > 0 && char.IsAsciiDigit(line[0]))];
        Assert.Equal(TwoSenders.Frames, rows.Length);
        Assert.All(rows, row => Assert.Equal(x / 100, float.Parse(row.Split(',')[4], CultureInfo.InvariantCulture)));
    }
}
