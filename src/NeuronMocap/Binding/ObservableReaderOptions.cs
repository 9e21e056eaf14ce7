namespace NeuronMocap;

/// <summary>Options of an <see cref="ObservableReader"/>. The values are copied when it is made.</summary>
public sealed class ObservableReaderOptions
{
    private const double SlowestRate = 0.01;
    private const double FastestRate = 60;

    /// <summary>
    /// The context on which properties change. Null, the default, means the <see cref="SynchronizationContext.Current"/> of the thread that makes the
    /// object.
    /// </summary>
    public SynchronizationContext? Context { get; set; }

    /// <summary>
    /// A function that posts an action to the window's thread, instead of <see cref="Context"/>: see <see cref="FrameDeliveryOptions.Post"/>. Null, the
    /// default, for none.
    /// </summary>
    public Func<Action, bool>? Post { get; set; }

    /// <summary>Largest number of updates per second, 0.01 to 60. The default is 4. A change of status does not wait.</summary>
    public double UpdateRate { get; set; } = 4;

    internal ObservableReaderOptions Copy() => (ObservableReaderOptions)MemberwiseClone();

    internal string? FindFault()
    {
        if (Context is not null && Post is not null)
            return "Context and Post are both set; set one of them.";

        return UpdateRate is >= SlowestRate and <= FastestRate
            ? null
            : FormattableString.Invariant($"UpdateRate is {UpdateRate}; it must be 0.01 to 60 updates per second.");
    }
}
