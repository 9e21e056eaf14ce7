using System.Globalization;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.View.Access;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View;

/// <summary>What the program says on standard output once the page can be opened.</summary>
internal sealed class Announcement(ViewOptions options, StandardStreams streams)
{
    private const int WidestText = 160;

    private readonly TextPage _page = new(streams, WidestText);

    public void Write(ViewServer server)
    {
        if (!PageFiles.Exist)
            streams.Complain($"this build does not contain the page. Install Node 20 or later, then run: {PageFiles.BuildCommand}");
        if (options.Port is null && server.LocalEndPoint.Port != ViewOptions.DefaultPort)
            streams.Complain(DescribePort(server.LocalEndPoint.Port));

        // Scripts wait for this line.
        string own = PageLinks.OfThisComputer(server.LocalEndPoint, server.Token);
        _page.WriteUnbroken($"Viewing {options.Source} on {own}");
        WriteOthers(
        [
            .. options.AllowedOrigins.Select(origin => PageLinks.OfProxy(origin, server.Token)),
            .. PageLinks.OfOthers(server.LocalEndPoint, server.Token),
        ]);
        _page.WriteLine("Ctrl+C ends the program.");
        if (options.Open)
            BrowserStart.Open(own, streams);
    }

    private static string DescribePort(int port) => string.Create(
        CultureInfo.InvariantCulture, $"port {ViewOptions.DefaultPort} is in use, perhaps by another viewer; this one is on port {port}.");

    private void WriteOthers(IReadOnlyList<string> links)
    {
        foreach (string link in links)
            _page.WriteUnbroken($"From other computers and phones: {link}");

        if (links.Count == 0 || !streams.IsTerminal || QrPicture.Create(links[0], _page.Width) is not { } picture)
            return;

        _page.WriteLine();
        _page.Console.Write(picture);
        _page.WriteLine();
    }
}
