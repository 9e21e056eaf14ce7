using System.Text;
using NeuronMocap.Monitor.Files.Inspection;

namespace NeuronMocap.Monitor.Files;

/// <summary>--info: says what a file holds.</summary>
internal sealed class InfoTool(FileSettings settings, StandardStreams streams)
{
    public void Run(CancellationToken cancelled)
    {
        InfoReport report;
        using (var progress = new ProgressLine(streams, $"reading {Path.GetFileName(settings.Input)}"))
            report = new BvhInspection(settings.Input, progress).Run(cancelled);

        if (!settings.Json)
        {
            new InfoPage(streams).Write(report);
            return;
        }

        streams.Output.Write(Encoding.UTF8.GetBytes(InfoJson.Write(report)));
        streams.Output.Flush();
    }
}
