namespace NeuronMocap.Server.Sources.Synthetic;

internal enum GestureKind
{
    Wave,
    LookAround,
    CountFingers,
    Stretch,
}

// A gesture in addition to walking: one during every stop and during two of the walks.
internal readonly struct Gesture
{
    private const int KindCount = 4;

    public Gesture(in GaitMoment moment, int avatar)
    {
        float seconds = moment.Seconds;
        if (!moment.IsWalking)
        {
            // Each avatar makes the gestures in another order and starts a little earlier or later.
            Kind = (GestureKind)((moment.Index + avatar) % KindCount);
            Seconds = seconds - (0.1f + (0.1f * ((moment.Index + (3 * avatar)) % 5)));
            Amount = Easing.Plateau(Seconds, 0, 0.9f, 3.8f, 4.8f);
            return;
        }

        Kind = moment.Index == 0 ? GestureKind.Wave : GestureKind.LookAround;
        Seconds = seconds - 0.8f;
        Amount = moment.Index switch
        {
            0 => Easing.Plateau(Seconds, 0, 0.9f, 2.9f, 4.0f),
            2 => Easing.Plateau(Seconds, 0, 0.5f, 2.4f, 3.0f),
            _ => 0,
        };
    }

    public GestureKind Kind { get; }

    // 0 to 1. It is 0 at the ends of every walk and stop.
    public float Amount { get; }

    // Time since the start of the gesture.
    public float Seconds { get; }

    public float AmountOf(GestureKind kind) => Kind == kind ? Amount : 0;
}
