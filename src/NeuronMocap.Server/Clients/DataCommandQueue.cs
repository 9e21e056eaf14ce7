using NeuronMocap.Protocol;

namespace NeuronMocap.Server.Clients;

/// <summary>The requests of one client that have not been answered yet. Thread-safe.</summary>
/// <remarks>
/// A reply is made when it is sent, so it carries the value of that moment. A waiting request takes a few bytes, and at most
/// <see cref="Capacity"/> requests wait.
/// </remarks>
internal sealed class DataCommandQueue(DataCommandReplies replies)
{
    // More than a client of 256 avatars requests at once. A client that does not read its replies cannot queue more.
    public const int Capacity = 1024;

    private readonly object _lock = new();
    private readonly Queue<Entry> _waiting = new();
    private readonly HashSet<Entry> _pushes = [];
    private readonly HashSet<DataCommandId> _registered = [];
    private int _requests;
    private long _ignored;
    private long _dropped;

    // Requests that have no answer.
    public long Ignored => Interlocked.Read(ref _ignored);

    // Requests that exceeded the capacity.
    public long Dropped => Interlocked.Read(ref _dropped);

    public bool IsEmpty
    {
        get
        {
            lock (_lock)
                return _waiting.Count == 0;
        }
    }

    // Returns whether there is something to send.
    public bool Accept(in DataCommandHeader request)
    {
        lock (_lock)
        {
            var id = (DataCommandId)request.Parameter;
            bool isKnown = request.CommandId switch
            {
                DataCommandId.RegisterEvent => Register(id),
                DataCommandId.UnregisterEvent => replies.CountValues(id) > 0,
                _ => replies.Has(request.CommandId, request.Parameter),
            };
            if (!isKnown)
                Interlocked.Increment(ref _ignored);
            else if (request.CommandId == DataCommandId.UnregisterEvent)
                _registered.Remove(id);
            else if (request.CommandId != DataCommandId.RegisterEvent)
                Enqueue(new Entry(request.CommandId, request.Parameter, IsPush: false));

            return _waiting.Count > 0;
        }
    }

    // Called when a value has changed. Returns whether there is something to send.
    public bool Push(DataCommandId id, int avatar)
    {
        lock (_lock)
        {
            if (!_registered.Contains(id))
                return false;

            EnqueuePush(id, avatar);
            return true;
        }
    }

    public bool TryTake(out DataCommandId id, out int avatar)
    {
        lock (_lock)
        {
            bool found = _waiting.TryDequeue(out Entry entry);
            if (found && entry.IsPush)
                _pushes.Remove(entry);
            else if (found)
                _requests--;

            (id, avatar) = (entry.Id, entry.Avatar);
            return found;
        }
    }

    // The current values are sent at once. Otherwise a client that wants to stay current would also have to request them.
    private bool Register(DataCommandId id)
    {
        int count = replies.CountValues(id);
        if (count == 0)
            return false;

        _registered.Add(id);
        for (int avatar = 0; avatar < count; avatar++)
            EnqueuePush(id, avatar);

        return true;
    }

    private void Enqueue(Entry request)
    {
        if (_requests == Capacity)
        {
            Interlocked.Increment(ref _dropped);
            return;
        }

        _requests++;
        _waiting.Enqueue(request);
    }

    // At most one push of each value waits. It will carry the newest value.
    private void EnqueuePush(DataCommandId id, int avatar)
    {
        var entry = new Entry(id, avatar, IsPush: true);
        if (_pushes.Add(entry))
            _waiting.Enqueue(entry);
    }

    private readonly record struct Entry(DataCommandId Id, int Avatar, bool IsPush);
}
