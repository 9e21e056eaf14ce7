namespace NeuronMocap.Bvh;

/// <summary>
/// Specifies how missing frames of a stream are written. Frame indices reveal them; a row of BVH has no time of its own, only a position.
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
