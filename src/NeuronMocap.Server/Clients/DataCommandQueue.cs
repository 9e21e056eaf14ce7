using NeuronMocap.Protocol;

namespace NeuronMocap.Server.Clients;

/// <summary>
/// What one client has asked for and not yet been sent. A reply is made when it is sent, and so tells the value of that moment; what waits is a
/// few bytes for each, and no more than a thousand requests. Safe on any thread.
/// </summary>
internal sealed class DataCommandQueue(DataCommandReplies replies)
{
    // More than a client of 256 avatars asks for in one go; one that does not read its replies gets no further.
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

    // Requests beyond the capacity.
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

    // A value has changed. Returns whether there is something to send.
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

    // The values of now are sent at once: else a client that wants to keep up would have to fetch them, too.
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

    // Of each value one at most waits, and it will tell the newest.
    private void EnqueuePush(DataCommandId id, int avatar)
    {
        var entry = new Entry(id, avatar, IsPush: true);
        if (_pushes.Add(entry))
            _waiting.Enqueue(entry);
    }

    private readonly record struct Entry(DataCommandId Id, int Avatar, bool IsPush);
}
