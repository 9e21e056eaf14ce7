namespace NeuronMocap.Bvh;

/// <summary>Specifies where the OFFSETs of an exported file come from.</summary>
public enum BvhBodyOrigin
{
    /// <summary>The default body of the manual's Appendix B. Its directions are right, its lengths are not.</summary>
    Default,

    /// <summary>The positions of the stream, which has displacement.</summary>
    Stream,

    /// <summary>The options of the export.</summary>
    Options,

    /// <summary>The BVH header from the command channel.</summary>
    Header,

    /// <summary>The bone sizes from the command channel, with the proportions of the default body.</summary>
    Dimensions,
}
