using System.Numerics;

namespace NeuronMocap.Server.Sources.Synthetic;

// The ring that an avatar walks round, to its left. Positions along it are counted in steps. One round has fourteen steps.
internal static class WalkingPath
{
    public const float StepsPerRound = 14;

    // Two avatars on neighbouring rings are never closer than 120 cm: the distance between the centres less one diameter.
    public const float RingDistance = (2 * Radius) + 120;

    private const float Radius = 100;

    public static float Heading(float station) => station * (360 / StepsPerRound);

    // A point on the ground beside the ring; a positive distance is to the left, towards the centre.
    public static Vector3 Point(float station, float left, float ringX)
    {
        float angle = station * (2 * MathF.PI / StepsPerRound);
        float radius = Radius - left;
        return new Vector3(ringX - (radius * MathF.Cos(angle)), 0, radius * MathF.Sin(angle));
    }
}
