namespace NeuronMocap.Bvh;

/// <summary>
/// Specifies how frames that are missing from a stream are written. The frame indices reveal missing frames; a BVH row has a position but no time.
/// </summary>
public enum BvhGapHandling
{
    /// <summary>
    /// Repeats the previous row for each missing frame. The take then lasts as long as the motion and stays in step with sound and video.
    /// </summary>
    Repeat,

    /// <summary>Writes only the received frames. Rows after a gap come too early by the length of the gap.</summary>
    Skip,
}
