using System.Text.Json;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Info;

public sealed class RecordingInfoTests : InfoPages
{
    [Fact]
    public async Task A_recording_is_described_with_avatars_gaps_and_skipped_bytes()
    {
        using (RecordingWriter writer = RecordingWriter.Create(Folder["two.nmrec"], RecordingMetadata.Empty.With(RecordingMetadata.ServerKey, "studio:7001")))
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "10.0.0.2:50000", "10.0.0.1:7001"));
            writer.WriteBytes(TimeSpan.Zero, 0, "hello"u8);
            for (uint frame = 0; frame < 100; frame++)
            {
                // Three frames of avatar 0 are lost.
                if (frame is < 50 or > 52)
                    writer.WriteBytes(TimeSpan.FromSeconds(frame / 60.0), 0, Packet(0, "Anna", frame));

                writer.WriteBytes(TimeSpan.FromSeconds(frame / 60.0), 0, Packet(1, "Ben", frame));
            }

            writer.CloseConnection(TimeSpan.FromSeconds(2), 0, "the server has gone");
        }

        string[] page = await PageAsync("two.nmrec");
        Assert.Equal("studio:7001", Fact(page, "server"));
        Assert.Contains(page, static line => line.EndsWith("connection 0: TCP from 10.0.0.1:7001 to 10.0.0.2:50000", StringComparison.Ordinal));
        Assert.Contains(page, static line => line.EndsWith("connection 0: closed: the server has gone", StringComparison.Ordinal));
        Assert.Equal("5 bytes that are not packets", Fact(page, "skipped"));
        Assert.Contains(page, static line => line.StartsWith("  0 Anna: 97 motion frames, ", StringComparison.Ordinal) && line.EndsWith("3 lost in 1 gap", StringComparison.Ordinal));
        Assert.Contains("Take of avatar 0, Anna", page);
        Assert.Equal("100: 97 received and 3 interpolated", Fact(page, "frames", after: "Take of avatar 0, Anna"));
        Assert.Contains(page, static line => line.StartsWith("  3 frames are missing before 0.883 s: interpolated", StringComparison.Ordinal));

        string[] other = await PageAsync("two.nmrec", "--avatar", "1");
        Assert.Contains("Take of avatar 1, Ben", other);
        JsonElement json = await JsonAsync("two.nmrec");
        Assert.Equal(5, json.GetProperty("stream").GetProperty("skippedBytes").GetProperty("noTokens").GetInt64());
        Assert.Equal(2, json.GetProperty("avatars").GetArrayLength());
        Assert.Equal(0, json.GetProperty("avatars")[0].GetProperty("outOfOrder").GetInt64());
        Assert.Equal(60, json.GetProperty("take").GetProperty("frameRate").GetDouble());
    }

    [Fact]
    public async Task A_rotation_order_that_the_file_does_not_state_is_called_assumed()
    {
        await File.WriteAllBytesAsync(Folder["raw.bin"], Packet(0, "Anna", 1), TestContext.Current.CancellationToken);
        foreach ((string name, RecordingMetadata metadata) in ((string, RecordingMetadata)[])[("plain.nmrec", RecordingMetadata.Empty), ("zxy.nmrec", RecordingMetadata.Empty.With(RecordingMetadata.RotationOrderKey, "ZXY"))])
        {
            using RecordingWriter writer = RecordingWriter.Create(Folder[name], metadata);
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, string.Empty, string.Empty));
            writer.WriteBytes(TimeSpan.Zero, 0, Packet(0, "Anna", 1));
        }

        const string Assumed = "YXZ, assumed; --order sets another one";
        Assert.Equal(Assumed, Fact(await PageAsync("raw.bin"), "rotation order"));
        Assert.Equal(Assumed, Fact(await PageAsync("plain.nmrec"), "rotation order"));
        Assert.Equal("XYZ", Fact(await PageAsync("plain.nmrec", "--order", "xyz"), "rotation order"));
        Assert.Equal("ZXY", Fact(await PageAsync("zxy.nmrec"), "rotation order"));
        Assert.Equal("YXZ", (await JsonAsync("plain.nmrec")).GetProperty("take").GetProperty("rotationOrder").GetString());
    }

    // Packets of Axis Studio contain it: 0 is XZY. The other avatars of a stream do not matter.
    [Fact]
    public async Task The_rotation_order_in_packets_is_known()
    {
        MotionFrame upright = Poses.Upright(1);
        byte[] studio = new byte[upright.Header.PacketSize];
        PacketEncoder.WriteMotion(studio, upright.Header with { Version = DataVersion.Studio, AvatarIndex = 1, AvatarName = new AvatarName("Ben") }, upright.Values);
        await File.WriteAllBytesAsync(Folder["mix.bin"], [.. Packet(0, "Anna", 1), .. studio], TestContext.Current.CancellationToken);

        Assert.Equal("YXZ, assumed; --order sets another one", Fact(await PageAsync("mix.bin"), "rotation order"));
        Assert.Equal("XZY", Fact(await PageAsync("mix.bin", "--avatar", "1"), "rotation order"));
    }

    [Fact]
    public async Task A_recording_of_many_connections_lists_the_first_of_them()
    {
        using (RecordingWriter writer = RecordingWriter.Create(Folder["take.nmrec"]))
        {
            for (int i = 0; i < 5000; i++)
            {
                writer.OpenConnection(TimeSpan.FromMilliseconds(i), new RecordedConnection(i, TransportKind.Tcp, "", $"studio:{i}"));
                writer.CloseConnection(TimeSpan.FromMilliseconds(i), i, "Reset");
            }
        }

        JsonElement json = await JsonAsync("take.nmrec");
        JsonElement[] connections = [.. json.GetProperty("connections").EnumerateArray()];
        Assert.Equal(1001, connections.Length);
        Assert.Equal("more", connections[^1].GetProperty("code").GetString());
        Assert.Contains("9,000 more", connections[^1].GetProperty("text").GetString(), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Missing_blocks_are_not_mistaken_for_a_cut()
    {
        using (RecordingWriter writer = RecordingWriter.Create(Folder["take.nmrec"]))
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "", ""));
            for (int i = 0; i < 3; i++)
            {
                writer.WriteBytes(TimeSpan.FromMilliseconds(i), 0, FrameServer.Motion((uint)i, new float[354]));
                writer.Flush();
            }
        }

        // The second of the three.
        byte[] file = await File.ReadAllBytesAsync(Folder["take.nmrec"], TestContext.Current.CancellationToken);
        byte[] marker = [0xF7, (byte)'N', (byte)'M', (byte)'B'];
        int first = file.AsSpan(70).IndexOf(marker) + 70;
        int second = file.AsSpan(first + 1).IndexOf(marker) + first + 1;
        int third = file.AsSpan(second + 1).IndexOf(marker) + second + 1;
        await File.WriteAllBytesAsync(Folder["take.nmrec"], [.. file[..second], .. file[third..]], TestContext.Current.CancellationToken);
        JsonElement json = await JsonAsync("take.nmrec");
        Assert.True(json.GetProperty("recording").GetProperty("complete").GetBoolean());
        Assert.Equal("Block 2 is missing before this one.", Assert.Single(json.GetProperty("damage").EnumerateArray()).GetProperty("text").GetString());
    }

    [Fact]
    public async Task A_cut_recording_is_reported()
    {
        Takes.Actor(600).Save(Folder["take.bvh"]);
        await ToolRunner.RunAsync("convert", Folder["take.bvh"], Folder["take.nmrec"]);
        byte[] whole = await File.ReadAllBytesAsync(Folder["take.nmrec"], TestContext.Current.CancellationToken);
        await File.WriteAllBytesAsync(Folder["cut.nmrec"], whole[..(whole.Length / 2)], TestContext.Current.CancellationToken);
        JsonElement json = await JsonAsync("cut.nmrec");

        Assert.False(json.GetProperty("recording").GetProperty("complete").GetBoolean());
        Assert.Equal(1, json.GetProperty("damage").GetArrayLength());
        Assert.InRange(json.GetProperty("take").GetProperty("frames").GetInt32(), 200, 300);
    }
}
