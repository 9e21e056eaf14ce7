using System.Collections.Immutable;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>A take that is open in the page. It can be read while a thread still reads its file. Thread-safe.</summary>
internal sealed class Take : IDisposable
{
    private const int MostProblems = 20;

    private readonly Lock _lock = new();
    private readonly CancellationTokenSource _stop = new();
    private ImmutableArray<TakePerformer> _performers = [];
    private ImmutableArray<string> _problems = [];
    private double _progress;
    private long _moreProblems;
    private bool _isDisposed;

    /// <param name="id">Identifies the take.</param>
    /// <param name="name">Name of the file, as a person knows it.</param>
    /// <param name="path">Where the file is.</param>
    /// <param name="kind">The kind of file, by its contents.</param>
    public Take(string id, string name, string path, FileKind kind) => (Id, Name, Path, Kind) = (id, name, path, kind);

    public string Id { get; }

    public string Name { get; }

    public string Path { get; }

    public FileKind Kind { get; }

    /// <summary>Whether the file is deleted with the take.</summary>
    public bool IsUpload { get; init; }

    /// <summary>Rotation order of a stream in the file; null for the order that the file states, or YXZ.</summary>
    public RotationOrder? RotationOrder { get; init; }

    /// <summary>Whether the take was closed before, so that pages know frames that its second reading has yet to reach.</summary>
    public bool IsAgain { get; private init; }

    /// <summary>Cancelled when the take is closed.</summary>
    public CancellationToken Closed => _stop.Token;

    /// <summary>Completes when the whole file was read. It does not fail: faults are among the problems.</summary>
    public Task Completion { get; private set; } = Task.CompletedTask;

    /// <summary>How much of the file was read, 0 to 1.</summary>
    public double Progress => Volatile.Read(ref _progress);

    /// <summary>Time of the last frame that can be read.</summary>
    public TimeSpan Duration
    {
        get
        {
            long end = 0;
            foreach (TakePerformer performer in Performers)
                end = Math.Max(end, performer.Frames == 0 ? 0 : performer.Times.End);

            return TimeSpan.FromMicroseconds(end);
        }
    }

    public ImmutableArray<TakePerformer> Performers
    {
        get
        {
            lock (_lock)
                return _performers;
        }
    }

    /// <summary>What is wrong with the file, in sentences.</summary>
    public ImmutableArray<string> Problems
    {
        get
        {
            lock (_lock)
                return _moreProblems == 0 ? _problems : _problems.Add($"{_moreProblems} more problems are not listed.");
        }
    }

    /// <summary>Finds a performer; the first one for an empty key. Null if there is none.</summary>
    public TakePerformer? Find(string? key)
    {
        ImmutableArray<TakePerformer> all = Performers;
        return string.IsNullOrEmpty(key) ? all.FirstOrDefault() : all.FirstOrDefault(performer => string.Equals(performer.Key, key, StringComparison.Ordinal));
    }

    /// <summary>Makes the take as it was before its file was read.</summary>
    public Take CopyUnread() => new(Id, Name, Path, Kind) { IsUpload = IsUpload, RotationOrder = RotationOrder, IsAgain = true };

    /// <summary>Waits until the take has all that pages know of it.</summary>
    public Task WaitUntilKnownAsync(CancellationToken cancellationToken) => IsAgain ? Completion.WaitAsync(cancellationToken) : Task.CompletedTask;

    /// <summary>Reads the file on another thread.</summary>
    public void Start(Action read) => Completion = Task.Run(read, CancellationToken.None);

    public void Report(double progress) => Volatile.Write(ref _progress, Math.Clamp(progress, 0, 1));

    public void Add(TakePerformer performer)
    {
        lock (_lock)
        {
            if (_isDisposed)
            {
                performer.Dispose();
                throw new OperationCanceledException();
            }

            _performers = _performers.Add(performer);
        }
    }

    public void AddProblem(string sentence)
    {
        lock (_lock)
        {
            if (_problems.Length < MostProblems)
                _problems = _problems.Add(sentence);
            else
                _moreProblems++;
        }
    }

    /// <summary>Stops reading and deletes what was stored. The file itself stays.</summary>
    public void Dispose()
    {
        _stop.Cancel();
        lock (_lock)
        {
            _isDisposed = true;
            foreach (TakePerformer performer in _performers)
                performer.Dispose();
        }
    }
}
