using UnityEngine.StandIn;

namespace UnityEngine;

public static class Random
{
    private static System.Random _random = new(1);

    public static float value => Range(0f, 1f);

    public static Vector3 insideUnitSphere => onUnitSphere * Mathf.Pow(value, 1 / 3f);

    public static Vector3 onUnitSphere
    {
        get
        {
            float height = Range(-1f, 1f);
            float angle = Range(0, 2 * Mathf.PI);
            float radius = Mathf.Sqrt(1 - (height * height));
            return new Vector3(radius * Mathf.Cos(angle), height, radius * Mathf.Sin(angle));
        }
    }

    public static Quaternion rotation => Quaternion.AngleAxis(Range(0f, 360f), onUnitSphere);

    public static void InitState(int seed) => _random = new System.Random(seed);

    public static float Range(float minInclusive, float maxInclusive)
    {
        MainThread.Check();
        return minInclusive + ((float)_random.NextDouble() * (maxInclusive - minInclusive));
    }

    public static int Range(int minInclusive, int maxExclusive)
    {
        MainThread.Check();
        return minInclusive == maxExclusive ? minInclusive : _random.Next(minInclusive, maxExclusive);
    }
}
