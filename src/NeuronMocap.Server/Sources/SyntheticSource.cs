using System.Numerics;
using NeuronMocap.Server.Sources.Synthetic;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>A synthetic walk, which needs no file.</summary>
/// <remarks>
/// The avatar walks round a ring of two metres and stops every few steps. It also waves, looks around, counts with its fingers or stretches. Its body
/// is the default body (<see cref="DefaultOffsets"/>, variant Neck1). A foot on the ground does not move, and no foot goes below the ground, which is
/// at Y = 0.
/// <para>
/// The motion repeats every 40 seconds. A pose is computed from the frame number alone. Time and precision are the same for every frame up to 2^53.
/// Immutable and thread-safe. Computing a pose allocates nothing.
/// </para>
/// </remarks>
public sealed class SyntheticSource : MotionSource
{
    // The part of the lap between the starting points of consecutive avatars. Its multiples stay well apart, however many avatars there are.
    private const double GoldenPart = 0.38196601125010515;

    private const float StandingHeight = 83.4f;
    private const float BreathsPerLap = 10;

    private static readonly Vector3[] Offsets = [.. BoneHierarchy.Bones.ToArray().Select(bone => DefaultOffsets.Get(bone))];

    private readonly int _avatar;
    private readonly double _framesPerLap;
    private readonly double _startSeconds;
    private readonly float _ringX;

    /// <summary>Creates a source.</summary>
    /// <param name="frameRate">Frames per second. The speed of the avatar does not depend on it.</param>
    /// <param name="avatarIndex">
    /// Index of the avatar, from 0. Each avatar has its own ring, 320 cm further along X than the previous one. It starts at another point of the
    /// motion and makes its gestures in another order. The paths of two neighbours are at least 120 cm apart.
    /// </param>
    /// <exception cref="ArgumentOutOfRangeException">The rate is not a positive number, or the avatar index is negative.</exception>
    public SyntheticSource(double frameRate = 60, int avatarIndex = 0)
    {
        if (!(frameRate > 0) || double.IsInfinity(frameRate))
            throw new ArgumentOutOfRangeException(nameof(frameRate), frameRate, "The frame rate must be a positive number.");
        if (avatarIndex < 0)
            throw new ArgumentOutOfRangeException(nameof(avatarIndex), avatarIndex, "The avatar number must not be negative.");

        FrameRate = frameRate;
        _avatar = avatarIndex;
        _framesPerLap = frameRate * GaitMoment.LapSeconds;
        _startSeconds = avatarIndex * GoldenPart % 1 * GaitMoment.LapSeconds;
        _ringX = avatarIndex * WalkingPath.RingDistance;
    }

    /// <inheritdoc/>
    public override double FrameRate { get; }

    /// <summary>Always null, because the motion never ends.</summary>
    public override long? FrameCount => null;

    /// <summary>Always true.</summary>
    public override bool HasDisplacement => true;

    /// <inheritdoc/>
    /// <exception cref="ArgumentOutOfRangeException">The frame number is negative.</exception>
    /// <exception cref="ArgumentException">There is no room for 59 transforms.</exception>
    public override void GetPose(long frame, Span<BoneTransform> pose)
    {
        if (pose.Length < BoneHierarchy.BoneCount)
            throw new ArgumentException("There must be room for each of the 59 bones.", nameof(pose));

        double seconds = SecondsInLap(frame);
        var moment = new GaitMoment(seconds);
        var gesture = new Gesture(moment, _avatar);
        float lap = (float)(seconds / GaitMoment.LapSeconds) * (2 * MathF.PI);
        float breath = MathF.Sin(lap * BreathsPerLap);

        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
            pose[bone] = new BoneTransform(Offsets[bone], Quaternion.Identity);

        WriteHips(moment, lap, pose);
        WriteLegs(moment, pose);
        Torso.Write(moment, gesture, breath, pose);
        WriteArms(moment, gesture, breath, pose);
        WriteHands(gesture, lap, pose);
    }

    /// <summary>Gets which feet are on the ground with the whole sole. At least one foot is.</summary>
    /// <remarks>A foot that rolls over its toes counts as lifted.</remarks>
    /// <param name="frame">Frame number, from 0.</param>
    /// <returns>True for each foot that is planted.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The frame number is negative.</exception>
    public override FootContacts GetFootContacts(long frame)
    {
        var moment = new GaitMoment(SecondsInLap(frame));
        return new FootContacts(moment.GetFoot(right: false).IsPlanted, moment.GetFoot(right: true).IsPlanted);
    }

    /// <summary>Writes the default body.</summary>
    /// <param name="offsets">Room for 59 bone positions relative to the parent bone, in <see cref="Bone"/> order; centimetres.</param>
    /// <param name="endSites">Room for 59 end points of bones, relative to the bone. Zero for bones that have children.</param>
    public override void GetBody(Span<Vector3> offsets, Span<Vector3> endSites)
    {
        Offsets.CopyTo(offsets);
        foreach (Bone bone in BoneHierarchy.Bones)
            DefaultOffsets.TryGetEndSite(bone, out endSites[(int)bone]);
    }

    private static float PelvisHeading(in GaitMoment moment) => WalkingPath.Heading(moment.Station) + (moment.Stride * 5);

    private static void WriteHands(in Gesture gesture, float lap, Span<BoneTransform> pose)
    {
        float wave = gesture.AmountOf(GestureKind.Wave);
        float stretch = gesture.AmountOf(GestureKind.Stretch);
        float counting = gesture.AmountOf(GestureKind.CountFingers);

        // Both hands show one finger after the other from 0.6 s on. The left hand is a little behind.
        float count = (gesture.Seconds - 0.6f) * 1.9f;
        Hand.Write(right: true, lap * 11, Math.Max(wave, stretch), count, counting, pose);
        Hand.Write(right: false, lap * 13, stretch, count - 0.4f, counting, pose);
    }

    private static void WriteArms(in GaitMoment moment, in Gesture gesture, float breath, Span<BoneTransform> pose)
    {
        float show = gesture.AmountOf(GestureKind.CountFingers);
        float stretch = gesture.AmountOf(GestureKind.Stretch);
        Arm.Swing(moment.Stride, moment.Walking, breath)
            .Blend(Arm.Wave(gesture.Seconds), gesture.AmountOf(GestureKind.Wave))
            .Blend(Arm.ShowHand(gesture.Seconds), show)
            .Blend(Arm.Stretch(gesture.Seconds), stretch)
            .Write(right: true, pose);
        Arm.Swing(-moment.Stride, moment.Walking, breath)
            .Blend(Arm.ShowHand(gesture.Seconds), show)
            .Blend(Arm.Stretch(gesture.Seconds), stretch)
            .Write(right: false, pose);
    }

    private double SecondsInLap(long frame)
    {
        if (frame < 0)
            throw new ArgumentOutOfRangeException(nameof(frame), frame, "The frame number must not be negative.");

        // The remainder of two doubles is exact, so the time within the lap stays precise after any number of laps.
        double seconds = (frame % _framesPerLap / FrameRate) + _startSeconds;
        return seconds < GaitMoment.LapSeconds ? seconds : seconds - GaitMoment.LapSeconds;
    }

    private void WriteHips(in GaitMoment moment, float lap, Span<BoneTransform> pose)
    {
        float walking = moment.Walking;
        float idle = (1 - walking) * MathF.Sin(lap * 5);

        // The pelvis shifts over the standing foot, and into the ring. It is low when both feet are on the ground, far apart.
        float left = (moment.Weight * 2.2f) + walking + (idle * 1.2f);
        Vector3 place = WalkingPath.Point(moment.Station, left, _ringX);
        place.Y = StandingHeight - (walking * 3.3f) + (moment.Rise * 1.9f) - (idle * idle * 0.4f);

        // The side of the swinging leg moves forward and drops a little.
        Quaternion rotation = Turn.Y(PelvisHeading(moment))
            * Turn.Z((moment.Weight * 3) - (walking * 0.6f) + idle)
            * Turn.X(walking * 2);
        pose[(int)Bone.Hips] = new BoneTransform(place, rotation);
    }

    private void WriteLegs(in GaitMoment moment, Span<BoneTransform> pose)
    {
        float heading = PelvisHeading(moment);
        var right = new FootPose(moment.GetFoot(right: true), right: true, _ringX);
        var left = new FootPose(moment.GetFoot(right: false), right: false, _ringX);
        Leg.Solve(Bone.RightUpLeg, right, Turn.Y((heading + right.Heading) / 2), pose);
        Leg.Solve(Bone.LeftUpLeg, left, Turn.Y((heading + left.Heading) / 2), pose);
    }
}
