namespace NeuronMocap.Server.Broadcasting;

/// <summary>The paced broadcast from now on: the frames that appear in the log.</summary>
internal sealed class LiveFeed(FrameLog log, bool isSingle = false) : FrameFeed
{
    private readonly FrameCursor _cursor = log.CreateCursor();

    public override bool IsLive => true;

    public override bool IsAtEnd => log.IsAtEnd(_cursor);

    public override bool HasEnded => log.HasEnded(_cursor);

    public override long MissedPackets => log.GetMissed(_cursor);

    public override FrameBatch Read(Span<byte> destination) => log.Read(_cursor, destination, isSingle ? 1 : int.MaxValue);

    public override void Attach(IDirectRecipient recipient) => log.Attach(_cursor, recipient);

    public override void Wake() => log.Wake(_cursor);

    public override void Close() => log.Remove(_cursor);
}
