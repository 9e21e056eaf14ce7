namespace NeuronMocap.Bvh;

/// <summary>Where the OFFSETs of an exported file come from.</summary>
public enum BvhBodyOrigin
{
    /// <summary>The default body's, of the manual's Appendix B: right in direction, not in length.</summary>
    Default,

    /// <summary>The stream's own positions: it has displacement.</summary>
    Stream,

    /// <summary>The export's options.</summary>
    Options,

    /// <summary>The BVH header that the command channel answered.</summary>
    Header,

    /// <summary>The bone sizes that the command channel answered, on the default body's proportions.</summary>
    Dimensions,
}
