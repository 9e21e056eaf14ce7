#nullable enable
using Vector2 = UnityEngine.Vector2;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    // A capsule with an elliptical section that may change from end to end: a limb, a palm, a skull. In metres, in the axes of its bone.
    internal readonly struct FigureShape
    {
        public FigureShape(Bone bone, Vector3 start, Vector3 end, Vector2 startRadii, Vector2 endRadii, Vector3 side, bool isAccent = false, float bulge = 0)
        {
            Bone = bone;
            Start = start;
            End = end;
            StartRadii = startRadii;
            EndRadii = endRadii;
            Side = side;
            IsAccent = isAccent;
            Bulge = bulge;
        }

        public Bone Bone { get; }

        // Centres of the two end sections. The round ends extend beyond them.
        public Vector3 Start { get; }

        public Vector3 End { get; }

        // Half widths along Side, and across it.
        public Vector2 StartRadii { get; }

        public Vector2 EndRadii { get; }

        public Vector3 Side { get; }

        // Drawn in the second colour.
        public bool IsAccent { get; }

        // How much thicker the shape is a quarter of the way along, where a muscle is thickest, as a fraction of the radii.
        public float Bulge { get; }

        public static FigureShape Round(Bone bone, Vector3 start, Vector3 end, float startRadius, float endRadius, bool isAccent = false, float bulge = 0) =>
            new FigureShape(
                bone,
                start,
                end,
                new Vector2(startRadius, startRadius),
                new Vector2(endRadius, endRadius),
                Vector3.forward,
                isAccent,
                bulge);

        public static FigureShape Ball(Bone bone, float radius) => Round(bone, Vector3.zero, Vector3.zero, radius, radius, true);
    }
}
