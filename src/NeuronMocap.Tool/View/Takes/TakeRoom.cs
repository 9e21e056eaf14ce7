namespace NeuronMocap.Tool.View.Takes;

/// <summary>The bytes that all temporary files of one take may have. Not thread-safe: the thread that reads the take uses it.</summary>
/// <param name="bytes">The number of bytes.</param>
internal sealed class TakeRoom(long bytes)
{
    private long _left = bytes;

    /// <summary>Takes room for bytes that will be written.</summary>
    /// <returns>False if there is not enough room.</returns>
    public bool TryTake(int count)
    {
        if (count > _left)
            return false;

        _left -= count;
        return true;
    }
}
