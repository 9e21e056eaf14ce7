using System.Net;
using NeuronMocap.Desktop.Tests.Infrastructure;
using NeuronMocap.Recording;
using NeuronMocap.Server;

namespace NeuronMocap.Desktop.Tests;

/// <summary>Uses the window of samples/DesktopForms.</summary>
public sealed class DesktopFormsTests
{
    private const string Skeleton = "Skeleton";

    // A pose that differs is drawn differently, and an equal pose equally.
    [Fact]
    public async Task Window_connects_to_the_typed_address_and_draws_the_pose_that_arrives()
    {
        Screen.Require();
        var performer = new StillSource();
        using Broadcaster server = Start(performer);
        using Screen screen = await Screen.OpenAsync();
        using WindowProgram program = await WindowProgram.StartAsync(screen, Programs.SampleTitle, Programs.Sample);
        await program.UntilTextAsync("^Not connected$");
        Picture nothing = await program.TakePictureAsync(Skeleton);

        await program.EnterAsync($"{server.LocalEndPoint}");
        await program.UntilTextAsync($"^Receiving from {server.LocalEndPoint}: ");
        await program.UntilTextAsync("^[1-9][0-9]* frames/s received, [1-9][0-9]* frames/s shown$");
        Picture first = await program.UntilPictureAsync(Skeleton, IsBody);
        Assert.False(first.IsSameAs(nothing));

        performer.Angle = 60;
        Picture second = await program.UntilPictureAsync(Skeleton, picture => IsBody(picture) && !picture.IsSameAs(first));
        await program.UntilPictureAsync(Skeleton, picture => picture.IsSameAs(second));
        performer.Angle = 0;
        await program.UntilPictureAsync(Skeleton, picture => picture.IsSameAs(first));
        for (int i = 0; i < 5; i++)
            Assert.True((await program.TakePictureAsync(Skeleton)).IsSameAs(first));

        await program.ClickAsync("Disconnect");
        await program.UntilTextAsync("^Not connected$");
        await Limits.UntilAsync(() => server.GetStatistics().Clients == 0);
        await program.CloseAsync();
        Assert.Equal("", program.Output);
    }

    [Fact]
    public async Task Window_says_why_nothing_arrives()
    {
        Screen.Require();
        using Screen screen = await Screen.OpenAsync();
        using WindowProgram program = await WindowProgram.StartAsync(screen, Programs.SampleTitle, Programs.Sample);

        await program.EnterAsync("no address");
        await program.UntilTextAsync("^'no address' is not an address");
        await program.UntilTextAsync("^Connect$");

        await program.CloseAsync();
    }

    [Fact]
    public async Task Server_dies_and_comes_back()
    {
        Screen.Require();
        using Screen screen = await Screen.OpenAsync();
        Broadcaster server = Start(new StillSource());
        try
        {
            IPEndPoint address = server.LocalEndPoint!;
            using WindowProgram program = await WindowProgram.StartAsync(screen, Programs.SampleTitle, Programs.Sample, $"{address}");
            await program.UntilPictureAsync(Skeleton, IsBody);

            server.Dispose();
            await program.UntilTextAsync($"^{address} refused the connection: nothing listens there");
            await program.UntilPictureAsync(Skeleton, static picture => !IsBody(picture));

            server = Start(new StillSource(), address);
            await program.UntilTextAsync($"^Receiving from {address}: ");
            await program.UntilPictureAsync(Skeleton, IsBody);
            await program.CloseAsync();
        }
        finally
        {
            server.Dispose();
        }
    }

    [Fact]
    public async Task Record_button_writes_a_recording_that_can_be_played()
    {
        Screen.Require();
        using Broadcaster server = Start(new StillSource());
        using Screen screen = await Screen.OpenAsync();
        using WindowProgram program = await WindowProgram.StartAsync(screen, Programs.SampleTitle, Programs.Sample, $"{server.LocalEndPoint}");
        string path = await RecordAsync(program);
        await program.ClickAsync("Stop recording");
        await program.UntilTextAsync("^Recorded [1-9][0-9.]* s to ");
        await program.UntilTextAsync("^Record$");

        await CheckAsync(path);
        await program.CloseAsync();
    }

    [Fact]
    public async Task Closing_the_window_completes_the_recording()
    {
        Screen.Require();
        using Broadcaster server = Start(new StillSource());
        using Screen screen = await Screen.OpenAsync();
        using WindowProgram program = await WindowProgram.StartAsync(screen, Programs.SampleTitle, Programs.Sample, $"{server.LocalEndPoint}");
        string path = await RecordAsync(program);
        await program.CloseAsync();

        await CheckAsync(path);
        Assert.Equal("", program.Output);
    }

    // On an address of this computer's that no other program uses, a port stays free between two servers.
    private static Broadcaster Start(StillSource performer, IPEndPoint? address = null)
    {
        var server = new Broadcaster(new BroadcasterOptions
        {
            Sources = [performer],
            BindAddress = address?.Address ?? new IPAddress([127, (byte)Random.Shared.Next(1, 255), (byte)Random.Shared.Next(256), 1]),
            Port = address?.Port ?? 0,
        });
        server.Start();
        return server;
    }

    // The colours of the left and the right side. They are grey while nothing arrives.
    private static bool IsBody(Picture picture) => picture.Count(30, 144, 255) > 200 && picture.Count(255, 165, 0) > 200;

    private static async Task<string> RecordAsync(WindowProgram program)
    {
        await program.UntilTextAsync("^Receiving from ");
        await program.ClickAsync("Record");
        return (await program.UntilTextAsync("^Recording [1-9][0-9.]* s to (.*)$")).Groups[1].Value;
    }

    private static async Task CheckAsync(string path)
    {
        using (RecordingReader file = RecordingReader.Open(path))
        {
            Assert.True(file.IsComplete);
            Assert.Empty(file.Problems);
        }

        using RecordingPlayer player = RecordingPlayer.Open(path);
        player.Speed = RecordingPlayer.MaxSpeed;
        await using var reader = new NeuronReader(player);
        reader.Start();
        await reader.Completion.Soon();
        ReaderStatistics played = reader.GetStatistics();
        Assert.InRange(played.MotionFrames, 1, long.MaxValue);
        Assert.Equal(0, played.Lost);
    }
}
