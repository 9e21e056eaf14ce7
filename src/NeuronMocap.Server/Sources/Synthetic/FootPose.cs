using System.Numerics;

namespace NeuronMocap.Server.Sources.Synthetic;

// Position of an ankle and rotation of the foot, in the world. A leaving foot rolls over the tip of its toes, which does not move. In flight the
// pivot moves along the sole to the heel. The foot comes down heel first and is flat when it lands.
internal readonly struct FootPose
{
    // The End Site of the foot is this far below and in front of the ankle. The heel is as far below.
    private const float AnkleHeight = 10;
    private const float ToeLength = 15.75f;
    private const float HeelLength = 5;

    private const float HalfTrack = 6.5f;
    private const float ToeOut = 6;
    private const float RollDegrees = 36;
    private const float ToeUpDegrees = 10;
    private const float Clearance = 3.5f;

    public FootPose(FootSwing swing, bool right, float ringX)
    {
        float side = right ? -1 : 1;
        float v = swing.Progress;
        float travel = Easing.Glide((v - 0.2f) / 0.8f);
        float station = Easing.Lerp(swing.From, swing.To, travel);
        float heading = WalkingPath.Heading(station) + (side * ToeOut);

        // A short step at the start or end of a walk turns the foot less.
        float size = (1 + swing.To - swing.From) / 3f;
        float pitch = size * ((RollDegrees * Easing.Bump(v, 0, 0.3f, 0.75f)) - (ToeUpDegrees * Easing.Bump(v, 0.55f, 0.85f, 1)));
        float pivot = Easing.Lerp(ToeLength, -HeelLength, Easing.Step(v, 0.35f, 0.75f));
        float height = Clearance * Easing.Bump(v, 0, 0.5f, 1);

        Quaternion yaw = Turn.Y(heading);
        Vector3 ground = WalkingPath.Point(station, side * HalfTrack, ringX);
        var sole = new Vector3(0, -AnkleHeight, pivot);
        Rotation = yaw * Turn.X(pitch);
        Ankle = ground + Vector3.Transform(new Vector3(0, height, pivot), yaw) - Vector3.Transform(sole, Rotation);
        Heading = heading;
    }

    public Vector3 Ankle { get; }

    public Quaternion Rotation { get; }

    // Degrees about Y.
    public float Heading { get; }
}
