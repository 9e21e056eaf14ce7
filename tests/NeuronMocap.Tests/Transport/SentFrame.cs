using FsCheck;
using FsCheck.Fluent;

namespace NeuronMocap.Tests.Transport;

/// <summary>Specifies what happens to the two datagrams of a frame in transit.</summary>
internal enum Fate
{
    Both,
    FirstLost,
    SecondLost,
    Swapped,
    FirstTwice,
    SecondTwice,

    /// <summary>A single datagram.</summary>
    Uncut,
}

/// <summary>A frame, or anything else that a sender sends, and the arrival of its datagrams.</summary>
/// <param name="Sender">The last number of the sender's address.</param>
/// <param name="Part">The sent bytes.</param>
/// <param name="Cut">The size of the first datagram.</param>
/// <param name="Fate">What the network does.</param>
/// <param name="IsLate">Whether the last datagram arrives after the first datagram that is sent next.</param>
internal sealed record SentFrame(int Sender, WirePart Part, int Cut, Fate Fate, bool IsLate)
{
    public static Gen<SentFrame> From(int senders, Gen<WirePart> parts) =>
        from sender in Gen.Choose(1, senders)
        from part in parts
        from cut in Gen.Choose(1, 200)
        from fate in Gen.Elements(Enum.GetValues<Fate>())
        from isLate in Gen.Elements(false, false, true)
        select new SentFrame(sender, part, cut, fate, isLate);

    /// <summary>Returns all datagrams in the order of their arrival.</summary>
    public static List<Datagram> Arrivals(IEnumerable<SentFrame> frames)
    {
        List<Datagram> arrivals = [];
        Datagram? late = null;
        foreach (SentFrame frame in frames)
        {
            List<Datagram> own = [.. frame.Datagrams().Select(bytes => new Datagram(frame.Sender, bytes))];
            Datagram? last = frame.IsLate ? own[^1] : null;
            if (last is not null)
                own.RemoveAt(own.Count - 1);
            if (late is not null)
                own.Insert(Math.Min(1, own.Count), late);

            late = last;
            arrivals.AddRange(own);
        }

        return late is null ? arrivals : [.. arrivals, late];
    }

    public IEnumerable<SentFrame> Simpler() =>
    [
        .. Fate == Fate.Uncut ? (IEnumerable<SentFrame>)[] : [this with { Fate = Fate.Uncut }],
        .. IsLate ? [this with { IsLate = false }] : (IEnumerable<SentFrame>)[],
        .. Part.Simpler().Select(part => this with { Part = part }),
        .. Properties.SimplerNumbers(Sender - 1).Select(sender => this with { Sender = sender + 1 }),
    ];

    // At least one. A part of fewer than two bytes cannot be cut.
    private IEnumerable<byte[]> Datagrams()
    {
        byte[] bytes = Part.ToBytes();
        int cut = Math.Min(Cut, bytes.Length - 1);
        if (cut < 1)
            return [bytes];

        (byte[] first, byte[] second) = (bytes[..cut], bytes[cut..]);
        return Fate switch
        {
            Fate.Both => [first, second],
            Fate.FirstLost => [second],
            Fate.SecondLost => [first],
            Fate.Swapped => [second, first],
            Fate.FirstTwice => [first, first, second],
            Fate.SecondTwice => [first, second, second],
            _ => [bytes],
        };
    }
}

internal sealed record Datagram(int Sender, byte[] Bytes);
