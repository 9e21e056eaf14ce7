using NeuronMocap.Files;
using NeuronMocap.Skeleton;
using static System.FormattableString;

namespace NeuronMocap.Bvh;

// Assigns frames to the files of an export. Runs on the export's thread; any thread may read Snapshot and Ignored.
internal sealed class BvhExportFiles
{
    // A limit above any real number of avatars. A malicious stream must not fill a folder.
    private const int MaxAvatars = 64;
    private const int MaxParts = 100;

    private readonly string _path;
    private readonly BvhExportOptions _options;
    private readonly BvhExportBodies _bodies;
    private readonly Func<string, Stream> _open;
    private readonly Dictionary<(int Sender, int Avatar), Take> _takes = [];
    private readonly List<Take> _begun = [];

    // Only files created here may be deleted. A path that existed before may be anything, for example a device.
    private readonly HashSet<string> _made = new(StringComparer.Ordinal);
    private Stream? _first;
    private volatile BvhExportFile[] _snapshot = [];
    private long _ignored;
    private long _received;
    private long _taken;

    /// <summary>Opens the file immediately if there is only one. The caller then learns of a wrong name at once.</summary>
    public BvhExportFiles(string path, BvhExportOptions options, BvhExportBodies bodies, Func<string, Stream>? open = null)
    {
        _path = path;
        _options = options;
        _bodies = bodies;
        _open = open ?? OpenFile;
        _first = options.FilePerAvatar ? null : Open(path);
    }

    public IReadOnlyList<BvhExportFile> Snapshot => _snapshot;

    public long Ignored => Volatile.Read(ref _ignored);

    // Valid after Close: the number of received frames that are in no file because the disk failed.
    public long Cut { get; private set; }

    public bool IsFull => _taken >= _options.MaxFrames;

    public void Write(MotionFrame frame)
    {
        if (IsFull)
            return;

        _received++;
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

    /// <summary>Completes all files. A file without frames, or of which nothing could be written, is deleted.</summary>
    /// <returns>The failure to complete a file; null if all files are complete.</returns>
    public Exception? Close()
    {
        Exception? failure = null;
        foreach (Take take in _takes.Values)
        {
            try
            {
                CloseWriter(take);
            }
            catch (Exception exception)
            {
                // The other files are closed whatever the exception is.
                failure = exception;
            }
        }

        Cut = _received - _ignored - _begun.Sum(static take => take.Received);
        _begun.RemoveAll(static take => take.IsDeleted);
        _snapshot = [.. _begun.Select(static take => take.Describe())];
        try
        {
            if (_first is { } unused)
                CloseUnused(unused, _path);
        }
        catch (Exception exception)
        {
            failure ??= exception;
        }

        return failure;
    }

    // Further calls have no effect.
    private void CloseWriter(Take take)
    {
        if (take.IsClosed)
            return;

        take.IsClosed = true;
        try
        {
            take.Writer.Flush();
        }
        finally
        {
            take.IsDeleted = take.Writer.FrameCount == 0 && DeleteIfEmpty(take.Path);
            take.Writer.Dispose();
        }
    }

    private void CloseUnused(Stream stream, string path)
    {
        DeleteIfEmpty(path);
        stream.Dispose();
    }

    // Deletes while the file is still open. No other writer can have it then.
    private bool DeleteIfEmpty(string path)
    {
        var file = new FileInfo(path);
        if (!_made.Contains(path) || !file.Exists || file.Length > 0)
            return false;

        try
        {
            file.Delete();
            return true;
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }

    private Stream Open(string path)
    {
        bool isNew = !File.Exists(path);
        Stream stream = _open(path);
        if (isNew)
            _made.Add(path);

        return stream;
    }

    // A file that is to be replaced keeps its content until the first frame.
    private FileStream OpenFile(string path) => _options.Overwrite ? WritableFile.OpenOrCreate(path) : WritableFile.CreateNew(path);

    private Take? FindTake(MotionFrame frame)
    {
        var key = (frame.Sender, frame.AvatarIndex);
        if (_takes.TryGetValue(key, out Take? take))
            return take;

        bool isWanted = _options.AvatarIndex is { } wanted ? wanted == frame.AvatarIndex : _options.FilePerAvatar || _takes.Count == 0;
        if (!isWanted || _takes.Count == (_options.FilePerAvatar ? MaxAvatars : 1))
            return null;

        return Begin(frame, part: 1);
    }

    private Take BeginNextPart(Take take, MotionFrame frame)
    {
        CloseWriter(take);
        if (take.Part == MaxParts)
            throw new NeuronException($"The server changed the layout or rotation order of avatar {frame.AvatarIndex} {MaxParts} times. The export ends.");

        return Begin(frame, take.Part + 1);
    }

    private Take Begin(MotionFrame frame, int part)
    {
        string path = PathOf(frame, part);
        (SkeletonBody? body, BvhBodyOrigin source) = _bodies.Find(frame);
        Stream stream = _first ?? Open(path);
        _first = null;
        BvhTakeWriter writer;
        try
        {
            writer = CreateWriter(stream, body);
        }
        catch
        {
            CloseUnused(stream, path);
            throw;
        }

        var take = new Take(writer, path, part, frame.AvatarIndex, frame.AvatarName, source);
        _takes[(frame.Sender, frame.AvatarIndex)] = take;
        _begun.Add(take);
        return take;
    }

    private BvhTakeWriter CreateWriter(Stream stream, SkeletonBody? body)
    {
        if (stream.Length > 0)
            stream.SetLength(0);

        var options = new BvhTakeOptions
        {
            Body = body,
            FrameTime = _options.FrameTime,
            GapHandling = _options.GapHandling,
            TextFormat = _options.TextFormat,
        };
        return new BvhTakeWriter(stream, options);
    }

    private string PathOf(MotionFrame frame, int part)
    {
        string suffix = !_options.FilePerAvatar ? ""
            : frame.Sender == 0 ? Invariant($"-avatar{frame.AvatarIndex}")
            : Invariant($"-sender{frame.Sender}-avatar{frame.AvatarIndex}");
        suffix += part == 1 ? "" : Invariant($"-part{part}");
        return suffix.Length == 0
            ? _path
            : Path.Combine(Path.GetDirectoryName(_path) ?? "", Path.GetFileNameWithoutExtension(_path) + suffix + Path.GetExtension(_path));
    }

    private sealed class Take(BvhTakeWriter writer, string path, int part, int avatarIndex, string avatarName, BvhBodyOrigin bodySource)
    {
        public BvhTakeWriter Writer => writer;

        public string Path => path;

        public int Part => part;

        // Number of frames in the file plus the frames that arrived out of order.
        public int Received => writer.FrameCount - writer.RepeatedFrames + writer.LateFrames;

        public bool IsChanged { get; set; }

        public bool IsClosed { get; set; }

        public bool IsDeleted { get; set; }

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
