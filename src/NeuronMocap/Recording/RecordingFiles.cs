using System.Globalization;

namespace NeuronMocap.Recording;

// The files of one recording, one after the other. The time of all calls is the recording's, never before that of the last.
internal sealed class RecordingFiles : IDisposable
{
    // ERROR_FILE_EXISTS.
    private const int FileExists = unchecked((int)0x8007_0050);

    private readonly string _path;
    private readonly RecordingOptions _options;
    private readonly Func<string, RecordingOptions, Stream> _open;
    private readonly Queue<string> _kept = [];
    private Stream _stream;
    private RecordingWriter _writer;
    private TimeSpan _start;
    private long _closedBytes;
    private long _writtenBytes;
    private volatile string _currentPath;
    private volatile int _count;

    // Throws what the system throws when the first file cannot be made.
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
        _kept.Enqueue(_currentPath);
        _count = 1;
    }

    // Any thread, as the two that follow.
    public string CurrentPath => _currentPath;

    public int Count => _count;

    public long WrittenBytes => Volatile.Read(ref _writtenBytes);

    // The writer of the file into which the next piece goes.
    public RecordingWriter Prepare(TimeSpan time, int length, out TimeSpan timeInFile)
    {
        if (IsFull(time - _start, length))
            Rotate(time);

        timeInFile = time - _start;
        return _writer;
    }

    public void Flush()
    {
        _writer.Flush();
        if (_options.FlushToDisk && _stream is FileStream file)
            file.Flush(flushToDisk: true);

        Volatile.Write(ref _writtenBytes, _closedBytes + _writer.WrittenLength);
    }

    public void Dispose()
    {
        _writer.Dispose();
        Volatile.Write(ref _writtenBytes, _closedBytes + _writer.WrittenLength);
    }

    // A file that has nothing in it yet takes anything: else there would be no end of files.
    private bool IsFull(TimeSpan time, int length) => _writer.Totals != default
        && (time >= _options.MaxFileDuration || _writer.LengthWith(length) > _options.MaxFileSize);

    private void Rotate(TimeSpan time)
    {
        string path = NameOf(Count + 1);
        Stream stream = _open(path, _options);
        RecordingWriter next = Begin(stream, file => _writer.ContinueIn(file, time - _start));
        RecordingWriter last = _writer;
        (_stream, _writer, _start, _currentPath) = (stream, next, time, path);
        _count++;
        last.Dispose();
        _closedBytes += last.WrittenLength;
        _kept.Enqueue(path);
        while (_kept.Count > (_options.MaxFiles ?? int.MaxValue))
            File.Delete(_kept.Dequeue());
    }

    // Those of an earlier recording, whose first files may be deleted: this one would come to them hours later, and end there.
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
                throw new IOException($"The file '{file}' already exists, and this recording would come to it.", FileExists);
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

    // take.nmrec becomes take.0001.nmrec, where there may be several.
    private string NameOf(int number) => _options.HasNumbers
        ? Path.ChangeExtension(_path, number.ToString("0000", CultureInfo.InvariantCulture) + Path.GetExtension(_path))
        : _path;

    // Others may read the file meanwhile. A block is one write, so that buffering would only copy.
    private static FileStream OpenFile(string path, RecordingOptions options) => new(
        path, options.Overwrite ? FileMode.Create : FileMode.CreateNew, FileAccess.Write, FileShare.Read | FileShare.Delete, bufferSize: 1);
}
