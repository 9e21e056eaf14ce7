using System.Net;
using System.Text.Json;
using Microsoft.AspNetCore.Http;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.View.Takes;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.Tests.View.Takes;

public sealed class TakeDownloadTests
{
    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Theory]
    [InlineData("bvh")]
    [InlineData("glb")]
    [InlineData("csv")]
    [InlineData("calc")]
    [InlineData("bvh&performer=t1-0")]
    [InlineData("nmrec&from=0&to=100")]
    public async Task A_recording_without_motion_says_so(string wish)
    {
        using var takes = new OpenTakes();
        string recording = takes.Record([]);
        await using TakeClient client = await TakeClient.StartAsync();
        await client.OpenAsync(recording);

        JsonElement answer = await client.GetAsync($"takes/t1/download?format={wish}", HttpStatusCode.Conflict);

        Assert.Equal("'take.nmrec' holds no frames of motion.", answer.GetProperty("error").GetString());
    }

    [Fact]
    public async Task A_recording_without_motion_is_downloaded_as_it_is()
    {
        using var takes = new OpenTakes();
        string recording = takes.Record([]);
        await using TakeClient client = await TakeClient.StartAsync();
        await client.OpenAsync(recording);

        using HttpResponseMessage answer = await client.GetFileAsync("takes/t1/download?format=nmrec");

        Assert.Equal(await File.ReadAllBytesAsync(recording, Token), await answer.Content.ReadAsByteArrayAsync(Token));
    }

    [Fact]
    public async Task A_take_that_is_closed_before_its_first_frame_says_so()
    {
        using var scratch = new ScratchFolder(long.MaxValue);
        using var download = new TakeDownload(scratch);
        using var take = new Take("t1", "take.nmrec", "take.nmrec", FileKind.Recording);
        take.Start(() => take.Closed.WaitHandle.WaitOne());
        Task sending = download.SendAsync(new DefaultHttpContext { Request = { QueryString = new QueryString("?format=glb") } }, take);

        take.Dispose();

        ApiException answer = await Assert.ThrowsAsync<ApiException>(() => sending);
        Assert.Equal("The take was closed.", answer.Message);
    }

    [Fact]
    public async Task A_skeleton_without_frames_says_so()
    {
        await using TakeClient client = await TakeClient.StartAsync();
        Files.Takes.Actor(0).Save(client.Folder["still.bvh"]);
        await client.OpenAsync(client.Folder["still.bvh"]);

        JsonElement answer = await client.GetAsync("takes/t1/download?format=glb", HttpStatusCode.Conflict);

        Assert.Equal("'still.bvh' holds no frames of motion.", answer.GetProperty("error").GetString());
    }
}
