using System.Net;
using System.Text.Json;
using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Gltf;

namespace NeuronMocap.Tool.Tests.View.Takes;

public sealed class TakeServiceTests
{
    [Fact]
    public async Task A_dropped_take_is_described_with_its_performers_in_metres()
    {
        await using TakeClient client = await TakeClient.StartAsync();
        Files.Takes.Actor(120).Save(client.Folder["walk.bvh"]);

        JsonElement info = await client.UploadAsync(client.Folder["walk.bvh"]);

        Assert.Equal("walk.bvh", info.GetProperty("name").GetString());
        Assert.Equal("bvh", info.GetProperty("kind").GetString());
        Assert.Equal(119 / 0.06, info.GetProperty("duration").GetDouble(), 2);
        Assert.Empty(info.GetProperty("problems").EnumerateArray());
        JsonElement performer = Assert.Single(info.GetProperty("performers").EnumerateArray());
        Assert.Equal("t1-0", performer.GetProperty("key").GetString());
        Assert.Equal(120, performer.GetProperty("frames").GetInt64());
        Assert.Equal(60, performer.GetProperty("rate").GetDouble(), 6);
        Assert.Equal(59, performer.GetProperty("bones").GetArrayLength());
        Assert.InRange(performer.GetProperty("bones")[1].GetProperty("offset")[1].GetDouble(), -1, 1);
        Assert.Empty(performer.GetProperty("gaps").EnumerateArray());
    }

    [Fact]
    public async Task Any_frames_can_be_read_and_those_behind_the_end_are_missing()
    {
        await using TakeClient client = await TakeClient.StartAsync();
        Files.Takes.Actor(150).Save(client.Folder["walk.bvh"]);
        await client.UploadAsync(client.Folder["walk.bvh"]);

        List<byte[]> all = await client.GetPosesAsync("t1", "t1-0", 0, 150);
        List<byte[]> end = await client.GetPosesAsync("t1", "t1-0", 140, 100);
        List<byte[]> behind = await client.GetPosesAsync("t1", "t1-0", 5000, 100);

        Assert.Equal(150, all.Count);
        Assert.Equal(all[140..], end);
        Assert.Empty(behind);
        Assert.True(CompactPose.TryDecode(all[60], out CompactPoseHeader header, new BoneTransform[BoneHierarchy.BoneCount]));
        Assert.Equal(TimeSpan.FromSeconds(1), header.Time - DateTimeOffset.UnixEpoch);
        JsonElement times = await client.GetAsync("takes/t1/times");
        Assert.Equal(64, times.GetProperty("step").GetInt32());
        Assert.True(times.GetProperty("isComplete").GetBoolean());
        Assert.Equal([0, 64 / 0.06, 128 / 0.06], times.GetProperty("times").EnumerateArray().Select(static time => time.GetDouble()), static (a, b) => Math.Abs(a - b) < 0.01);
    }

    [Fact]
    public async Task Contacts_and_curves_are_in_milliseconds_and_metres()
    {
        await using TakeClient client = await TakeClient.StartAsync();
        Files.Takes.StraightWalk().Save(client.Folder["walk.bvh"]);
        await client.UploadAsync(client.Folder["walk.bvh"]);

        JsonElement curve = await client.GetAsync("takes/t1/curves?performer=t1-0&bone=Head&quantity=speed&points=20&from=500&to=1500");
        JsonElement contacts = await client.GetAsync("takes/t1/contacts?performer=t1-0");

        Assert.Equal("m/s", curve.GetProperty("unit").GetString());
        Assert.Equal(20, curve.GetProperty("times").GetArrayLength());
        Assert.All(curve.GetProperty("max").EnumerateArray(), static value => Assert.Equal(1, value.GetDouble(), 2));
        Assert.Equal(JsonValueKind.Array, contacts.GetProperty("left").ValueKind);
        Assert.Equal(JsonValueKind.Array, contacts.GetProperty("right").ValueKind);
    }

    [Theory]
    [InlineData("takes/t1/curves?bone=Tail&quantity=speed", "bone")]
    [InlineData("takes/t1/curves?bone=Hips&quantity=weight", "quantity")]
    [InlineData("takes/t1/curves?bone=Hips&quantity=1", "quantity")]
    [InlineData("takes/t1/curves?bone=Hips&quantity=speed&points=0", "points")]
    [InlineData("takes/t1/curves?bone=Hips&quantity=speed&from=NaN", "from")]
    [InlineData("takes/t1/curves?bone=Hips&quantity=speed&from=9&to=3", "to")]
    [InlineData("takes/t1/poses?from=-1", "from")]
    [InlineData("takes/t1/poses?count=999999999", "count")]
    [InlineData("takes/t1/download?format=exe", "format")]
    public async Task Wrong_values_are_refused_with_a_sentence(string address, string name)
    {
        await using TakeClient client = await TakeClient.StartAsync();
        Files.Takes.Actor(2).Save(client.Folder["walk.bvh"]);
        await client.UploadAsync(client.Folder["walk.bvh"]);

        JsonElement error = await client.GetAsync(address, HttpStatusCode.BadRequest);

        Assert.StartsWith(name, error.GetProperty("error").GetString(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("takes/t9")]
    [InlineData("takes/t9/poses")]
    [InlineData("takes/t1/poses?performer=0-7")]
    public async Task What_is_not_open_is_not_found(string address)
    {
        await using TakeClient client = await TakeClient.StartAsync();
        Files.Takes.Actor(2).Save(client.Folder["walk.bvh"]);
        await client.UploadAsync(client.Folder["walk.bvh"]);
        await client.GetAsync(address, HttpStatusCode.NotFound);
    }

    [Fact]
    public async Task A_file_of_a_wrong_kind_is_refused_and_not_kept()
    {
        await using TakeClient client = await TakeClient.StartAsync();

        JsonElement error = await client.PostAsync("photo.jpg", [0xFF, 0xD8, 0xFF, 0, 1, 2, 3], HttpStatusCode.BadRequest);
        JsonElement empty = await client.PostAsync("none.bvh", [], HttpStatusCode.BadRequest);

        Assert.DoesNotContain('\n', error.GetProperty("error").GetString()!);
        Assert.Contains("none.bvh", empty.GetProperty("error").GetString(), StringComparison.Ordinal);
        Assert.Equal(0, client.ScratchFiles);
    }

    [Fact]
    public async Task A_file_that_is_too_large_is_refused_and_not_kept()
    {
        await using TakeClient client = await TakeClient.StartAsync(megabytes: 1);
        await client.PostAsync("big.bvh", new byte[1_100_000], HttpStatusCode.RequestEntityTooLarge);
        Assert.Equal(0, client.ScratchFiles);
    }

    [Fact]
    public async Task A_name_with_a_path_is_only_shown()
    {
        await using TakeClient client = await TakeClient.StartAsync();
        Files.Takes.Actor(2).Save(client.Folder["walk.bvh"]);

        JsonElement answer = await client.PostAsync("../../etc/\"x\"\r\n.bvh", await File.ReadAllBytesAsync(client.Folder["walk.bvh"]));
        JsonElement info = await client.GetAsync($"takes/{answer.GetProperty("id").GetString()}");

        Assert.Equal("x.bvh", info.GetProperty("name").GetString());
    }

    [Fact]
    public async Task Takes_are_downloaded_as_other_files_and_as_they_were()
    {
        await using TakeClient client = await TakeClient.StartAsync();
        Files.Takes.Actor(90).Save(client.Folder["a walk.bvh"]);
        await client.UploadAsync(client.Folder["a walk.bvh"]);

        using HttpResponseMessage same = await client.GetFileAsync("takes/t1/download?format=bvh");
        using HttpResponseMessage part = await client.GetFileAsync("takes/t1/download?format=bvh&performer=t1-0&from=500&to=1000");
        using HttpResponseMessage between = await client.GetFileAsync("takes/t1/download?format=bvh&from=166.667&to=333.333");
        using HttpResponseMessage recording = await client.GetFileAsync("takes/t1/download?format=nmrec");

        Assert.Equal(await File.ReadAllBytesAsync(client.Folder["a walk.bvh"]), await same.Content.ReadAsByteArrayAsync());
        Assert.Equal(30, BvhDocument.Parse(await part.Content.ReadAsByteArrayAsync()).FrameCount);
        // At 60 Hz, these are the times of frames 10 and 20 as the page knows them.
        Assert.Equal(10, BvhDocument.Parse(await between.Content.ReadAsByteArrayAsync()).FrameCount);
        Assert.Equal("a walk.nmrec", recording.Content.Headers.ContentDisposition!.FileNameStar);
        string copy = client.Folder["copy.nmrec"];
        await File.WriteAllBytesAsync(copy, await recording.Content.ReadAsByteArrayAsync());
        using (RecordingReader reader = RecordingReader.Open(copy))
            Assert.Equal("the file a walk.bvh", reader.Metadata[RecordingMetadata.ServerKey]);

        JsonElement again = await client.OpenAsync(copy);
        Assert.Equal(90, again.GetProperty("performers")[0].GetProperty("frames").GetInt64());
    }

    [Fact]
    public async Task A_file_that_was_deleted_meanwhile_is_named()
    {
        await using TakeClient client = await TakeClient.StartAsync();
        Files.Takes.Actor(10).Save(client.Folder["walk.bvh"]);
        await client.OpenAsync(client.Folder["walk.bvh"]);
        File.Delete(client.Folder["walk.bvh"]);

        JsonElement answer = await client.GetAsync("takes/t1/download?format=bvh", HttpStatusCode.NotFound);

        Assert.Equal("'walk.bvh' does not exist.", answer.GetProperty("error").GetString());
    }

    [Fact]
    public async Task Figures_and_tables_hold_all_performers_unless_one_is_chosen()
    {
        using var takes = new OpenTakes();
        string recording = takes.Record(Enumerable.Range(0, 60).SelectMany(static frame => (IEnumerable<(double, int, int)>)[(frame * 1000 / 60.0, 0, frame), (frame * 1000 / 60.0, 1, frame)]));
        await using TakeClient client = await TakeClient.StartAsync();
        await client.UploadAsync(recording);

        using HttpResponseMessage figures = await client.GetFileAsync("takes/t1/download?format=glb");
        using HttpResponseMessage figure = await client.GetFileAsync("takes/t1/download?format=glb&performer=t1-1");
        using HttpResponseMessage table = await client.GetFileAsync("takes/t1/download?format=csv");
        using HttpResponseMessage second = await client.GetFileAsync("takes/t1/download?format=csv&performer=t1-1");

        Assert.Equal(["Actor 0", "Actor 1"], GlbFile.Parse(await figures.Content.ReadAsByteArrayAsync()).Names("animations"));
        Assert.Equal(["Actor 1"], GlbFile.Parse(await figure.Content.ReadAsByteArrayAsync()).Names("animations"));
        string text = await table.Content.ReadAsStringAsync();
        Assert.Contains("# source: take.nmrec\n", text, StringComparison.Ordinal);
        Assert.Equal(120, CountRows(text));
        Assert.Equal(60, CountRows(await second.Content.ReadAsStringAsync()));
    }

    [Fact]
    public async Task A_new_take_closes_the_oldest_and_deletes_its_file()
    {
        await using TakeClient client = await TakeClient.StartAsync();
        Files.Takes.Actor(2).Save(client.Folder["walk.bvh"]);
        byte[] file = await File.ReadAllBytesAsync(client.Folder["walk.bvh"]);
        for (int i = 0; i <= NeuronMocap.Tool.View.Takes.TakeLibrary.MostTakes; i++)
            await client.PostAsync("walk.bvh", file);

        await client.GetAsync("takes/t1", HttpStatusCode.NotFound);
        await client.GetAsync("takes/t2");
    }

    [Fact]
    public async Task Large_uploads_close_the_oldest_take_too()
    {
        using var folder = new Files.TemporaryFolder();
        Files.Takes.Actor(2).Save(folder["walk.bvh"]);
        byte[] file = new byte[950_000];
        file.AsSpan().Fill((byte)'\n');
        (await File.ReadAllBytesAsync(folder["walk.bvh"], TestContext.Current.CancellationToken)).CopyTo(file, 0);
        await using RunningView view = await RunningView.StartAsync(folder["walk.bvh"], "--upload-limit", "1");

        for (int i = 0; i < NeuronMocap.Tool.View.Takes.TakeLibrary.MostTakes + 1; i++)
        {
            using HttpResponseMessage answer = await view.Client.PostAsync("/api/takes?name=walk.bvh", new ByteArrayContent(file), TestContext.Current.CancellationToken);
            Assert.Equal(HttpStatusCode.OK, answer.StatusCode);
        }
    }

    [Fact]
    public async Task A_take_of_the_programs_own_disk_opens_again_after_newer_ones_closed_it()
    {
        await using TakeClient client = await TakeClient.StartAsync();
        Files.Takes.Actor(2).Save(client.Folder["walk.bvh"]);
        JsonElement first = await client.OpenAsync(client.Folder["walk.bvh"]);
        byte[] file = await File.ReadAllBytesAsync(client.Folder["walk.bvh"]);
        for (int i = 0; i < NeuronMocap.Tool.View.Takes.TakeLibrary.MostTakes; i++)
            await client.PostAsync("walk.bvh", file);

        using HttpResponseMessage download = await client.GetFileAsync("takes/t1/download?format=nmrec&performer=t1-0");
        JsonElement again = await client.WaitAsync("t1");

        Assert.Equal(HttpStatusCode.OK, download.StatusCode);
        Assert.Equal(first.GetRawText(), again.GetRawText());
        await client.GetAsync("takes/t2", HttpStatusCode.NotFound);
    }

    [Theory]
    [InlineData("times?performer=t1-0")]
    [InlineData("poses?performer=t1-0&from=80&count=4")]
    [InlineData("contacts?performer=t1-0")]
    [InlineData("curves?performer=t1-0&bone=Hips&quantity=height")]
    [InlineData("download?format=bvh&performer=t1-0&from=500&to=1000")]
    public async Task A_page_that_shows_a_closed_take_goes_on(string wish)
    {
        await using TakeClient client = await TakeClient.StartAsync();
        Files.Takes.Actor(120).Save(client.Folder["walk.bvh"]);
        await client.OpenAsync(client.Folder["walk.bvh"]);
        byte[] before = await GetAsync();
        byte[] file = await File.ReadAllBytesAsync(client.Folder["walk.bvh"]);
        for (int i = 0; i < NeuronMocap.Tool.View.Takes.TakeLibrary.MostTakes; i++)
            await client.PostAsync("walk.bvh", file);

        Assert.NotEmpty(before);
        Assert.Equal(before, await GetAsync());

        async Task<byte[]> GetAsync()
        {
            using HttpResponseMessage answer = await client.GetFileAsync($"takes/t1/{wish}");
            Assert.Equal(HttpStatusCode.OK, answer.StatusCode);
            return await answer.Content.ReadAsByteArrayAsync();
        }
    }

    [Fact]
    public async Task A_take_of_an_earlier_run_of_the_program_is_gone_although_another_take_is_open()
    {
        using var folder = new Files.TemporaryFolder();
        string file = folder["walk.bvh"];
        Files.Takes.Actor(2).Save(file);
        string before, after;
        await using (RunningView first = await RunningView.StartAsync(file))
            before = (await first.GetAsync("/api/hello")).GetProperty("take").GetString()!;

        await using RunningView second = await RunningView.StartAsync(file);
        after = (await second.GetAsync("/api/hello")).GetProperty("take").GetString()!;
        using HttpResponseMessage gone = await second.Client.GetAsync($"/api/takes/{before}", TestContext.Current.CancellationToken);

        Assert.NotEqual(before, after);
        Assert.Equal(HttpStatusCode.NotFound, gone.StatusCode);
        Assert.Contains("Drop its file on the page again.", await gone.Content.ReadAsStringAsync(TestContext.Current.CancellationToken), StringComparison.Ordinal);
        Assert.Equal("walk.bvh", (await second.GetAsync($"/api/takes/{after}")).GetProperty("name").GetString());
    }

    [Theory]
    [InlineData("bvh")]
    [InlineData("nmrec")]
    public async Task A_part_of_a_recording_has_the_frames_that_the_page_shows_in_it(string format)
    {
        // The stream begins after two seconds, and pauses for three.
        using var takes = new OpenTakes();
        string recording = takes.Record(Enumerable.Range(0, 240).Select(static frame => (2000 + (frame * 1000 / 60.0) + (frame < 120 ? 0 : 3000), 0, frame)));
        await using TakeClient client = await TakeClient.StartAsync();
        await client.UploadAsync(recording);

        using HttpResponseMessage part = await client.GetFileAsync($"takes/t1/download?format={format}&from=3000&to=7500");
        string file = client.Folder["part." + format];
        await File.WriteAllBytesAsync(file, await part.Content.ReadAsByteArrayAsync());
        await client.OpenAsync(file);

        List<byte[]> expected = await client.GetPosesAsync("t1", "t1-0", 60, 90), actual = await client.GetPosesAsync("t2", "t2-0", 0, 200);
        Assert.Equal(90, actual.Count);
        foreach (int frame in (int[])[0, 59, 60, 89])
            Assert.Equal(RotationsOf(expected[frame]), RotationsOf(actual[frame]), static (a, b) => Math.Abs(a - b) < 1e-3f);
    }

    // The page shows the frames evenly from 2 to 7 s, and they arrived at 7 s.
    [Theory]
    [InlineData("bvh", 0.001)]
    [InlineData("nmrec", 0.001)]
    [InlineData("nmrec", 0)]
    [InlineData("csv", 0.001)]
    public async Task A_part_whose_frames_arrived_later_is_downloaded(string format, double step)
    {
        using var takes = new OpenTakes();
        string recording = takes.Record(Enumerable.Range(0, 600).Select(frame => (frame is < 120 or > 419 ? frame * 1000 / 60.0 : 6999 + (step * (frame - 120)), 0, frame)));
        await using TakeClient client = await TakeClient.StartAsync();
        await client.UploadAsync(recording);

        using HttpResponseMessage part = await client.GetFileAsync($"takes/t1/download?format={format}&from=3000&to=6000");

        Assert.Equal(HttpStatusCode.OK, part.StatusCode);
        if (format == "csv")
        {
            Assert.InRange(CountRows(await part.Content.ReadAsStringAsync()), 180, 244);
            return;
        }

        string file = client.Folder["part." + format];
        await File.WriteAllBytesAsync(file, await part.Content.ReadAsByteArrayAsync());
        JsonElement info = await client.OpenAsync(file);
        Assert.InRange(info.GetProperty("performers")[0].GetProperty("frames").GetInt64(), 180, step > 0 ? 244 : 300);
    }

    private static float[] RotationsOf(byte[] pose)
    {
        var transforms = new BoneTransform[BoneHierarchy.BoneCount];
        Assert.True(CompactPose.TryDecode(pose, out _, transforms));
        return [.. transforms.SelectMany(static bone => (float[])[bone.Rotation.X, bone.Rotation.Y, bone.Rotation.Z, bone.Rotation.W])];
    }

    private static int CountRows(string table) => table.Split('\n').Count(static line => line.Length > 0 && char.IsAsciiDigit(line[0]));
}
