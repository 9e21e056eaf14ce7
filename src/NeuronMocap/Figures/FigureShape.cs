using System.Numerics;

namespace NeuronMocap.Figures;

// A capsule with an elliptical section that may change from end to end: a limb, a palm, a skull. In metres, in the axes of its bone.
// Start and End are the centres of the two end sections; the round ends extend beyond them. Radii are half widths along Side, and across it.
// An accent is drawn in the second colour. Bulge is how much thicker the shape is a quarter of the way along, where a muscle is thickest, as a
// fraction of the radii.
internal readonly record struct FigureShape(
    Bone Bone, Vector3 Start, Vector3 End, Vector2 StartRadii, Vector2 EndRadii, Vector3 Side, bool IsAccent = false, float Bulge = 0)
{
    // Then one section is the widest of both ends.
    public bool IsEllipsoid => Start == End && StartRadii == EndRadii && Bulge == 0;

    public static FigureShape Round(Bone bone, Vector3 start, Vector3 end, float startRadius, float endRadius, bool isAccent = false, float bulge = 0) =>
        new(bone, start, end, new Vector2(startRadius), new Vector2(endRadius), Vector3.UnitZ, isAccent, bulge);

    public static FigureShape Ball(Bone bone, float radius) => Round(bone, Vector3.Zero, Vector3.Zero, radius, radius, isAccent: true);
}
