using System.Numerics;
using System.Text.Json;
using System.Text.Json.Nodes;
using NeuronMocap.Bvh;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.Tool.Info;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Info;

public sealed class InfoTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Fact]
    public async Task Several_files_are_told_one_after_the_other_whatever_is_wrong_with_one()
    {
        Takes.Actor(2).Save(_folder["a.bvh"]);
        Takes.Actor(3).Save(_folder["b.bvh"]);
        ToolResult page = await ToolRunner.RunAsync("info", _folder["a.bvh"], _folder["none.bvh"], _folder["b.bvh"]);
        Assert.Equal(1, page.ExitCode);
        Assert.Equal(["a.bvh", "b.bvh"], page.Output.Where(static line => line is "a.bvh" or "b.bvh"));
        Assert.Contains("none.bvh", Assert.Single(page.Error), StringComparison.Ordinal);

        ToolResult json = await ToolRunner.RunAsync("info", _folder["b.bvh"], _folder["a.bvh"], "--json");
        Assert.Equal(0, json.ExitCode);
        Assert.Equal(["b.bvh", "a.bvh"], json.Output.Select(static line => JsonDocument.Parse(line).RootElement.GetProperty("file").GetString()));
    }

    [Fact]
    public async Task A_page_for_a_person_is_plain_when_it_is_redirected()
    {
        Takes.StraightWalk(frames: 601).Save(_folder["walk.bvh"]);
        string[] page = await PageAsync("walk.bvh");

        Assert.Equal("walk.bvh", page[0]);
        Assert.StartsWith("BVH file of Neuron's 59 bones, ", page[1], StringComparison.Ordinal);
        Assert.All(page, static line => Assert.DoesNotContain('\e', line));
        Assert.Equal("10.017 s", Fact(page, "duration"));
        Assert.Equal("601", Fact(page, "frames"));
        Assert.StartsWith("60 Hz: the file says 0.016667 s, which is 1/60 s rounded", Fact(page, "frame rate"), StringComparison.Ordinal);
        Assert.Equal("YXZ", Fact(page, "rotation order"));
        Assert.Equal("25.0 cm", Fact(page, "upper arm").Trim());
        Assert.Equal("0.00 by 10.00 m: X 0.00 to 0.00, Z 0.00 to 10.00", Fact(page, "extent"));
        Assert.StartsWith("9.90 m", Fact(page, "distance walked"), StringComparison.Ordinal);
    }

    // A serial line or a bare pseudo-terminal says 0.
    [Theory]
    [InlineData(0)]
    [InlineData(7)]
    public async Task A_terminal_that_does_not_tell_its_size_is_written_to_as_a_narrow_one(int columns)
    {
        Takes.StraightWalk(frames: 61).Save(_folder["walk.bvh"]);
        ToolResult result = await ToolRunner.RunOnTerminalAsync(columns, "info", _folder["walk.bvh"]);

        Assert.Equal(0, result.ExitCode);
        Assert.Contains("walk.bvh", result.Output[0], StringComparison.Ordinal);
        Assert.Contains(result.Output, static line => line.Contains("duration", StringComparison.Ordinal));
    }

    [Fact]
    public async Task Programs_get_one_object()
    {
        Takes.StraightWalk(frames: 601).Save(_folder["walk.bvh"]);
        JsonElement info = await JsonAsync("walk.bvh");

        Assert.Equal("bvh", info.GetProperty("kind").GetString());
        Assert.Equal(601, info.GetProperty("take").GetProperty("frames").GetInt32());
        Assert.Equal(60, info.GetProperty("take").GetProperty("frameRate").GetDouble());
        Assert.Equal(59, info.GetProperty("skeleton").GetProperty("joints").GetInt32());
        Assert.Equal(0.25, info.GetProperty("boneSizes").GetProperty("upperArm").GetDouble(), 1e-6);
        Assert.Equal(10, info.GetProperty("walk").GetProperty("extent").GetProperty("highestZ").GetDouble(), 1e-4);
        Assert.Equal(1, info.GetProperty("walk").GetProperty("highestSpeed").GetDouble(), 1e-3);
    }

    [Fact]
    public async Task Programs_get_the_names_of_all_joints()
    {
        string[] names = [.. Enumerable.Range(0, 40).Select(static number => $"joint{number}")];
        string tree = string.Concat(names.Select(static (name, number) => $"{(number == 0 ? "ROOT" : "JOINT")} {name}\n{{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Yrotation Xrotation\n"));
        string row = string.Join(' ', Enumerable.Repeat("0", 3 * names.Length));
        _folder.Write("chain.bvh", $"HIERARCHY\n{tree}End Site\n{{\nOFFSET 0 1 0\n}}\n{new string('}', names.Length).Replace("}", "}\n", StringComparison.Ordinal)}MOTION\nFrames: 1\nFrame Time: 0.01\n{row}\n");
        JsonElement skeleton = (await JsonAsync("chain.bvh")).GetProperty("skeleton");
        Assert.Equal(names, skeleton.GetProperty("jointNames").EnumerateArray().Select(static name => name.GetString()));
        Assert.Contains(await PageAsync("chain.bvh"), static line => line.Contains("joint0, joint1", StringComparison.Ordinal) && line.Contains('…', StringComparison.Ordinal));
    }

    [Fact]
    public async Task The_real_take()
    {
        File.Copy(Fixtures.Require("test-take", "test.bvh"), _folder["test.bvh"]);
        string[] page = await PageAsync("test.bvh");

        Assert.StartsWith("120 Hz: the file says 0.008 s, which is 1/120 s rounded (125 Hz at its word)", Fact(page, "frame rate"), StringComparison.Ordinal);
        Assert.StartsWith("Spine3", Fact(page, "bone names"), StringComparison.Ordinal);
        Assert.Contains("  154 of the 180 values never change", page);
        Assert.StartsWith("0.000 m", Fact(page, "ground"), StringComparison.Ordinal);
    }

    [Fact]
    public async Task What_is_odd_is_found()
    {
        // A T first, then arms down; the head's angles jump by half a turn while it stays as it is; one value is no number.
        BvhDocument take = Takes.Neuron(
            40,
            static (frame, pose) =>
            {
                if (frame > 0)
                    pose[(int)Bone.LeftArm] = pose[(int)Bone.LeftArm] with { Rotation = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, -1.2f) };

                pose[(int)Bone.LeftHand] = pose[(int)Bone.LeftHand] with { Position = pose[(int)Bone.LeftHand].Position + new Vector3(frame * 0.02f, 0, 0) };
            },
            displacement: true);
        var layout = new ChannelLayout(hasDisplacement: true, hasReference: false);
        float[] values = [.. Enumerable.Range(0, take.FrameCount).SelectMany(frame => take.GetFrame(frame).ToArray())];
        int head = layout.GetRotationIndex(Bone.Head);
        for (int frame = 20; frame < 40; frame++)
            (values[(frame * 354) + head], values[(frame * 354) + head + 1], values[(frame * 354) + head + 2]) = (180, 180, 180);

        values[(30 * 354) + layout.GetRotationIndex(Bone.RightHand)] = float.NaN;
        new BvhDocument(take.Hierarchy, take.FrameTime, values).Save(_folder["odd.bvh"]);
        JsonElement[] oddities = [.. (await JsonAsync("odd.bvh")).GetProperty("oddities").EnumerateArray()];

        Assert.Contains(oddities, static oddity => Is(oddity, "restPose"));
        Assert.Contains("Head 1", Text(oddities, "flips"), StringComparison.Ordinal);
        Assert.Contains("0.33 s", Text(oddities, "flips"), StringComparison.Ordinal);
        Assert.Contains("frame 30", Text(oddities, "notNumbers"), StringComparison.Ordinal);
        Assert.Contains("0.78 cm at most (LeftHand at 0.65 s)", Text(oddities, "displacement"), StringComparison.Ordinal);
        Assert.Contains("of the 354 values never change", Text(oddities, "constantColumns"), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Repairs_have_their_place()
    {
        _folder.Write("bad.bvh", Takes.TwoJoints.Replace("Frames: 3", "Frames: 9", StringComparison.Ordinal));
        JsonElement oddity = (await JsonAsync("bad.bvh")).GetProperty("oddities").EnumerateArray().First();
        Assert.Equal("repair", oddity.GetProperty("code").GetString());
        Assert.Equal(17, oddity.GetProperty("line").GetInt32());
        Assert.True(oddity.GetProperty("column").GetInt32() > 0);
    }

    [Fact]
    public async Task Another_skeleton_is_described_too()
    {
        _folder.Write("joints.bvh", Takes.TwoJoints);
        string[] page = await PageAsync("joints.bvh");

        Assert.Equal("2, 1 End Sites, 2 deep, from base", Fact(page, "joints"));
        Assert.Contains("Hips", Fact(page, "not Neuron's"), StringComparison.Ordinal);
        Assert.Equal("ZYX (1 joints), X (1 joints)", Fact(page, "rotation order"));
        Assert.StartsWith("2.00 by 0.00 units of the file", Fact(page, "extent"), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_skeleton_without_frames()
    {
        _folder.Write("empty.bvh", Takes.TwoJoints[..Takes.TwoJoints.IndexOf("MOTION", StringComparison.Ordinal)]);
        Assert.Contains("  a skeleton without frames", await PageAsync("empty.bvh"));
        ToolResult plot = await ToolRunner.RunAsync("plot", _folder["empty.bvh"], _folder["empty.svg"]);
        Assert.Equal(1, plot.ExitCode);
    }

    [Fact]
    public async Task A_recording_tells_avatars_gaps_and_what_is_no_frame()
    {
        using (RecordingWriter writer = RecordingWriter.Create(_folder["two.nmrec"], RecordingMetadata.Empty.With(RecordingMetadata.ServerKey, "studio:7001")))
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
        Assert.Equal(60, json.GetProperty("take").GetProperty("frameRate").GetDouble());
    }

    // Of an avatar, a joint, a key of the metadata, a reason: none reaches the terminal as more than letters; JSON has all of it.
    [Fact]
    public async Task Text_of_a_file_does_not_steer_the_terminal()
    {
        const string Odd = "\e[2J\u009b31m\u202e\r";
        using (RecordingWriter writer = RecordingWriter.Create(
            _folder["odd.nmrec"], RecordingMetadata.Empty.With("key" + Odd, "value" + Odd).With(RecordingMetadata.ServerKey, "server" + Odd)))
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "local" + Odd, "remote" + Odd));
            for (uint frame = 0; frame < 20; frame++)
                writer.WriteBytes(TimeSpan.FromSeconds(frame / 60.0), 0, Packet(0, "A" + Odd, frame));

            writer.CloseConnection(TimeSpan.FromSeconds(2), 0, "gone" + Odd);
        }

        _folder.Write("odd.bvh", Takes.TwoJoints.Replace("lFoot", "lFoot" + Odd.Replace("\r", "", StringComparison.Ordinal), StringComparison.Ordinal));
        foreach (string name in (string[])["odd.nmrec", "odd.bvh"])
        {
            foreach (string line in await PageAsync(name))
                Assert.Equal(line, TerminalText.Clean(line));

            ToolResult json = await ToolRunner.RunAsync("info", _folder[name], "--json");
            Assert.Equal(json.Output[0], TerminalText.Clean(json.Output[0]));
        }

        Assert.Equal("A" + Odd, (await JsonAsync("odd.nmrec")).GetProperty("take").GetProperty("avatarName").GetString());
        ToolResult converted = await ToolRunner.RunAsync("convert", _folder["odd.nmrec"], _folder["odd.calc"]);
        Assert.Equal(Assert.Single(converted.Error), TerminalText.Clean(converted.Error[0]));
    }

    [Fact]
    public async Task A_frame_time_of_zero_is_one_oddity()
    {
        _folder.Write("zero.bvh", Takes.TwoJoints.Replace("0.04", "0", StringComparison.Ordinal));
        JsonElement oddities = (await JsonAsync("zero.bvh")).GetProperty("oddities");
        Assert.Single(oddities.EnumerateArray(), static oddity => oddity.GetProperty("text").GetString()!.Contains("frame time", StringComparison.Ordinal));
    }

    [Fact]
    public async Task A_recording_of_many_connections_lists_the_first_of_them()
    {
        using (RecordingWriter writer = RecordingWriter.Create(_folder["take.nmrec"]))
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
    public async Task A_recording_whose_blocks_were_taken_out_is_not_taken_for_one_that_was_cut()
    {
        using (RecordingWriter writer = RecordingWriter.Create(_folder["take.nmrec"]))
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "", ""));
            for (int i = 0; i < 3; i++)
            {
                writer.WriteBytes(TimeSpan.FromMilliseconds(i), 0, FrameServer.Motion((uint)i, new float[354]));
                writer.Flush();
            }
        }

        // The second of the three.
        byte[] file = await File.ReadAllBytesAsync(_folder["take.nmrec"], TestContext.Current.CancellationToken);
        byte[] marker = [0xF7, (byte)'N', (byte)'M', (byte)'B'];
        int first = file.AsSpan(70).IndexOf(marker) + 70;
        int second = file.AsSpan(first + 1).IndexOf(marker) + first + 1;
        int third = file.AsSpan(second + 1).IndexOf(marker) + second + 1;
        await File.WriteAllBytesAsync(_folder["take.nmrec"], [.. file[..second], .. file[third..]], TestContext.Current.CancellationToken);
        JsonElement json = await JsonAsync("take.nmrec");
        Assert.True(json.GetProperty("recording").GetProperty("complete").GetBoolean());
        Assert.Equal("Block 2 is missing before this one.", Assert.Single(json.GetProperty("damage").EnumerateArray()).GetProperty("text").GetString());
    }

    [Fact]
    public async Task A_recording_that_was_cut_says_so()
    {
        Takes.Actor(600).Save(_folder["take.bvh"]);
        await ToolRunner.RunAsync("convert", _folder["take.bvh"], _folder["take.nmrec"]);
        byte[] whole = await File.ReadAllBytesAsync(_folder["take.nmrec"], TestContext.Current.CancellationToken);
        await File.WriteAllBytesAsync(_folder["cut.nmrec"], whole[..(whole.Length / 2)], TestContext.Current.CancellationToken);
        JsonElement json = await JsonAsync("cut.nmrec");

        Assert.False(json.GetProperty("recording").GetProperty("complete").GetBoolean());
        Assert.Equal(1, json.GetProperty("damage").GetArrayLength());
        Assert.InRange(json.GetProperty("take").GetProperty("frames").GetInt32(), 200, 300);
    }

    [Theory]
    [InlineData("mixed")]
    [InlineData("text")]
    [InlineData("studio-354")]
    [InlineData("calculation")]
    [InlineData("zero-count")]
    public async Task The_bytes_of_a_stream(string name)
    {
        File.Copy(Fixtures.Require("streams", name + ".bin"), _folder["stream.bin"]);
        JsonElement json = await JsonAsync("stream.bin");
        Assert.Equal("raw", json.GetProperty("kind").GetString());
        Assert.NotEmpty(json.GetProperty("stream").GetProperty("formats").EnumerateArray());
        Assert.Equal(0, (await ToolRunner.RunAsync("info", _folder["stream.bin"])).ExitCode);
    }

    // Two frames in the middle are lost: the bytes have no times, so the rate is the one that is given and not one that the loss makes up.
    [Theory]
    [InlineData("60", 60)]
    [InlineData("59.94", 59.94)]
    [InlineData(null, 120)]
    public async Task The_rate_of_bytes_without_times_can_be_given(string? given, double rate)
    {
        await File.WriteAllBytesAsync(
            _folder["stream.bin"],
            [.. Enumerable.Range(0, 20).Where(static frame => frame is not (10 or 11)).SelectMany(static frame => Packet(0, "Anna", (uint)frame))],
            TestContext.Current.CancellationToken);
        string[] option = given is null ? [] : ["--rate", given];
        ToolResult info = await ToolRunner.RunAsync(["info", _folder["stream.bin"], "--json", .. option]);
        JsonElement take = JsonDocument.Parse(Assert.Single(info.Output)).RootElement.GetProperty("take");
        Assert.Equal((20, rate), (take.GetProperty("frames").GetInt32(), take.GetProperty("frameRate").GetDouble()));

        Assert.Equal(0, (await ToolRunner.RunAsync(["convert", _folder["stream.bin"], _folder["stream.bvh"], .. option])).ExitCode);
        Assert.Equal(rate, BvhDocument.Load(_folder["stream.bvh"]).FrameRate, 1e-3);
        Assert.Equal(0, (await ToolRunner.RunAsync(["convert", _folder["stream.bin"], _folder["stream.nmrec"], .. option])).ExitCode);
        using (RecordingReader reader = RecordingReader.Open(_folder["stream.nmrec"]))
            Assert.Equal(17 / rate, reader.Duration.TotalSeconds, 1e-6);

        Assert.Equal(0, (await ToolRunner.RunAsync(["plot", _folder["stream.bin"], _folder["stream.svg"], .. option])).ExitCode);
        Assert.Contains(FormattableString.Invariant($"20 frames at {rate:0.##} Hz"), await File.ReadAllTextAsync(_folder["stream.svg"], TestContext.Current.CancellationToken), StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_rate_is_not_for_files_with_times()
    {
        Takes.StraightWalk(frames: 3).Save(_folder["walk.bvh"]);
        ToolResult result = await ToolRunner.RunAsync("info", _folder["walk.bvh"], "--rate", "60");
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("walk.bvh has times of its own", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    // An export has no place for its rate: 60 Hz become 120 unless somebody says so.
    [Fact]
    public async Task The_rate_of_a_calculation_export_can_be_given()
    {
        Takes.Actor(60).Save(_folder["take.bvh"]);
        Assert.Equal(0, (await ToolRunner.RunAsync("convert", _folder["take.bvh"], _folder["take.calc"])).ExitCode);
        ToolResult info = await ToolRunner.RunAsync("info", _folder["take.calc"], "--json", "--rate", "60");
        Assert.Equal(60, JsonDocument.Parse(Assert.Single(info.Output)).RootElement.GetProperty("take").GetProperty("frameRate").GetDouble());
        Assert.Equal(0, (await ToolRunner.RunAsync("convert", _folder["take.calc"], _folder["back.bvh"], "--rate", "60")).ExitCode);
        Assert.Equal(60, BvhDocument.Load(_folder["back.bvh"]).FrameRate);
        Assert.Equal(0, (await ToolRunner.RunAsync("convert", _folder["take.calc"], _folder["back.nmrec"], "--rate", "60")).ExitCode);
        using RecordingReader reader = RecordingReader.Open(_folder["back.nmrec"]);
        Assert.Equal(59 / 60.0, reader.Duration.TotalSeconds, 1e-6);
    }

    [Fact]
    public async Task A_calculation_export()
    {
        File.Copy(Fixtures.Require("calc", "salsa_left_Char00.calc"), _folder["salsa.calc"]);
        JsonElement json = await JsonAsync("salsa.calc");
        Assert.Equal("calculation", json.GetProperty("kind").GetString());
        Assert.Equal(269, json.GetProperty("take").GetProperty("frames").GetInt32());
        Assert.Equal(946, json.GetProperty("take").GetProperty("columns").GetInt32());
        Assert.InRange(json.GetProperty("boneSizes").GetProperty("upperLeg").GetDouble(), 0.3, 0.6);
    }

    [Theory]
    [InlineData("nowhere.bvh", "nowhere.bvh")]
    [InlineData(".", "folder")]
    public async Task What_is_not_there_ends_with_1(string name, string told)
    {
        ToolResult result = await ToolRunner.RunAsync("info", _folder[name]);
        Assert.Equal(1, result.ExitCode);
        Assert.Contains(told, Assert.Single(result.Error), StringComparison.Ordinal);
    }

    public void Dispose() => _folder.Dispose();

    private static byte[] Packet(int avatar, string name, uint frame)
    {
        MotionFrame upright = Poses.Upright(frame);
        byte[] packet = new byte[upright.Header.PacketSize];
        PacketEncoder.WriteMotion(
            packet, upright.Header with { AvatarIndex = avatar, AvatarName = new AvatarName(name), FrameIndex = frame }, upright.Values);
        return packet;
    }

    private static bool Is(JsonElement oddity, string code) => oddity.GetProperty("code").ValueEquals(code);

    private static string Text(JsonElement[] oddities, string code) => oddities.Single(oddity => Is(oddity, code)).GetProperty("text").GetString()!;

    private static string Fact(string[] page, string label, string? after = null) => page
        .SkipWhile(line => after is not null && line != after)
        .First(line => line.StartsWith($"  {label} ", StringComparison.Ordinal))[(label.Length + 2)..]
        .Trim();

    // Dumps of streams that are text and lack what a line begins with.
    [Theory]
    [InlineData("", "without the avatar's number and name")]
    [InlineData("Char00 A ", "begin with a word instead of the avatar's number")]
    public async Task A_dump_of_text_without_an_avatar_says_what_is_missing(string lead, string said)
    {
        string line = lead + string.Join(' ', Enumerable.Range(0, 354).Select(static value => $"{value}.50")) + "||\r\n";
        await File.WriteAllTextAsync(_folder["text.bin"], string.Concat(Enumerable.Repeat(line, 5)), TestContext.Current.CancellationToken);
        ToolResult result = await ToolRunner.RunAsync("info", _folder["text.bin"]);

        Assert.Equal(1, result.ExitCode);
        Assert.Empty(result.Output);
        string error = string.Join(' ', result.Error);
        Assert.Contains(said, error, StringComparison.Ordinal);
        Assert.Contains("0 Char00 0.00 93.02", error, StringComparison.Ordinal);
    }

    // Of one frame whose positions are at the end of what a number can be, the extent has no end.
    [Fact]
    public async Task A_take_without_finite_extent_is_JSON_all_the_same()
    {
        byte[] packet = new byte[64 + (354 * sizeof(float))];
        float[] values = [float.MaxValue, -float.MaxValue, float.MaxValue, .. new float[351]];
        PacketEncoder.WriteMotion(packet, new MotionHeader { Version = DataVersion.New, HasDisplacement = true, AvatarName = new AvatarName("Char00") }, values);
        await File.WriteAllBytesAsync(_folder["far.bin"], packet, TestContext.Current.CancellationToken);
        JsonElement json = await JsonAsync("far.bin");

        Assert.Equal("raw", json.GetProperty("kind").GetString());
    }

    [Fact]
    public void Numbers_that_JSON_has_no_word_for_are_null()
    {
        var report = new InfoReport("a", "raw", "b");
        report.Section("s", "t").Add("box", "c", "d", new JsonObject { ["low"] = double.NegativeInfinity, ["high"] = 2.5, ["all"] = new JsonArray(float.NaN, 1) });

        JsonElement section = JsonDocument.Parse(InfoJson.Write(report)).RootElement.GetProperty("s");
        Assert.Equal("""{"low":null,"high":2.5,"all":[null,1]}""", section.GetProperty("box").GetRawText());
    }

    private async Task<string[]> PageAsync(string name, params string[] options)
    {
        ToolResult result = await ToolRunner.RunAsync(["info", _folder[name], .. options]);
        Assert.Empty(result.Error);
        Assert.Equal(0, result.ExitCode);
        return result.Output;
    }

    private async Task<JsonElement> JsonAsync(string name)
    {
        ToolResult result = await ToolRunner.RunAsync("info", _folder[name], "--json");
        Assert.Empty(result.Error);
        Assert.Equal(0, result.ExitCode);
        return JsonDocument.Parse(Assert.Single(result.Output)).RootElement;
    }
}
