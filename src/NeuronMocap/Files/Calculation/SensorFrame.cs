using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Calculation;

// The values of the 21 bones of the body in one frame, in the axes of BVH and in centimetres, by Bone.
internal ref struct SensorFrame
{
    private const int ValuesPerBone = 16;

    private readonly ReadOnlySpan<float> _values;
    private readonly CalculationAxes _axes;

    public SensorFrame(ReadOnlySpan<float> values, CalculationAxes axes)
    {
        _values = values;
        _axes = axes;
    }

    // A sensor that drops out can leave a value that is not a number.
    public bool IsFinite
    {
        get
        {
            for (int bone = 0; bone < CalculationOrder.BodyBoneCount; bone++)
            {
                ReadOnlySpan<float> values = _values[(bone * ValuesPerBone)..];
                if (!float.IsFinite(values[0]) || !float.IsFinite(values[1]) || !float.IsFinite(values[2]))
                    return false;
            }

            return true;
        }
    }

    public bool LeftContact => _values[CalculationOrder.BodyBoneCount * ValuesPerBone] != 0;

    public bool RightContact => _values[(CalculationOrder.BodyBoneCount * ValuesPerBone) + 1] != 0;

    public Vector3 GetCentre(Bone bone)
    {
        ReadOnlySpan<float> values = _values[(CalculationOrder.IndexOf(bone) * ValuesPerBone)..];
        return _axes.ToBvh(new Vector3(values[0], values[1], values[2])) * CalculationAxes.CentimetresPerMetre;
    }

    public Quaternion GetRotation(Bone bone)
    {
        ReadOnlySpan<float> values = _values[((CalculationOrder.IndexOf(bone) * ValuesPerBone) + 6)..];
        Quaternion rotation = _axes.ToBvh(new Quaternion(values[1], values[2], values[3], values[0]));

        // The text has four digits. A sensor that sent nothing has zeros.
        float length = rotation.Length();
        return length > 0.5f && length < 2 ? Quaternion.Normalize(rotation) : Quaternion.Identity;
    }
}
