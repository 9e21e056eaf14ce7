namespace NeuronMocap.Delivery;

// Finds the distance between the indices of one kind of frame: the smallest step of the last frames. Lost frames only make steps larger. Receive thread only.
internal sealed class IndexGrid
{
    private const int Length = 32;

    private uint _smallest = uint.MaxValue;
    private uint _smallestBefore = uint.MaxValue;
    private int _steps;

    public uint Step => Math.Min(_smallest, _smallestBefore);

    public void Add(uint step)
    {
        _smallest = Math.Min(_smallest, step);
        if (++_steps < Length)
            return;

        (_smallestBefore, _smallest, _steps) = (_smallest, uint.MaxValue, 0);
    }

    public void Reset() => (_smallestBefore, _smallest, _steps) = (uint.MaxValue, uint.MaxValue, 0);
}
