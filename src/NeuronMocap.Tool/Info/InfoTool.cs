using System.Text;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Info;

/// <summary>Says what a file holds.</summary>
internal sealed class InfoTool(FileSettings settings, StandardStreams streams)
{
    public void Run(CancellationToken cancelled)
    {
        InfoReport report;
        using (var progress = new ProgressLine(streams, $"reading {Path.GetFileName(settings.Input)}"))
            report = Inspect(progress, cancelled);

        if (!settings.Json)
        {
            new InfoPage(streams).Write(report, settings.FollowsAnother);
            return;
        }

        streams.Output.Write(Encoding.UTF8.GetBytes(InfoJson.Write(report)));
        streams.Output.Flush();
    }

    private InfoReport Inspect(IProgress<double> progress, CancellationToken cancelled) => settings.RecognizeInput() switch
    {
        FileKind.Bvh => new BvhInspection(settings.Input, progress).Run(cancelled),
        FileKind.Calculation => new CalculationInspection(settings, progress).Run(cancelled),
        var kind => new StreamInspection(settings, kind == FileKind.Recording, progress).Run(cancelled),
    };
}
