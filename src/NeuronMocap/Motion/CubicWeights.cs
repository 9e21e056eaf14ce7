namespace NeuronMocap.Motion;

// The weights of four frames for a time between the middle two. They come from the Hermite polynomial whose slopes at those two frames are the
// central differences for uneven times. The weights sum to 1. A frame infinitely far away has no weight: the slope beside it is that to the other
// neighbour.
internal readonly struct CubicWeights
{
    public CubicWeights(double first, double second, double third, double fourth, double seconds)
    {
        double h0 = second - first;
        double h1 = third - second;
        double h2 = fourth - third;
        if (!(h0 > 0 && h1 > 0 && h2 > 0))
            throw new ArgumentException("Each frame must be later than the previous one.", nameof(seconds));

        double t = Math.Max(0, Math.Min(1, (seconds - second) / h1));
        double slope1 = t * (1 - t) * (1 - t) * h1;
        double slope2 = -t * t * (1 - t) * h1;
        double to = t * t * (3 - (2 * t));

        // A slope at a frame is the mean of the two differences beside it, each weighted by the length of the other.
        double before1 = h1 / (h0 + h1) / h0 * slope1;
        double after1 = 1 / (1 + (h1 / h0)) / h1 * slope1;
        double before2 = 1 / (1 + (h1 / h2)) / h1 * slope2;
        double after2 = h1 / (h1 + h2) / h2 * slope2;
        Part = (float)t;
        First = (float)-before1;
        Second = (float)(1 - to + before1 - after1 - before2);
        Third = (float)(to + after1 + before2 - after2);
        Fourth = (float)after2;
    }

    public float Part { get; }

    public float First { get; }

    public float Second { get; }

    public float Third { get; }

    public float Fourth { get; }
}
