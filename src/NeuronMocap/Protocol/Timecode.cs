namespace NeuronMocap;

/// <summary>The time of a clock that a server writes into its frames, such as the clock of a film set: hours, minutes, seconds and sub-frame.</summary>
/// <param name="Hours">0 to 23.</param>
/// <param name="Minutes">0 to 59.</param>
/// <param name="Seconds">0 to 59.</param>
/// <param name="Frames">
/// The sub-frame, from 0. Its relation to a frame rate is not known. The stream does not contain the rate of its timecode, which can differ from the rate
/// of its frames.
/// </param>
public readonly record struct Timecode(int Hours, int Minutes, int Seconds, int Frames)
{
    // No frame rate has more frames in a second.
    private const uint MaxFrames = 1000;

    /// <summary>Gets the timecode in its usual form, for example 10:11:12:07.</summary>
    /// <returns>Four numbers of at least two digits.</returns>
    public override string ToString() => $"{Hours:00}:{Minutes:00}:{Seconds:00}:{Frames:00}";

    // Axis Studio writes 0x00HHMMSS and the sub-frame into the reserved fields (protocol.md section 9). A server without a clock leaves both 0, which
    // looks the same as midnight.
    internal static Timecode? Read(uint time, uint frames)
    {
        (uint hours, uint minutes, uint seconds) = (time >> 16, (time >> 8) & 0xFF, time & 0xFF);
        return (time | frames) != 0 && hours < 24 && minutes < 60 && seconds < 60 && frames < MaxFrames
            ? new Timecode((int)hours, (int)minutes, (int)seconds, (int)frames)
            : null;
    }
}
