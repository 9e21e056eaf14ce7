namespace NeuronMocap.Delivery;

// The handlers of one event. Any thread adds and removes; the array is replaced and never changed.
internal class HandlerSet<T>
{
    private readonly object _lock = new();
    private volatile Action<T>[] _handlers = [];

    public bool IsEmpty => _handlers.Length == 0;

    public Action<T>[] All => _handlers;

    public void Add(Action<T>? handler)
    {
        if (handler is null)
            return;

        lock (_lock)
            _handlers = [.. _handlers, handler];
    }

    // Removes the last of several equal handlers, as delegates do.
    public void Remove(Action<T>? handler)
    {
        lock (_lock)
        {
            int index = Array.LastIndexOf(_handlers, handler);
            if (index >= 0)
                _handlers = [.. _handlers.AsSpan(0, index), .. _handlers.AsSpan(index + 1)];
        }
    }
}

// Each call is separate, so an exception from one handler stops neither the other handlers nor the caller.
internal class HandlerList<T>(Action<Exception> failed) : HandlerSet<T>
{
    public void Invoke(T argument)
    {
        foreach (Action<T> handler in All)
        {
            try
            {
                handler(argument);
            }
            catch (Exception exception)
            {
                failed(exception);
            }
        }
    }
}
