using System.Collections.ObjectModel;
using System.ComponentModel;
using System.Diagnostics;
using System.Runtime.ExceptionServices;
using NeuronMocap.Delivery;

namespace NeuronMocap;

/// <summary>What a window shows of a reader: state, message, rates and avatars, for data binding in XAML and Windows Forms.</summary>
/// <remarks>
/// <para>
/// Make it on the window's thread. Properties and the list change on that thread and nowhere else, at most
/// <see cref="ObservableReaderOptions.UpdateRate"/> times a second, and only if something has changed. It does not own the reader.
/// </para>
/// <para>
/// It ends when it is disposed, when the reader has stopped, or when the context is gone. It shows the last state of the reader, also after the reader is
/// disposed.
/// </para>
/// <para>
/// An exception of a handler goes to the context, and thus to the application's own handler, after all changes have been reported. Of several exceptions,
/// it is the first.
/// </para>
/// </remarks>
public sealed class ObservableReader : INotifyPropertyChanged, IContextWork, IDisposable
{
    private static readonly PropertyChangedEventArgs StateChanged = new(nameof(State));
    private static readonly PropertyChangedEventArgs ReasonChanged = new(nameof(Reason));
    private static readonly PropertyChangedEventArgs MessageChanged = new(nameof(Message));
    private static readonly PropertyChangedEventArgs IsConnectedChanged = new(nameof(IsConnected));
    private static readonly PropertyChangedEventArgs FrameRateChanged = new(nameof(FrameRate));
    private static readonly PropertyChangedEventArgs FramesChanged = new(nameof(Frames));
    private static readonly PropertyChangedEventArgs LostChanged = new(nameof(Lost));
    private static readonly PropertyChangedEventArgs DroppedChanged = new(nameof(Dropped));

    private readonly NeuronReader _reader;
    private readonly DeliveryClock _ticker;
    private readonly ContextRunner _runner;
    private readonly long _interval;
    private readonly ObservableCollection<ObservableAvatar> _avatars = [];
    private readonly Dictionary<(int Sender, int AvatarIndex), AvatarTotals> _totals = [];
    private ReaderStatistics _seen;
    private ConnectionState _state;
    private ConnectionReason _reason;
    private string _message;
    private bool _isConnected;
    private double _frameRate;
    private long _frames;
    private long _lost;
    private long _dropped;
    private ExceptionDispatchInfo? _failure;
    private int _isTicking;
    private volatile bool _hasRates;
    private volatile bool _isDue;
    private volatile bool _hasEnded;

    /// <summary>Makes an object that follows a reader, before or after the reader starts.</summary>
    /// <param name="reader">The reader.</param>
    /// <param name="options">On which context and how often to update; copied. Null for the context of this thread, 4 times a second.</param>
    /// <exception cref="InvalidOperationException">
    /// This thread has no <see cref="SynchronizationContext"/>, and the options name none; the message says what to set.
    /// </exception>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    public ObservableReader(NeuronReader reader, ObservableReaderOptions? options = null)
        : this(reader, options, new SystemDeliveryClock(), new SystemDeliveryClock())
    {
    }

    internal ObservableReader(NeuronReader reader, ObservableReaderOptions? options, DeliveryClock ticker, DeliveryClock clock)
    {
        ArgumentNullException.ThrowIfNull(reader);
        ObservableReaderOptions how = options?.Copy() ?? new ObservableReaderOptions();
        if (how.FindFault() is { } fault)
            throw new ArgumentException(fault, nameof(options));

        _reader = reader;
        _interval = (long)(Stopwatch.Frequency / how.UpdateRate);
        _runner = new ContextRunner(how.Context, how.Post, clock, this);
        _ticker = ticker;
        _ticker.Elapsed = OnTick;
        Avatars = new ReadOnlyObservableCollection<ObservableAvatar>(_avatars);
        _message = string.Empty;
        ShowStatus(reader.Status);
        reader.StatusChanged += OnStatus;
        if (reader.Status.State != ConnectionState.Created)
            OnStatus(reader.Status);
    }

    /// <summary>Occurs on the context after a property has changed.</summary>
    public event PropertyChangedEventHandler? PropertyChanged;

    /// <summary>State of the connection.</summary>
    public ConnectionState State => _state;

    /// <summary>The reason for the state.</summary>
    public ConnectionReason Reason => _reason;

    /// <summary>The state in one or two English sentences for people.</summary>
    public string Message => _message;

    /// <summary>Whether the connection is established, regardless of what arrives.</summary>
    public bool IsConnected => _isConnected;

    /// <summary>Motion frames per second of all avatars together, rounded to a tenth.</summary>
    public double FrameRate => _frameRate;

    /// <summary>Number of frames received, of all kinds.</summary>
    public long Frames => _frames;

    /// <summary>Number of frames that the server sent but that did not arrive.</summary>
    public long Lost => _lost;

    /// <summary>Number of received frames that were dropped because a queue of this program was full.</summary>
    public long Dropped => _dropped;

    /// <summary>The avatars, in order of appearance. The list and its items change on the context.</summary>
    public ReadOnlyObservableCollection<ObservableAvatar> Avatars { get; }

    /// <summary>
    /// Ends the updates; the reader continues. Any thread, any number of times. After a call on the context's thread, nothing changes any more, except that
    /// an update that is running finishes.
    /// </summary>
    public void Dispose()
    {
        if (_hasEnded)
            return;

        _hasEnded = true;
        _reader.StatusChanged -= OnStatus;
        _runner.Dispose();
        _ticker.Dispose();
    }

    // A thread of the reader. Before the reader starts, nothing changes and there are no ticks.
    private void OnStatus(ConnectionStatus status)
    {
        if (_hasEnded)
            return;

        if (Interlocked.Exchange(ref _isTicking, 1) == 0)
            _ticker.Set(_interval);

        _isDue = true;
        _runner.Request(isUrgent: true);
    }

    // A pool thread. Nothing is posted if nothing has changed.
    private void OnTick()
    {
        if (_hasEnded)
            return;

        ReaderStatistics statistics = _reader.GetStatistics();
        if (statistics != _seen || _hasRates)
        {
            _seen = statistics;
            _isDue = true;
            _runner.Request();
        }

        _ticker.Set(_interval);
    }

    void IContextWork.Work(long limit)
    {
        _isDue = false;
        ConnectionStatus status = _reader.Status;
        ShowAvatars(isRunning: status.State != ConnectionState.Stopped);
        ShowStatus(status);
        if (status.State == ConnectionState.Stopped)
            Dispose();

        ExceptionDispatchInfo? failure = _failure;
        _failure = null;
        failure?.Throw();
    }

    bool IContextWork.TryGetDue(out long due)
    {
        due = 0;
        return _isDue && !_hasEnded;
    }

    void IContextWork.OnLost(FrameDeliveryEnd end) => Dispose();

    private void ShowStatus(ConnectionStatus status)
    {
        Set(ref _state, status.State, StateChanged);
        Set(ref _reason, status.Reason, ReasonChanged);
        Set(ref _message, status.Message, MessageChanged);
        Set(ref _isConnected, status.IsConnected, IsConnectedChanged);
    }

    // After the end, nothing would update the rates again: they are 0.
    private void ShowAvatars(bool isRunning)
    {
        long now = Stopwatch.GetTimestamp();
        _totals.Clear();
        foreach (AvatarStatistics statistics in _reader.GetAvatarStatistics())
        {
            (int Sender, int AvatarIndex) key = (statistics.Sender, statistics.AvatarIndex);
            _totals.TryGetValue(key, out AvatarTotals totals);
            _totals[key] = totals.Add(statistics, now, isRunning);
        }

        ReaderStatistics reader = _reader.GetStatistics();
        double frameRate = Math.Round(_totals.Values.Sum(static totals => totals.FrameRate), 1);
        _hasRates = _totals.Values.Any(static totals => totals.FrameRate + totals.CalculationRate > 0);
        Set(ref _frameRate, frameRate, FrameRateChanged);
        Set(ref _frames, reader.Frames, FramesChanged);
        Set(ref _lost, reader.Lost, LostChanged);
        Set(ref _dropped, reader.Dropped, DroppedChanged);
        UpdateList();
    }

    // The reader forgets avatars only to make room for others.
    private void UpdateList()
    {
        for (int i = _avatars.Count - 1; i >= 0; i--)
        {
            ObservableAvatar avatar = _avatars[i];
            (int Sender, int AvatarIndex) key = (avatar.Sender, avatar.AvatarIndex);
            if (_totals.TryGetValue(key, out AvatarTotals totals))
                avatar.Update(totals, ref _failure);
            else
                ChangeList(i, added: null);

            _totals.Remove(key);
        }

        foreach (KeyValuePair<(int Sender, int AvatarIndex), AvatarTotals> entry in _totals)
        {
            var avatar = new ObservableAvatar(entry.Key.Sender, entry.Key.AvatarIndex);
            avatar.Update(entry.Value, ref _failure);
            ChangeList(_avatars.Count, avatar);
        }
    }

    // The list has changed when its handlers run. added: null to remove.
    private void ChangeList(int index, ObservableAvatar? added)
    {
        try
        {
            if (added is null)
                _avatars.RemoveAt(index);
            else
                _avatars.Insert(index, added);
        }
        catch (Exception exception)
        {
            _failure ??= ExceptionDispatchInfo.Capture(exception);
        }
    }

    private void Set<T>(ref T field, T value, PropertyChangedEventArgs changed)
    {
        if (PropertyChange.TrySet(ref field, value))
            PropertyChange.Raise(PropertyChanged, this, changed, ref _failure);
    }
}
