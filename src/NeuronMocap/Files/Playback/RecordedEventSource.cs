using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Recording;

// Reads the events of a recorded stream, in order. Not thread-safe.
internal abstract class RecordedEventSource(string path) : IDisposable
{
    public string FileName => Path.GetFileName(path);

    public string FilePath => path;

    // The name in status messages.
    public virtual string Target => $"recording {FileName}";

    // What defines the format, in status messages.
    public virtual string Origin => "the recording";

    // The time of the end, never before the last event.
    public abstract TimeSpan Duration { get; }

    // The format of the frames according to the recording; null if unknown.
    public virtual RotationOrder? RotationOrder => null;

    public virtual SkeletonVariant? SkeletonVariant => null;

    public virtual int MaxValues => ProtocolConstants.DefaultMaxValues;

    // The first bytes of the file determine its kind.
    public static RecordedEventSource Open(string path, PlaybackOptions options)
    {
        FileStream file = RecordingReader.OpenFile(path);
        try
        {
            if (!RecordingReader.IsRecording(file))
                return RawDumpSource.Open(path, file, options);
            if (options.FrameRate is not null)
                throw new ArgumentException("FrameRate applies only to raw dumps; a recording contains the time of each byte.", nameof(options));

            return new RecordedStreamSource(path, RecordingReader.Open(file));
        }
        catch
        {
            file.Dispose();
            throw;
        }
    }

    public FrameFormat CreateFormat(RotationOrder? order, SkeletonVariant? variant)
    {
        var format = new FrameFormat(order, variant) { FormatOrigin = Origin };
        format.Learn(RotationOrder, SkeletonVariant);
        return format;
    }

    // Returns the next event. At the end, every further call returns RecordedEventKind.End.
    public abstract RecordedEvent Read();

    // Continues at a position at or before a time from which events can be read; zero is the start. Returns true at the start.
    public abstract bool Seek(TimeSpan time);

    public abstract void Dispose();
}
