namespace NeuronMocap.Compatibility.Callbacks;

// One callback and the object that is passed to it. Both change together, but the callback may stand in a public field, which programs also
// set without asking; they then get the object that was registered last.
internal sealed class CallbackSlot<THandler>
    where THandler : Delegate
{
    private readonly object _lock = new();
    private IntPtr _customObject;

    public void Set(ref THandler? field, IntPtr customObject, THandler? handler)
    {
        lock (_lock)
        {
            field = handler;
            _customObject = customObject;
        }
    }

    public THandler? Get(ref THandler? field, out IntPtr customObject)
    {
        lock (_lock)
        {
            customObject = _customObject;
            return field;
        }
    }
}
