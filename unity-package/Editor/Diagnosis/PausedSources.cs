#nullable enable

using System;
using System.Linq;

namespace NeuronMocap.Unity.EditorTools
{
    // The open sources that hold a UDP port needed by a diagnosis. Only one socket can hold a port.
    internal sealed class PausedSources : IDisposable
    {
        private readonly MocapSource[] _sources;

        private PausedSources(MocapSource[] sources)
        {
            _sources = sources;
            foreach (MocapSource source in _sources)
                source.Close();
        }

        public static PausedSources? SharingUdpPort(NeuronReaderOptions options) => options.Transport == TransportKind.Udp
            ? new PausedSources(SceneSources.Find().Where(source => source.IsOpen && source.Kind == SourceKind.Network
                && source.Transport == TransportKind.Udp && source.Port == options.Port).ToArray())
            : null;

        public void Dispose()
        {
            // In edit mode, only sources with a preview are in the list.
            foreach (MocapSource source in _sources.Where(source => source != null && source.isActiveAndEnabled && MocapSource.All.Contains(source)))
                source.Open();
        }
    }
}
