using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Tests.Reader;

namespace NeuronMocap.Data.Tests.Takes;

public sealed class ForeignTakeTests : TakeTests
{
    private static readonly Lazy<BvhDocument> Take = new(static () => BvhDocument.Load(Fixtures.Require("test-take", "test.bvh")));

    internal override BvhDocument Load() => Take.Value;

    [Fact]
    public void The_performer_stands()
    {
        var source = new BvhSource(Load());
        Assert.Equal(2156, source.FrameCount);
        Assert.All(Enumerable.Range(0, 200), frame => Assert.Equal(new FootContacts(Left: true, Right: true), source.GetFootContacts(frame)));
    }
}
