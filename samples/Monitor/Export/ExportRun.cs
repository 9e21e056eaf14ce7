using System.Globalization;

namespace NeuronMocap.Monitor.Export;

/// <summary>A file that is written while the stream is shown; none where none was asked for.</summary>
internal sealed class ExportRun : IDisposable
{
    private readonly BvhExport? _export;

    private ExportRun(BvhExport? export) => _export = export;

    /// <summary>Ends when the file cannot be written any more.</summary>
    public Task Broken => _export is null ? Task.Delay(Timeout.Infinite) : WaitForFailureAsync(_export);

    /// <summary>Begins before the reader is started, so that no frame is missing.</summary>
    /// <exception cref="ExportException">The file is there already, or cannot be written.</exception>
    public static ExportRun Begin(NeuronReader reader, ExportSettings? settings, long? frames)
    {
        try
        {
            return new ExportRun(settings is null ? null : reader.ExportBvh(settings.Path, settings.ToOptions(frames)));
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException or ArgumentException)
        {
            string hint = File.Exists(settings!.Path) && !settings.Overwrite ? " --overwrite replaces it." : "";
            throw new ExportException($"--export: {exception.Message}{hint}", exception);
        }
    }

    /// <summary>Completes the files and says what is in them.</summary>
    /// <returns>False when something is not.</returns>
    public bool TryFinish(TextWriter messages)
    {
        if (_export is null)
            return true;

        _export.Dispose();
        foreach (BvhExportFile file in _export.Files)
            messages.WriteLine($"neuron-monitor: {Describe(file)}");

        if (_export.Files.Count == 0)
            messages.WriteLine("neuron-monitor: no motion frame came, and no file was written.");
        if (_export.FramesDropped > 0)
            messages.WriteLine($"neuron-monitor: {_export.FramesDropped} frames are missing: the disk was too slow.");
        if (_export.Failure is { } failure)
            messages.WriteLine($"neuron-monitor: the export ended early: {failure.Message}");

        return _export.Failure is null;
    }

    public void Dispose() => _export?.Dispose();

    private static async Task WaitForFailureAsync(BvhExport export)
    {
        await export.Completion;
        if (export.Failure is null)
            await Task.Delay(Timeout.Infinite);
    }

    private static string Describe(BvhExportFile file)
    {
        string body = file.BodySource switch
        {
            BvhBodySource.Stream => "lengths of the bones from the stream",
            BvhBodySource.Header => "lengths of the bones from the command channel",
            BvhBodySource.Dimensions => "lengths of the bones from the sizes that the command channel told",
            _ => "lengths of the bones of the default body",
        };
        string repeated = file.RepeatedFrames == 0 ? "" : $" {file.RepeatedFrames} of them stand in for lost ones;";
        string late = file.LateFrames == 0 ? "" : $" {file.LateFrames} more came too late;";
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{file.FrameCount} frames of {TerminalText.Clean(file.AvatarName)} at {file.FrameRate:0.##} Hz in {file.Path};{repeated}{late} {body}.");
    }
}
