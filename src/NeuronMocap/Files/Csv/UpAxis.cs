namespace NeuronMocap.Csv;

/// <summary>The axes of a table. All are right-handed.</summary>
public enum UpAxis
{
    /// <summary>Y up, X to the left and Z forward, for a performer in T-pose. These are the axes of BVH files and of the library.</summary>
    Y,

    /// <summary>Z up, X forward and Y to the left. These are the axes of robots, as in ROS.</summary>
    Z,
}
