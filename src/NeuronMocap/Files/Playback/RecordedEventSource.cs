using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Recording;

// What a file holds of a stream, in the order in which it happened. One thread at a time.
internal abstract class RecordedEventSource(string path) : IDisposable
{
    public string FileName => Path.GetFileName(path);

    public string FilePath => path;

    // When the end comes: never before the last arrival.
    public abstract TimeSpan Duration { get; }

    // What the recording says about its frames; null where it does not.
    public virtual RotationOrder? RotationOrder => null;

    public virtual SkeletonVariant? SkeletonVariant => null;

    public virtual int MaxValues => ProtocolConstants.DefaultMaxValues;

    // What it is, its first bytes tell.
    public static RecordedEventSource Open(string path, PlaybackOptions options)
    {
        // Others may be writing it.
        var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 1);
        try
        {
            if (!RecordingReader.IsRecording(file))
                return RawDumpSource.Open(path, file, options);
            if (options.FrameRate is not null)
                throw new ArgumentException("FrameRate is for raw dumps; this recording knows when each byte came.", nameof(options));

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
        var format = new FrameFormat(order, variant) { FormatOrigin = "the recording" };
        format.Learn(RotationOrder, SkeletonVariant);
        return format;
    }

    // The next arrival; at the end, and ever after, ArrivalKind.End.
    public abstract RecordedEvent Read();

    // Goes on at a place at or before a time, from which on arrivals can be read; zero for the very start. True when it is the start.
    public abstract bool Seek(TimeSpan time);

    public abstract void Dispose();
}
