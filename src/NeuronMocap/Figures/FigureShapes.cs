using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Figures;

// The shapes of a figure: a jointed doll. Lengths are those of the body. Thicknesses are those of an adult, scaled by stature.
internal sealed class FigureShapes
{
    // Height of the default body's hips, in metres. The thicknesses below belong to this stature.
    private const float ReferenceHipsHeight = 0.841f;

    // Centimetres to metres.
    public const float Metre = 0.01f;

    private readonly List<FigureShape> _shapes = new(64);
    private readonly SkeletonBody _body;
    private readonly float _size;

    private FigureShapes(SkeletonBody body)
    {
        _body = body;
        float hipsHeight = Offset(Bone.Hips).Y;
        _size = hipsHeight > 0 ? hipsHeight / ReferenceHipsHeight : 1;
    }

    public static IReadOnlyList<FigureShape> Of(SkeletonBody body)
    {
        var shapes = new FigureShapes(body);
        shapes.AddTrunk();
        shapes.AddHead();
        shapes.AddLeg(Bone.LeftUpLeg);
        shapes.AddLeg(Bone.RightUpLeg);
        shapes.AddArm(Bone.LeftShoulder);
        shapes.AddArm(Bone.RightShoulder);
        return shapes._shapes;
    }

    // Pelvis, narrower waist and rib cage, which overlap. Both variants have five bones from the hips up. The parent of the shoulders determines
    // which of them form the chest.
    private void AddTrunk()
    {
        Vector2 waist = Radii(0.106f, 0.081f);
        Vector3 hip = Offset(Bone.LeftUpLeg);
        var half = new Vector3(MathF.Abs(hip.X) * 0.75f, 0, 0);
        Add(Bone.Hips, -half, half, Radii(0.092f, 0.098f), Radii(0.092f, 0.098f), Vector3.UnitY);
        Add(Bone.Hips, Vector3.Zero, Offset(Bone.Spine), Radii(0.125f, 0.088f), Radii(0.108f, 0.084f));
        Add(Bone.Spine, Vector3.Zero, Offset(Bone.Spine1), waist, waist);
        Add(Bone.Spine1, Vector3.Zero, Offset(Bone.Spine2), waist, waist);

        bool hasFourSpineBones = _body.Variant == SkeletonVariant.Spine3;
        Bone shoulders = hasFourSpineBones ? Bone.Neck : Bone.Spine2;
        if (hasFourSpineBones)
            Add(Bone.Spine2, Vector3.Zero, Offset(Bone.Neck), waist, waist);

        // From the lowest rib to below the collar bones. The round end reaches them.
        float collar = Math.Max(0, Offset(Bone.LeftShoulder).Y);
        var top = new Vector3(0, collar - (0.045f * _size), 0);
        var ribs = new Vector3(0, top.Y - (0.13f * _size), 0.008f * _size);
        Add(shoulders, ribs, top, Radii(0.118f, 0.096f), Radii(0.145f, 0.103f));

        for (Bone bone = shoulders + 1; bone < Bone.Head; bone++)
            _shapes.Add(FigureShape.Round(bone, Vector3.Zero, Offset(bone + 1), 0.05f * _size, 0.05f * _size));
    }

    private void AddHead()
    {
        Vector3 crown = End(Bone.Head);
        float length = crown.Length();
        Vector3 up = length > 0 ? crown / length : Vector3.UnitY;
        Vector2 jaw = new Vector2(0.34f, 0.39f) * length;
        Vector2 skull = new Vector2(0.48f, 0.57f) * length;
        Add(Bone.Head, (up * (0.22f * length)) + (Vector3.UnitZ * (0.16f * length)), (up * (0.6f * length)) + (Vector3.UnitZ * (0.05f * length)), jaw, skull);

        // A visor shows where the figure looks.
        Vector3 eyes = (up * (0.53f * length)) + (Vector3.UnitZ * (0.5f * length));
        Vector3 half = Vector3.UnitX * (0.21f * length);
        var visor = new Vector2(0.13f, 0.14f) * length;
        _shapes.Add(new FigureShape(Bone.Head, eyes - half, eyes + half, visor, visor, up, true));
    }

    private void AddLeg(Bone thigh)
    {
        Bone shin = thigh + 1;
        Bone foot = thigh + 2;
        float ankle = 0.036f * _size;
        AddMuscle(thigh, Offset(shin) * 0.1f, Offset(shin), 0.079f, 0.05f, 0.06f);
        _shapes.Add(FigureShape.Ball(shin, 0.055f * _size));
        AddMuscle(shin, Vector3.Zero, Offset(foot), 0.048f, 0.034f, 0.2f);

        // A sole on the ground, from behind the ankle to the toes, and its connection to the ankle.
        Vector3 toes = End(foot);
        float half = Math.Min(0.026f * _size, MathF.Abs(toes.Y) / 2);
        Vector3 tip = toes + new Vector3(0, half, 0);
        var heel = new Vector3(0, tip.Y, -0.045f * _size);
        Add(foot, heel, tip, new Vector2(0.036f * _size, half), new Vector2(0.046f * _size, 0.9f * half));
        Add(foot, Vector3.Zero, Vector3.Lerp(heel, tip, 0.55f), new Vector2(ankle, ankle), new Vector2(0.04f * _size, 0.024f * _size));
    }

    private void AddArm(Bone shoulder)
    {
        Bone upperArm = shoulder + 1;
        Bone forearm = shoulder + 2;
        Bone hand = shoulder + 3;
        _shapes.Add(FigureShape.Round(shoulder, Vector3.Zero, Offset(upperArm) * 0.85f, 0.052f * _size, 0.048f * _size));
        _shapes.Add(FigureShape.Ball(upperArm, 0.058f * _size));
        AddMuscle(upperArm, Vector3.Zero, Offset(forearm), 0.046f, 0.035f, 0.05f);
        _shapes.Add(FigureShape.Ball(forearm, 0.041f * _size));
        AddMuscle(forearm, Vector3.Zero, Offset(hand), 0.035f, 0.025f, 0.14f);
        AddHand(hand);
    }

    // Each of the four fingers has a palm bone and three more bones; the thumb has three. The palm is one shape, because its bones hardly move.
    private void AddHand(Bone hand)
    {
        Bone thumb = hand + 1;
        Bone index = hand + 4;
        Vector3 knuckles = (FirstJoint(index) + FirstJoint(index + 12)) / 2;
        float halfWidth = Vector3.Distance(FirstJoint(index), FirstJoint(index + 12)) / 2;
        var palm = new Vector2(halfWidth + (0.008f * _size), 0.014f * _size);
        Add(hand, knuckles * 0.25f, knuckles * 0.9f, new Vector2(0.026f, 0.016f) * _size, palm, Vector3.UnitZ);
        AddFinger(thumb, 0.0125f);
        for (Bone finger = index; finger < index + 16; finger += 4)
            AddFinger(finger + 1, 0.0095f);
    }

    private Vector3 FirstJoint(Bone palmBone) => Offset(palmBone) + Offset(palmBone + 1);

    private void AddFinger(Bone first, float radius)
    {
        float wide = radius * _size;
        float narrow = 0.85f * wide;
        _shapes.Add(FigureShape.Round(first, Vector3.Zero, Offset(first + 1), wide, wide));
        _shapes.Add(FigureShape.Round(first + 1, Vector3.Zero, Offset(first + 2), wide, narrow));
        _shapes.Add(FigureShape.Round(first + 2, Vector3.Zero, End(first + 2) * 0.6f, narrow, 0.8f * wide));
    }

    private void AddMuscle(Bone bone, Vector3 start, Vector3 end, float startRadius, float endRadius, float bulge) =>
        _shapes.Add(FigureShape.Round(bone, start, end, startRadius * _size, endRadius * _size, bulge: bulge));

    private void Add(Bone bone, Vector3 start, Vector3 end, Vector2 startRadii, Vector2 endRadii) =>
        Add(bone, start, end, startRadii, endRadii, Vector3.UnitX);

    private void Add(Bone bone, Vector3 start, Vector3 end, Vector2 startRadii, Vector2 endRadii, Vector3 side) =>
        _shapes.Add(new FigureShape(bone, start, end, startRadii, endRadii, side));

    private Vector2 Radii(float width, float depth) => new Vector2(width, depth) * _size;

    private Vector3 Offset(Bone bone) => _body.Offsets[(int)bone] * Metre;

    private Vector3 End(Bone bone) => _body.EndSites[(int)bone] * Metre;
}
