using System.Numerics;

namespace NeuronMocap.Calculation;

// The mean of a vector over a take, in the axes of a sensor. Directions and lengths are averaged separately.
internal struct DirectionSum
{
    private Vector3 _sum;
    private double _length;
    private int _count;

    public readonly Vector3 Sum => _sum;

    public readonly int Count => _count;

    public readonly Vector3 Mean => _count == 0 || _sum == Vector3.Zero
        ? Vector3.Zero
        : Vector3.Normalize(_sum) * (float)(_length / _count);

    public void Add(Quaternion sensor, Vector3 world)
    {
        _sum += Vector3.Transform(world, Quaternion.Conjugate(sensor));
        _length += world.Length();
        _count++;
    }
}
