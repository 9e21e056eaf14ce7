using System.Globalization;
using NeuronMocap.Files;

namespace NeuronMocap.Recording;

// Manages the successive files of one recording. All times are relative to the start of the recording and never decrease.
internal sealed class RecordingFiles : IDisposable
{
    // ERROR_FILE_EXISTS.
    private const int FileExists = unchecked((int)0x8007_0050);

    private readonly string _path;
    private readonly RecordingOptions _options;
    private readonly Func<string, RecordingOptions, Stream> _open;
    private readonly List<string> _kept = [];
    private Stream _stream;
    private RecordingWriter _writer;
    private TimeSpan _start;
    private RecordingTotals _closedTotals;
    private long _closedBytes;
    private long _writtenBytes;
    private long _pieces;
    private long _pieceBytes;
    private long _writtenTime;
    private volatile string _currentPath;
    private volatile int _count;
    private volatile int _undeleted;
    private volatile string? _undeletedReason;

    // If the first file cannot be created, the exception of the system reaches the caller.
    public RecordingFiles(
        string path, RecordingOptions options, RecordingMetadata metadata, DateTimeOffset startTime, Func<string, RecordingOptions, Stream>? open = null)
    {
        _path = path;
        _options = options;
        _open = open ?? OpenFile;
        _currentPath = NameOf(1);
        RefuseLaterFiles();
        _stream = _open(_currentPath, options);
        _writer = Begin(
            _stream, stream => new RecordingWriter(stream, metadata, new RecordingWriterOptions { StartTime = startTime, Compress = options.Compress }));
        _kept.Add(_currentPath);
        _count = 1;
    }

    // Any thread may read this property and those that follow.
    public string CurrentPath => _currentPath;

    public int Count => _count;

    // These four describe the data that the system has accepted.
    public long WrittenBytes => Volatile.Read(ref _writtenBytes);

    public long Pieces => Volatile.Read(ref _pieces);

    public long PieceBytes => Volatile.Read(ref _pieceBytes);

    public TimeSpan WrittenTime => new(Volatile.Read(ref _writtenTime));

    // Number of old files that could not be deleted, and the reason.
    public int Undeleted => _undeleted;

    public string? UndeletedReason => _undeletedReason;

    // Returns the writer of the file that receives the next piece.
    public RecordingWriter Prepare(TimeSpan time, int length, out TimeSpan timeInFile)
    {
        if (IsFull(time - _start, length))
            Rotate(time);

        Publish();
        timeInFile = time - _start;
        return _writer;
    }

    public void Flush()
    {
        _writer.Flush();
        if (_options.FlushToDisk && _stream is FileStream file)
            file.Flush(flushToDisk: true);

        Publish();
    }

    public void Dispose()
    {
        try
        {
            _writer.Dispose();
        }
        finally
        {
            Publish();
        }
    }

    private void Publish()
    {
        Volatile.Write(ref _writtenBytes, _closedBytes + _writer.WrittenLength);
        Volatile.Write(ref _pieces, _closedTotals.Pieces + _writer.WrittenTotals.Pieces);
        Volatile.Write(ref _pieceBytes, _closedTotals.Bytes + _writer.WrittenTotals.Bytes);

        // While the system has accepted nothing of a file, the time of the previous file remains.
        if (_writer.WrittenDuration > TimeSpan.Zero)
            Volatile.Write(ref _writtenTime, (_start + _writer.WrittenDuration).Ticks);
    }

    // An empty file accepts a piece of any size. Otherwise, new files would begin without end.
    private bool IsFull(TimeSpan time, int length) => _writer.Totals != default
        && (time >= _options.MaxFileDuration || _writer.LengthWith(length) > _options.MaxFileSize);

    private void Rotate(TimeSpan time)
    {
        string path = NameOf(Count + 1);
        Stream stream = _open(path, _options);
        RecordingWriter next = Begin(stream, file => _writer.ContinueIn(file, time - _start));
        (RecordingWriter last, TimeSpan lastStart) = (_writer, _start);
        (_stream, _writer, _start, _currentPath) = (stream, next, time, path);
        _count++;
        _kept.Add(path);
        try
        {
            last.Dispose();
        }
        finally
        {
            Volatile.Write(ref _writtenTime, Math.Max(WrittenTime.Ticks, (lastStart + last.WrittenDuration).Ticks));
            _closedBytes += last.WrittenLength;
            _closedTotals = new RecordingTotals(_closedTotals.Pieces + last.WrittenTotals.Pieces, _closedTotals.Bytes + last.WrittenTotals.Bytes, 0, 0);
        }

        DeleteOldFiles();
    }

    // A file may be undeletable, for example because a program has it open. The recording continues, and the next file triggers another attempt.
    private void DeleteOldFiles()
    {
        int old = Math.Max(0, _kept.Count - (_options.MaxFiles ?? int.MaxValue));
        int undeleted = 0;
        for (int i = 0; i < old; i++)
        {
            string path = _kept[undeleted];
            try
            {
                File.Delete(path);
                _kept.RemoveAt(undeleted);
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
            {
                undeleted++;
                _undeletedReason = $"{path}: {exception.Message}";
            }
        }

        _undeleted = undeleted;
    }

    // Fails if later files of an earlier recording exist. Its first files may have been deleted. Otherwise, this recording would reach those names
    // hours later and end there.
    private void RefuseLaterFiles()
    {
        if (!_options.HasNumbers || _options.Overwrite)
            return;

        string path = Path.GetFullPath(_path);
        (string start, string end) = (Path.GetFileNameWithoutExtension(path) + ".", Path.GetExtension(path));
        string folder = Path.GetDirectoryName(path)!;
        foreach (string file in Directory.Exists(folder) ? Directory.EnumerateFiles(folder) : [])
        {
            string name = Path.GetFileName(file);
            bool isLike = name.Length > start.Length + end.Length
                && name.StartsWith(start, StringComparison.OrdinalIgnoreCase) && name.EndsWith(end, StringComparison.OrdinalIgnoreCase);
            if (isLike && int.TryParse(name.AsSpan(start.Length, name.Length - start.Length - end.Length), NumberStyles.None, CultureInfo.InvariantCulture, out _))
                throw new IOException($"'{file}' already exists, and this recording would reach its name.", FileExists);
        }
    }

    private static RecordingWriter Begin(Stream stream, Func<Stream, RecordingWriter> create)
    {
        try
        {
            return create(stream);
        }
        catch
        {
            stream.Dispose();
            throw;
        }
    }

    // If several files are possible, take.nmrec becomes take.0001.nmrec.
    private string NameOf(int number) => _options.HasNumbers
        ? Path.ChangeExtension(_path, number.ToString("0000", CultureInfo.InvariantCulture) + Path.GetExtension(_path))
        : _path;

    private static FileStream OpenFile(string path, RecordingOptions options) =>
        options.Overwrite ? WritableFile.Create(path) : WritableFile.CreateNew(path);
}
