using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Playback;
using NeuronMocap.Tests.Protocol;
using NeuronMocap.Tests.Reader;

namespace NeuronMocap.Data.Tests.Streams;

public sealed class ForeignPacketTests : StreamFixtureTests
{
    internal override StreamFixture Load(string name) => ForeignStreams.Load(name);
}

public sealed class ForeignReaderTests : FixtureReaderTests
{
    internal override StreamFixture Load(string name) => ForeignStreams.Load(name);
}

public sealed class ForeignPlaybackTests : PlaybackFixtureTests
{
    internal override StreamFixture Load(string name) => ForeignStreams.Load(name);
}

public sealed class ForeignTextTests
{
    [Fact]
    public void Lines_are_written_byte_for_byte()
    {
        StreamFixture fixture = ForeignStreams.Load("text");
        var text = new StringBuilder();
        byte[] buffer = new byte[100_000];
        foreach (ExpectedPacket frame in fixture.Expected)
            text.Append(Encoding.ASCII.GetString(buffer, 0, TextEncoder.WriteMotion(buffer, frame.Avatar, new AvatarName(frame.Name), frame.Values)));

        Assert.Equal(Encoding.ASCII.GetString(fixture.Bytes), text.ToString());
    }
}
