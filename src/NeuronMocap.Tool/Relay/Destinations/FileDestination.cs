using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Watch.Export;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>A file to write.</summary>
/// <param name="Text">The argument of the command line.</param>
internal abstract record FileDestination(string Text) : Destination(Text)
{
    public override string File => Text;

    public override bool IsSame(Destination other) => other.File is { } file && SameFile.IsSame(file, Text);
}

/// <summary>FILE.nmrec: records every byte, with the time of its arrival.</summary>
/// <param name="Text">The file.</param>
internal sealed record RecordingDestination(string Text) : FileDestination(Text)
{
    public override Outlet Open(NeuronReader reader, bool overwrite)
    {
        var takes = new TakeRecorder(reader, new RecordingSettings(Text, new() { Overwrite = overwrite }) { Argument = Text });
        return takes.TryBegin(out string? error) ? new RecordingOutlet(takes, Text) : throw new RelayException(error!);
    }
}

/// <summary>FILE.bvh: exports the motion of the first avatar that arrives.</summary>
/// <param name="Text">The file.</param>
internal sealed record BvhDestination(string Text) : FileDestination(Text)
{
    public override Outlet Open(NeuronReader reader, bool overwrite)
    {
        try
        {
            var settings = new ExportSettings(Text, overwrite, Avatar: null, FilePerAvatar: false) { Argument = Text };
            return new BvhOutlet(ExportRun.Begin(reader, settings, frames: null), Text);
        }
        catch (ExportException exception)
        {
            throw new RelayException(exception.Message);
        }
    }
}
