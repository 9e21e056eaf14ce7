namespace NeuronMocap;

/// <summary>A time of the clock that a server stamps its frames with, such as that of a film set: hours, minutes, seconds and sub-frame.</summary>
/// <param name="Hours">0 to 23.</param>
/// <param name="Minutes">0 to 59.</param>
/// <param name="Seconds">0 to 59.</param>
/// <param name="Frames">
/// The sub-frame, from 0. How it relates to a frame rate is not known: the stream names no rate of its timecode, which may be another than that of its
/// frames.
/// </param>
public readonly record struct Timecode(int Hours, int Minutes, int Seconds, int Frames)
{
    // No frame rate has more in a second.
    private const uint MaxFrames = 1000;

    /// <summary>The timecode as people write it: 10:11:12:07.</summary>
    /// <returns>Four numbers of at least two digits.</returns>
    public override string ToString() => $"{Hours:00}:{Minutes:00}:{Seconds:00}:{Frames:00}";

    // As Axis Studio puts it into the reserved fields: 0x00HHMMSS and the frame (protocol.md section 9). A server without a clock leaves both 0,
    // which cannot be told from midnight.
    internal static Timecode? Read(uint time, uint frames)
    {
        (uint hours, uint minutes, uint seconds) = (time >> 16, (time >> 8) & 0xFF, time & 0xFF);
        return (time | frames) != 0 && hours < 24 && minutes < 60 && seconds < 60 && frames < MaxFrames
            ? new Timecode((int)hours, (int)minutes, (int)seconds, (int)frames)
            : null;
    }
}
