using System.Text.Json;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Tests.View.Takes;

/// <summary>A packed recording that is much smaller than the poses in it.</summary>
public sealed class TakeRoomTests
{
    private const int Frames = 12_000;

    [Fact]
    public async Task The_poses_of_an_upload_have_room_for_four_times_the_largest_one()
    {
        await using TakeClient client = await TakeClient.StartAsync(megabytes: 1);
        RecordPacked(client.Folder["packed.nmrec"]);
        Assert.InRange(new FileInfo(client.Folder["packed.nmrec"]).Length, 1, 1_000_000);

        JsonElement upload = await client.UploadAsync(client.Folder["packed.nmrec"]);
        JsonElement own = await client.OpenAsync(client.Folder["packed.nmrec"]);

        Assert.Equal("The temporary folder of the program has no room for the rest of the take.", Assert.Single(upload.GetProperty("problems").EnumerateArray()).GetString());
        long frames = upload.GetProperty("performers")[0].GetProperty("frames").GetInt64();
        Assert.InRange(frames, 1, Frames - 1);
        Assert.Single(await client.GetPosesAsync("t1", "t1-0", frames - 1, 9));
        Assert.Empty(own.GetProperty("problems").EnumerateArray());
        Assert.Equal(Frames, own.GetProperty("performers")[0].GetProperty("frames").GetInt64());
    }

    private static void RecordPacked(string path)
    {
        var layout = new ChannelLayout(hasDisplacement: true, hasReference: false);
        float[] values = new float[layout.ValueCount];
        using RecordingWriter writer = RecordingWriter.Create(path, options: new RecordingWriterOptions { Compress = true });
        writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "127.0.0.1:50000", "127.0.0.1:7001"));
        for (int frame = 0; frame < Frames; frame++)
        {
            var header = new MotionHeader { AvatarName = new AvatarName("Actor"), FrameIndex = (uint)frame, HasDisplacement = true, ValueCount = values.Length };
            byte[] packet = new byte[header.PacketSize];
            PacketEncoder.WriteMotion(packet, header, values);
            writer.WriteBytes(TimeSpan.FromSeconds(frame / 60.0), 0, packet);
        }
    }
}
