using System.Runtime.InteropServices;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Native;

// The C struct: 12 floats in metres (manual section 2.1.8).
[StructLayout(LayoutKind.Sequential)]
internal readonly struct BoneDimension(BoneDimensions source)
{
    public readonly float Head = source.Head;
    public readonly float Neck = source.Neck;
    public readonly float Body = source.Body;
    public readonly float ShoulderWidth = source.ShoulderWidth;
    public readonly float UpperArm = source.UpperArm;
    public readonly float Forearm = source.Forearm;
    public readonly float Palm = source.Palm;
    public readonly float HipWidth = source.HipWidth;
    public readonly float UpperLeg = source.UpperLeg;
    public readonly float LowerLeg = source.LowerLeg;
    public readonly float HeelHeight = source.HeelHeight;
    public readonly float FootLength = source.FootLength;
}
