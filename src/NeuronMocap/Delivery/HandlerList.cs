namespace NeuronMocap.Delivery;

// The handlers of one event. Each is called by itself, so that one that throws keeps neither the others nor the caller from going on.
internal class HandlerList<T>(Action<Exception> failed)
{
    private readonly object _lock = new();
    private volatile Action<T>[] _handlers = [];

    public bool IsEmpty => _handlers.Length == 0;

    public void Add(Action<T>? handler)
    {
        if (handler is null)
            return;

        lock (_lock)
            _handlers = [.. _handlers, handler];
    }

    // As delegates do: the last one added of those that are equal.
    public void Remove(Action<T>? handler)
    {
        lock (_lock)
        {
            int index = Array.LastIndexOf(_handlers, handler);
            if (index >= 0)
                _handlers = [.. _handlers[..index], .. _handlers[(index + 1)..]];
        }
    }

    public void Invoke(T argument)
    {
        foreach (Action<T> handler in _handlers)
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
