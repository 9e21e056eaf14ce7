namespace NeuronMocap.Tests.Network;

internal sealed partial class TestServer
{
    static partial void SetStopTimeout(NeuronReaderOptions options) => options.StopTimeout = Limits.Unexpected;
}
