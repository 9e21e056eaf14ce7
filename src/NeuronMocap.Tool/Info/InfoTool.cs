using System.Text;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Info;

/// <summary>Describes the contents of a file.</summary>
internal sealed class InfoTool(FileSettings settings, StandardStreams streams)
{
    /// <summary>Describes the file. Returns the exit code.</summary>
    public Task<int> RunAsync(CancellationToken cancellationToken)
    {
        var run = new FileRun(settings, streams) { Failed = settings.Json ? WriteFault : null };
        return run.RunAsync((_, stop) => Run(stop), cancellationToken);
    }

    private void Run(CancellationToken cancellationToken)
    {
        InfoReport report;
        using (var progress = new ProgressLine(streams, $"reading {Path.GetFileName(settings.Input)}"))
            report = Inspect(progress, cancellationToken);

        if (!settings.Json)
        {
            new InfoPage(streams).Write(report, settings.FollowsAnother);
            return;
        }

        Write(InfoJson.Write(report));
    }

    private void WriteFault(string sentence) => Write(InfoJson.WriteFault(Path.GetFileName(settings.Input), sentence));

    private void Write(string line)
    {
        streams.Output.Write(Encoding.UTF8.GetBytes(line));
        streams.Output.Flush();
    }

    private InfoReport Inspect(IProgress<double> progress, CancellationToken cancellationToken) => settings.RecognizeInput() switch
    {
        FileKind.Bvh => new BvhInspection(settings.Input, progress).Run(cancellationToken),
        FileKind.Calculation => new CalculationInspection(settings, progress).Run(cancellationToken),
        var kind => new StreamInspection(settings, kind == FileKind.Recording, progress).Run(cancellationToken),
    };
}
