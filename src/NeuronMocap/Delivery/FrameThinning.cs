namespace NeuronMocap.Delivery;

// Which frames a consumer wants: at most MaxRate per second, or every n-th.
internal readonly record struct FrameThinning(double MaxRate, int EveryNth)
{
    public const double SlowestRate = 0.01;
    public const double FastestRate = 1000;
    public const int LargestNth = 1_000_000;

    public static FrameThinning None => new(0, 1);

    // Null if every frame is wanted.
    public FrameThinner? CreateThinner() => this == None ? null : new FrameThinner(this);

    public string? FindFault()
    {
        if (!(MaxRate is 0 or (>= SlowestRate and <= FastestRate)))
            return FormattableString.Invariant($"MaxRate is {MaxRate}; it must be 0, or 0.01 to 1000 frames per second.");
        if (EveryNth is < 1 or > LargestNth)
            return $"EveryNth is {EveryNth}; it must be 1 to 1,000,000.";

        return MaxRate > 0 && EveryNth > 1 ? "MaxRate and EveryNth are both set; set one of them." : null;
    }
}
