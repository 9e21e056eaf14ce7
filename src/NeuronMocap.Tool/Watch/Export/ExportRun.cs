using System.Globalization;
using NeuronMocap.Bvh;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Watch.Export;

/// <summary>The export of a run. It does nothing if no export was requested.</summary>
internal sealed class ExportRun : IDisposable
{
    private readonly BvhExport? _export;
    private readonly string _path;

    private ExportRun(BvhExport? export, string path) => (_export, _path) = (export, path);

    /// <summary>The export; null if none was requested.</summary>
    public BvhExport? Export => _export;

    /// <summary>Completes when the file cannot be written any more. Null without an export.</summary>
    public Task? Broken => _export is null ? null : WaitForFailureAsync(_export.Completion, () => _export.Failure);

    /// <summary>Starts before the reader, so that no frame is missing.</summary>
    /// <exception cref="ExportException">The file already exists, or it cannot be written.</exception>
    public static ExportRun Begin(NeuronReader reader, ExportSettings? settings, long? frames)
    {
        try
        {
            return new ExportRun(settings is null ? null : reader.ExportBvh(settings.Path, settings.ToOptions(frames)), settings?.Path ?? string.Empty);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException or ArgumentException)
        {
            string hint = File.Exists(settings!.Path) && !settings.Overwrite && InputFile.FindOddKind(settings.Path) is null ? " --overwrite replaces it." : "";
            throw new ExportException($"{settings.Argument}: {FileFault.OfWriting(exception, settings.Path)}{hint}", exception);
        }
    }

    /// <summary>Completes the files and reports their contents.</summary>
    /// <returns>False if a frame could not be written.</returns>
    public bool TryFinish(StandardStreams streams)
    {
        if (_export is null)
            return true;

        _export.Dispose();
        foreach (BvhExportFile file in _export.Files)
            streams.Complain($"{Describe(file)}");

        if (_export.Files.Count == 0 && _export.Failure is null)
            streams.Complain("no motion frame arrived, so no file was written.");
        if (_export.FramesDropped is > 0 and var missing)
        {
            string frames = string.Create(CultureInfo.InvariantCulture, $"{missing} {Quantity.Noun(missing, "frame")}");
            streams.Complain(_export.Failure is null
                ? $"the export lacks {frames}: the disk was too slow."
                : $"{frames} could not be written; later frames were not exported.");
        }

        if (_export.Failure is { } failure)
            streams.Complain($"the export ended early: {FileFault.OfWriting(failure, _export.Files is [.., var last] ? last.Path : _path)}");

        return _export.Failure is null;
    }

    public void Dispose() => _export?.Dispose();

    /// <summary>Completes when the work has failed. Never completes after a success.</summary>
    public static async Task WaitForFailureAsync(Task completion, Func<Exception?> getFailure)
    {
        await completion;
        if (getFailure() is null)
            await Task.Delay(Timeout.Infinite);
    }

    private static string Describe(BvhExportFile file)
    {
        string body = file.BodyOrigin switch
        {
            BvhBodyOrigin.Stream => "lengths of the bones from the stream",
            BvhBodyOrigin.Header => "lengths of the bones from the command channel",
            BvhBodyOrigin.Dimensions => "bone lengths from the sizes of the command channel",
            _ => "lengths of the bones of the default body",
        };
        string repeated = file.RepeatedFrames == 0 ? "" : $" {file.RepeatedFrames} of them {Quantity.Noun(file.RepeatedFrames, "replaces a lost frame", "replace lost frames")};";
        string late = file.LateFrames == 0 ? "" : $" {file.LateFrames} more came too late;";
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{file.FrameCount} {Quantity.Noun(file.FrameCount, "frame")} of {TerminalText.Clean(file.AvatarName)} at {file.FrameRate:0.##} Hz in {TerminalText.Clean(file.Path)};{repeated}{late} {body}.");
    }
}
