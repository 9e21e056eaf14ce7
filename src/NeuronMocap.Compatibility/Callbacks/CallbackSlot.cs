namespace NeuronMocap.Compatibility.Callbacks;

// One callback and the object that is passed to it. Registration changes both together. The callback may also be a public field, which programs can
// set directly. Such a callback gets the object that was registered last.
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
