using System.Globalization;
using NeuronMocap.Desktop.Tests.Infrastructure;
using NeuronMocap.Server;

namespace NeuronMocap.Desktop.Tests;

/// <summary>Uses the window of a program for the vendor's C# wrapper. Its callbacks call Control.Invoke for every frame.</summary>
public sealed class WrapperProgramTests
{
    [Fact]
    public async Task Window_shows_frames_disconnects_in_the_middle_and_connects_again()
    {
        Screen.Require();
        using Screen screen = await Screen.OpenAsync();
        using Broadcaster server = Broadcaster.StartDemo(avatars: 3, frameRate: 120);
        string[] target = [$"{server.LocalEndPoint!.Address}", $"{server.LocalEndPoint.Port}"];
        using WindowProgram program = await WindowProgram.StartAsync(screen, Programs.WrapperTitle, [Programs.Wrapper, .. target]);

        await program.ClickAsync("Connect");
        await program.UntilTextAsync("^CS_Running: Successfully connected to ");
        await program.UntilTextAsync("^Demo [1-3], frame [1-9][0-9]*$");
        int shown = await CountAsync();

        // The button's handler closes the connection on the window's thread, for which a callback waits.
        await program.ClickAsync("Disconnect");
        await program.UntilTextAsync("^CS_OffWork: Service is stoped$");
        await program.UntilTextAsync("^Connect$");
        await Limits.UntilAsync(() => server.GetStatistics().Clients == 0);
        int last = await CountAsync();
        Assert.InRange(last, shown, int.MaxValue);

        await program.ClickAsync("Connect");
        await program.UntilTextAsync("^CS_Running: Successfully connected to ");
        while (await CountAsync() < last + 100)
            await Task.Yield();

        server.Dispose();
        await program.UntilTextAsync("^CS_Running: Data thread exited.$");
        await program.CloseAsync();
        Assert.Equal("", program.Output);

        async Task<int> CountAsync() =>
            int.Parse((await program.UntilTextAsync("^([1-9][0-9]+) frames$")).Groups[1].Value, CultureInfo.InvariantCulture);
    }
}
