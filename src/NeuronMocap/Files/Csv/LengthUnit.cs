namespace NeuronMocap.Csv;

/// <summary>The unit of positions in a table.</summary>
public enum LengthUnit
{
    /// <summary>Metres.</summary>
    Metres,

    /// <summary>Centimetres, as in BVH files and in the library.</summary>
    Centimetres,
}
