namespace NeuronMocap.Bvh;

/// <summary>What becomes of frames that the frame index of a stream tells to be missing. A row of BVH has no time of its own, only a place.</summary>
public enum BvhGapHandling
{
    /// <summary>The row before stands in for each of them, so that the take lasts as long as the motion did and stays in step with sound and video.</summary>
    Repeat,

    /// <summary>Nothing: the file holds what was received, and what follows a gap comes too early by its length.</summary>
    Skip,
}
