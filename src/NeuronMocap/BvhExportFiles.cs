using System.Globalization;
using NeuronMocap.Bvh;
using NeuronMocap.Frames;
using NeuronMocap.Skeleton;

namespace NeuronMocap;

// The files of an export: which frame goes into which. The export's thread; the snapshot and the number of those ignored are for anyone.
internal sealed class BvhExportFiles
{
    // Nobody has more, and a stream that means harm shall not fill a folder.
    private const int MostAvatars = 64;
    private const int MostParts = 100;

    private readonly string _path;
    private readonly BvhExportOptions _options;
    private readonly BvhExportBodies _bodies;
    private readonly Dictionary<(int Source, int Avatar), Take> _takes = [];
    private readonly List<Take> _begun = [];
    private FileStream? _first;
    private volatile BvhExportFile[] _snapshot = [];
    private long _ignored;
    private long _taken;

    /// <summary>Opens the file, where there is one only: who gave a wrong name shall know at once.</summary>
    public BvhExportFiles(string path, BvhExportOptions options, BvhExportBodies bodies)
    {
        _path = path;
        _options = options;
        _bodies = bodies;
        _first = options.IsForEachAvatar ? null : Open(path);
    }

    public IReadOnlyList<BvhExportFile> Snapshot => _snapshot;

    public long Ignored => Volatile.Read(ref _ignored);

    public bool IsFull => _taken >= _options.MaxFrames;

    public void Write(MotionFrame frame)
    {
        if (IsFull)
            return;

        if (!frame.HasSkeleton || FindTake(frame) is not { } take)
        {
            Volatile.Write(ref _ignored, _ignored + 1);
            return;
        }

        if (!take.Writer.Accepts(frame))
            take = BeginNextPart(take, frame);

        take.Writer.Write(frame);
        take.IsChanged = true;
        _taken++;
    }

    public void Flush()
    {
        if (!_begun.Exists(static take => take.IsChanged))
            return;

        foreach (Take take in _takes.Values.Where(static take => take.IsChanged))
        {
            take.Writer.Flush();
            take.IsChanged = false;
        }

        _snapshot = [.. _begun.Select(static take => take.Describe())];
    }

    /// <summary>Completes all files. A file for which nothing came is not left behind.</summary>
    /// <returns>Why one could not be completed.</returns>
    public Exception? Close()
    {
        Exception? failure = null;
        foreach (Take take in _takes.Values)
        {
            try
            {
                take.Writer.Dispose();
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
            {
                failure = exception;
            }
        }

        _snapshot = [.. _begun.Select(static take => take.Describe())];
        if (_first is { } unused)
        {
            bool isEmpty = unused.Length == 0;
            unused.Dispose();
            if (isEmpty)
                File.Delete(_path);
        }

        return failure;
    }

    // A file that is replaced stays what it was until there is a first frame.
    private FileStream Open(string path) => BvhFile.Open(path, _options.IsOverwriting);

    private Take? FindTake(MotionFrame frame)
    {
        var key = (frame.Source, frame.AvatarIndex);
        if (_takes.TryGetValue(key, out Take? take))
            return take;

        bool isWanted = _options.AvatarIndex is { } wanted ? wanted == frame.AvatarIndex : _options.IsForEachAvatar || _takes.Count == 0;
        if (!isWanted || _takes.Count == (_options.IsForEachAvatar ? MostAvatars : 1))
            return null;

        return Begin(frame, part: 1);
    }

    private Take BeginNextPart(Take take, MotionFrame frame)
    {
        take.Writer.Dispose();
        if (take.Part == MostParts)
            throw new NeuronException($"The server changed layout or rotation order of avatar {frame.AvatarIndex} {MostParts} times; the export ends.");

        return Begin(frame, take.Part + 1);
    }

    private Take Begin(MotionFrame frame, int part)
    {
        string path = PathOf(frame, part);
        (SkeletonBody? body, BvhBodySource source) = _bodies.Find(frame);
        FileStream stream = _first ?? Open(path);
        _first = null;
        stream.SetLength(0);
        var options = new BvhTakeOptions
        {
            Body = body,
            FrameTime = _options.FrameTime,
            Gaps = _options.Gaps,
            TextFormat = _options.TextFormat,
        };
        var take = new Take(new BvhTakeWriter(stream, options), path, part, frame.AvatarIndex, frame.AvatarName, source);
        _takes[(frame.Source, frame.AvatarIndex)] = take;
        _begun.Add(take);
        return take;
    }

    private string PathOf(MotionFrame frame, int part)
    {
        string suffix = !_options.IsForEachAvatar ? ""
            : frame.Source == 0 ? Invariant($"-avatar{frame.AvatarIndex}")
            : Invariant($"-sender{frame.Source}-avatar{frame.AvatarIndex}");
        suffix += part == 1 ? "" : Invariant($"-part{part}");
        return suffix.Length == 0
            ? _path
            : Path.Combine(Path.GetDirectoryName(_path) ?? "", Path.GetFileNameWithoutExtension(_path) + suffix + Path.GetExtension(_path));
    }

    private static string Invariant(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    private sealed class Take(BvhTakeWriter writer, string path, int part, int avatarIndex, string avatarName, BvhBodySource bodySource)
    {
        public BvhTakeWriter Writer => writer;

        public int Part => part;

        public bool IsChanged { get; set; }

        public BvhExportFile Describe() => new(
            path,
            avatarIndex,
            avatarName,
            writer.FrameCount,
            writer.RepeatedFrames,
            writer.LateFrames,
            writer.FrameTime.FrameRate,
            bodySource);
    }
}
